// What the program shows while it works, and how it is stopped.

#include <algorithm>

#include "tests/app/program.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

class Terminal : public InRoom {
 protected:
  void SetUp() override {
    InRoom::SetUp();
    if (run("", "command -v script || exit 9;").status == 9) GTEST_SKIP() << "no script(1) here";
    makeEndless();
  }
  // Long enough for a bar to be drawn, however busy the machine is.
  const std::string search_ = "plan in/scenario.yaml -o out --time-limit 4";
};

TEST_F(Terminal, ABarIsDrawnAndIsGoneBeforeTheResult) {
  const Ran ran = onTerminal(search_, "unset NO_COLOR;");
  EXPECT_EQ(ran.status, 1) << ran.out;
  const size_t bar = ran.out.rfind("\r\033[36m["), gone = ran.out.rfind("\r\033[K");
  const size_t result = ran.out.find("scenario: no_walk");
  ASSERT_TRUE(bar != std::string::npos && gone != std::string::npos) << ran.out;
  ASSERT_NE(result, std::string::npos) << ran.out;
  EXPECT_LT(bar, gone);
  EXPECT_EQ(gone + 4, result) << ran.out;
  EXPECT_TRUE(holds(ran.out, "guards, "));
}

TEST_F(Terminal, NoColourIsHonoured) {
  const Ran ran = onTerminal(search_, "export NO_COLOR=1;");
  EXPECT_TRUE(holds(ran.out, "\r["));
  EXPECT_FALSE(holds(ran.out, "\033[36m")) << ran.out;
}

TEST_F(Terminal, OneThatCanDoNothingGetsNoBar) {
  const Ran ran = onTerminal(search_, "export TERM=dumb;");
  EXPECT_FALSE(holds(ran.out, "\033")) << ran.out;
  EXPECT_FALSE(holds(ran.out, "\r[")) << ran.out;
}

TEST_F(Terminal, ElsewhereThereAreNoMarksInTheLog) {
  const Ran ran = run(search_);
  EXPECT_FALSE(holds(ran.err, "\r"));
  EXPECT_FALSE(holds(ran.err + ran.out, "\033"));
  EXPECT_LE(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << "a line in five seconds";
}

class Stopping : public InRoom {
 protected:
  // With the program's number in $pid.
  Ran during(const std::string& arguments, const std::string& what) const {
    return run(arguments + " & pid=$!; " + what + "; wait $pid");
  }
};

TEST_F(Stopping, WhoWaitsForAnInputEndsAtOnce) {
  const std::string fifo = "mkfifo pipe.yaml pipe.bvh;";
  for (const char* const command :
       {"plan pipe.yaml -o out", "check pipe.yaml", "inspect pipe.yaml", "analyse pipe.bvh",
        "convert pipe.bvh -o out.bvh", "validate pipe.bvh --scene in/room.yaml",
        "library add l.yaml pipe.bvh"}) {
    // A shell has its background jobs ignore Ctrl-C; SIGTERM is treated alike.
    const Ran ran = run(std::string(command) + " & pid=$!; sleep 0.3; kill -TERM $pid; wait $pid",
                        "rm -f pipe.*; " + fifo);
    EXPECT_EQ(ran.status, 130) << command << ": " << ran.err;
  }
  EXPECT_FALSE(fs::exists(folder_ / "out"));
  EXPECT_FALSE(fs::exists(folder_ / "out.bvh"));
  EXPECT_FALSE(fs::exists(folder_ / "l.yaml"));
}

TEST_F(Stopping, ASecondCtrlCEndsWhatGoesOn) {
  makeEndless();
  const Ran ran =
      during("plan in/scenario.yaml -o out", "sleep 1; kill -TERM $pid; kill -TERM $pid");
  EXPECT_EQ(ran.status, 130) << ran.err;
  for (const std::string& file : files()) EXPECT_FALSE(holds(file, ".part")) << file;
}

TEST_F(Stopping, WhoWasToldToIgnoreSignalsGoesOn) {
  const Ran ran =
      run("plan in/scenario.yaml -o out --formats bvh & pid=$!; sleep 0.05; "
          "kill -INT $pid; wait $pid",
          "trap '' INT;");
  EXPECT_EQ(ran.status, 0) << ran.err;
  EXPECT_TRUE(fs::exists(folder_ / "out/walk.bvh"));
}

TEST_F(Stopping, LoadingASceneIsStoppedToo) {
  // Thousands of boxes, so that it takes a while.
  std::string scene = kRoom;
  for (int i = 0; i < 20000; ++i) {
    scene += "  - {name: b" + std::to_string(i) + ", sphere: {radius: 0.01}, at: [" +
             std::to_string(0.001 * (i % 6000)) + ", 3.9, " + std::to_string(0.0001 * i) + "]}\n";
  }
  write("in/room.yaml", scene);
  const Ran ran = during("plan in/scenario.yaml -o out", "sleep 0.5; kill -TERM $pid");
  EXPECT_EQ(ran.status, 130) << ran.err;
  EXPECT_FALSE(fs::exists(folder_ / "out/walk.bvh"));
}

}  // namespace
}  // namespace amble
