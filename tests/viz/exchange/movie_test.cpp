#include "viz/exchange/movie.h"

#include <gtest/gtest.h>

#include <atomic>
#include <sstream>

#include "tests/viz/test_walk.h"

namespace amble {
namespace {

constexpr FilmSettings kSmall{.width = 96, .height = 64, .rate = 5.0, .threads = 1};

// The boxes that a file begins with, one after another (ISO 14496-12), by their names.
std::vector<std::string> boxesOf(const std::string& bytes) {
  std::vector<std::string> names;
  size_t at = 0;
  while (at + 8 <= bytes.size()) {
    size_t size = 0;
    for (int i = 0; i < 4; ++i) size = size << 8 | static_cast<uint8_t>(bytes[at + i]);
    names.push_back(bytes.substr(at + 4, 4));
    if (size < 8) break;
    at += size;
  }
  EXPECT_EQ(at, bytes.size()) << "whole";
  return names;
}

class Movie : public testing::Test {
 protected:
  void SetUp() override {
    if (findFilmMaker().empty()) GTEST_SKIP() << "ffmpeg is not installed";
  }
  const std::unique_ptr<TestWalk> walk_ = makeTestWalk();
};

TEST_F(Movie, HasItsIndexBeforeItsPicturesAndIsWhole) {
  std::ostringstream out;
  writeMp4(out, walk_->view, figureOfTestWalk(), kSmall);
  const std::vector<std::string> boxes = boxesOf(out.str());
  ASSERT_GE(boxes.size(), 3u);
  EXPECT_EQ(boxes[0], "ftyp");
  EXPECT_EQ(boxes[1], "moov") << "so that it plays while it is loaded";
}

TEST_F(Movie, TheSameWalkGivesTheSameBytes) {
  std::ostringstream one, two;
  writeMp4(one, walk_->view, figureOfTestWalk(), kSmall);
  writeMp4(two, walk_->view, figureOfTestWalk(), kSmall);
  EXPECT_EQ(one.str(), two.str());
}

TEST_F(Movie, IsNoneWhereItIsStopped) {
  const std::atomic<bool> stop{true};
  std::ostringstream out;
  EXPECT_THROW(
      writeMp4(out, walk_->view, figureOfTestWalk(), kSmall, {.flag = &stop, .deadline = {}}),
      FilmStopped);
  EXPECT_EQ(out.str(), "");
}

}  // namespace
}  // namespace amble
