#include "base/child_program.h"

#include <gtest/gtest.h>

#include <sstream>
#include <system_error>

namespace amble {
namespace {

const std::string kShell = "/bin/sh";

std::string resultOf(ChildProgram& program) {
  std::ostringstream out;
  program.writeResult(out);
  return out.str();
}

TEST(ChildProgram, ProgramsAreFoundOnThePath) {
  EXPECT_EQ(findProgram("sh").filename(), "sh");
  EXPECT_TRUE(findProgram("no-such-program-anywhere").empty());
  EXPECT_TRUE(findProgram("").empty()) << "a folder is none";
}

TEST(ChildProgram, MakesOfWhatItIsFed) {
  ChildProgram program(kShell, {"-c", "tr a-z A-Z >/dev/fd/3"});
  std::string much;
  for (int i = 0; i < 100000; ++i) much += "words ";
  EXPECT_TRUE(program.feed(much));
  EXPECT_EQ(program.finish(), 0);
  const std::string made = resultOf(program);
  EXPECT_EQ(made.size(), much.size());
  EXPECT_EQ(made.substr(0, 12), "WORDS WORDS ");
}

TEST(ChildProgram, OneThatEndsIsFedNoMoreAndEndsNobodyElse) {
  ChildProgram program(kShell, {"-c", "printf 'it\\033 broke\\nmore' >&2; exit 7"});
  bool taken = true;
  for (int i = 0; i < 1000 && taken; ++i) taken = program.feed(std::string(1 << 16, 'x'));
  EXPECT_FALSE(taken);
  EXPECT_EQ(program.finish(), 7);
  EXPECT_EQ(program.complaint(), "it  broke");
}

TEST(ChildProgram, OneThatCannotBeStartedIsAnError) {
  EXPECT_THROW(ChildProgram("/no/such/program", {}), std::system_error);
}

}  // namespace
}  // namespace amble
