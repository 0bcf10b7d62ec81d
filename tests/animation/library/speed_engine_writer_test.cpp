#include "animation/library/speed_engine_writer.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "animation/library/speed_engine_reader.h"
#include "base/error.h"
#include "test_paths.h"
#include "tests/animation/drawn_engine.h"

namespace amble {
namespace {

/// A folder of the test's own, with an engine in it.
class EngineFile : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) / (std::string("amble_") + test->name());
    std::filesystem::remove_all(folder_);
    file_ = folder_ / "new/drawn.yaml";
    writeSpeedEngine(DrawnEngine().data({0.8, 1.2, 1.6}, {2.6}), file_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string text() const {
    std::ifstream in(file_, std::ios::binary);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
  }
  /// With this instead of that, the file is refused at a line, with these words.
  void expectRefused(const std::string& that, const std::string& instead,
                     const std::string& words) const {
    std::string bad = text();
    const size_t at = bad.find(that);
    ASSERT_NE(at, std::string::npos) << that;
    bad.replace(at, that.size(), instead);
    const std::filesystem::path file = file_.parent_path() / "bad.yaml";
    std::ofstream(file) << bad;
    try {
      readSpeedEngine(file);
      FAIL() << instead << " was taken";
    } catch (const InputError& error) {
      EXPECT_GT(error.line(), 0);
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  }

  std::filesystem::path folder_, file_;
};

TEST_F(EngineFile, OfWrongContentIsRefusedWithItsLine) {
  expectRefused("stature:", "statur: 1.7\nstature:", "statur");
  expectRefused("power: 0.5", "power: .nan", "power");
  expectRefused("law: {", "lawn: {", "lawn");
  expectRefused("speed: 1.2", "speed: 0.7", "slower than the clip before");
  expectRefused("share: 1", "share: 1.2", "share");
  const std::string whole = text();
  const size_t walk = whole.find("\nwalk:");
  expectRefused(whole.substr(walk), "\n", "neither walks nor runs");
}

TEST_F(EngineFile, ADirectionThatIsNoneIsRefused) {
  const std::string whole = text();
  const size_t begin = whole.find("direction:"), row = whole.find("- [", begin);
  // Rows of the drawn engine are zeros but those of the thighs.
  size_t moving = row;
  while (whole.compare(moving, 6, "- [0, ") == 0) moving = whole.find("- [", moving + 1);
  const size_t number = moving + 3, end = whole.find(',', number);
  expectRefused(whole.substr(moving, end - moving), "- [3", "a direction of length 1");
}

TEST_F(EngineFile, ReadsAsItWas) {
  const EngineData engine = readSpeedEngine(file_);
  const EngineData drawn = DrawnEngine().data({0.8, 1.2, 1.6}, {2.6});
  EXPECT_LT((engine.walk->mean - drawn.walk->mean).cwiseAbs().maxCoeff(), 1e-7);
  EXPECT_LT((engine.run->root - drawn.run->root).cwiseAbs().maxCoeff(), 1e-7);
  EXPECT_NEAR(engine.walk->toe_out[0].at_zero, drawn.walk->toe_out[0].at_zero, 1e-8);
  EXPECT_EQ(engine.walk->clips[1].source.licence, "none");
  EXPECT_EQ(engine.walk->clips[1].capture.joint_jerk, drawn.walk->clips[1].capture.joint_jerk);
  EXPECT_EQ(engine.stand_source.clip, "stand.bvh");
  EXPECT_EQ(engine.stand_source.frames, drawn.stand_source.frames);
  const std::string before = text();
  writeSpeedEngine(engine, file_);
  EXPECT_EQ(text(), before);
}

TEST_F(EngineFile, IsNotWrittenOverALibrary) {
  const std::filesystem::path library = folder_ / "default.yaml";
  std::filesystem::copy_file(
      std::filesystem::path(AMBLE_SOURCE_DIR) / "animation/motions/default.yaml", library);
  EXPECT_THROW(writeSpeedEngine(readSpeedEngine(file_), library), InputError);
}

}  // namespace
}  // namespace amble
