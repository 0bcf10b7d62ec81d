#include "base/error.h"

#include <utility>

#include "base/text.h"

namespace amble {
namespace {

std::string oneLine(const std::string& file, int line, const std::string& problem,
                    const std::string& expected) {
  std::string text = file;
  if (line > 0) text += ":" + std::to_string(line);
  text += ": " + problem;
  if (!expected.empty()) text += "; expected " + expected;
  return withoutControls(std::move(text));  // which a file that is quoted may hold
}

}  // namespace

InputError::InputError(std::string file, int line, std::string problem, std::string expected)
    : std::runtime_error(oneLine(file, line, problem, expected)),
      file_(std::move(file)),
      line_(line),
      problem_(std::move(problem)),
      expected_(std::move(expected)) {}

}  // namespace amble
