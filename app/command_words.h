/// What the command line takes, as its own help says it: of this the manual page and the completion
/// of shells are made, so that none of them can say something else.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace amble {

/// What is completed where a value stands.
enum class ValueKind { kNone, kFile, kFolder, kChoice, kOther };

struct OptionWords {
  std::vector<std::string> names;     ///< "-o", "--output"; "CLIP", where one stands by its place
  ValueKind kind = ValueKind::kNone;  ///< of its value; none of a flag
  std::string value;                  ///< "FILE", "INT:[1 to 64]", "TEXT:{m,cm}"; "" of a flag
  std::vector<std::string> choices;
  bool list = false;  ///< takes several, with commas or one after another
  bool required = false;
  std::string usual;  ///< its default; "" where it has none to show
  std::string what;
};

struct CommandWords {
  std::string name;  ///< "add"
  std::string path;  ///< "amble library add"
  std::string what;
  std::vector<OptionWords> options, places;
  std::vector<std::string> examples;  ///< whole command lines
  std::string exit_status;            ///< a line, without "Exit status: "
  std::vector<CommandWords> commands;
};

/// @param app  with all its commands
CommandWords wordsOf(const CLI::App& app);

/// The command and all below it, each after the one that it belongs to.
std::vector<const CommandWords*> allCommands(const CommandWords& program);

}  // namespace amble
