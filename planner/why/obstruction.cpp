#include "planner/why/obstruction.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

#include "base/parallel.h"
#include "base/rotation.h"
#include "planner/why/ground_profile.h"
#include "planner/why/passage.h"

namespace amble {
namespace {

using Lack = Obstruction::Lack;

constexpr double kFarthestFree = 1.5;   // from a blocked end, where it would do [m]
constexpr int kFreeDirections = 16;     // around it
constexpr double kTellingShare = 0.05;  // of refusals, by which the scene stands in the way
constexpr size_t kMostMeasured = 20;    // places of refusals
constexpr double kNearPlace = 1.0;      // in plan, refusals are about a place [m]
constexpr double kNearWay = 0.75;       // in plan, refusals are about a way [m]
constexpr double kStretch = 0.5;        // of a way, in which refusals are counted [m]
constexpr int kEveryFrame = 2;          // of a refused walk, that is looked at for overlaps
constexpr double kExactOverlap = 5e-4;  // [m]

// The nearest place where the body stands as asked, by any heading where any will do.
// @param rise  higher, or lower, is another floor [m]
std::optional<Eigen::Vector3d> nearestFree(const Waypoint& end, double rise,
                                           const Steering& steering) {
  constexpr double kSpacing = 0.02;  // between rings [m]
  constexpr int kHeadings = 8;
  const SteeringScratchPtr scratch = steering.makeScratch();
  for (double r = kSpacing; r <= kFarthestFree; r += kSpacing) {
    for (int i = 0; i < kFreeDirections; ++i) {
      for (int k = 0; k < (end.any_heading ? kHeadings : 1); ++k) {
        const double direction = 2.0 * kPi * i / kFreeDirections;
        Stance stance = end.stance;
        stance.position += r * Eigen::Vector3d(std::cos(direction), std::sin(direction), 0.0);
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

double inPlan(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return (a - b).head<2>().norm();
}

// What was measured, and of the refusals near there which part of the body is concerned most.
Obstruction withPart(Obstruction why, const std::vector<SteeringFailure>& refusals,
                     const PlanRequest& request) {
  const Scene& scene = request.world->scene();
  std::vector<SteeringFailure> near;
  for (const SteeringFailure& refusal : refusals) {
    if (inPlan(refusal.at, why.at) > kNearPlace) continue;
    const std::string object = refusal.object < 0 ? "" : objectName(scene.objects[refusal.object]);
    if (object.empty() || object == why.object || object == why.other) near.push_back(refusal);
  }
  const auto most = mostOften(near, scene, request.world->body());
  why.part.clear();
  if (!most) return why;
  why.rule = most->rule;
  why.part = most->part;
  why.count = most->count;
  why.gap = most->gap;
  return why;
}

// Whether the one is told rather than the other: gaps before what hangs before what lies in the
// way, and of the same kind the one that lacks least.
bool isBetter(const Obstruction& a, const Obstruction& b) {
  if (a.lack != b.lack) return a.lack < b.lack;
  return a.lack == Lack::kStep ? *a.width < *b.width : *a.width > *b.width;
}

// Of so many of the places of refusals what lacks least there.
std::optional<Obstruction> measuredAtRefusals(const std::vector<SteeringFailure>& refusals,
                                              const PlanRequest& request, const Obstruction& why) {
  const PassageProbe probe(request);
  std::optional<Obstruction> least;
  const size_t stride = 1 + refusals.size() / kMostMeasured;
  for (size_t i = 0; i < refusals.size(); i += stride) {
    const SteeringFailure& refusal = refusals[i];
    Obstruction here = why;
    if (refusal.rule == WalkRule::kContact && probe.measure(refusal.body, refusal.heading, here) &&
        (!least || isBetter(here, *least)))
      least = here;
  }
  return least;
}

// Of places where the ground refused the first that is measured: the middle one, then others.
void measureGroundOf(const std::vector<SteeringFailure>& refusals, const PlanRequest& request,
                     Obstruction& why) {
  if (measureGround(why.at, why.body, request, why)) return;
  if (why.rule == WalkRule::kReach && measureRise(why.at, why.body, request, why)) return;
  const size_t stride = 1 + refusals.size() / kMostMeasured;
  for (size_t i = 0; i < refusals.size(); i += stride) {
    const SteeringFailure& refusal = refusals[i];
    if (refusal.rule != why.rule) continue;
    if (measureGround(refusal.at, refusal.body, request, why)) return;
  }
}

// How deep a capsule is in things at most: by so much thinner it would touch none.
double depthOf(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
               const CollisionWorld& world, CollisionScratch& scratch, int& object) {
  const auto touches = [&](double depth) {
    const int there = world.touched(from, to, std::max(1e-6, radius - depth), scratch);
    if (there >= 0) object = there;
    return there >= 0;
  };
  if (!touches(0.0)) return 0.0;
  double in = 0.0, out = radius;
  if (touches(out)) return radius;
  while (out - in > kExactOverlap) (touches(0.5 * (in + out)) ? in : out) = 0.5 * (in + out);
  return out;
}

struct Overlap {
  double depth = 0.0;  // [m]
  int part = -1, object = -1;
};

// The deepest of a walk.
Overlap deepest(const AnimationBuffer& walk, const Skeleton& skeleton, const CollisionWorld& world,
                CollisionScratch& scratch) {
  const Body& body = world.body();
  std::vector<JointFrame> joints(skeleton.size());
  std::vector<Eigen::Vector3d> from(body.parts.size()), to(body.parts.size());
  Overlap most;
  for (int frame = 0; frame < walk.size(); frame += kEveryFrame) {
    forwardKinematics(skeleton, walk.poses[frame], joints);
    placeBody(body, joints, from, to);
    for (int part = 0; part < static_cast<int>(body.parts.size()); ++part) {
      int object = -1;
      const double depth =
          depthOf(from[part], to[part], body.parts[part].radius, world, scratch, object);
      if (depth > most.depth) most = {depth, part, object};
    }
  }
  return most;
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

std::optional<Obstruction> whatStoodInTheWay(const std::vector<SteeringFailure>& all,
                                             const PlanRequest& request,
                                             const std::optional<WayGuide::Narrow>& narrow) {
  // Another place would do for an edge that has no curve, or no whole number of steps: what the
  // scene refuses says more, where it is not next to nothing.
  std::vector<SteeringFailure> refusals;
  std::copy_if(all.begin(), all.end(), std::back_inserter(refusals), [](const auto& refusal) {
    return stageOf(refusal.rule) >= SteeringStage::kAnimation;
  });
  if (refusals.size() < kTellingShare * static_cast<double>(all.size())) refusals = all;
  auto why = mostOften(refusals, request.world->scene(), request.world->body());
  if (!why) return why;
  if (narrow && PassageProbe(request).measure(narrow->at, narrow->heading, *why))
    return withPart(*why, refusals, request);
  if (why->rule != WalkRule::kContact)
    measureGroundOf(refusals, request, *why);
  else if (const auto measured = measuredAtRefusals(refusals, request, *why))
    return withPart(*measured, refusals, request);
  return why;
}

std::vector<SteeringFailure> whereMostWereRefused(const std::vector<SteeringFailure>& refusals,
                                                  const std::vector<Eigen::Vector3d>& way) {
  std::map<int, std::vector<SteeringFailure>> stretches;
  for (const SteeringFailure& refusal : refusals) {
    double nearest = kNearWay, passed = 0.0;
    int stretch = -1;
    for (size_t i = 0; i + 1 < way.size(); ++i) {
      const Eigen::Vector2d a = way[i].head<2>(), line = (way[i + 1] - way[i]).head<2>();
      const double length = line.norm();
      const double along =
          length > 0.0
              ? std::clamp((refusal.body.head<2>() - a).dot(line) / (length * length), 0.0, 1.0)
              : 0.0;
      const double off = (refusal.body.head<2>() - a - along * line).norm();
      if (off < nearest) {
        nearest = off;
        stretch = static_cast<int>((passed + along * length) / kStretch);
      }
      passed += length;
    }
    if (stretch >= 0) stretches[stretch].push_back(refusal);
  }
  if (stretches.empty()) return refusals;
  return std::max_element(
             stretches.begin(), stretches.end(),
             [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); })
      ->second;
}

Obstruction whatBlocks(const SteeringFailure& failure, const Waypoint& end,
                       const PlanRequest& request, const Steering& steering) {
  Obstruction why = *mostOften({failure}, request.world->scene(), request.world->body());
  const PassageProbe probe(request);
  const Scene& scene = request.world->scene();
  const double step = request.ground->settings().limits.highestStep();
  const Eigen::Vector3d& place = end.stance.position;
  int object = -1;
  const auto top =
      failure.rule == WalkRule::kContact ? std::nullopt : probe.topOver(place, &object);
  // In a thing with ground on it only its sides would be felt, from within.
  const bool open = request.ground->stand(place.x(), place.y(), place.z(), step).has_value();
  const auto near = open && !top ? probe.nearest(place) : std::nullopt;
  if (near && why.object.empty()) why.object = objectName(scene.objects[near->object]);
  if (near && objectName(scene.objects[near->object]) == why.object) {
    why.lack = Lack::kDistance;
    why.width = near->distance;
  }
  why.free = nearestFree(end, step, steering);
  if (top) {
    why.lack = Lack::kStep;
    why.object = objectName(scene.objects[object]);
    why.width = *top;
    why.needed = step;
  }
  if (!why.free || why.lack != Lack::kDistance) return why;
  const auto there = probe.nearest(*why.free);
  why.needed = std::max(*why.width, there ? there->distance : kFarthestFree);
  return why;
}

Obstruction whatShutsOff(const SteeringFailure& barrier, const PlanRequest& request) {
  constexpr double kAround = 1.5;  // treads that a barrier on stairs is told by differ less [m]
  Obstruction why = *mostOften({barrier}, request.world->scene(), request.world->body());
  Eigen::Vector3d place = barrier.body;
  if (const auto ground = request.ground->stand(place.x(), place.y(), place.z(), kAround))
    place.z() = ground->height;
  PassageProbe(request).measure(place, barrier.heading, why);
  return why;
}

Obstruction whatTheGroundLacks(const GroundGap& gap, const PlanRequest& request) {
  Obstruction why;
  why.at = gap.near;
  why.body = gap.far;
  why.count = 1;
  why.rule =
      gap.width() > longestStep(*request.synthesizer) ? WalkRule::kNoGround : WalkRule::kStepHeight;
  if (measureGround(gap.near, gap.far, request, why) || why.rule != WalkRule::kStepHeight)
    return why;
  // Another storey, of which nothing is seen from here.
  why.lack = gap.rise() > 0.0 ? Obstruction::Lack::kStep : Obstruction::Lack::kDrop;
  why.width = std::abs(gap.rise());
  why.needed = highestStep(request.ground->settings().limits, gap.rise() > 0.0);
  return why;
}

void addLeastOverlap(const std::vector<const RefusedEdge*>& refused, const WalkSteering& steering,
                     int threads, Obstruction& why) {
  if (why.rule != WalkRule::kContact) return;
  const Scene& scene = steering.world().scene();
  std::vector<const RefusedEdge*> near;
  for (const RefusedEdge* edge : refused) {
    const SteeringFailure& failure = edge->failure;
    if (failure.rule != WalkRule::kContact || inPlan(failure.at, why.at) > kNearPlace) continue;
    const std::string object = objectName(scene.objects[failure.object]);
    if (object == why.object || object == why.other) near.push_back(edge);
  }
  const size_t stride = 1 + near.size() / kMostReplayed;
  std::vector<Overlap> overlaps((near.size() + stride - 1) / stride);
  parallelFor(static_cast<int>(overlaps.size()), threads, [&](int i, int) {
    const SteeringScratchPtr scratch = steering.makeScratch();
    const CollisionScratchPtr collision = steering.world().makeScratch();
    const RefusedEdge& edge = *near[i * stride];
    const auto attempt = steering.attempt(edge.from, edge.to, *scratch);
    AnimationBuffer walk;
    if (!attempt.refused || steering.animateRefused(*attempt.refused, walk) != WalkRule::kNone)
      return;
    overlaps[i] = deepest(walk, steering.synthesizer().skeleton(), steering.world(), *collision);
  });
  std::optional<Overlap> least;
  for (const Overlap& own : overlaps)
    if (own.part >= 0 && (!least || own.depth < least->depth)) least = own;
  if (!least) return;
  const std::string object = objectName(scene.objects[least->object]);
  if (object != why.object && object != why.other) return;
  if (object == why.other) std::swap(why.object, why.other);
  why.part = steering.world().body().parts[least->part].name;
  why.overlap = least->depth;
}

}  // namespace amble
