#include "scenarios/find_contacts.h"

#include <algorithm>
#include <map>
#include <set>

#include "scenarios/problem.h"
#include "scenarios/run_scenario.h"
#include "tests/scenarios/small_room.h"

namespace amble {
namespace {

class FindContacts : public SmallRoom {
 protected:
  // A walk through the room, planned once, in another scene.
  void SetUp() override {
    SmallRoom::SetUp();
    static const RunResult planned = runScenario(readScenario(write("case.yaml", kScenario)));
    result_ = &planned;
    ASSERT_EQ(result_->report.status, PlanStatus::kSolved);
  }
  const PoseArray& poses() const { return result_->outcome.walk.buffer.poses; }
  double frameTime() const { return result_->outcome.walk.buffer.frame_time; }
  std::vector<ContactSpan> contactsIn(const std::string& scene_text) const {
    const Problem& problem = *result_->problem;
    const Scene scene = readScene(write("other.yaml", scene_text));
    const SceneGround ground(scene);
    const CollisionWorld world(scene, ground, problem.synthesizer.skeleton(), problem.body);
    return findContacts(world, poses(), frameTime());
  }

  const RunResult* result_ = nullptr;
};

TEST_F(FindContacts, AWalkThatIsFreeHasNone) { EXPECT_TRUE(contactsIn(kScene).empty()); }

TEST_F(FindContacts, EveryPartThatTouchesAtATimeIsTold) {
  // A slab across the way from knee to shoulder: legs, trunk and arms go through it together.
  const std::vector<ContactSpan> spans = contactsIn(
      std::string(kScene) + "  - {name: slab, box: {size: [0.3, 3, 1.0]}, at: [4.4, 1.5, 0.9]}\n");
  std::set<std::string> parts;
  for (const ContactSpan& span : spans) {
    EXPECT_EQ(span.object, "slab");
    EXPECT_LE(span.start, span.end);
    parts.insert(span.part);
  }
  for (const char* part : {"pelvis", "left thigh", "right thigh"}) {
    EXPECT_TRUE(parts.count(part)) << part;
  }
  const bool together = std::any_of(spans.begin(), spans.end(), [&](const ContactSpan& a) {
    return std::any_of(spans.begin(), spans.end(), [&](const ContactSpan& b) {
      return a.part != b.part && a.start <= b.end && b.start <= a.end;
    });
  });
  EXPECT_TRUE(together);
  EXPECT_TRUE(std::is_sorted(spans.begin(), spans.end(),
                             [](const auto& a, const auto& b) { return a.start < b.start; }));
}

TEST_F(FindContacts, APartThatIsInTwoObjectsIsToldWithBoth) {
  const std::string bar = "  - {name: bar, box: {size: [0.2, 3, 0.2]}, at: [4.4, 1.5, 1.0]}\n";
  const std::string slab = "  - {name: slab, box: {size: [0.3, 3, 1.0]}, at: [4.4, 1.5, 0.9]}\n";
  const auto with = [&](const std::string& name, const std::string& things) {
    std::map<std::string, ContactSpan> spans;
    for (const ContactSpan& span : contactsIn(kScene + things)) {
      if (span.object == name) spans.emplace(span.part, span);
    }
    return spans;
  };
  for (const std::string name : {"bar", "slab"}) {
    const auto alone = with(name, name == "bar" ? bar : slab);
    EXPECT_FALSE(alone.empty());
    for (const auto& both : {with(name, bar + slab), with(name, slab + bar)}) {
      ASSERT_EQ(both.size(), alone.size()) << name;
      // But for what touches between two frames only, of which one contact is told.
      for (const auto& [part, span] : alone) {
        ASSERT_TRUE(both.count(part)) << part;
        EXPECT_NEAR(both.at(part).start, span.start, 1.01 * frameTime()) << part;
        EXPECT_NEAR(both.at(part).end, span.end, 1.01 * frameTime()) << part;
      }
    }
  }
}

TEST_F(FindContacts, EachFrameTellsWhatAPoseAloneTells) {
  const std::string text =
      std::string(kScene) + "  - {name: bar, box: {size: [0.1, 3, 0.4]}, at: [4.4, 1.5, 1.2]}\n";
  const std::vector<ContactSpan> spans = contactsIn(text);
  const Problem& problem = *result_->problem;
  const Scene scene = readScene(folder_ / "other.yaml");
  const SceneGround ground(scene);
  const CollisionWorld world(scene, ground, problem.synthesizer.skeleton(), problem.body);
  const auto scratch = world.makeScratch();
  int touched = 0;
  for (int frame = 0; frame < poses().size(); ++frame) {
    for (const Contact& contact : world.contacts(poses()[frame], *scratch)) {
      const std::string& part = problem.body.parts.at(contact.part).name;
      const double time = frame * frameTime();
      EXPECT_TRUE(std::any_of(spans.begin(), spans.end(),
                              [&](const ContactSpan& span) {
                                return span.part == part && span.start <= time && time <= span.end;
                              }))
          << part << " at " << time;
      ++touched;
    }
  }
  EXPECT_GT(touched, 10);
}

}  // namespace
}  // namespace amble
