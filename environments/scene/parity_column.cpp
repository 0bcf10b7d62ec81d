#include "environments/scene/parity_column.h"

#include <algorithm>

namespace amble {

ParityColumn::ParityColumn(const Eigen::Vector2d& at, double beside,
                           std::vector<const Parity*> solids)
    : at_(at), reach_(beside / Parity::kShear), solids_(std::move(solids)) {}

void ParityColumn::castFrom(double z) {
  last_ = z + reach_;
  steps_.clear();
  depth_.clear();
  inside_ = 0;
  next_ = 0;
  for (size_t k = 0; k < solids_.size(); ++k) {
    crossings_.clear();
    depth_.push_back(solids_[k]->addCrossings({at_.x(), at_.y(), z}, crossings_));
    inside_ += depth_[k] > 0;
    for (const Parity::Crossing& c : crossings_)
      steps_.push_back({c.height, static_cast<int>(k), c.change});
  }
  std::sort(steps_.begin(), steps_.end(),
            [](const Step& a, const Step& b) { return a.height < b.height; });
}

bool ParityColumn::isInside(double z) {
  if (z > last_) castFrom(z);
  for (; next_ < steps_.size() && steps_[next_].height < z; ++next_) {
    int& depth = depth_[steps_[next_].solid];
    const int before = depth;
    depth += steps_[next_].change;
    inside_ += (depth > 0) - (before > 0);
  }
  return inside_ > 0;
}

}  // namespace amble
