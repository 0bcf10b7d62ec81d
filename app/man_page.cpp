#include "app/man_page.h"

#include "base/text.h"
#include "base/version.h"

namespace amble {
namespace {

// Text as it stands: neither escapes nor, at the begin of a line, requests.
std::string plain(std::string_view text) {
  std::string safe;
  for (const char c : text) {
    if (c == '\\') {
      safe += "\\e";
    } else if (c == '-') {
      safe += "\\-";  // a hyphen that is one of the shell's
    } else {
      safe += c == '\n' ? ' ' : c;
    }
  }
  return safe.starts_with('.') || safe.starts_with('\'') ? "\\&" + safe : safe;
}

// "[1 to 64]" of "INT:[1 to 64]".
std::string rangeOf(const OptionWords& option) {
  const size_t range = option.value.find(":[");
  return range == std::string::npos ? "" : option.value.substr(range + 1);
}

std::string valueName(const OptionWords& option) {
  return option.value.substr(0, option.value.find(':'));
}

void writeOption(std::ostream& out, const OptionWords& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.names) names.push_back("\\fB" + plain(name) + "\\fR");
  out << ".TP\n" << joined(names);
  const bool by_place = !option.names.front().starts_with('-');
  if (!option.value.empty() && !by_place) out << " \\fI" << plain(valueName(option)) << "\\fR";
  out << '\n' << plain(option.what) << ".\n";
  if (!option.choices.empty()) out << "One of " << plain(joined(option.choices)) << ".\n";
  if (const std::string range = rangeOf(option); !range.empty())
    out << "Range: " << plain(range.substr(1, range.size() - 2)) << ".\n";
  if (!option.usual.empty()) out << "Default: " << plain(option.usual) << ".\n";
}

std::string usageOf(const CommandWords& command) {
  std::string usage = "\\fB" + plain(command.path) + "\\fR";
  if (!command.options.empty()) usage += " [\\fIOPTIONS\\fR]";
  for (const OptionWords& place : command.places) {
    const std::string name =
        "\\fI" + plain(place.names.front()) + "\\fR" + (place.list ? "..." : "");
    usage += place.required ? " " + name : " [" + name + "]";
  }
  return usage;
}

void writeCommand(std::ostream& out, const CommandWords& command) {
  out << ".SS " << plain(command.path) << '\n' << plain(command.what) << ".\n";
  out << ".PP\n" << usageOf(command) << '\n';
  for (const OptionWords& place : command.places) writeOption(out, place);
  for (const OptionWords& option : command.options)
    if (option.names.back() != "--help") writeOption(out, option);
  if (!command.exit_status.empty())
    out << ".PP\nExit status: " << plain(command.exit_status) << '\n';
}

void writeExamples(std::ostream& out, const std::vector<const CommandWords*>& commands) {
  out << ".SH EXAMPLES\n.nf\n";
  for (const CommandWords* command : commands)
    for (const std::string& example : command->examples) out << plain(example) << '\n';
  out << ".fi\n";
}

}  // namespace

void writeManPage(std::ostream& out, const CommandWords& program) {
  const std::vector<const CommandWords*> commands = allCommands(program);
  out << ".\\\" Written by the program: amble help --man\n"
      << ".TH AMBLE 1 \"\" \"Amble " << plain(version()) << "\"\n"
      << ".SH NAME\namble \\- plans how a person walks through a 3D scene\n"
      << ".SH SYNOPSIS\n\\fBamble\\fR \\fICOMMAND\\fR [\\fIARGUMENTS\\fR]\n"
      << ".SH DESCRIPTION\n"
      << plain(program.what) << '\n'
      << ".SH COMMANDS\n";
  for (const CommandWords* command : commands)
    if (command->commands.empty()) writeCommand(out, *command);
  out << ".SH OPTIONS\n";
  for (const OptionWords& option : program.options) writeOption(out, option);
  out << ".SH EXIT STATUS\n" << plain(program.exit_status) << '\n';
  out << ".SH ENVIRONMENT\n.TP\n\\fBNO_COLOR\\fR\nIf set and not empty, nothing is coloured.\n";
  writeExamples(out, commands);
}

}  // namespace amble
