/// Ground that lies somewhere else: slopes and stairs begin at the origin.
#pragma once

#include <memory>
#include <utility>

#include "animation/ground/ground.h"

namespace amble {

class PlacedGround : public Ground {
 public:
  /// @param at  where the other's origin comes to lie [m, World]
  PlacedGround(std::unique_ptr<Ground> ground, const Eigen::Vector2d& at)
      : ground_(std::move(ground)), at_(at) {}

  std::optional<SurfacePoint> surface(double x, double y, double z, double reach) const override {
    return ground_->surface(x - at_.x(), y - at_.y(), z, reach);
  }

 private:
  std::unique_ptr<Ground> ground_;
  Eigen::Vector2d at_;
};

}  // namespace amble
