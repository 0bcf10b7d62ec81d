#include "base/error.h"

#include <utility>

namespace amble {
namespace {

std::string oneLine(const std::string& file, int line, const std::string& problem,
                    const std::string& expected) {
  std::string text = file;
  if (line > 0) text += ":" + std::to_string(line);
  text += ": " + problem;
  if (!expected.empty()) text += "; expected " + expected;
  // A message quotes what a file holds, and that may hold anything.
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  }
  return text;
}

}  // namespace

InputError::InputError(std::string file, int line, std::string problem, std::string expected)
    : std::runtime_error(oneLine(file, line, problem, expected)),
      file_(std::move(file)),
      line_(line),
      problem_(std::move(problem)),
      expected_(std::move(expected)) {}

}  // namespace amble
