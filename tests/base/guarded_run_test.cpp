#include "base/guarded_run.h"

#include <gtest/gtest.h>

#include <csignal>
#include <stdexcept>
#include <vector>

namespace amble {
namespace {

TEST(GuardedRun, WorkThatEndsBadlyHasNoResult) {
  EXPECT_FALSE(runGuarded([]() -> std::string { throw std::runtime_error("no"); }));
  EXPECT_FALSE(runGuarded([]() -> std::string { std::abort(); }));
  EXPECT_FALSE(runGuarded([]() -> std::string {
    std::raise(SIGSEGV);
    return "";
  }));
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
  EXPECT_FALSE(runGuarded(fill(size_t{256} << 20), limits));
  EXPECT_EQ(runGuarded(fill(size_t{1} << 20), limits), "x");
}

TEST(GuardedRun, TimeIsBounded) {
  GuardLimits limits;
  limits.cpu_time = 1;
  EXPECT_FALSE(runGuarded(
      []() -> std::string {
        const volatile bool forever = true;
        while (forever) {
        }
        return "";
      },
      limits));
}

TEST(GuardedRun, TheResultComesBackWhateverItsLength) {
  for (const size_t length : {size_t{0}, size_t{1}, size_t{1} << 16, size_t{10} << 20}) {
    const std::string bytes(length, '\0');
    EXPECT_EQ(runGuarded([&] { return bytes; }), bytes);
  }
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
