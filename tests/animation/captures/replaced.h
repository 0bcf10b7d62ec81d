/// A text that is a little other than it was.
#pragma once

#include <gtest/gtest.h>

#include <string>

namespace amble {

/// `text` with `to` in the first place of `from`, which must be in it.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

}  // namespace amble
