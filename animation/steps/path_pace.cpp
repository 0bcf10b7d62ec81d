#include "animation/steps/path_pace.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "animation/steps/slope_gait.h"
#include "animation/steps/stance_feet.h"
#include "base/parts.h"

namespace amble {

std::function<double(double)> paceAlong(const StepSettings& settings, const FootholdFinder& holds,
                                        const RootPath& path, const Stance& from,
                                        const Stance& to) {
  constexpr double kSpacing = 0.25;  // of the points: a step's slope changes no faster [m]
  const int count = partsOf(path.length(), kSpacing);
  const double spacing = path.length() / count;
  const auto paceAt = [&](const Stance& stance) {
    return slopePace(slopeUnder(settings, holds, stance));
  };
  std::vector<double> paces(count + 1, 1.0);
  double z = from.position.z();
  bool level = true;
  for (int i = 0; i <= count; ++i) {
    GroundPoint point = pathPoint(path, i * spacing, z);
    const auto surface =
        holds.ground().surface(point.position.x(), point.position.y(), z, settings.reach());
    if (surface) z = surface->height;
    if (!surface || surface->normal.z() > 1.0 - Unevenness::kVertical) continue;
    level = false;
    point.position.z() = z;
    paces[i] = paceAt({point.position, point.heading, true, kLeft});
  }
  const auto slows = [](const Stance& end) { return !end.standing && end.pace < 1.0; };
  if (level && !slows(from) && !slows(to)) return nullptr;
  if (!from.standing) paces.front() = from.pace * paceAt(from);
  if (!to.standing) paces.back() = to.pace * paceAt(to);
  return [paces = std::move(paces), spacing](double arc) {
    const double at = std::clamp(arc / spacing, 0.0, static_cast<double>(paces.size() - 1));
    const size_t i = std::min(static_cast<size_t>(at), paces.size() - 2);
    return paces[i] + (at - static_cast<double>(i)) * (paces[i + 1] - paces[i]);
  };
}

}  // namespace amble
