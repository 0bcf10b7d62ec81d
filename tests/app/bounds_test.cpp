// Bounds of numbers, as the help says them: no command takes what is beyond, and all say so alike.

#include <cmath>
#include <regex>

#include "tests/app/options.h"

namespace amble {
namespace {

// A number of an option, or a ramp of two, and its bounds.
struct Bounded {
  std::string name, text;
  double low = 0.0, high = 0.0;
  bool whole = false, other = false;  // whole numbers only; a ramp, factors or a pair too
};

class Bounds : public Options, public testing::WithParamInterface<const char*> {
 protected:
  // Of the command and what is below it, by the help's own words.
  std::vector<std::string> commands() const {
    std::vector<std::string> all = {GetParam()};
    for (const std::string& below : listed(GetParam(), "Subcommands:"))
      all.push_back(std::string(GetParam()) + " " + below);
    return all;
  }
  std::vector<Bounded> boundedOf(const std::string& command) const {
    static const std::regex line(
        R"(^ +(?:-\w,)?(--[a-z0-9-]+) (INT|FLOAT|TEXT):\[(-?[0-9.e+-]+) to (-?[0-9.e+-]+)([^\]]*)\])");
    std::istringstream help(run(command + " --help").out);
    std::vector<Bounded> found;
    std::smatch match;
    for (std::string text; std::getline(help, text);) {
      if (!std::regex_search(text, match, line)) continue;
      found.push_back({match[1], match[0], std::stod(match[3]), std::stod(match[4]),
                       match[2] == "INT", match[2] == "TEXT"});
    }
    return found;
  }
};

std::string numberText(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

// Just below, just above, and no number at all.
std::vector<std::string> refusedOf(const Bounded& option) {
  if (option.whole) return {numberText(option.low - 1), numberText(option.high + 1), "1.5"};
  const double off = 1e-3 * std::max(1e-3, option.high - option.low);
  std::vector<std::string> refused = {numberText(option.high + off), "nan"};
  if (!option.other) refused.push_back(numberText(option.low - off));
  return refused;
}

TEST_P(Bounds, NoNumberBeyondThemIsTakenAndNothingIsWritten) {
  for (const std::string& command : commands()) {
    const std::string input = command == "animate" ? "" : " in/room.yaml";
    for (const Bounded& option : boundedOf(command)) {
      for (const std::string& value : refusedOf(option)) {
        SCOPED_TRACE(option.text);
        expectRefused(command + " " + option.name + "=" + value + input,
                      {"amble " + command, option.name, "expected"});
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Bounds,
                         testing::Values("plan", "check", "validate", "animate", "analyse",
                                         "library", "edit", "convert", "graft", "inspect",
                                         "roadmap", "graph", "view", "batch"),
                         [](const auto& of) { return std::string(of.param); });

// A command that comes to be is to be looked at here.
TEST_F(Options, BoundsAreLookedForInEveryCommand) {
  for (const std::string& command : listed("", "Subcommands:")) {
    if (command == "help" || command == "completion") continue;
    const auto* suite = testing::UnitTest::GetInstance();
    bool found = false;
    for (int i = 0; i < suite->total_test_suite_count(); ++i)
      for (int k = 0; k < suite->GetTestSuite(i)->total_test_count(); ++k)
        found |= std::string(suite->GetTestSuite(i)->GetTestInfo(k)->name())
                     .ends_with("TakenAndNothingIsWritten/" + command);
    EXPECT_TRUE(found) << command;
  }
}

}  // namespace
}  // namespace amble
