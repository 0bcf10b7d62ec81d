/// What is wrong with the input, where, and what was expected: the one error type that readers
/// throw.
#pragma once

#include <stdexcept>
#include <string>

namespace amble {

/// Thrown for bad input only (DESIGN.md, section 4): a refusal of the planner is a value, not an
/// error. what() is one line: `FILE:LINE: what is wrong; what was expected`, without `:LINE` where
/// there is none and without `; ...` where nothing was expected.
class InputError : public std::runtime_error {
 public:
  /// @param line  1 for the first line; 0 where a line makes no sense (a missing file) [>= 0].
  InputError(std::string file, int line, std::string problem, std::string expected = "");

  const std::string& file() const { return file_; }
  int line() const { return line_; }
  const std::string& problem() const { return problem_; }
  const std::string& expected() const { return expected_; }

 private:
  std::string file_;
  int line_;
  std::string problem_;
  std::string expected_;
};

}  // namespace amble
