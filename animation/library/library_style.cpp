#include "animation/library/library_style.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace amble {
std::vector<std::string> stylesOf(const MotionLibrary& library) {
  std::set<std::string> styles;
  for (const Motion& motion : library.motions) {
    if (motion.kind == MotionKind::kWalk && !motion.turning) styles.insert(motion.style);
  }
  styles.erase("");
  return {styles.begin(), styles.end()};
}

MotionLibrary inStyle(MotionLibrary library, const std::string& style) {
  const auto hasOwn = [&](MotionKind kind) {
    return std::any_of(library.motions.begin(), library.motions.end(), [&](const Motion& motion) {
      return motion.kind == kind && motion.style == style;
    });
  };
  std::map<MotionKind, bool> own;
  for (const MotionKind kind : {MotionKind::kStart, MotionKind::kStop, MotionKind::kTurnOnSpot})
    own[kind] = hasOwn(kind);
  std::erase_if(library.motions, [&](const Motion& motion) {
    if (motion.kind == MotionKind::kWalk) return motion.style != style;
    const auto kind = own.find(motion.kind);
    return kind != own.end() && motion.style != (kind->second ? style : "");
  });
  return library;
}

double ownSpeed(const MotionLibrary& library, double height) {
  double sum = 0.0;
  int count = 0;
  for (const Motion& motion : library.motions) {
    if (motion.kind != MotionKind::kWalk || motion.turning) continue;
    sum += motion.cycle.speed;
    ++count;
  }
  const double scale = height > 0.0 ? height / library.stature : 1.0;
  return std::clamp(std::sqrt(scale) * sum / count, kSlowestWalk, kFastestWalk);
}

}  // namespace amble
