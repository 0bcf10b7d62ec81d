#include "environments/scene/mesh_reader.h"

#include <algorithm>
#include <utility>

#include "base/byte_pack.h"
#include "base/error.h"
#include "base/parallel.h"
#include "environments/scene/mesh_header.h"
#include "environments/scene/mesh_import.h"
#include "environments/scene/obj_import.h"

namespace amble {
namespace {

// Time that reading may take: so much, and as much more as a slow machine needs for what is in the
// file [s, s a MiB]; by trial, three times what the slowest formats take.
constexpr int kLeastTime = 4;
constexpr int kTimeOfMiB = 1;

// What comes out of the guard: parts, or what was wrong.
struct Answer {
  MeshFile mesh;
  int line = 0;
  std::string problem, expected;
};

template <typename Pack, typename Mesh>
void visitMesh(Pack& pack, Mesh& mesh) {
  pack(mesh.vertices);
  size_t count = mesh.triangles.size();
  pack(count);
  mesh.triangles.resize(count);
  for (auto& t : mesh.triangles) pack(t);
}

template <typename Pack>
void visitAnswer(Pack& pack, Answer& answer) {
  pack(answer.line);
  pack(answer.problem);
  pack(answer.expected);
  pack(answer.mesh.has_axes);
  pack(answer.mesh.others);
  pack(answer.mesh.warnings);
  size_t count = answer.mesh.parts.size();
  pack(count);
  answer.mesh.parts.resize(count);
  for (MeshPart& part : answer.mesh.parts) {
    pack(part.names);
    visitMesh(pack, part.mesh);
  }
}

Answer readUnguarded(const std::filesystem::path& file) {
  try {
    if (meshEnding(file) == ".obj")
      return {parseObj(readWholeFile(file, kMeshFile), file.string()), 0, {}, {}};
    checkMeshHeader(file);
    return {importMesh(file), 0, {}, {}};
  } catch (const InputError& error) {
    return {{}, error.line(), error.problem(), error.expected()};
  }
}

// The answers of all, in their order.
GuardedWork beginReading(const std::vector<std::filesystem::path>& files,
                         const GuardLimits& limits) {
  return GuardedWork(
      [&] {
        Packer pack;
        for (const std::filesystem::path& file : files) {
          Answer answer = readUnguarded(file);
          visitAnswer(pack, answer);
        }
        return pack.bytes();
      },
      limits);
}

bool isSmallMesh(const std::filesystem::path& file) {
  std::error_code error;
  return std::filesystem::is_regular_file(file, error) && isMeshEnding(meshEnding(file)) &&
         std::filesystem::file_size(file, error) <= kSmallMesh && !error;
}

// Each once, those of most bytes first.
std::vector<std::filesystem::path> smallOnes(const std::vector<std::filesystem::path>& files) {
  std::vector<std::pair<size_t, std::filesystem::path>> sized;
  for (const std::filesystem::path& file : files)
    if (isSmallMesh(file)) sized.emplace_back(std::filesystem::file_size(file), file);
  std::sort(sized.begin(), sized.end(), std::greater<>());
  sized.erase(std::unique(sized.begin(), sized.end()), sized.end());
  std::vector<std::filesystem::path> small;
  for (auto& [size, file] : sized) small.push_back(std::move(file));
  return small;
}

// As many shares as there are processors, of about as much work: each of what comes, which is
// sorted, goes where least is.
std::vector<std::vector<std::filesystem::path>> sharedOut(
    const std::vector<std::filesystem::path>& files) {
  if (files.size() < 2) return {};
  const size_t count = std::min<size_t>(files.size() / 2, usualThreads());
  std::vector<std::vector<std::filesystem::path>> shares(std::max<size_t>(1, count));
  std::vector<size_t> bytes(shares.size(), 0);
  for (const std::filesystem::path& file : files) {
    const size_t least = std::min_element(bytes.begin(), bytes.end()) - bytes.begin();
    bytes[least] += std::filesystem::file_size(file);
    shares[least].push_back(file);
  }
  return shares;
}

// What can be said without opening the file. Returns its size [bytes].
size_t requireMeshFile(const std::filesystem::path& file) {
  const std::string expected = std::string("a mesh as ") + kMeshFormats;
  std::error_code error;
  if (!std::filesystem::exists(file, error))
    throw InputError(file.string(), 0, "no such file", expected);
  if (!std::filesystem::is_regular_file(file, error))
    throw InputError(file.string(), 0, "is no regular file", expected);
  if (!isMeshEnding(meshEnding(file)))
    throw InputError(file.string(), 0, "not a format for meshes", kMeshFormats);
  const size_t size = std::filesystem::file_size(file);
  if (size > kMeshFile.limit)
    throw InputError(file.string(), 0, "is too large for a mesh",
                     "at most " + sizeText(kMeshFile.limit));
  return size;
}

}  // namespace

MeshFile readMesh(const std::filesystem::path& file, size_t memory,
                  const std::function<bool()>& stopped) {
  const size_t size = requireMeshFile(file);
  const GuardLimits limits{memory, kLeastTime + kTimeOfMiB * static_cast<int>(size >> 20), stopped};
  const GuardedAnswer guarded = beginReading({file}, limits).answer();
  if (!guarded.done())
    throw InputError(file.string(), 0, "cannot be read: " + guarded.why(limits),
                     guarded.end == GuardEnd::kMemory ? std::string(kMoreMemory)
                                                      : std::string("a mesh as ") + kMeshFormats);
  Unpacker unpack(guarded.bytes);
  Answer answer;
  visitAnswer(unpack, answer);
  if (!answer.problem.empty())
    throw InputError(file.string(), answer.line, answer.problem, answer.expected);
  return std::move(answer.mesh);
}

SmallMeshes::SmallMeshes(const std::vector<std::filesystem::path>& files, size_t memory,
                         const std::function<bool()>& stopped) {
  const std::vector<std::vector<std::filesystem::path>> shares = sharedOut(smallOnes(files));
  for (const std::vector<std::filesystem::path>& share : shares)
    shares_.push_back({share, beginReading(share, {memory / shares.size(), kLeastTime, stopped})});
}

std::map<std::filesystem::path, MeshFile> SmallMeshes::take() {
  std::map<std::filesystem::path, MeshFile> meshes;
  for (Share& share : shares_) {
    const GuardedAnswer guarded = share.reading.answer();
    if (!guarded.done()) continue;
    Unpacker unpack(guarded.bytes);
    for (const std::filesystem::path& file : share.files) {
      Answer answer;
      visitAnswer(unpack, answer);
      if (answer.problem.empty()) meshes.emplace(file, std::move(answer.mesh));
    }
  }
  return meshes;
}

}  // namespace amble
