#include "scenarios/find_contacts.h"

#include <algorithm>
#include <map>

#include "scenarios/problem.h"

namespace amble {
namespace {

// Contacts one after another, as stretches of time.
class Spans {
 public:
  Spans(const CollisionWorld& world, double frame_time) : world_(world), frame_time_(frame_time) {}

  void add(const Contact& contact, double time) {
    const auto [open, is_new] =
        open_.emplace(std::pair{contact.part, contact.object}, spans_.size());
    if (!is_new && time - spans_[open->second].end < 2.0 * frame_time_) {
      spans_[open->second].end = time;
      return;
    }
    open->second = spans_.size();
    spans_.push_back({time, time, world_.body().parts.at(contact.part).name,
                      objectName(world_.scene().objects.at(contact.object))});
  }
  std::vector<ContactSpan> take() { return std::move(spans_); }

 private:
  const CollisionWorld& world_;
  const double frame_time_;
  std::vector<ContactSpan> spans_;
  std::map<std::pair<int, int>, size_t> open_;  // last span of each part and object
};

}  // namespace

std::vector<ContactSpan> findContacts(const CollisionWorld& world, const PoseArray& poses,
                                      double frame_time) {
  const auto scratch = world.makeScratch();
  const std::vector<SolePhases> planted(std::max(2, poses.size()));  // as they begin
  if (!world.check(poses, planted, false, *scratch)) return {};
  Spans spans(world, frame_time);
  for (int frame = 0; frame < poses.size(); ++frame) {
    const std::vector<Contact> here = world.contacts(poses[frame], *scratch);
    for (const Contact& contact : here) spans.add(contact, frame * frame_time);
    if (!here.empty() || frame + 1 == poses.size()) continue;
    PoseArray interval(poses.joints());
    interval.append(poses, frame, 2);
    const auto between = world.check(interval, planted, false, *scratch);
    if (between && between->frame == 0)
      spans.add(*between, (frame + between->between) * frame_time);
  }
  return spans.take();
}

}  // namespace amble
