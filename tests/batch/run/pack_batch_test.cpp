#include "batch/run/pack_batch.h"

#include "tests/batch/small_job.h"
#include "viz/exchange/stored_zip.h"

namespace amble {
namespace {

using PackBatch = SmallJob;

TEST_F(PackBatch, HoldsEveryFileOfEveryWalk) {
  const BatchJob walks = twoRooms();
  make(walks, "out");
  BatchOptions options;
  options.pack = true;
  mergeBatch(walks, folder_ / "out", options);
  std::map<std::string, std::string> packed;
  for (const ZipEntry& entry : readStoredZip(read(folder_ / "out/packs/00000.npz"), "pack"))
    packed[entry.name] = entry.bytes;
  size_t count = 0;
  for (const auto& [file, bytes] : filesIn("out/walks")) {
    const std::string name = file.substr(file.find('/') + 1);  // without the folder of folders
    if (!name.ends_with(".npz")) {
      EXPECT_EQ(packed.at(name), bytes);
      ++count;
      continue;
    }
    for (const ZipEntry& array : readStoredZip(bytes, file)) {
      EXPECT_EQ(packed.at(name.substr(0, name.find('/') + 1) + array.name), array.bytes);
      ++count;
    }
  }
  EXPECT_EQ(packed.size(), count);
}

TEST_F(PackBatch, OfAShorterJobLeavesNoneOfALongerOne) {
  const BatchJob walks = twoRooms();
  make(walks, "out");
  write("out/packs/00001.npz", "of a longer job");
  packBatch(BatchFolder(folder_ / "out"), keysOfItems(walks, listItems(walks), {}));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "out/packs/00000.npz"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out/packs/00001.npz"));
}

}  // namespace
}  // namespace amble
