#include "base/guarded_run.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <stdexcept>
#include <thread>
#include <vector>

namespace amble {
namespace {

std::string forever() {
  const volatile bool on = true;
  while (on) std::this_thread::yield();
  return "";
}

TEST(GuardedRun, WorkThatEndsBadlyHasNoResult) {
  const auto end = [](const std::function<std::string()>& work) { return runGuarded(work).end; };
  EXPECT_EQ(end([]() -> std::string { throw std::runtime_error("no"); }), GuardEnd::kBroken);
  EXPECT_EQ(end([]() -> std::string { std::abort(); }), GuardEnd::kBroken);
  EXPECT_EQ(end([]() -> std::string {
              std::raise(SIGSEGV);
              return "";
            }),
            GuardEnd::kBroken);
}

TEST(GuardedRun, MemoryIsBounded) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "a sanitizer's memory has no bound";
#endif
  GuardLimits limits;
  limits.memory = size_t{64} << 20;
  const auto fill = [](size_t bytes) {
    return [bytes]() -> std::string {
      const std::vector<char> much(bytes, 'x');
      return {much.back()};
    };
  };
  const GuardedAnswer much = runGuarded(fill(size_t{256} << 20), limits);
  EXPECT_EQ(much.end, GuardEnd::kMemory);
  EXPECT_EQ(much.why(limits), "it fills more than 64 MB of memory");
  EXPECT_EQ(runGuarded(fill(size_t{1} << 20), limits).bytes, "x");
}

TEST(GuardedRun, MemoryThatTheWorkItselfWouldForgiveIsBoundedToo) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "a sanitizer's memory has no bound";
#endif
  GuardLimits limits;
  limits.memory = size_t{64} << 20;
  const auto forgiving = []() -> std::string {
    try {
      return {std::vector<char>(size_t{256} << 20, 'x').back()};
    } catch (const std::bad_alloc&) {
      return "forgiven";
    }
  };
  EXPECT_EQ(runGuarded(forgiving, limits).end, GuardEnd::kMemory);
}

TEST(GuardedRun, TimeIsBounded) {
  GuardLimits limits;
  limits.cpu_time = 1;
  const GuardedAnswer answer = runGuarded(forever, limits);
  EXPECT_EQ(answer.end, GuardEnd::kTime);
  EXPECT_EQ(answer.why(limits), "it takes more than 1 s");
}

TEST(GuardedRun, WorkEndsWhenItsCallerWantsNoMore) {
  int asked = 0;
  GuardLimits limits;
  limits.stopped = [&asked] { return ++asked == 3; };
  EXPECT_EQ(runGuarded(forever, limits).end, GuardEnd::kStopped);
}

TEST(GuardedRun, TheResultComesBackWhateverItsLength) {
  for (const size_t length : {size_t{0}, size_t{1}, size_t{1} << 16, size_t{10} << 20}) {
    const std::string bytes(length, '\0');
    EXPECT_EQ(runGuarded([&] { return bytes; }).bytes, bytes);
  }
}

// Each waits for a word of the other's: done one after the other, the first would wait for good.
TEST(GuardedWork, SeveralAreDoneAtOnce) {
  std::array<int, 2> forth, back;
  ASSERT_EQ(pipe(forth.data()), 0);
  ASSERT_EQ(pipe(back.data()), 0);
  const auto greet = [](int to, int from) {
    char word = 'x';
    const bool met = write(to, &word, 1) == 1 && read(from, &word, 1) == 1;
    return std::string(met ? "met" : "alone");
  };
  GuardedWork one([&] { return greet(forth[1], back[0]); });
  GuardedWork other([&] { return greet(back[1], forth[0]); });
  EXPECT_EQ(one.answer().bytes, "met");
  EXPECT_EQ(other.answer().bytes, "met");
  for (const int end : {forth[0], forth[1], back[0], back[1]}) close(end);
}

TEST(GuardedWork, WhatNobodyAsksForEndsWithItsOwner) {
  std::array<int, 2> ends;
  ASSERT_EQ(pipe(ends.data()), 0);
  {
    const GuardedWork work(forever);
    close(ends[1]);
  }
  char word = 0;  // the copy held the other end of the pipe, and would for its minute of time
  EXPECT_EQ(read(ends[0], &word, 1), 0);
  close(ends[0]);
}

TEST(GuardedRun, NothingElseOfTheWorkIsSeen) {
  int changed = 0;
  testing::internal::CaptureStderr();
  runGuarded([&] {
    changed = 1;
    std::fputs("noise", stderr);
    std::fflush(stderr);
    return std::string();
  });
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(changed, 0);
}

}  // namespace
}  // namespace amble
