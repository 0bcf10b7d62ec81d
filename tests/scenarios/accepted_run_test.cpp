#include "scenarios/accepted_run.h"

#include <set>

#include "tests/scenarios/small_room.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

class AcceptedRunFile : public SmallRoom {
 protected:
  static RunFigures someFigures() {
    return {"solved", 5.123456789, 4.5, 0.0123, 1e-5, 0.25, std::string(64, 'a')};
  }
};

TEST_F(AcceptedRunFile, ComesBackToTheNanometre) {
  const fs::path file = folder_ / "accepted/case.json";
  EXPECT_FALSE(readAccepted(file));
  writeAccepted(file, {someFigures(), "a picture"});
  const std::optional<AcceptedRun> back = readAccepted(file);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->figures.status, "solved");
  EXPECT_EQ(back->figures.bvh_sha256, std::string(64, 'a'));
  for (const RunFigure& figure : kFigures)
    EXPECT_NEAR(back->figures.*figure.value, someFigures().*figure.value, 1e-9) << figure.name;
  EXPECT_EQ(back->picture, "a picture");
  EXPECT_EQ(changesSince(back->figures, someFigures()), "");
}

TEST_F(AcceptedRunFile, OfARunWithoutAWalkHasNoneOfItsFigures) {
  const fs::path file = folder_ / "accepted/case.json";
  RunFigures none;
  none.status = "no_walk";
  writeAccepted(file, {someFigures(), "a picture"});
  writeAccepted(file, {none, ""});
  const std::optional<AcceptedRun> back = readAccepted(file);
  ASSERT_TRUE(back);
  EXPECT_FALSE(back->figures.hasWalk());
  EXPECT_EQ(back->picture, "");
  EXPECT_FALSE(fs::exists(folder_ / "accepted/case.png")) << "of the run before";
  EXPECT_FALSE(holds(read(file), "length"));
}

TEST_F(AcceptedRunFile, ThatIsNoneIsNamedWithItsLine) {
  const auto wrong = [&](const std::string& text) {
    write("accepted/case.json", text);
    return inputError([&] { readAccepted(folder_ / "accepted/case.json"); });
  };
  EXPECT_TRUE(holds(wrong("{\n"), "case.json:"));
  EXPECT_TRUE(holds(wrong("{\"status\": \"solved\",\n\"lenght\": 1}"), "case.json:2: "));
  EXPECT_TRUE(holds(wrong("{\"status\": \"no_walk\"}"), "planning_time"));
}

TEST_F(AcceptedRunFile, OfNoTwoScenariosOrQueriesIsTheSame) {
  const std::set<fs::path> all = {acceptedFile("a/x.yaml", ""), acceptedFile("b/x.yaml", ""),
                                  acceptedFile("a/x.yml", ""), acceptedFile("a/x.yaml", "q"),
                                  acceptedFile("a/x.yaml", "r")};
  EXPECT_EQ(all.size(), 5u);
}

TEST(ChangesSince, AreThoseOfTheWalkAndNotOfItsTime) {
  const RunFigures before = {"solved", 5.0, 4.0, 0.02, 0.001, 0.5, std::string(64, 'a')};
  RunFigures now = before;
  now.planning_time = 50.0;
  EXPECT_EQ(changesSince(before, now), "");
  now.length = 5.25;
  EXPECT_EQ(changesSince(before, now), "walk is not the accepted one: length 5.00 -> 5.25 m");
  now.foot_skate = 0.0015;
  EXPECT_EQ(changesSince(before, now),
            "walk is not the accepted one: length 5.00 -> 5.25 m, foot skate 1.0 -> 1.5 mm");
  now = before;
  now.bvh_sha256 = std::string(64, 'b');
  EXPECT_EQ(changesSince(before, now), "walk is not the accepted one: its figures are the same");
  now = {};
  now.status = "no_walk";
  EXPECT_EQ(changesSince(before, now), "status is no_walk; accepted was solved");
}

}  // namespace
}  // namespace amble
