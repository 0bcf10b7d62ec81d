#include "planner/obstruction.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <map>
#include <utility>

#include "animation/steps/stride_law.h"
#include "base/rotation.h"
#include "planner/steering/straight_walk.h"

namespace amble {
namespace {

constexpr double kProbeRadius = 0.02;    // of the post that feels for what is beside a place [m]
constexpr double kProbeStep = 0.01;      // [m]
constexpr double kFarthestProbe = 1.5;   // [m]
constexpr int kProbeDirections = 16;     // around a place
constexpr double kLowestProbe = 0.3;     // over the ground: what is lower may be stepped over [m]
constexpr double kHighestProbe = 0.85;   // of stature: shoulders and what hangs from them
constexpr double kOverhead = 0.55;       // of stature: what begins higher is walked under
constexpr double kGroundStep = 0.02;     // between the places where ground is looked at [m]
constexpr double kFarthestGround = 3.0;  // beyond an edge [m]
constexpr double kSeen = 1.5;            // up and down, to which ground is seen from an edge [m]
constexpr double kTellingShare = 0.05;   // of refusals, by which the scene stands in the way
constexpr size_t kMostMeasured = 100;    // places of refusals

std::string metres(double value, int digits = 2) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f m", digits, value);
  return text;
}

std::string placeText(const Eigen::Vector3d& p) {
  const Eigen::Vector3d q = p + Eigen::Vector3d::Constant(1e-9);  // no -0.00
  char text[96];
  std::snprintf(text, sizeof text, "(%.2f, %.2f, %.2f)", q.x(), q.y(), q.z());
  return text;
}

// How much there is, and what would do.
std::string measureText(const Obstruction& why) {
  const bool rises = why.rule == WalkRule::kStepHeight || why.rule == WalkRule::kReach;
  const char* what = why.free                                 ? " away"
                     : rises                                  ? " high"
                     : why.other.empty() && !why.part.empty() ? " high"
                                                              : " wide";
  std::string text = ", " + metres(*why.width) + what;
  const bool most = why.needed && *why.needed < *why.width;
  if (why.needed) text += (most && !why.free ? ", at most " : ", needed ") + metres(*why.needed);
  return text;
}

// What a rule means, where nothing was touched: its name alone says little.
const char* meaningOf(WalkRule rule) {
  switch (rule) {
    case WalkRule::kNoCurve:
      return " (too near, or too sharp a turn, to walk)";
    case WalkRule::kStepLength:
      return " (no whole number of steps fits)";
    case WalkRule::kTurnRate:
      return " (a sharper turn than the library's walks)";
    case WalkRule::kReach:
      return " (a leg is too short)";
    case WalkRule::kFoothold:
      return " (no room for a whole sole)";
    default:
      return "";
  }
}

Eigen::Vector3d unit(double heading) { return {std::cos(heading), std::sin(heading), 0.0}; }

// Feels with an upright post for what is around a place.
class PlaceProbe {
 public:
  struct Side {
    double distance = 0.0;  // to the post [m]
    std::string object;
  };

  explicit PlaceProbe(const PlanRequest& request)
      : request_(request),
        scratch_(request.world->makeScratch()),
        stature_(request.synthesizer->stature()) {}

  // What is met first from a place on the ground along a heading.
  std::optional<Side> along(const Eigen::Vector3d& ground, double heading, double low) const {
    const double high = std::max(low + kProbeStep, kHighestProbe * stature_);
    for (double d = 0.0; d <= kFarthestProbe; d += kProbeStep) {
      const Eigen::Vector3d p = ground + d * unit(heading);
      const int object = request_.world->touched(
          p + Eigen::Vector3d(0, 0, low), p + Eigen::Vector3d(0, 0, high), kProbeRadius, *scratch_);
      if (object >= 0) return Side{d, objectName(request_.world->scene().objects[object])};
    }
    return std::nullopt;
  }

  std::optional<Side> nearest(const Eigen::Vector3d& ground) const {
    std::optional<Side> best;
    for (int i = 0; i < kProbeDirections; ++i) {
      const auto side = along(ground, 2.0 * kPi * i / kProbeDirections, kLowestStep);
      if (side && (!best || side->distance < best->distance)) best = side;
    }
    return best;
  }

  // Of the places of refusals the widest passage that is too narrow, or what is too low there.
  void measurePassage(const std::vector<SteeringFailure>& refusals, Obstruction& why) const {
    const WalkSynthesizer& synthesizer = *request_.synthesizer;
    const Eigen::AlignedBox1d breadth =
        walkingBreadth(straightWalk(synthesizer, *request_.ground), synthesizer.skeleton(),
                       request_.world->body());
    const double needed = breadth.isEmpty() ? 0.0 : breadth.sizes()[0];
    const size_t stride = 1 + refusals.size() / kMostMeasured;
    for (size_t i = 0; i < refusals.size(); i += stride) {
      const SteeringFailure& refusal = refusals[i];
      if (refusal.rule != WalkRule::kContact) continue;
      const auto sides = narrowest(refusal);
      if (!sides) continue;
      const auto& [near, far] = *sides;
      const double width = near.distance + far.distance + 2.0 * kProbeRadius;
      if (width >= needed - kProbeStep || (why.width && width <= *why.width)) continue;
      why.object = near.object;
      why.other = far.object;
      why.at = refusal.at;
      why.part = request_.world->body().parts[std::max(0, refusal.part)].name;
      why.gap = refusal.gap;
      why.width = width;
      why.needed = needed;
    }
    if (!why.width) measureHeadroom(refusals, why);
  }

  // Of what is in the way of a leg how high it is, where that ends below the hips.
  void measureStep(Obstruction& why) const {
    const double highest = request_.ground->settings().limits.highestStep();
    const Eigen::Vector2d at = why.body.head<2>(), way = kSeenAhead * unit(why.heading).head<2>();
    const double top =
        request_.ground->crest(at - way, at + way, kProbeRadius, why.body.z() + highest,
                               why.body.z() + kOverhead * stature_);
    if (!std::isfinite(top)) return;
    why.width = top - why.body.z();
    why.needed = highest;
  }

  // The highest step between two stances, which a leg did not reach: where it is, and how high.
  void measureRise(Obstruction& why) const {
    constexpr double kLeast = 0.05;  // a lower one is none [m]
    const SceneGround& ground = *request_.ground;
    const Eigen::Vector3d begin = why.at, way = why.body - why.at;
    const int count = static_cast<int>(way.head<2>().norm() / kGroundStep);
    std::optional<double> last;
    double z = begin.z(), highest = kLeast;
    for (int i = 0; i <= count; ++i) {
      const Eigen::Vector3d p = begin + way * i / std::max(1, count);
      const auto here = ground.height(p.x(), p.y(), z, ground.settings().limits.highestStep());
      if (here && last && std::abs(*here - *last) > highest) {
        highest = std::abs(*here - *last);
        why.at << p.x(), p.y(), std::min(*here, *last);
        why.width = highest;
      }
      last = here;
      if (here) z = *here;
    }
  }

  // Where the ground between two stances does not let a walk through.
  void measureGround(Obstruction& why) const {
    const SceneGround& ground = *request_.ground;
    const GroundLimits& limits = ground.settings().limits;
    const Eigen::Vector3d begin = why.at, way = why.body - why.at;
    const int count = static_cast<int>(way.head<2>().norm() / kGroundStep);
    double z = begin.z();
    for (int i = 0; i <= count; ++i) {
      const Eigen::Vector3d p = begin + way * i / std::max(1, count);
      const auto here = ground.surface(p.x(), p.y(), z, limits.highestStep());
      why.at << p.x(), p.y(), z;
      if (!here) return measureEdge(why, way);
      if (here->normal.z() < std::cos(limits.max_slope)) return;
      if (why.rule != WalkRule::kNoGround && stepsOver(why, way)) return;
      z = here->height;
    }
    why.at = begin;
  }

 private:
  static constexpr double kLowestStep = 0.05;  // over the ground [m]
  static constexpr double kSeenAhead = 0.1;  // to which the height of an obstacle is looked at [m]

  // The nearer and the farther side of what is narrowest a little before and behind the body; none
  // where it is open to a side, or where the way leads straight into something.
  std::optional<std::pair<Side, Side>> narrowest(const SteeringFailure& refusal) const {
    std::optional<std::pair<Side, Side>> best;
    for (const double ahead : {0.0, 0.1, 0.2, 0.3, 0.4, 0.5}) {
      const Eigen::Vector3d p = refusal.body + ahead * unit(refusal.heading);
      // Inside of what has ground on it both sides are its own.
      const double step = request_.ground->settings().limits.highestStep();
      if (!request_.ground->stand(p.x(), p.y(), p.z(), step)) break;
      const auto left = along(p, refusal.heading + 0.5 * kPi, kLowestProbe);
      const auto right = along(p, refusal.heading - 0.5 * kPi, kLowestProbe);
      if (!left || !right) continue;
      if (left->distance <= 0.0 || right->distance <= 0.0) break;
      const double width = left->distance + right->distance;
      if (best && width >= best->first.distance + best->second.distance) continue;
      best =
          left->distance <= right->distance ? std::pair(*left, *right) : std::pair(*right, *left);
    }
    return best;
  }

  // Of what hangs, lower than the body is tall, over the places where heads were refused the
  // highest.
  void measureHeadroom(const std::vector<SteeringFailure>& refusals, Obstruction& why) const {
    const Body& body = request_.world->body();
    const size_t stride = 1 + refusals.size() / (4 * kMostMeasured);
    for (size_t i = 0; i < refusals.size(); i += stride) {
      const SteeringFailure& refusal = refusals[i];
      if (refusal.rule != WalkRule::kContact || refusal.part != body.head) continue;
      const auto height =
          headroom({refusal.at.x(), refusal.at.y(), refusal.body.z()}, refusal.object);
      if (!height || (why.width && *height <= *why.width)) continue;
      why.object = objectName(request_.world->scene().objects[refusal.object]);
      why.part = body.parts[body.head].name;
      why.other.clear();
      why.at = refusal.at;
      why.gap = refusal.gap;
      why.width = height;
      why.needed = stature_;
      why.count =
          std::count_if(refusals.begin(), refusals.end(), [&](const SteeringFailure& other) {
            return other.object == refusal.object && other.part == body.head;
          });
    }
  }

  // From the ground to the underside of an object that hangs over it, lower than the body is tall;
  // none where it goes on below: it is no thing to walk under.
  std::optional<double> headroom(const Eigen::Vector3d& ground, int object) const {
    for (double height = kOverhead * stature_; height < stature_; height += kProbeStep) {
      const Eigen::Vector3d p = ground + Eigen::Vector3d(0, 0, height);
      if (request_.world->touched(p, p, kProbeRadius, *scratch_) != object) continue;
      if (height <= kOverhead * stature_) return std::nullopt;
      return height + kProbeRadius;
    }
    return std::nullopt;
  }

  // The ground ends at why.at: how far, or how high, is it to what goes on?
  void measureEdge(Obstruction& why, const Eigen::Vector3d& way) const {
    const SceneGround& ground = *request_.ground;
    const double heading = std::atan2(way.y(), way.x());
    for (double d = 0.0; d <= kFarthestGround; d += kGroundStep) {
      const Eigen::Vector3d p = why.at + d * unit(heading);
      const auto there = ground.height(p.x(), p.y(), why.at.z(), kSeen);
      if (!there) continue;
      const double rise = std::abs(*there - why.at.z());
      const bool steps = d < kGroundStep && rise > ground.settings().limits.highestStep();
      why.width = steps ? rise : d;
      why.needed =
          steps ? ground.settings().limits.highestStep() : longestStep(*request_.synthesizer);
      return;
    }
  }

  // Something at why.at that is higher than a step.
  bool stepsOver(Obstruction& why, const Eigen::Vector3d& way) const {
    const double highest = request_.ground->settings().limits.highestStep();
    const Eigen::Vector3d low = why.at + Eigen::Vector3d(0, 0, highest + kProbeRadius);
    const Eigen::Vector3d high = why.at + Eigen::Vector3d(0, 0, highest + kOverhead * stature_);
    const int object = request_.world->touched(low, high, kProbeRadius, *scratch_);
    if (object < 0) return false;
    why.object = objectName(request_.world->scene().objects[object]);
    const Eigen::Vector2d p = why.at.head<2>();
    const Eigen::Vector2d ahead = p + kSeenAhead * way.head<2>().normalized();
    const double top = request_.ground->crest(p, ahead, kProbeRadius, low.z(), high.z());
    if (std::isfinite(top)) why.width = top - why.at.z();
    if (why.width) why.needed = highest;
    return true;
  }

  const PlanRequest& request_;
  CollisionScratchPtr scratch_;
  double stature_;
};

// The nearest place where the body stands as asked, by any heading where any will do.
// @param rise  higher, or lower, is another floor [m]
std::optional<Eigen::Vector3d> nearestFree(const Waypoint& end, double rise,
                                           const Steering& steering) {
  constexpr double kSpacing = 0.02;  // between rings [m]
  constexpr int kHeadings = 8;
  const SteeringScratchPtr scratch = steering.makeScratch();
  for (double r = kSpacing; r <= kFarthestProbe; r += kSpacing) {
    for (int i = 0; i < kProbeDirections; ++i) {
      for (int k = 0; k < (end.any_heading ? kHeadings : 1); ++k) {
        Stance stance = end.stance;
        stance.position += r * unit(2.0 * kPi * i / kProbeDirections);
        stance.heading += 2.0 * kPi * k / kHeadings;
        const bool stands = !steering.stand(stance, *scratch);
        if (stands && std::abs(stance.position.z() - end.stance.position.z()) <= rise)
          return stance.position;
      }
    }
  }
  return std::nullopt;
}

// The key that is there most often, the first of equal ones.
template <typename Key>
std::pair<Key, long long> best(const std::map<Key, long long>& counts) {
  return *std::max_element(counts.begin(), counts.end(),
                           [](const auto& a, const auto& b) { return a.second < b.second; });
}

// Of the places of refusals the one nearest to their mean.
const SteeringFailure& middleOf(const std::vector<const SteeringFailure*>& refusals) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const SteeringFailure* failure : refusals)
    mean += failure->at / static_cast<double>(refusals.size());
  return **std::min_element(refusals.begin(), refusals.end(),
                            [&](const SteeringFailure* a, const SteeringFailure* b) {
                              return (a->at - mean).squaredNorm() < (b->at - mean).squaredNorm();
                            });
}

}  // namespace

std::optional<Obstruction> mostOften(const std::vector<SteeringFailure>& refusals,
                                     const Scene& scene, const Body& body) {
  if (refusals.empty()) return std::nullopt;
  std::map<std::pair<std::string_view, int>, long long> by_object;
  for (const SteeringFailure& failure : refusals)
    ++by_object[{walkRuleName(failure.rule), failure.object}];
  const auto [most, count] = best(by_object);
  std::map<int, long long> by_part;
  std::vector<const SteeringFailure*> these;
  for (const SteeringFailure& failure : refusals) {
    if (walkRuleName(failure.rule) != most.first || failure.object != most.second) continue;
    ++by_part[failure.part];
    these.push_back(&failure);
  }
  const SteeringFailure& middle = middleOf(these);
  Obstruction why;
  why.rule = these.front()->rule;
  why.count = count;
  why.at = middle.at;
  why.body = middle.body;
  why.heading = middle.heading;
  why.gap = HUGE_VAL;
  for (const SteeringFailure* failure : these) why.gap = std::min(why.gap, failure->gap);
  if (most.second >= 0) why.object = objectName(scene.objects[most.second]);
  const int part = best(by_part).first;
  if (part >= 0) why.part = body.parts[part].name;
  return why;
}

double longestStep(const WalkSynthesizer& synthesizer) {
  return StrideLaw::kLongestStep * synthesizer.capturedStep();
}

std::optional<Obstruction> whatStoodInTheWay(const std::vector<SteeringFailure>& all,
                                             const PlanRequest& request) {
  // Another place would do for an edge that has no curve, or no whole number of steps: what the
  // scene refuses says more, where it is not next to nothing.
  std::vector<SteeringFailure> refusals;
  std::copy_if(all.begin(), all.end(), std::back_inserter(refusals), [](const auto& refusal) {
    return stageOf(refusal.rule) >= SteeringStage::kAnimation;
  });
  if (refusals.size() < kTellingShare * static_cast<double>(all.size())) refusals = all;
  auto why = mostOften(refusals, request.world->scene(), request.world->body());
  if (!why) return why;
  const PlaceProbe probe(request);
  if (why->rule == WalkRule::kContact)
    probe.measurePassage(refusals, *why);
  else if (why->rule == WalkRule::kReach)
    probe.measureRise(*why);
  else
    probe.measureGround(*why);
  return why;
}

Obstruction whatBlocks(const SteeringFailure& failure, const Waypoint& end,
                       const PlanRequest& request, const Steering& steering) {
  Obstruction why = *mostOften({failure}, request.world->scene(), request.world->body());
  const PlaceProbe probe(request);
  const double step = request.ground->settings().limits.highestStep();
  const Eigen::Vector3d& place = end.stance.position;
  // In a thing with ground on it only its sides would be felt, from within.
  const bool open = request.ground->stand(place.x(), place.y(), place.z(), step).has_value();
  const auto near = open ? probe.nearest(place) : std::nullopt;
  if (near && why.object.empty()) why.object = near->object;
  if (near && near->object == why.object) why.width = near->distance;
  why.free = nearestFree(end, step, steering);
  if (!why.free || !why.width) return why;
  const auto there = probe.nearest(*why.free);
  why.needed = std::max(*why.width, there ? there->distance : kFarthestProbe);
  return why;
}

Obstruction whatShutsOff(const SteeringFailure& barrier, const PlanRequest& request) {
  SteeringFailure touched = barrier;
  touched.rule = WalkRule::kContact;  // measured as those are
  Obstruction why = *whatStoodInTheWay({touched}, request);
  why.rule = barrier.rule;
  if (!why.width) PlaceProbe(request).measureStep(why);
  return why;
}

Obstruction whatTheGroundLacks(const GroundGap& gap, const PlanRequest& request) {
  Obstruction why;
  const double longest = longestStep(*request.synthesizer);
  const bool wide = gap.width() > longest;
  why.rule = wide ? WalkRule::kNoGround : WalkRule::kStepHeight;
  why.at = gap.near;
  why.body = gap.far;
  why.count = 1;
  why.width = wide ? gap.width() : std::abs(gap.rise());
  why.needed = wide ? longest : request.ground->settings().limits.highestStep();
  return why;
}

std::string describe(const Obstruction& why) {
  std::string text = why.via ? "via[" + std::to_string(*why.via) + "] is blocked: " : "";
  text += walkRuleName(why.rule);
  text += meaningOf(why.rule);
  if (!why.part.empty()) text += ": " + why.part + " and " + why.object;
  if (why.part.empty() && !why.object.empty()) text += ": " + why.object;
  if (!why.other.empty())
    text += ", between " + (why.other == why.object ? "its sides" : "it and " + why.other);
  text += " at " + placeText(why.at);
  const double way = (why.body - why.at).norm();
  if (why.part.empty() && !why.width && way > 0.0)
    text += ", on the way to " + placeText(why.body) + ", " + metres(way);
  if (why.gap > 0.0) text += ", " + metres(why.gap, 3) + " apart";
  if (why.width) text += measureText(why);
  if (why.free) text += "; the nearest place that would do is " + placeText(*why.free);
  return text;
}

}  // namespace amble
