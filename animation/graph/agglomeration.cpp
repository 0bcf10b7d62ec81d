#include "animation/graph/agglomeration.h"

#include <algorithm>
#include <limits>

#include "base/parallel.h"

namespace amble {
namespace {

// So many comparisons are worth a second thread.
constexpr int kWorthATask = 1024;

/// Clusters in slots, each that of its latest frame.
class Agglomeration {
 public:
  Agglomeration(FrameFeatures features, int threads)
      : means_(std::move(features)),
        threads_(threads),
        count_(static_cast<int>(means_.cols())),
        frames_(count_, 1),
        nodes_(count_),
        nearest_(count_, -1),
        bound_(count_, kNone),
        exact_(count_, true),
        errors_(count_) {
    for (int i = 0; i < count_; ++i) {
      slots_.push_back(i);
      nodes_[i] = i;
    }
  }

  std::vector<Merge> merges(const StopRequest& stop) {
    parallelFor(count_, threads_, [&](int i, int) {
      stop.check();
      findFirst(i);
    });
    std::vector<Merge> merges;
    while (slots_.size() > 1) {
      stop.check();
      const int a = nearestPair(), b = nearest_[a];
      merges.push_back({nodes_[a], nodes_[b], bound_[a]});
      nodes_[b] = count_ + static_cast<int>(merges.size()) - 1;
      merge(a, b);
    }
    return merges;
  }

 private:
  static constexpr float kNone = std::numeric_limits<float>::infinity();

  float error(int i, int j) const { return frameError(means_, i, j); }

  void findFirst(int i) {
    for (int j = i + 1; j < count_; ++j) {
      const float e = error(i, j);
      if (e < bound_[i]) bound_[i] = e, nearest_[i] = j;
    }
  }

  // Into errors_: of a slot to those from place `first` of slots_ on.
  void compare(int slot, size_t first) {
    const int left = static_cast<int>(slots_.size() - first);
    const int tasks = threads_ == 1 ? 1 : std::clamp(left / kWorthATask, 1, 4 * threads_);
    parallelFor(tasks, threads_, [&](int task, int) {
      const size_t begin = first + static_cast<size_t>(left) * task / tasks;
      const size_t end = first + static_cast<size_t>(left) * (task + 1) / tasks;
      for (size_t k = begin; k < end; ++k) errors_[slots_[k]] = error(slot, slots_[k]);
    });
  }

  size_t placeOf(int slot) const {
    return std::lower_bound(slots_.begin(), slots_.end(), slot) - slots_.begin();
  }

  void findAgain(int slot) {
    const size_t first = placeOf(slot) + 1;
    compare(slot, first);
    takeNearest(slot, first);
  }

  void takeNearest(int slot, size_t first) {
    bound_[slot] = kNone;
    nearest_[slot] = -1;
    exact_[slot] = true;
    for (size_t k = first; k < slots_.size(); ++k) {
      const int j = slots_[k];
      if (errors_[j] < bound_[slot]) bound_[slot] = errors_[j], nearest_[slot] = j;
    }
  }

  // The first slot of the pair that is most alike. Bounds that are least are made exact until one
  // is both.
  int nearestPair() {
    while (true) {
      int least = slots_.front();
      for (const int slot : slots_)
        if (bound_[slot] < bound_[least]) least = slot;
      if (exact_[least]) return least;
      findAgain(least);
    }
  }

  // Slot a goes into slot b > a.
  void merge(int a, int b) {
    meanOf(means_.col(a).data(), frames_[a], means_.col(b).data(), frames_[b],
           means_.col(b).data());
    frames_[b] += frames_[a];
    slots_.erase(slots_.begin() + static_cast<ptrdiff_t>(placeOf(a)));
    compare(b, 0);
    for (const int slot : slots_) {
      if (slot >= b) break;
      const float e = errors_[slot];
      const bool lost = nearest_[slot] == a || nearest_[slot] == b;
      if (e < bound_[slot] || (e == bound_[slot] && exact_[slot] && !lost && b < nearest_[slot])) {
        bound_[slot] = e;
        nearest_[slot] = b;
        exact_[slot] = true;
      } else if (lost) {
        exact_[slot] = false;  // what it has is a bound for all that are left
      }
    }
    takeNearest(b, placeOf(b) + 1);
  }

  FrameFeatures means_;  // a column a slot
  const int threads_;
  const int count_;
  std::vector<int> slots_;     // those that are there, in order
  std::vector<int> frames_;    // by slot: frames in it
  std::vector<int> nodes_;     // its node of the tree
  std::vector<int> nearest_;   // the nearest slot behind it, the first of such; -1: none is there
  std::vector<float> bound_;   // error of that one, or less
  std::vector<char> exact_;    // whether it is that error; a byte each, for threads
  std::vector<float> errors_;  // of a comparison
};

}  // namespace

void meanOf(const float* a, int frames_a, const float* b, int frames_b, float* mean) {
  const float sum = static_cast<float>(frames_a + frames_b);
  const float of_a = static_cast<float>(frames_a) / sum, of_b = static_cast<float>(frames_b) / sum;
  for (int i = 0; i < kFeatureRows; ++i) mean[i] = of_a * a[i] + of_b * b[i];
}

std::vector<Merge> agglomerate(FrameFeatures features, int threads, const StopRequest& stop) {
  if (features.cols() == 0) return {};
  return Agglomeration(std::move(features), threads).merges(stop);
}

}  // namespace amble
