// amble batch stats, as a shell runs it: of a batch that was made, and of tables as others may have
// left them.

#include "tests/app/options.h"

namespace amble {
namespace {

using nlohmann::json;

class BatchStats : public Options {
 protected:
  void SetUp() override {
    Options::SetUp();
    write("in/job.yaml",
          "scenes:\n  - scene: room.yaml\n    ways:\n"
          "      - {name: ahead, start: {at: [1, 2]}, goal: {at: [3, 2]}}\n"
          "      - {name: off the floor, start: {at: [1, 2]}, goal: {at: [9, 2]}}\n"
          "speeds: [1.0, 1.3]\n");
  }
  void make() const { good("batch in/job.yaml -o walks"); }
};

TEST_F(BatchStats, OptionsAreAllTried) {
  make();
  expectEach("batch stats",
             {{"--json", [&] { EXPECT_EQ(printed("batch stats walks --json")["walks"], 4); }},
              {"--plot", [&] {
                 good("batch stats walks --plot out.svg");
                 EXPECT_NE(read("out.svg").find("<svg"), std::string::npos);
               }}});
}

TEST_F(BatchStats, FiguresAreThoseOfTheTable) {
  make();
  const json all = printed("batch stats walks --json");
  std::istringstream table(read("walks/index.jsonl"));
  std::vector<double> lengths;
  int refused = 0;
  for (std::string line; std::getline(table, line);) {
    const json row = json::parse(line);
    if (row["status"] == "solved") {
      lengths.push_back(row["length"]);
    } else {
      ++refused;
    }
  }
  ASSERT_EQ(lengths.size(), 2u);
  EXPECT_EQ(all["solved"], 2);
  EXPECT_EQ(all["measures"]["length"]["least"], std::min(lengths[0], lengths[1]));
  EXPECT_EQ(all["measures"]["length"]["most"], std::max(lengths[0], lengths[1]));
  double frames = 0.0, seconds = 0.0;
  for (const auto& [activity, time] : all["activities"].items()) seconds += time.get<double>();
  std::istringstream again(read("walks/index.jsonl"));
  for (std::string line; std::getline(again, line);)
    frames += json::parse(line)["frames"].get<int>();
  EXPECT_NEAR(seconds, frames / 60.0, 0.01);
  int counted = 0;
  for (const auto& [rule, count] : all["refusals"].items()) counted += count.get<int>();
  EXPECT_EQ(counted, refused);
  const Ran told = good("batch stats walks");
  for (const char* part : {"walks: 2 walks of 4 asked for", "length", "m/s", "refused by"})
    EXPECT_NE(told.out.find(part), std::string::npos) << part << '\n' << told.out;
}

TEST_F(BatchStats, WhatIsNoTableIsOneLine) {
  write("empty/note.txt", "");
  expectRefused("batch stats empty", {"empty: has no index.jsonl; expected", "amble batch merge"});
  expectRefused("batch stats nowhere", {"nowhere: has no index.jsonl"});
  make();
  const std::string table = read("walks/index.jsonl");
  write("walks/index.jsonl", table + "{\"walk\": 3}\n");
  expectRefused("batch stats walks", {"walks/index.jsonl:5: is no row of a batch; expected"});
  write("walks/index.jsonl", table.substr(0, table.size() / 2));
  expectRefused("batch stats walks", {"walks/index.jsonl:", "is no row of a batch"});
  expectRefused("batch stats walks --plot nowhere/out.svg", {"index.jsonl"});
}

TEST_F(BatchStats, OfNoWalksThereAreNoFigures) {
  write("walks/index.jsonl", "");
  const json none = printed("batch stats walks --json --plot none.svg");
  EXPECT_EQ(none["walks"], 0);
  EXPECT_TRUE(none["measures"].empty());
  EXPECT_NE(read("none.svg").find("</svg>"), std::string::npos);
}

}  // namespace
}  // namespace amble
