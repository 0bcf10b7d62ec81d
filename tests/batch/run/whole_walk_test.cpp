#include "batch/run/whole_walk.h"

#include "batch/run/batch_status.h"
#include "batch/run/check_batch.h"
#include "tests/batch/small_job.h"

namespace amble {
namespace {

namespace fs = std::filesystem;
using WholeWalk = SmallJob;

// Walks that are found, refused, and of a scene that is broken.
constexpr const char* kAllKinds =
    "scenes:\n"
    "  - {scene: scene.yaml, ways: [{start: {at: [0.8, 1.5]}, goal: {at: [2, 1]}}]}\n"
    "  - {scene: walled.yaml, ways: [{start: {at: [0.8, 1.5]}, goal: {at: [5.2, 1.5]}}]}\n"
    "  - {scene: none.yaml, ways: [{start: {at: [0.8, 1.5]}, goal: {at: [5.2, 1.5]}}]}\n"
    "fps: 30\n";

void writeWalled(const std::function<void(const std::string&, const std::string&)>& write,
                 const std::string& scene) {
  write("walled.yaml",
        scene + "  - {name: wall, box: {size: [0.1, 3, 2.5]}, at: [4, 1.5, 1.25]}\n");
}

TEST_F(WholeWalk, HoldsTheFilesThatAreToldByFormatsAndStatus) {
  writeWalled([&](const auto& name, const auto& text) { write(name, text); }, kScene);
  int folder = 0;
  for (const char* formats : {"[bvh, json, labels]", "[json]", "[labels]", "[bvh]"}) {
    const BatchJob walks = job(std::string(kAllKinds) + "formats: " + formats + "\n");
    const std::string out = "out-" + std::to_string(folder++);
    make(walks, out);
    std::set<std::string> statuses;
    for (const WalkRow& row : rows(walks, out)) {
      statuses.insert(row.status);
      const std::vector<std::string> told = filesOfWalk(walks, row);
      std::set<std::string> there;
      for (const auto& [file, bytes] : filesIn(out + "/" + BatchFolder::nameOf(row.key).string()))
        there.insert(file);
      EXPECT_EQ(there, std::set<std::string>(told.begin(), told.end())) << formats << row.status;
      EXPECT_TRUE(isWhole(walks, BatchFolder(folder_ / out), row.key));
    }
    EXPECT_EQ(statuses, (std::set<std::string>{"error", "no_walk", "solved"}));
  }
}

// Whatever file is lost, everybody who asks notices, and a run brings its bytes back.
TEST_F(WholeWalk, AFileThatIsLostIsMissedByAllAndMadeAgain) {
  const BatchJob walks = twoRooms();
  make(walks, "out");
  mergeBatch(walks, folder_ / "out", {});
  const auto before = filesIn("out");
  const std::string key = rows(walks, "out")[2].key;
  const fs::path folder = folder_ / "out" / BatchFolder::nameOf(key);
  for (const char* file : {"labels.npz", "labels.json", "walk.bvh", "report.json", "row.json"}) {
    ASSERT_TRUE(fs::remove(folder / file)) << file;
    EXPECT_EQ(batchStatus(walks, folder_ / "out", {}).there, 3) << file;
    EXPECT_EQ(mergeBatch(walks, folder_ / "out", {}).missing, 1) << file;
    const std::string said = inputError([&] { checkBatch(walks, folder_ / "out", 100, 1, {}); });
    EXPECT_TRUE(holds(said, "walk 2 of the job is missing")) << file << said;
    const BatchSummary again = make(walks, "out");
    EXPECT_EQ(again.made, 1) << file;
    EXPECT_EQ(again.kept, 3) << file;
    EXPECT_EQ(filesIn("out"), before) << file;
  }
}

TEST_F(WholeWalk, AFolderInPlaceOfAFileIsNoFile) {
  const BatchJob walks = twoRooms();
  make(walks, "out");
  const std::string key = rows(walks, "out")[0].key;
  const fs::path file = folder_ / "out" / BatchFolder::nameOf(key) / "labels.npz";
  fs::remove(file);
  fs::create_directory(file);
  EXPECT_FALSE(isWhole(walks, BatchFolder(folder_ / "out"), key));
}

// It is not remade behind the back of who wrote it: who reads it says what is wrong.
TEST_F(WholeWalk, ARowThatCannotBeReadIsThereAndSaysSoWhenItIsRead) {
  const BatchJob walks = twoRooms();
  make(walks, "out");
  const std::string key = rows(walks, "out")[0].key;
  write("out/" + BatchFolder::nameOf(key).string() + "/row.json", "{\"walk\": 3}\n");
  EXPECT_EQ(make(walks, "out").kept, 4);
  EXPECT_TRUE(holds(inputError([&] { mergeBatch(walks, folder_ / "out", {}); }),
                    "row.json:1: is no row of a batch"));
}

}  // namespace
}  // namespace amble
