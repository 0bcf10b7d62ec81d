#include "app/misuse.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/strict_yaml.h"

namespace amble {
namespace {

// The command that was chosen, subcommands last, with its words: "amble library add".
std::pair<const CLI::App*, std::string> chosenCommand(const CLI::App& app) {
  const CLI::App* at = &app;
  std::string words = app.get_name();
  while (!at->get_subcommands().empty()) {
    at = at->get_subcommands().front();
    words += " " + at->get_name();
  }
  return {at, words};
}

std::vector<std::string> commandNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(command->get_name());
  }
  return names;
}

std::vector<std::string> optionNames(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

std::string expectation(const std::string& meant, const std::string& otherwise) {
  return "; expected " + (meant.empty() ? otherwise : "'" + meant + "'");
}

std::string listed(const std::vector<std::string>& names) {
  return fmt::format("one of {}", fmt::join(names, ", "));
}

std::string unknownOption(const CLI::App& command, const std::string& words,
                          const std::string& typed) {
  const std::string name = typed.substr(0, typed.find('='));
  return fmt::format("{}: there is no option '{}'", words, name) +
         expectation(nearestWord(name, optionNames(command)),
                     "one that " + words + " --help names");
}

}  // namespace

std::string explainMisuse(const CLI::App& app, const CLI::ParseError& error) {
  const auto [command, words] = chosenCommand(app);
  const std::vector<std::string> left = app.remaining(true);
  const auto option = std::find_if(left.begin(), left.end(), [](const std::string& word) {
    return word.size() > 1 && word[0] == '-';
  });
  if (option != left.end()) return unknownOption(*command, words, *option);
  const std::vector<std::string> commands = commandNames(*command);
  if (!commands.empty() && command->get_require_subcommand_min() > 0) {
    const std::string problem =
        left.empty() ? "no command" : fmt::format("there is no command '{}'", left.front());
    const std::string meant = left.empty() ? "" : nearestWord(left.front(), commands);
    return fmt::format("{}: {}", words, problem) + expectation(meant, listed(commands));
  }
  if (!left.empty()) {
    return fmt::format("{}: '{}' is one too many; expected a command line as {} --help has it",
                       words, left.front(), words);
  }
  const std::string what = error.what();
  if (what.find("; expected ") != std::string::npos) return fmt::format("{}: {}", words, what);
  return fmt::format("{}: {}; expected a command line as {} --help has it", words, what, words);
}

void takeOneArgumentEach(CLI::App& app) {
  for (CLI::Option* option : app.get_options([](CLI::Option*) { return true; })) {
    const bool list = option->get_items_expected_max() >= CLI::detail::expected_max_vector_size;
    if (list && !option->get_positional()) option->allow_extra_args(false);
  }
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; })) {
    takeOneArgumentEach(*command);
  }
}

}  // namespace amble
