/// Disjoint sets of numbers that are joined step by step (Galler and Fischer 1964).
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace amble {

class UnionFind {
 public:
  /// 0 .. count - 1, each alone [>= 0].
  explicit UnionFind(int count) : parent_(static_cast<size_t>(count)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  int size() const { return static_cast<int>(parent_.size()); }
  /// The smallest number of the set that holds i, so that sets come in the order of their members.
  int find(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// Makes the sets of both one. @return whether they were two
  bool join(int a, int b) {
    a = find(a);
    b = find(b);
    parent_[std::max(a, b)] = std::min(a, b);
    return a != b;
  }

 private:
  std::vector<int> parent_;  // each on the way to the smallest of its set, never larger than itself
};

}  // namespace amble
