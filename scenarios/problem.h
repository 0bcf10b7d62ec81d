/// What a scenario names, read and put together: all that a planner is asked about and that
/// pictures are drawn of.
#pragma once

#include <memory>

#include "animation/library/motion_library.h"
#include "animation/synthesis/walk_synthesizer.h"
#include "base/stopwatch.h"
#include "environments/body/body.h"
#include "environments/collision/collision_world.h"
#include "environments/ground/scene_ground.h"
#include "environments/scene/scene.h"
#include "planner/legs/planner.h"
#include "scenarios/report.h"
#include "scenarios/scenario.h"

namespace amble {

class WalkedScene;  // walked_scene.h

/// What a problem is read from; problems may share it.
struct ProblemInputs {
  std::shared_ptr<const Scene> scene;
  std::shared_ptr<const MotionLibrary> library;
  LoadTimes times = {};  ///< of reading these
  /// What walkers find in the scene, where several do; none: it is made. @pre of this scene
  std::shared_ptr<const WalkedScene> walked = {};
};
/// @throws InputError; Stopped
ProblemInputs readInputs(const Scenario& scenario, const LoadLimits& limits);

/// Const after construction, but for which of its scenario's queries is asked.
struct Problem {
 private:
  struct Parts;  // they know one another by address, and stay where they were made

 public:
  /// @param frame_time  of the animation [s, 1/240 to 1/24].
  /// @throws InputError: what is not there or broken; a place outside of the bounds or where no
  /// floor is, or several without a z that says which; an unknown planner. @throws Stopped
  Problem(const Scenario& scenario, double frame_time, const LoadLimits& limits = {},
          Checker checker = Checker::kFast);
  /// The same of what is read already. @pre it is what the scenario names
  Problem(const Scenario& scenario, double frame_time, ProblemInputs inputs,
          const LoadLimits& limits = {}, Checker checker = Checker::kFast);
  /// Another walk of the same walker in the same scene: all that was made is shared, for as long as
  /// either is there. What of the scene is ground is what it is to `other`.
  /// @pre but for name, source, ends, planner and expectations the scenarios are the same
  Problem(const Problem& other, const Scenario& scenario);
  Problem(const Problem&) = delete;
  Problem& operator=(const Problem&) = delete;

  std::string keys;  ///< of the query that is asked, before its places' own: "queries[1]."
  LoadTimes times;   ///< what making the parts below took; first, since they tell it
  Scenario scenario;

 private:
  std::shared_ptr<const Parts> parts_;

 public:
  const MotionLibrary& library;
  const Scene& scene;
  const SceneGround& ground;  ///< what the character can stand on, in all layers
  double floor;               ///< height of that which the start stands on [m, World]
  const WalkSynthesizer& synthesizer;
  const Body& body;
  const CollisionWorld& world;

  /// From now on start, goal and via of the scenario are those of its query of that index; at the
  /// begin they are those of the first. @throws InputError
  void ask(size_t query);
  /// What a planner is asked, without start, goal and via, by the scenario's seed and max_failures.
  PlanRequest request() const;
  /// Start, goal and via, on the ground. @throws InputError
  PlanQuery query() const;

  /// Where a stance of the scenario stands: on the floor there, or on that which its z names [m,
  /// World].
  Eigen::Vector3d stand(const Place& place, const std::string& key) const;
  /// Every file that it was read from: what may not be written over.
  std::vector<std::filesystem::path> inputs() const;
  /// Where to look: the scenario's bounds, or the extent of what can be walked on [m].
  Eigen::AlignedBox2d bounds() const;
};

/// What a scenario names, as Problem reads it. @throws InputError; Stopped
SceneReading beginScene(const Scenario& scenario, const LoadLimits& limits);
MotionLibrary loadLibrary(const Scenario& scenario);
/// The same of its file that is read, with all styles.
MotionLibrary loadLibrary(const Scenario& scenario, const MotionLibrary& all);
/// What is ground to the scenario's character, whose places are ground.
GroundSettings groundSettings(const Scenario& scenario, const MotionLibrary& library);

/// Height of the floor that a place stands on [m]. `key` names it in messages: "start", "goal",
/// "via[0]". @throws InputError
double chooseFloor(const Scene& scene, const SceneGround& ground, const Scenario& scenario,
                   const Place& place, const std::string& key);

}  // namespace amble
