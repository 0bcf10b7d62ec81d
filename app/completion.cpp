#include "app/completion.h"

#include <fmt/format.h>

#include "base/text.h"

namespace amble {
namespace {

// In single quotes, as all three shells know them; a quote itself is theirs.
std::string quoted(std::string_view text, std::string_view quote) {
  std::string safe = "'";
  for (const char c : text) safe += c == '\'' ? std::string(quote) : std::string(1, c);
  return safe + "'";
}
std::string shellQuoted(std::string_view text) { return quoted(text, "'\\''"); }
std::string fishQuoted(std::string_view text) {
  std::string escaped;
  for (const char c : text) escaped += c == '\\' ? "\\\\" : std::string(1, c);
  return quoted(escaped, "\\'");
}

std::vector<std::string> namesOf(const CommandWords& command) {
  std::vector<std::string> names;
  for (const CommandWords& below : command.commands) names.push_back(below.name);
  return names;
}

std::vector<std::string> optionNames(const CommandWords& command) {
  std::vector<std::string> names;
  for (const OptionWords& option : command.options)
    names.insert(names.end(), option.names.begin(), option.names.end());
  return names;
}

// Patterns of `case` for every command's path.
std::string pathPatterns(const CommandWords& program) {
  std::vector<std::string> paths;
  for (const CommandWords* command : allCommands(program))
    if (command != &program) paths.push_back(shellQuoted(command->path));
  return joined(paths, " | ");
}

// ---- bash

std::string bashValue(const OptionWords& option) {
  switch (option.kind) {
    case ValueKind::kFile:
      return "_amble_files -f";
    case ValueKind::kFolder:
      return "_amble_files -d";
    case ValueKind::kChoice:
      return "_amble_words " + shellQuoted(joined(option.choices, " "));
    case ValueKind::kNone:
    case ValueKind::kOther:
      return ":";
  }
  return ":";
}

void writeBashCommand(std::ostream& out, const CommandWords& command) {
  for (const OptionWords& option : command.options) {
    if (option.value.empty()) continue;
    std::vector<std::string> patterns;
    for (const std::string& name : option.names)
      patterns.push_back(shellQuoted(command.path + " " + name));
    out << "    " << joined(patterns, " | ") << ") " << bashValue(option) << "; return ;;\n";
  }
}

void writeBashPlaces(std::ostream& out, const CommandWords& command) {
  out << "    " << shellQuoted(command.path) << ")\n      if [[ $word == -* ]]; then _amble_words "
      << shellQuoted(joined(optionNames(command), " ")) << '\n';
  if (!command.commands.empty()) {
    out << "      else _amble_words " << shellQuoted(joined(namesOf(command), " ")) << '\n';
  } else if (!command.places.empty()) {
    out << "      else " << bashValue(command.places.back()) << '\n';
  }
  out << "      fi ;;\n";
}

// ---- zsh

std::string zshText(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\\') escaped += '\\';
    escaped += c;
  }
  return escaped;
}

std::string zshAction(const OptionWords& option) {
  switch (option.kind) {
    case ValueKind::kFile:
      return "_files";
    case ValueKind::kFolder:
      return "_files -/";
    case ValueKind::kChoice:
      return option.list ? "_sequence compadd - " + joined(option.choices, " ")
                         : "(" + joined(option.choices, " ") + ")";
    case ValueKind::kNone:
    case ValueKind::kOther:
      return " ";
  }
  return " ";
}

std::string zshMessage(const OptionWords& option) {
  return ":" + zshText(option.value.substr(0, option.value.find(':'))) + ":" + zshAction(option);
}

void writeZshOption(std::ostream& out, const OptionWords& option) {
  const std::string repeat = option.list ? "*" : "(" + joined(option.names, " ") + ")";
  for (const std::string& name : option.names) {
    const std::string value = option.value.empty() ? "" : name.starts_with("--") ? "=" : "+";
    const std::string text = repeat + name + value + "[" + zshText(option.what) + "]" +
                             (option.value.empty() ? "" : zshMessage(option));
    out << " \\\n        " << shellQuoted(text);
  }
}

void writeZshCommand(std::ostream& out, const CommandWords& command) {
  out << "    " << shellQuoted(command.path) << ")\n";
  if (!command.commands.empty()) {
    out << "      local -a commands=(";
    for (const CommandWords& below : command.commands)
      out << "\n        " << shellQuoted(below.name + ":" + below.what);
    out << ")\n";
  }
  out << "      _arguments";
  for (const OptionWords& option : command.options) writeZshOption(out, option);
  if (!command.commands.empty())
    out << " \\\n        '1:command:{_describe command commands}'";
  else if (!command.places.empty())
    out << " \\\n        " << shellQuoted("*" + zshMessage(command.places.back()));
  out << " ;;\n";
}

// ---- fish

std::string fishValue(const OptionWords& option) {
  switch (option.kind) {
    case ValueKind::kFile:
      return " -r -F";
    case ValueKind::kFolder:
      return " -x -a '(__fish_complete_directories)'";
    case ValueKind::kChoice: {
      const std::string choices = joined(option.choices, " ");
      return option.list ? " -x -a '(__fish_append , " + choices + ")'"
                         : " -x -a '" + choices + "'";
    }
    case ValueKind::kOther:
      return " -x";
    case ValueKind::kNone:
      return "";
  }
  return "";
}

void writeFishCommand(std::ostream& out, const CommandWords& command) {
  const std::string here =
      "complete -c amble -n " + fishQuoted("test (__amble_command) = " + fishQuoted(command.path));
  for (const CommandWords& below : command.commands)
    out << here << " -a " << below.name << " -d " << fishQuoted(below.what) << '\n';
  for (const OptionWords& option : command.options) {
    out << here;
    for (const std::string& name : option.names)
      out << (name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1));
    out << fishValue(option) << " -d " << fishQuoted(option.what) << '\n';
  }
  if (command.places.empty()) return;
  const OptionWords& place = command.places.back();
  if (place.kind == ValueKind::kFile || place.kind == ValueKind::kFolder) out << here << " -F\n";
  if (place.kind == ValueKind::kChoice)
    out << here << " -a '" << joined(place.choices, " ") << "'\n";
}

}  // namespace

void writeBashCompletion(std::ostream& out, const CommandWords& program) {
  out << R"(# bash completion for amble; written by the program: amble completion bash
_amble_files() {
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen "$1" -- "$word")
}
# Behind a comma too.
_amble_words() {
  local before=
  [[ $word == *,* ]] && before=${word%,*},
  mapfile -t COMPREPLY < <(compgen -P "$before" -W "$1" -- "${word##*,}")
}
_amble() {
  local word=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD-1]} at=amble i
  COMPREPLY=()
  # --option=value comes as three words.
  if [[ $word == = ]]; then word=
  elif [[ $previous == = ]]; then previous=${COMP_WORDS[COMP_CWORD-2]}
  fi
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case "$at ${COMP_WORDS[i]}" in
      )"
      << pathPatterns(program) << R"() at+=" ${COMP_WORDS[i]}" ;;
    esac
  done
  case "$at $previous" in
)";
  for (const CommandWords* command : allCommands(program)) writeBashCommand(out, *command);
  out << "  esac\n  case $at in\n";
  for (const CommandWords* command : allCommands(program)) writeBashPlaces(out, *command);
  out << "  esac\n}\ncomplete -F _amble amble\n";
}

void writeZshCompletion(std::ostream& out, const CommandWords& program) {
  out << R"(#compdef amble
# zsh completion for amble; written by the program: amble completion zsh
_amble() {
  local at=amble
  local -i i depth=0
  for ((i = 2; i < CURRENT; ++i)); do
    case "$at ${words[i]}" in
      )"
      << pathPatterns(program) << R"() at+=" ${words[i]}"; depth=i-1 ;;
    esac
  done
  shift $depth words
  ((CURRENT -= depth))
  case $at in
)";
  for (const CommandWords* command : allCommands(program)) writeZshCommand(out, *command);
  out << "  esac\n}\n[[ $funcstack[1] == _amble ]] && _amble \"$@\" || compdef _amble amble\n";
}

void writeFishCompletion(std::ostream& out, const CommandWords& program) {
  std::vector<std::string> paths;
  for (const CommandWords* command : allCommands(program))
    paths.push_back(fishQuoted(command->path));
  out << "# fish completion for amble; written by the program: amble completion fish\n"
      << "function __amble_command\n  set -l at amble\n"
      << "  for word in (commandline -opc)[2..-1]\n    if contains -- \"$at $word\" "
      << joined(paths, " ") << "\n      set at \"$at $word\"\n    end\n  end\n  echo $at\nend\n"
      << "complete -c amble -f\n";
  for (const CommandWords* command : allCommands(program)) writeFishCommand(out, *command);
}

}  // namespace amble
