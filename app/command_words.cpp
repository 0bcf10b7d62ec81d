#include "app/command_words.h"

#include <CLI/CLI.hpp>
#include <sstream>

#include "base/text.h"

namespace amble {
namespace {

// Of "TEXT:{m,cm}", as CLI::IsMember and ours say what may be given.
std::vector<std::string> choicesIn(const std::string& value) {
  const size_t from = value.find('{'), to = value.find('}');
  std::vector<std::string> choices;
  if (from == std::string::npos || to == std::string::npos || to < from) return choices;
  std::istringstream list(value.substr(from + 1, to - from - 1));
  for (std::string choice; std::getline(list, choice, ',');) choices.push_back(choice);
  return choices;
}

OptionWords wordsOf(const CLI::Option& option) {
  OptionWords words;
  for (const std::string& name : option.get_snames()) words.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) words.names.push_back("--" + name);
  if (option.get_positional()) words.names = {option.get_name(true)};
  words.what = option.get_description();
  words.required = option.get_required();
  if (option.get_items_expected_max() == 0) return words;
  words.value = option.get_type_name();
  words.choices = choicesIn(words.value);
  words.usual = option.get_default_str();
  words.list = option.get_delimiter() != '\0' ||
               option.get_items_expected_max() >= CLI::detail::expected_max_vector_size;
  words.kind = !words.choices.empty()            ? ValueKind::kChoice
               : words.value.starts_with("FILE") ? ValueKind::kFile
               : words.value.starts_with("DIR")  ? ValueKind::kFolder
                                                 : ValueKind::kOther;
  return words;
}

void readFooter(const std::string& footer, CommandWords& words) {
  constexpr std::string_view kExample = "  amble ", kStatus = "Exit status: ";
  std::istringstream lines(footer);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(kExample)) words.examples.push_back(line.substr(2));
    if (line.starts_with(kStatus)) words.exit_status = line.substr(kStatus.size());
  }
}

CommandWords wordsBelow(const CLI::App& app, const std::string& parent) {
  CommandWords words;
  words.name = app.get_name();
  words.path = parent.empty() ? words.name : parent + " " + words.name;
  words.what = app.get_description();
  for (const CLI::Option* option : app.get_options([](const CLI::Option*) { return true; }))
    (option->get_positional() ? words.places : words.options).push_back(wordsOf(*option));
  readFooter(app.get_footer(), words);
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
    words.commands.push_back(wordsBelow(*command, words.path));
  return words;
}

void addAll(const CommandWords& command, std::vector<const CommandWords*>& all) {
  all.push_back(&command);
  for (const CommandWords& below : command.commands) addAll(below, all);
}

}  // namespace

CommandWords wordsOf(const CLI::App& app) {
  CommandWords program = wordsBelow(app, "");
  // Its description begins with examples.
  if (const auto parts = splitAt(program.what, "\n\n")) {
    const std::string text = program.what;
    program.what = parts->first;
    readFooter(text, program);
  }
  readFooter(app.get_footer(), program);
  return program;
}

std::vector<const CommandWords*> allCommands(const CommandWords& program) {
  std::vector<const CommandWords*> all;
  addAll(program, all);
  return all;
}

}  // namespace amble
