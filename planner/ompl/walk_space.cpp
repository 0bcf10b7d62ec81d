#include "planner/ompl/walk_space.h"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/StateSampler.h>
#include <ompl/base/StateSpace.h>
#include <ompl/base/StateValidityChecker.h>

#include <cmath>
#include <unordered_set>

#include "base/rotation.h"
#include "planner/ompl/quiet_ompl.h"

namespace amble {
namespace {

namespace ob = ompl::base;

// How much nearer a stance is that needs no turn: metres that are walked while the body turns by a
// radian, roughly [m/rad].
constexpr double kTurnWeight = 0.3;
// Streams of samples near a place are far from those of the roadmap's samples, which begin at 0.
constexpr std::uint64_t kNearStreams = 1ULL << 50;

class WalkState : public ob::State {
 public:
  Waypoint at;
  PlaceId place = 0;
};

WalkState& walkState(ob::State* state) { return *static_cast<WalkState*>(state); }
const WalkState& walkState(const ob::State* state) { return *static_cast<const WalkState*>(state); }

class WalkSpace : public ob::StateSpace {
 public:
  WalkSpace(const Steering& steering, const Eigen::AlignedBox2d& bounds, std::uint64_t the_seed)
      : sampler(steering, bounds), seed(the_seed), scratch_(steering.makeScratch()) {
    setName("Amble stances");
    type_ = ob::STATE_SPACE_UNKNOWN;
  }
  ~WalkSpace() override {
    for (WalkState* state : states_) delete state;
  }

  bool isMetricSpace() const override { return false; }
  bool hasSymmetricDistance() const override { return false; }
  bool hasSymmetricInterpolate() const override { return false; }
  unsigned int validSegmentCount(const ob::State*, const ob::State*) const override { return 1; }
  unsigned int getDimension() const override { return 3; }
  double getMaximumExtent() const override {
    return sampler.bounds().diagonal().norm() + kTurnWeight * kPi;
  }
  double getMeasure() const override { return sampler.bounds().volume() * 2.0 * kPi; }

  void enforceBounds(ob::State* state) const override {
    if (satisfiesBounds(state)) return;
    const Eigen::AlignedBox2d& bounds = sampler.bounds();
    Waypoint at = walkState(state).at;
    Eigen::Vector3d& p = at.stance.position;
    p.head<2>() = p.head<2>().cwiseMax(bounds.min()).cwiseMin(bounds.max()).eval();
    put(at, state);
  }
  bool satisfiesBounds(const ob::State* state) const override {
    return sampler.bounds().contains(walkState(state).at.stance.position.head<2>());
  }
  void copyState(ob::State* to, const ob::State* from) const override {
    walkState(to).at = walkState(from).at;
    walkState(to).place = walkState(from).place;
  }
  bool equalStates(const ob::State* a, const ob::State* b) const override {
    return distance(a, b) == 0.0;
  }

  double distance(const ob::State* from, const ob::State* to) const override {
    const Waypoint &a = walkState(from).at, &b = walkState(to).at;
    const double way = (a.stance.position - b.stance.position).norm();
    if (a.any_heading || b.any_heading) return way;
    return way + kTurnWeight * std::abs(wrapAngle(b.stance.heading - a.stance.heading));
  }

  // A stance on the straight line, headed along it: the way one walks from `from` to `to`, not
  // back.
  void interpolate(const ob::State* from, const ob::State* to, double t,
                   ob::State* state) const override {
    if (t <= 0.0 || t >= 1.0) {
      copyState(state, t <= 0.0 ? from : to);
      return;
    }
    const Eigen::Vector3d begin = walkState(from).at.stance.position;
    const Eigen::Vector3d way = walkState(to).at.stance.position - begin;
    Waypoint at;
    at.stance.position = begin + t * way;
    at.stance.heading = std::atan2(way.y(), way.x());
    sampler.steering().place(at.stance);
    put(at, state);
  }

  ob::StateSamplerPtr allocDefaultStateSampler() const override;
  ob::State* allocState() const override { return *states_.insert(new WalkState).first; }
  void freeState(ob::State* state) const override {
    states_.erase(&walkState(state));
    delete &walkState(state);
  }

  void put(const Waypoint& at, ob::State* state) const {
    walkState(state).at = at;
    walkState(state).place = ++places_;
  }
  const SteerResult& motion(const ob::State* from, const ob::State* to) const {
    const WalkState &a = walkState(from), &b = walkState(to);
    return edges.answer(a.place, b.place, [&] {
      SteerResult result = sampler.steering().steer(a.at, b.at, *scratch_);
      effort.steering.add(result);
      if (!result.edge) effort.refused.push_back({a.at, b.at, result.failure});
      return result;
    });
  }

  const StanceSampler sampler;
  // OMPL asks const objects; whoever plans in the space does so alone.
  mutable std::uint64_t seed;
  mutable SpaceEffort effort;
  mutable EdgeMemory edges;

 private:
  const SteeringScratchPtr scratch_;
  mutable PlaceId places_ = 0;
  // All that live: some planners (SST) forget to free theirs.
  mutable std::unordered_set<WalkState*> states_;
};

class WalkSampler : public ob::StateSampler {
 public:
  explicit WalkSampler(const WalkSpace* space)
      : StateSampler(space), own_(*space), scratch_(space->sampler.steering().makeScratch()) {}

  // Where no try is free the state stays as it is, and costs one more refusal.
  void sampleUniform(ob::State* state) override {
    if (const auto sample = own_.sampler.draw(own_.seed, own_.effort.samples++, *scratch_))
      own_.put({sample->stance}, state);
  }
  // Headed as one gets there from `near`.
  void sampleUniformNear(ob::State* state, const ob::State* near, double distance) override {
    SampleStream stream(own_.seed, kNearStreams + own_.effort.samples++);
    const double heading = stream.uniform(-kPi, kPi),
                 radius = distance * std::sqrt(stream.uniform());
    Waypoint at;
    at.stance = walkState(near).at.stance;
    at.stance.standing = true;
    at.stance.heading = heading;
    at.stance.position += radius * Eigen::Vector3d(std::cos(heading), std::sin(heading), 0.0);
    own_.sampler.steering().place(at.stance);
    own_.put(at, state);
  }
  void sampleGaussian(ob::State* state, const ob::State* mean, double deviation) override {
    sampleUniformNear(state, mean, 2.0 * deviation);
  }

 private:
  const WalkSpace& own_;
  SteeringScratchPtr scratch_;
};

ob::StateSamplerPtr WalkSpace::allocDefaultStateSampler() const {
  return std::make_shared<WalkSampler>(this);
}

const WalkSpace& walkSpace(const ob::SpaceInformation& space) {
  return static_cast<const WalkSpace&>(*space.getStateSpace());
}

class StandChecker : public ob::StateValidityChecker {
 public:
  explicit StandChecker(ob::SpaceInformation* space)
      : StateValidityChecker(space),
        steering_(walkSpace(*space).sampler.steering()),
        scratch_(steering_.makeScratch()) {}
  bool isValid(const ob::State* state) const override {
    Stance stance = walkState(state).at.stance;
    return si_->satisfiesBounds(state) && !steering_.stand(stance, *scratch_);
  }

 private:
  const Steering& steering_;
  SteeringScratchPtr scratch_;
};

class WalkValidator : public ob::MotionValidator {
 public:
  using MotionValidator::MotionValidator;

  bool checkMotion(const ob::State* from, const ob::State* to) const override {
    const bool valid = walkSpace(*si_).motion(from, to).edge.has_value();
    valid ? ++valid_ : ++invalid_;
    return valid;
  }
  // An edge is valid whole or not at all: of a refused one the last valid state is its begin.
  bool checkMotion(const ob::State* from, const ob::State* to,
                   std::pair<ob::State*, double>& last) const override {
    if (checkMotion(from, to)) return true;
    if (last.first) si_->copyState(last.first, from);
    last.second = 0.0;
    return false;
  }
};

}  // namespace

OmplSpacePtr makeWalkSpace(const Steering& steering, const Eigen::AlignedBox2d& bounds,
                           std::uint64_t seed) {
  const QuietOmpl quiet;
  const auto space =
      std::make_shared<ob::SpaceInformation>(std::make_shared<WalkSpace>(steering, bounds, seed));
  space->setStateValidityChecker(std::make_shared<StandChecker>(space.get()));
  space->setMotionValidator(std::make_shared<WalkValidator>(space.get()));
  space->setup();
  return space;
}

SpaceEffort& effortOf(const ob::SpaceInformation& space) { return walkSpace(space).effort; }

void restart(const ob::SpaceInformation& space, std::uint64_t seed) {
  const WalkSpace& own = walkSpace(space);
  own.seed = seed;
  own.effort = {};
  own.edges.clear();
}

std::uint64_t seedOf(const ob::SpaceInformation& space) { return walkSpace(space).seed; }

const StanceSampler& samplerOf(const ob::SpaceInformation& space) {
  return walkSpace(space).sampler;
}

const Waypoint& waypointOf(const ob::State* state) { return walkState(state).at; }

void setWaypoint(const ob::SpaceInformation& space, const Waypoint& at, ob::State* state) {
  walkSpace(space).put(at, state);
}

const SteerResult& motionOf(const ob::SpaceInformation& space, const ob::State* from,
                            const ob::State* to) {
  return walkSpace(space).motion(from, to);
}

void learnEdge(const ob::SpaceInformation& space, const ob::State* from, const ob::State* to,
               const WalkEdge& edge) {
  SteerResult known;
  known.edge = edge;
  walkSpace(space).edges.learn(walkState(from).place, walkState(to).place, std::move(known));
}

}  // namespace amble
