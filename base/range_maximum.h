/// The greatest of any run of values, in constant time, from a table of those of 1, 2, 4, ...
/// values.
#pragma once

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>
#include <vector>

namespace amble {

class RangeMaximum {
 public:
  explicit RangeMaximum(std::vector<double> values = {}) {
    const size_t count = values.size();
    levels_.push_back(std::move(values));
    for (size_t length = 2; length <= count; length *= 2) {
      const std::vector<double>& half = levels_.back();
      std::vector<double> level(count - length + 1);
      for (size_t i = 0; i < level.size(); ++i) level[i] = std::max(half[i], half[i + length / 2]);
      levels_.push_back(std::move(level));
    }
  }

  /// Of the values from first to last, both included; -infinity where first > last.
  /// @pre 0 <= first, last < their number
  double over(int first, int last) const {
    if (first > last) return -std::numeric_limits<double>::infinity();
    const unsigned length = static_cast<unsigned>(last - first + 1);
    const int level = std::bit_width(length) - 1;
    const std::vector<double>& of = levels_[level];
    return std::max(of[first], of[last + 1 - (1 << level)]);
  }

 private:
  std::vector<std::vector<double>> levels_;
};

}  // namespace amble
