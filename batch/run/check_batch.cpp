#include "batch/run/check_batch.h"

#include <algorithm>

#include "base/error.h"
#include "base/files.h"
#include "base/parallel.h"
#include "base/sample_stream.h"
#include "base/text.h"
#include "batch/labels/walk_row.h"
#include "batch/run/batch_folder.h"
#include "batch/run/merge_batch.h"
#include "batch/run/whole_walk.h"
#include "scenarios/validate_walk.h"

namespace amble {
namespace {

struct FoundWalk {
  BatchItem item;
  WalkRow row;
};

std::vector<FoundWalk> foundWalks(const BatchJob& job, const BatchFolder& batch,
                                  const LoadLimits& limits) {
  const std::vector<BatchItem> items = listItems(job);
  const std::vector<std::string> keys = keysOfItems(job, items, limits);
  std::vector<FoundWalk> walks;
  for (const BatchItem& item : items) {
    const std::string& key = keys[static_cast<size_t>(item.number)];
    if (!isWhole(job, batch, key)) {
      throw InputError(
          batch.root().string(), 0,
          "walk " + std::to_string(item.number) + " of the job is missing, or a file of it",
          "all of them: `amble batch` makes it");
    }
    WalkRow row = readRowOf(batch, key);
    if (row.status == "solved") walks.push_back({item, std::move(row)});
  }
  return walks;
}

// Each has the same chance (Knuth's selection sampling, The Art of Computer Programming 2, 3.4.2).
std::vector<FoundWalk> drawn(std::vector<FoundWalk> walks, int sample, std::uint64_t seed) {
  SampleStream stream(seed, 0);
  int left = static_cast<int>(walks.size()), wanted = std::min(sample, left);
  std::erase_if(walks, [&](const FoundWalk&) {
    const bool take = stream.uniform() * left-- < wanted;
    wanted -= take ? 1 : 0;
    return !take;
  });
  return walks;
}

CheckedWalk look(const BatchJob& job, const BatchFolder& batch, const FoundWalk& walk,
                 const LoadLimits& limits) {
  CheckedWalk checked;
  checked.item = walk.item.number;
  checked.key = walk.row.key;
  checked.scene = walk.row.scene;
  ValidateOptions how;
  how.metres_per_unit = 1.0;
  how.height = walk.row.height;
  how.load = limits;
  how.limits = job.limits;
  try {
    const WalkValidation found =
        validateWalk(batch.folderOf(walk.row.key) / "walk.bvh",
                     job.scenes[static_cast<size_t>(walk.item.scene)].file, how);
    checked.contacts = static_cast<int>(found.contacts.size());
    checked.clearance = found.clearance;
    if (!found.contacts.empty()) {
      const ContactSpan& first = found.contacts.front();
      checked.first =
          first.part + " and " + first.object + " at " + fixedNumber(first.start, 2) + " s";
    }
    if (found.frames != walk.row.frames)
      checked.wrong = "it has " + std::to_string(found.frames) + " frames; expected " +
                      std::to_string(walk.row.frames) + ", as its row says";
  } catch (const InputError& error) {
    checked.wrong = error.what();
  }
  return checked;
}

}  // namespace

std::vector<CheckedWalk> checkBatch(const BatchJob& job, const std::filesystem::path& folder,
                                    int sample, std::uint64_t seed, const BatchOptions& options) {
  if (std::find(job.formats.begin(), job.formats.end(), "bvh") == job.formats.end())
    throw InputError(job.file.string(), 0, "its walks are no BVH", "`bvh` among its formats");
  const BatchFolder batch(folder);
  const LoadLimits limits{options.memory, {options.stop, {}}};
  const std::vector<FoundWalk> walks = drawn(foundWalks(job, batch, limits), sample, seed);
  std::vector<CheckedWalk> checked(walks.size());
  parallelFor(static_cast<int>(walks.size()), options.threads, [&](int i, int) {
    limits.stop.check();
    checked[static_cast<size_t>(i)] = look(job, batch, walks[static_cast<size_t>(i)], limits);
  });
  return checked;
}

}  // namespace amble
