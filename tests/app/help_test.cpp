// What the program says of itself: its help, the manual page, and what shells complete.

#include <nlohmann/json.hpp>
#include <sstream>

#include "tests/app/options.h"

namespace amble {
namespace {

class Help : public Options {
 protected:
  /// "", "plan", ..., "library add", ...: every command there is.
  std::vector<std::string> commands() const {
    std::vector<std::string> all = {""};
    for (size_t i = 0; i < all.size(); ++i)
      for (const std::string& name : listed(all[i], "Subcommands:"))
        all.push_back(all[i].empty() ? name : all[i] + " " + name);
    return all;
  }
  bool has(const std::string& program) const { return shell("command -v " + program).status == 0; }
  /// What bash offers behind a command line, by the function that it has been told to ask.
  std::set<std::string> completed(const std::string& line) const {
    const Ran ran = shell("bash -c '" + kAsk + "' bash " + line);
    EXPECT_EQ(ran.status, 0) << ran.err;
    std::istringstream words(ran.out);
    std::set<std::string> all;
    for (std::string word; std::getline(words, word);) all.insert(word);
    return all;
  }

 private:
  // As readline does: the words in COMP_WORDS, the last of them unfinished.
  const std::string kAsk = std::string("source <(\"$AMBLE\" completion bash); COMP_WORDS=(amble ") +
                           "\"$@\"); COMP_CWORD=$#; set -- $(complete -p amble); "
                           "\"$3\" amble; printf \"%s\\n\" \"${COMPREPLY[@]}\"";
};

TEST_F(Help, BeginsWithExamples) {
  const std::string help = good("--help").out;
  const size_t examples = help.find("Examples:\n  amble plan "), usage = help.find("Usage:");
  ASSERT_NE(examples, std::string::npos) << help;
  EXPECT_LT(examples, usage);
}

TEST_F(Help, OfEveryCommandSaysWhatItEndsWith) {
  const std::vector<std::string> all = commands();
  EXPECT_GT(all.size(), 15u);
  for (const std::string& command : all) {
    const std::string help = good(command + " --help").out;
    const size_t line = help.find("\nExit status: 0 ");
    ASSERT_NE(line, std::string::npos) << command;
    EXPECT_NE(help.find("; 2 the input or the use is wrong; 130 stopped by Ctrl-C.\n", line),
              std::string::npos)
        << command;
    EXPECT_EQ(help.find("\nExit status: ", line + 1), std::string::npos)
        << command << " has its parent's too";
    EXPECT_EQ(good("help " + command).out, help) << "the same by another way";
  }
}

TEST_F(Help, OfEveryCommandIsInTheManualPage) {
  std::string page = good("help --man").out;
  for (size_t at; (at = page.find("\\-")) != std::string::npos;) page.erase(at, 1);
  for (const std::string& command : commands()) {
    if (command.empty() || !listed(command, "Subcommands:").empty()) continue;
    const size_t section = page.find(".SS amble " + command + "\n");
    ASSERT_NE(section, std::string::npos) << command;
    const std::string text = page.substr(section, page.find("\n.S", section + 1) - section);
    for (const std::string& option : optionsOf(command))
      EXPECT_NE(text.find("\\fB" + option + "\\fR"), std::string::npos) << command << option;
  }
}

TEST_F(Help, TheManualPageIsCleanForItsReaders) {
  good("help --man > amble.1");
  if (has("mandoc")) {
    // It has no date, so that it is the same whenever it is made.
    const Ran ran = shell("mandoc -Tlint -Wwarning amble.1 2>&1 | grep -v 'missing date'");
    EXPECT_EQ(ran.out + ran.err, "");
  } else {
    GTEST_SKIP() << "no mandoc here";
  }
}

TEST_F(Help, BashCompletesCommandsOptionsAndTheirValues) {
  using Words = std::set<std::string>;
  EXPECT_EQ(completed("pl"), Words{"plan"});
  EXPECT_TRUE(completed("''").contains("library"));
  EXPECT_EQ(completed("library sh"), Words{"show"});
  EXPECT_EQ(completed("plan --plann"), Words{"--planner"});
  EXPECT_TRUE(completed("plan --planner ''").contains("visibility"));
  EXPECT_EQ(completed("plan --planner = vis"), Words{"visibility"}) << "--planner=vis";
  EXPECT_EQ(completed("plan --bvh-units ''"), (Words{"m", "cm"}));
  EXPECT_EQ(completed("plan --formats bvh,js"), Words{"bvh,json"});
  EXPECT_EQ(completed("completion z"), Words{"zsh"});
  EXPECT_EQ(completed("plan --seed ''"), Words{""}) << "numbers are nobody's to guess";
}

TEST_F(Help, BashCompletesFilesAndFolders) {
  using Words = std::set<std::string>;
  write("two words.yaml", "");
  write("two words/in.yaml", "");
  EXPECT_EQ(completed("plan two"), (Words{"two words", "two words.yaml"}));
  EXPECT_EQ(completed("plan -o two"), Words{"two words"});
  EXPECT_EQ(completed("validate --scene two"), (Words{"two words", "two words.yaml"}));
}

// Every option of every command is offered, so none is forgotten.
TEST_F(Help, BashOffersWhatTheHelpHas) {
  for (const std::string& command : commands()) {
    const std::set<std::string> offered = completed(command + " --");
    for (const std::string& option : optionsOf(command))
      EXPECT_TRUE(offered.contains(option)) << command << ' ' << option;
  }
}

TEST_F(Help, FishAndZshTakeWhatIsWrittenForThem) {
  const std::string ask = "\"$AMBLE\" completion fish | source; complete -C ";
  if (!has("fish") || !has("zsh")) GTEST_SKIP() << "no fish or no zsh here";
  const auto fish = [&](const std::string& line) {
    return shell("fish --no-config -c '" + ask + "\"amble " + line + "\"'").out;
  };
  EXPECT_EQ(fish("pl").find("plan\t"), 0u) << fish("pl");
  EXPECT_EQ(fish("library sh").find("show\t"), 0u) << fish("library sh");
  EXPECT_NE(fish("plan --bvh-units ").find("cm"), std::string::npos);
  const Ran zsh = shell("\"$AMBLE\" completion zsh >_amble && zsh -n _amble");
  EXPECT_EQ(zsh.status, 0) << zsh.err;
}

}  // namespace
}  // namespace amble
