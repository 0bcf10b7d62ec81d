#include "animation/library/foot_numbers.h"

#include <algorithm>
#include <cassert>

namespace amble {
namespace {

constexpr int kPitches = FootCycle::kStanceSamples + FootCycle::kSwingSamples;

// Calls `take` with each stretch of numbers in turn: where they begin, and how many they are.
template <typename Foot, typename Take>
void eachStretch(Foot& foot, const Take& take) {
  take(&foot.slip, size_t{1});
  for (auto* terms : {&foot.progress, &foot.height, &foot.sideways, &foot.roll, &foot.yaw}) {
    take(terms->data(), terms->size());
  }
  take(foot.toes.data(), foot.toes.size());
  take(foot.pitch.data(), foot.pitch.size());
}

}  // namespace

int footNumberCount() {
  return 1 + 5 * static_cast<int>(FootCycle().progress.size()) + FootCycle::kToeSplines + kPitches;
}

Eigen::RowVectorXd footNumbers(const FootCycle& foot) {
  assert(static_cast<int>(foot.pitch.size()) == kPitches);
  Eigen::RowVectorXd numbers(footNumberCount());
  double* to = numbers.data();
  eachStretch(foot, [&](const double* from, size_t count) { to = std::copy_n(from, count, to); });
  return numbers;
}

FootCycle footOf(const Eigen::RowVectorXd& numbers) {
  assert(numbers.size() == footNumberCount());
  FootCycle foot;
  foot.pitch.resize(kPitches);
  const double* from = numbers.data();
  eachStretch(foot, [&](double* to, size_t count) {
    std::copy_n(from, count, to);
    from += count;
  });
  return foot;
}

}  // namespace amble
