/// A queue of which the least comes out first, for searches over large maps (R. B. Dial,
/// "Algorithm 360: shortest-path forest with topological ordering", Communications of the ACM 12,
/// 1969).
///
/// Entries lie in buckets by their value, each as broad as `breadth`; only of the bucket that is
/// emptied there is a heap. What comes out is the same as of one heap of all entries, by value and
/// then by number, to the last; but where what is put in is hardly ever less than what came out
/// last, at the cost of a heap of one bucket's entries.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

namespace amble {

class BucketQueue {
 public:
  static constexpr float kMostBuckets = 1 << 18;

  /// @param breadth  of a bucket [> 0]. There is one for each from 0 to the greatest value, but the
  /// last of kMostBuckets holds all that is greater.
  explicit BucketQueue(float breadth) : per_breadth_(1.0f / breadth) {}

  bool empty() const { return size_ == 0; }
  /// @param value  [>= 0, finite]; @param number  [>= 0]
  void push(float value, int number) {
    ++size_;
    const auto bucket = static_cast<size_t>(std::min(value * per_breadth_, kMostBuckets - 1.0f));
    if (bucket <= now_) {
      heap_.push_back(keyOf(value, number));
      std::push_heap(heap_.begin(), heap_.end(), std::greater<>());
      return;
    }
    if (bucket >= buckets_.size()) buckets_.resize(std::max(bucket + 1, 2 * buckets_.size()));
    std::vector<std::uint64_t>& entries = buckets_[bucket];
    if (entries.capacity() == 0 && !emptied_.empty()) {
      entries = std::move(emptied_.back());
      emptied_.pop_back();
    }
    entries.push_back(keyOf(value, number));
  }
  /// A number that comes out soon, likely next; -1: none is known.
  int soon() const {
    if (!heap_.empty()) return numberOf(heap_.front());
    for (size_t i = now_ + 1; i < std::min(buckets_.size(), now_ + 1 + kLookedAt); ++i)
      if (!buckets_[i].empty()) return numberOf(buckets_[i].front());
    return -1;
  }
  /// The number of the least, which is taken out. @pre not empty()
  int pop() {
    while (heap_.empty()) goOn();
    --size_;
    std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
    const std::uint64_t key = heap_.back();
    heap_.pop_back();
    return numberOf(key);
  }

 private:
  // Values are not negative: their bits come in their order.
  static std::uint64_t keyOf(float value, int number) {
    return static_cast<std::uint64_t>(std::bit_cast<std::uint32_t>(value)) << 32 |
           static_cast<std::uint32_t>(number);
  }
  static int numberOf(std::uint64_t key) { return static_cast<int>(key & 0xffffffffu); }
  void goOn() {
    heap_.swap(buckets_[++now_]);
    if (buckets_[now_].capacity() > 0) emptied_.push_back(std::move(buckets_[now_]));
    std::make_heap(heap_.begin(), heap_.end(), std::greater<>());
  }

  static constexpr size_t kLookedAt = 8;  // buckets for what comes out soon

  float per_breadth_;
  size_t size_ = 0, now_ = 0;
  std::vector<std::uint64_t> heap_;  // of the bucket now_, and of what came later and is less
  std::vector<std::vector<std::uint64_t>> buckets_;  // those after now_
  std::vector<std::vector<std::uint64_t>> emptied_;  // storage to be used again
};

}  // namespace amble
