#include "environments/collision/collision_world.h"

#include <cassert>
#include <utility>

#include "environments/collision/collision_model.h"
#include "environments/collision/least_clearance.h"
#include "environments/collision/motion_check.h"

namespace amble {

void CollisionScratchDeleter::operator()(CollisionScratch* scratch) const { delete scratch; }

CollisionWorld::CollisionWorld(const Scene& scene, const SceneGround& ground,
                               const Skeleton& skeleton, const Body& body, const StopRequest& stop,
                               Checker checker)
    : model_(std::make_unique<CollisionModel>(scene, ground, skeleton, body, stop, checker)) {}

CollisionWorld::CollisionWorld(const Scene& scene, std::shared_ptr<const SceneLayers> layers,
                               const Skeleton& skeleton, const Body& body)
    : model_(std::make_unique<CollisionModel>(scene, std::move(layers), skeleton, body)) {}

CollisionWorld::~CollisionWorld() = default;

const Scene& CollisionWorld::scene() const { return model_->scene; }
const Body& CollisionWorld::body() const { return model_->body; }

CollisionScratchPtr CollisionWorld::makeScratch() const {
  return CollisionScratchPtr(new CollisionScratch(model_->skeleton.size(), model_->parts()));
}

std::optional<Contact> CollisionWorld::check(const PoseArray& poses,
                                             std::span<const SolePhases> soles, bool any,
                                             CollisionScratch& scratch) const {
  assert(static_cast<int>(soles.size()) >= poses.size());
  MotionCheck check(*model_, poses, soles, scratch);
  if (any) {
    if (const auto contact = check.coarse()) return contact;
  }
  return check.all(any);
}

std::optional<Contact> CollisionWorld::checkPose(PoseView pose, CollisionScratch& scratch) const {
  model_->placeAlone(pose, scratch);
  return model_->firstContact(scratch);
}

std::vector<Contact> CollisionWorld::contacts(PoseView pose, CollisionScratch& scratch) const {
  std::vector<Contact> all;
  model_->placeAlone(pose, scratch);
  for (int part = 0; part < model_->parts(); ++part) {
    for (const int object : model_->allTouched(part, scratch))
      all.push_back({0, 0.0, part, object, 0.0});
  }
  return all;
}

int CollisionWorld::touched(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
                            CollisionScratch& scratch) const {
  return model_->layers.touchedObstacle({from, to, radius}, 0.0, *scratch.exact);
}

Clearance CollisionWorld::clearance(const PoseArray& poses, double limit,
                                    CollisionScratch& scratch) const {
  return LeastClearance(*model_, poses, limit, scratch).least();
}

PartClearances CollisionWorld::clearances(const PoseArray& poses, double limit,
                                          CollisionScratch& scratch) const {
  const size_t parts = static_cast<size_t>(model_->parts());
  PartClearances found;
  found.distance.reserve(parts * static_cast<size_t>(poses.size()));
  found.object.reserve(found.distance.capacity());
  scratch.prepare(poses.size());
  for (int frame = 0; frame < poses.size(); ++frame) {
    model_->place(poses[frame], scratch, {&scratch.capsule(frame, 0), parts});
    for (size_t part = 0; part < parts; ++part) {
      const ObstacleSet::Nearest nearest =
          model_->layers.nearestObstacle(scratch.capsule(frame, static_cast<int>(part)), limit,
                                         model_->body.parts[part].sole >= 0, *scratch.exact);
      found.distance.push_back(nearest.distance);
      found.object.push_back(nearest.object);
    }
  }
  return found;
}

double CollisionWorld::nearness(const PoseArray& poses, double limit,
                                CollisionScratch& scratch) const {
  constexpr int kEvery = 4;
  const size_t parts = static_cast<size_t>(model_->parts());
  scratch.prepare(poses.size());
  std::vector<int> frames;
  for (int frame = 0; frame < poses.size(); frame += kEvery) frames.push_back(frame);
  model_->track.place(poses, frames, scratch.capsules, scratch.lanes);
  double sum = 0.0;
  for (const int frame : frames) {
    double least = limit;
    for (size_t part = 0; part < parts; ++part) {
      if (model_->body.parts[part].sole >= 0) continue;
      const Capsule& capsule = scratch.capsule(frame, static_cast<int>(part));
      least = model_->layers.nearestObstacle(capsule, least, false, *scratch.exact).distance;
    }
    sum += kEvery * (1.0 - least / limit);
  }
  return sum;
}

}  // namespace amble
