#include "planner/why/passage.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/rotation.h"

namespace amble {
namespace {

constexpr double kPost = 0.02;        // radius [m]
constexpr double kMove = 0.02;        // in which it is moved [m]
constexpr double kExact = 1e-4;       // to which that is refined [m]
constexpr double kFarthest = 1.5;     // that is felt for to a side [m]
constexpr int kDirections = 16;       // around a place
constexpr double kLowest = 0.3;       // over the ground: what is lower may be stepped over [m]
constexpr double kLowestNear = 0.05;  // of what is near a place [m]
constexpr double kShoulders = 0.85;   // of stature, with what hangs from them
constexpr double kOverhead = 0.55;    // of stature: what begins higher is walked under
constexpr double kAhead = 0.5;        // and behind: part of a way that is looked at [m]
constexpr double kHere = 0.1;         // so far from it things lie in the way, else beside it [m]
constexpr double kAlong = 0.05;       // between places of it [m]
constexpr double kMostAslant = 60 * kDegree;  // of a gap to the way through it
constexpr double kHalfTurn = kPi / kDirections;
constexpr double kDeepest = 3.0;  // of a gap [m]
// In a gap as deep as most of a step arms swing whole wherever one steps; what is left to choose is
// how long steps are: they differ by a few centimetres from one walk's length to another's.
constexpr double kDeep = 0.5;                              // [m]
constexpr std::array<double, 2> kOtherWalks = {2.8, 3.6};  // lengths, by trial [m]

Eigen::Vector3d unit(double heading) { return {std::cos(heading), std::sin(heading), 0.0}; }

// The least of f over [low, high], where it has one minimum.
template <typename F>
double leastOf(double low, double high, F f) {
  constexpr int kThirds = 20;
  for (int i = 0; i < kThirds; ++i) {
    const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
    (f(a) <= f(b) ? high : low) = f(a) <= f(b) ? b : a;
  }
  return 0.5 * (low + high);
}

}  // namespace

PassageProbe::PassageProbe(const PlanRequest& request)
    : request_(request),
      walk_(straightWalk(*request.synthesizer)),
      stature_(request.synthesizer->stature()),
      highest_(request.ground->settings().limits.highestStep()),
      scratch_(request.world->makeScratch()) {
  const Eigen::AlignedBox1d breadth =
      walkingBreadth(walk_, request.synthesizer->skeleton(), request.world->body());
  if (!breadth.isEmpty()) breadth_ = breadth.sizes()[0];
}

std::string PassageProbe::name(int object) const {
  return objectName(request_.world->scene().objects[object]);
}

int PassageProbe::touched(const Eigen::Vector3d& ground, double low, double high) const {
  return request_.world->touched(ground + Eigen::Vector3d(0, 0, low),
                                 ground + Eigen::Vector3d(0, 0, high), kPost, *scratch_);
}

// What is met first from a place on the ground along a heading.
std::optional<PassageProbe::Side> PassageProbe::along(const Eigen::Vector3d& ground, double heading,
                                                      double low) const {
  const double high = std::max(low + kMove, kShoulders * stature_);
  const auto at = [&](double d) -> Eigen::Vector3d { return ground + d * unit(heading); };
  for (double d = 0.0; d <= kFarthest; d += kMove) {
    int object = touched(at(d), low, high);
    if (object < 0) continue;
    double free = std::max(0.0, d - kMove), met = d;
    while (met - free > kExact) {
      const double middle = 0.5 * (free + met);
      const int there = touched(at(middle), low, high);
      if (there >= 0) object = there;
      (there >= 0 ? met : free) = middle;
    }
    return Side{met, object, at(met)};
  }
  return std::nullopt;
}

std::optional<PassageProbe::Side> PassageProbe::nearest(const Eigen::Vector3d& ground) const {
  std::optional<Side> best;
  for (int i = 0; i < kDirections; ++i) {
    const auto side = along(ground, 2.0 * kPi * i / kDirections, kLowestNear);
    if (side && (!best || side->distance < best->distance)) best = side;
  }
  return best;
}

// To both sides of who passes a place; none where it is open to one, or in something.
std::optional<PassageProbe::Gap> PassageProbe::across(const Eigen::Vector3d& ground,
                                                      double heading) const {
  const auto left = along(ground, heading + 0.5 * kPi, kLowest),
             right = along(ground, heading - 0.5 * kPi, kLowest);
  if (!left || !right || left->distance <= 0.0 || right->distance <= 0.0) return std::nullopt;
  return Gap{*left, *right, left->distance + right->distance + 2.0 * kPost, heading,
             0.5 * (left->at + right->at)};
}

// The same by the heading by which it is narrowest there.
std::optional<PassageProbe::Gap> PassageProbe::narrowest(const Eigen::Vector3d& ground,
                                                         double heading) const {
  // At the edge of a wall there may be two sides straight across alone.
  std::optional<Gap> best = across(ground, heading);
  const auto width = [&](double by) {
    const auto gap = across(ground, by);
    return gap ? gap->width : HUGE_VAL;
  };
  for (double aslant = -kMostAslant; aslant <= kMostAslant; aslant += 2.0 * kHalfTurn) {
    const auto gap = across(ground, heading + aslant);
    if (gap && (!best || gap->width < best->width)) best = gap;
  }
  if (!best) return best;
  const auto exact =
      across(ground, leastOf(best->heading - kHalfTurn, best->heading + kHalfTurn, width));
  return exact && exact->width < best->width ? exact : best;
}

// Of a gap along the way through it: where the straight walk's whole breadth does not pass.
double PassageProbe::depth(const Gap& gap) const {
  double length = 0.0;
  for (const double direction : {1.0, -1.0}) {
    for (double d = kMove; d <= kDeepest; d += kMove) {
      const auto there = across(gap.middle + direction * d * unit(gap.heading), gap.heading);
      if (!there || there->width >= breadth_) break;
      length += kMove;
    }
  }
  return std::max(0.0, length - 2.0 * kPost);
}

// The least width that one gets through a gap of that depth by.
double PassageProbe::neededFor(double depth) const {
  const WalkSynthesizer& synthesizer = *request_.synthesizer;
  const Body& body = request_.world->body();
  double needed = passableBreadth(walk_, synthesizer.skeleton(), body, depth);
  if (depth < kDeep) return needed;
  for (const double length : kOtherWalks) {
    const StraightWalk other = straightWalk(synthesizer, length);
    if (other.buffer.size() > 0)
      needed = std::min(needed, passableBreadth(other, synthesizer.skeleton(), body, depth));
  }
  return needed;
}

bool PassageProbe::measureGap(const Gap& gap, Obstruction& why) const {
  const double needed = neededFor(depth(gap));
  if (gap.width >= needed) return false;
  const bool is_left = gap.left.distance <= gap.right.distance;
  why.object = name(is_left ? gap.left.object : gap.right.object);
  why.other = name(is_left ? gap.right.object : gap.left.object);
  why.lack = Obstruction::Lack::kGap;
  why.at = gap.middle + Eigen::Vector3d(0, 0, kLowest);
  why.width = gap.width;
  why.needed = needed;
  why.speed = request_.synthesizer->settings().speed;
  return true;
}

// From the ground to the underside of what hangs over it, lower than the body is tall; none where
// it goes on below: it is no thing to walk under.
std::optional<double> PassageProbe::headroom(const Eigen::Vector3d& ground, int& object) const {
  const auto touches = [&](double height) {
    const int there = touched(ground, height, height);
    if (there >= 0) object = there;
    return there >= 0;
  };
  for (double height = kOverhead * stature_; height < stature_; height += kMove) {
    if (!touches(height)) continue;
    if (height <= kOverhead * stature_) return std::nullopt;
    double free = height - kMove, met = height;
    while (met - free > kExact) {
      const double middle = 0.5 * (free + met);
      (touches(middle) ? met : free) = middle;
    }
    return met + kPost;
  }
  return std::nullopt;
}

std::optional<double> PassageProbe::topOver(const Eigen::Vector3d& ground, int* object) const {
  const int there = touched(ground, highest_ + kPost, kShoulders * stature_);
  if (there < 0) return std::nullopt;
  if (object) *object = there;
  const Eigen::Vector2d p = ground.head<2>(), beyond = p + Eigen::Vector2d(kExact, 0.0);
  const double top = request_.ground->crest(p, beyond, kPost, ground.z() + highest_,
                                            ground.z() + kShoulders * stature_);
  if (!std::isfinite(top)) return std::nullopt;
  // What goes on above that is higher: it is the underside of something else that ends there.
  const double above = top - ground.z() + 2.0 * kPost;
  if (touched(ground, above, std::max(above, kShoulders * stature_)) == there) return std::nullopt;
  return top - ground.z();
}

// Places of the way, a little before and behind one, on the ground that goes on from there, up to
// what is beside the way.
std::vector<Eigen::Vector3d> PassageProbe::placesAround(const Eigen::Vector3d& ground,
                                                        double heading) const {
  std::vector<Eigen::Vector3d> places;
  for (const double direction : {-1.0, 1.0}) {
    double z = ground.z();
    for (double d = 0.0; d <= kAhead; d += kAlong) {
      Eigen::Vector3d p = ground + direction * d * unit(heading);
      const auto here = request_.ground->stand(p.x(), p.y(), z, highest_);
      if (here) z = here->height;
      p.z() = z;
      if (d > kHere && touched(p, highest_ + kPost, kOverhead * stature_) >= 0) break;
      places.push_back(p);
    }
    if (direction < 0.0) std::reverse(places.begin(), places.end());
  }
  return places;
}

// What lies or hangs in the way: of the way there the first such thing, and where it is lowest, or
// highest.
bool PassageProbe::measureAbove(const std::vector<Eigen::Vector3d>& places,
                                Obstruction& why) const {
  std::optional<double> lowest;
  for (const Eigen::Vector3d& p : places) {
    int object = -1;
    if (const auto top = topOver(p, &object)) {
      why.lack = Obstruction::Lack::kStep;
      why.object = name(object);
      why.at = p + Eigen::Vector3d(0, 0, *top);
      why.width = *top;
      why.needed = highest_;
      return true;
    }
    const auto height = headroom(p, object);
    if (!height || (lowest && *height >= *lowest)) continue;
    lowest = height;
    why.lack = Obstruction::Lack::kHeadroom;
    why.object = name(object);
    why.at = p + Eigen::Vector3d(0, 0, *height);
    why.width = *height;
    why.needed = stature_;
  }
  return lowest.has_value();
}

bool PassageProbe::measure(const Eigen::Vector3d& ground, double heading, Obstruction& why) const {
  const std::vector<Eigen::Vector3d> places = placesAround(ground, heading);
  Obstruction found = why;
  found.other.clear();
  if (measureAbove(places, found)) {
    why = found;
    return true;
  }
  std::optional<Gap> best;
  for (const Eigen::Vector3d& p : places) {
    // Inside of what has ground on it both sides are its own.
    if (!request_.ground->stand(p.x(), p.y(), p.z(), highest_)) continue;
    const auto gap = across(p, heading);
    if (gap && (!best || gap->width < best->width)) best = gap;
  }
  if (best) best = narrowest(best->middle, heading);
  return best && measureGap(*best, why);
}

}  // namespace amble
