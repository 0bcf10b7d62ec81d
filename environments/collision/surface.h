/// The surface of one thing, and of a primitive its inside, as capsules meet it.
#pragma once

#include <memory>

#include "environments/body/capsule.h"

namespace amble {

/// Const after construction: threads may share it.
class Surface {
 public:
  virtual ~Surface() = default;
  virtual bool touches(const Capsule& capsule) const = 0;
  /// 0 where it touches; `limit` where it is that or more [m].
  virtual double distance(const Capsule& capsule, double limit) const = 0;
};
using SurfacePtr = std::unique_ptr<const Surface>;

}  // namespace amble
