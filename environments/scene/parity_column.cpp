#include "environments/scene/parity_column.h"

#include <algorithm>

namespace amble {

ParityColumn::ParityColumn(const Eigen::Vector2d& at, double beside,
                           std::vector<const Parity*> solids)
    : at_(at), reach_(beside / Parity::kShear), solids_(std::move(solids)) {}

void ParityColumn::castFrom(double z) {
  last_ = z + reach_;
  crossings_.clear();
  odd_.assign(solids_.size(), 0);
  inside_ = 0;
  next_ = 0;
  for (size_t k = 0; k < solids_.size(); ++k) {
    heights_.clear();
    solids_[k]->addCrossings({at_.x(), at_.y(), z}, heights_);
    for (const double height : heights_) crossings_.emplace_back(height, static_cast<int>(k));
    odd_[k] = static_cast<char>(heights_.size() % 2);
    inside_ += odd_[k];
  }
  std::sort(crossings_.begin(), crossings_.end());
}

bool ParityColumn::isInside(double z) {
  if (z > last_) castFrom(z);
  for (; next_ < crossings_.size() && crossings_[next_].first < z; ++next_) {
    char& odd = odd_[crossings_[next_].second];
    odd ^= 1;
    inside_ += odd ? 1 : -1;
  }
  return inside_ > 0;
}

}  // namespace amble
