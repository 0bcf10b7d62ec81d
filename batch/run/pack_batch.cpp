#include "batch/run/pack_batch.h"

#include <algorithm>
#include <system_error>

#include "base/files.h"
#include "base/output_file.h"
#include "viz/exchange/npy_archive.h"
#include "viz/exchange/stored_zip.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

constexpr FileKind kPackedKind = {"a file of a walk", size_t{1} << 30};
constexpr int kPackDigits = 5;

std::string packName(size_t pack) {
  std::string digits = std::to_string(pack);
  if (digits.size() < kPackDigits) digits.insert(0, kPackDigits - digits.size(), '0');
  return digits + ".npz";
}

void addWalk(const BatchFolder& batch, const std::string& key, NpyArchive& archive) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(batch.folderOf(key)))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    const std::string bytes = readWholeFile(file, kPackedKind);
    if (file.extension() != ".npz") {
      archive.addFile(key + "/" + file.filename().string(), bytes);
      continue;
    }
    // Names of walk.npz beside those of labels.npz.
    const std::string below = file.filename() == "labels.npz" ? "" : file.stem().string() + "/";
    for (const ZipEntry& entry : readStoredZip(bytes, file.string()))
      archive.addFile(key + "/" + below + entry.name, entry.bytes);
  }
}

// Packs are numbered without a gap.
void removeFrom(const fs::path& folder, size_t pack) {
  std::error_code error;
  while (fs::remove(folder / packName(pack), error)) ++pack;
}

}  // namespace

void packBatch(const BatchFolder& batch, const std::vector<std::string>& keys) {
  const fs::path folder = batch.root() / "packs";
  std::error_code error;
  fs::create_directories(folder, error);
  size_t packs = 0;
  for (size_t first = 0; first < keys.size(); first += kWalksInPack, ++packs) {
    NpyArchive archive;
    for (size_t i = first; i < std::min(keys.size(), first + kWalksInPack); ++i)
      addWalk(batch, keys[i], archive);
    writeFile(folder / packName(packs), [&](std::ostream& out) { archive.write(out); });
  }
  writeFile(folder / "index.csv", [&](std::ostream& out) {
    out << "item,walk,pack\r\n";
    for (size_t i = 0; i < keys.size(); ++i)
      out << i << ',' << keys[i] << ',' << packName(i / kWalksInPack) << "\r\n";
  });
  removeFrom(folder, packs);
}

}  // namespace amble
