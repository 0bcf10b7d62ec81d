#include "base/freed_memory.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <string>
#include <vector>

#include "base/guarded_run.h"

namespace amble {
namespace {

long pageFaults() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_minflt;
}

// In a process of its own, which it changes.
TEST(KeepFreedMemory, WhatWasFreedIsHandedOutAgainWithoutTheSystem) {
#if defined(__SANITIZE_ADDRESS__) || !defined(__GLIBC__)
  GTEST_SKIP() << "memory is not glibc's";
#endif
  constexpr size_t kBytes = size_t{16} << 20, kSmallPage = 4096;
  const GuardedAnswer answer = runGuarded([] {
    keepFreedMemory(2 * kBytes - 1);
    std::string faults;
    for (int round = 0; round < 2; ++round) {
      const long before = pageFaults();
      const std::vector<char> filled(kBytes, 'x');
      faults += std::to_string(pageFaults() - before) + " ";
    }
    return faults;
  });
  ASSERT_TRUE(answer.done());
  EXPECT_GT(std::stol(answer.bytes), 0);  // it was asked for, and filled
  const long again = std::stol(answer.bytes.substr(answer.bytes.find(' ')));
  EXPECT_LT(again, static_cast<long>(kBytes / kSmallPage) / 50) << answer.bytes;
}

// Whoever keeps memory and starts work that may fill little.
TEST(KeepFreedMemory, WhatAProcessKeepsIsNotForItsGuardedWork) {
#if defined(__SANITIZE_ADDRESS__) || !defined(__GLIBC__)
  GTEST_SKIP() << "memory is not glibc's";
#endif
  constexpr size_t kKept = size_t{30} << 20, kAllowed = size_t{2} << 20, kWanted = size_t{28} << 20;
  const GuardedAnswer keeper = runGuarded([] {
    keepFreedMemory(kKept);
    GuardLimits limits;
    limits.memory = kAllowed;
    const GuardedAnswer answer =
        runGuarded([] { return std::string(kWanted, 'x').substr(0, 1); }, limits);
    return std::string(answer.end == GuardEnd::kMemory ? "bounded" : "not");
  });
  ASSERT_TRUE(keeper.done());
  EXPECT_EQ(keeper.bytes, "bounded");
}

}  // namespace
}  // namespace amble
