/// Whether contacts are decided rightly: bodies in furnished and uneven scenes, ground and soles
/// included, half of them within 1 mm to 1e-6 m of a contact. `wrong` counts the decisions that
/// distances by brute force contradict.
///
/// A body is one of the scenario's walk, moved aside, its capsules all made thicker by what is left
/// to a contact and a drawn gap, so that it is decided by whatever is nearest: of whole bodies on
/// the floor by a sole, of bodies without their soles by furniture, walls and the edges of steps.
/// `bodies` are counted once a thickness, `places` once a pose.
#include <algorithm>
#include <cmath>
#include <random>

#include "base/rotation.h"
#include "benchmarks/brute_force.h"
#include "benchmarks/scenarios.h"
#include "environments/collision/contact.h"
#include "environments/collision/scene_layers.h"
#include "scenarios/problem.h"

namespace amble {
namespace {

// A capsule of a body, and how deep it may be in the ground [m].
struct Part {
  Capsule capsule;
  double depth;
};
using Parts = std::vector<Part>;

// By what is measured.
class Decider {
 public:
  explicit Decider(const Problem& problem) : layers_(problem.scene, problem.ground) {}

  bool touches(const Parts& body, double thicker) const {
    return std::any_of(body.begin(), body.end(), [&](const Part& part) {
      const Capsule capsule = part.capsule.inflated(thicker);
      return layers_.touchedObstacle(capsule, part.depth, *scratch_) >= 0 ||
             layers_.ground().touched(capsule, part.depth, *scratch_) >= 0;
    });
  }

 private:
  SceneLayers layers_;
  ObstacleSet::ScratchPtr scratch_ = ObstacleSet::makeScratch();
};

// The same by distances. Whatever is part of a ground object is met a sole's depth higher.
class Reference {
 public:
  explicit Reference(const Problem& problem) {
    for (size_t i = 0; i < problem.scene.objects.size(); ++i) {
      const SceneObject& object = problem.scene.objects[i];
      if (object.role == Role::kIgnore) continue;
      (problem.ground.isGround(static_cast<int>(i)) ? ground_ : obstacles_).add(object);
    }
  }

  double clearance(const Parts& body) const {
    double least = BruteForce::kFarthest;
    for (const Part& part : body) {
      const Eigen::Vector3d up(0.0, 0.0, part.depth);
      const Capsule lifted{part.capsule.from + up, part.capsule.to + up, part.capsule.radius};
      least = obstacles_.distance(part.capsule, ground_.distance(lifted, least));
    }
    return least;
  }

 private:
  BruteForce obstacles_, ground_;
};

// Bodies of the walk where they are, and beside there in eight directions.
std::vector<Parts> bodiesOf(const RunResult& result, int every, bool soles) {
  constexpr double kAside = 0.7;  // [m]
  const Problem& problem = *result.problem;
  const AnimationBuffer& walk = result.outcome.walk.buffer;
  const std::vector<BodyPart>& parts = problem.body.parts;
  std::vector<JointFrame> joints(problem.synthesizer.skeleton().size());
  std::vector<Eigen::Vector3d> from(parts.size()), to(parts.size());
  std::vector<Parts> bodies;
  for (int frame = 0; frame < walk.size(); frame += every) {
    forwardKinematics(problem.synthesizer.skeleton(), walk.poses[frame], joints);
    placeBody(problem.body, joints, from, to);
    for (int direction = -1; direction < 8; ++direction) {
      const double angle = kPi / 4.0 * direction;
      const Eigen::Vector3d aside =
          (direction < 0 ? 0.0 : kAside) * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0);
      Parts body;
      for (size_t i = 0; i < parts.size(); ++i) {
        const int sole = parts[i].sole;
        if (sole >= 0 && !soles) continue;
        const double depth = sole < 0                                          ? 0.0
                             : walk.soles[frame][sole] == SolePhase::kSwinging ? kSwingDepth
                                                                               : kSoleDepth;
        body.push_back({{from[i] + aside, to[i] + aside, parts[i].radius}, depth});
      }
      bodies.push_back(std::move(body));
    }
  }
  return bodies;
}

struct Count {
  int wrong = 0, bodies = 0, near = 0, places = 0;
};

// Decisions about a body, made so thick that it is short of a contact, or over it, by drawn gaps.
void judge(const Parts& body, double clearance, int times, const Decider& decider,
           std::mt19937_64& generator, Count& count) {
  std::uniform_real_distribution<double> power(-6.0, -3.0), gaps(-0.1, 0.2), coin(0.0, 1.0);
  for (int k = 0; k < times; ++k) {
    const bool is_near = k % 2 == 0;
    const double tiny = (coin(generator) < 0.5 ? -1.0 : 1.0) * std::pow(10.0, power(generator));
    const double gap = is_near ? tiny : std::min(gaps(generator), clearance);
    ++count.bodies;
    count.near += is_near;
    count.wrong += decider.touches(body, clearance - gap) != (gap < 0.0);
  }
}

void decisions(benchmark::State& state, const std::string& scenario, bool soles) {
  constexpr int kBodies = 12000;  // of each row
  constexpr int kPlaces = 300;    // most of each row
  const RunResult& result = planned(scenario);
  const int every = std::max(1, 9 * result.outcome.walk.buffer.size() / kPlaces);
  const std::vector<Parts> bodies = bodiesOf(result, every, soles);
  const Decider decider(*result.problem);
  const Reference exact(*result.problem);
  std::mt19937_64 generator(1);
  Count count;
  for (auto _ : state) {
    std::vector<std::pair<const Parts*, double>> free;
    for (const Parts& body : bodies) {
      const double clearance = exact.clearance(body);
      const bool touches = decider.touches(body, 0.0);
      if (!touches && clearance < 0.0) ++count.wrong;
      // Those that are said to touch, far from all surfaces, are inside of something.
      if (!touches && clearance > 0.0 && clearance < BruteForce::kFarthest)
        free.emplace_back(&body, clearance);
    }
    count.places = static_cast<int>(free.size());
    for (const auto& [body, clearance] : free)
      judge(*body, clearance, kBodies / count.places + 1, decider, generator, count);
  }
  state.counters["wrong"] = count.wrong;
  state.counters["bodies"] = count.bodies;
  state.counters["near"] = count.near;
  state.counters["places"] = count.places;
}

void addRows(const std::string& scenario) {
  for (const bool soles : {true, false}) {
    const std::string measure = soles ? "decisions" : "decisionsWithoutSoles";
    benchmark::RegisterBenchmark(
        rowName(measure, scenario).c_str(),
        [scenario, soles](benchmark::State& state) { decisions(state, scenario, soles); })
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
  }
}

}  // namespace
}  // namespace amble

int main(int argc, char** argv) {
  return amble::runOnScenarios(
      argc, argv, {"living-room", "apartment", "rubble", "stairs-up", "rolling-terrain"},
      amble::addRows);
}
