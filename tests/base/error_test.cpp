#include "base/error.h"

#include <gtest/gtest.h>

namespace amble {
namespace {

TEST(InputError, IsOneLineOfFileLineProblemAndWhatWasExpected) {
  EXPECT_STREQ(InputError("a.yaml", 3, "is x", "y").what(), "a.yaml:3: is x; expected y");
}

TEST(InputError, LeavesOutWhatIsNotKnown) {
  EXPECT_STREQ(InputError("a.yaml", 0, "is missing").what(), "a.yaml: is missing");
}

TEST(InputError, StaysOneLineWhateverAFileHolds) {
  const InputError error("a\nb", 1, "key 'x\ny\t\x1b[31m'", "z");
  EXPECT_STREQ(error.what(), "a b:1: key 'x y  [31m'; expected z");
  EXPECT_EQ(error.problem(), "key 'x\ny\t\x1b[31m'");
}

}  // namespace
}  // namespace amble
