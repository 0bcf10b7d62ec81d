// amble help [COMMAND...] and amble completion SHELL: what the command line knows of itself.

#include <fmt/format.h>

#include <iostream>
#include <memory>

#include "app/command.h"
#include "app/command_words.h"
#include "app/completion.h"
#include "app/man_page.h"
#include "base/error.h"
#include "base/strict_yaml.h"
#include "base/text.h"

namespace amble {
namespace {

// The one that the words name, such as "library add". @throws InputError
const CLI::App& named(const CLI::App& program, const std::vector<std::string>& words) {
  const CLI::App* at = &program;
  std::string path = program.get_name();
  for (const std::string& word : words) {
    std::vector<std::string> names;
    const CLI::App* next = nullptr;
    for (const CLI::App* command : at->get_subcommands([](const CLI::App*) { return true; })) {
      names.push_back(command->get_name());
      if (command->get_name() == word) next = command;
    }
    if (next == nullptr) {
      const std::string meant = nearestWord(word, names);
      throw InputError(path, 0, "there is no command '" + word + "'",
                       !meant.empty()  ? "'" + meant + "'"
                       : names.empty() ? "nothing behind " + path
                                       : "one of " + joined(names));
    }
    at = next;
    path += " " + word;
  }
  return *at;
}

std::string pathOf(const CLI::App& command) {
  const CLI::App* const parent = command.get_parent();
  return parent == nullptr ? command.get_name() : pathOf(*parent) + " " + command.get_name();
}

}  // namespace

void addHelp(CLI::App& app, Command& chosen) {
  struct Options {
    std::vector<std::string> words;
    bool man = false;
  };
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("help", "Say how a command is used, as its --help does");
  command->add_option("COMMAND", options->words, "Which one, such as library add; default: all")
      ->type_name("NAME");
  command->add_flag("--man", options->man, "The manual page, for man(1)");
  addExamples(*command, {"amble help check", "amble help --man > amble.1"});
  command->callback([&app, options, &chosen] {
    chosen = [&app, options] {
      if (options->man) {
        writeManPage(std::cout, wordsOf(app));
      } else {
        const CLI::App& wanted = named(app, options->words);
        std::cout << wanted.get_formatter()->make_help(&wanted, pathOf(wanted),
                                                       CLI::AppFormatMode::Normal);
      }
      return kExitDone;
    };
  });
}

void addCompletion(CLI::App& app, Command& chosen) {
  const auto shell = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand(
      "completion", "Print what a shell needs to complete commands, options and their values");
  command->add_option("SHELL", *shell, "Which one")
      ->required()
      ->check(choice({"bash", "zsh", "fish"}));
  addExamples(*command, {"amble completion bash > amble.bash", "amble completion zsh > _amble",
                         "amble completion fish > amble.fish"});
  command->callback([&app, shell, &chosen] {
    chosen = [&app, shell] {
      const auto write = *shell == "bash"  ? writeBashCompletion
                         : *shell == "zsh" ? writeZshCompletion
                                           : writeFishCompletion;
      write(std::cout, wordsOf(app));
      return kExitDone;
    };
  });
}

}  // namespace amble
