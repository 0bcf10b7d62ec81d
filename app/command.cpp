#include "app/command.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "base/parallel.h"
#include "base/strict_yaml.h"
#include "base/text.h"

namespace amble {
namespace {

// Both sides of a separator; the whole twice where there is none.
std::pair<std::string_view, std::string_view> sides(std::string_view text,
                                                    std::string_view separator) {
  return splitAt(text, separator).value_or(std::pair{text, text});
}

bool within(std::string_view text, double min, double max) {
  const std::optional<double> value = numberOf(text);
  return value && *value >= min && *value <= max;
}

/// `1.2x`
std::optional<double> factorOf(std::string_view text) {
  if (text.empty() || text.back() != 'x') return std::nullopt;
  const std::optional<double> value = numberOf(text.substr(0, text.size() - 1));
  return value && *value > 0.0 && *value <= 100.0 ? value : std::nullopt;
}

double numberIn(std::string_view text) { return numberOf(text).value_or(0.0); }

}  // namespace

CLI::Validator ramp(double min, double max, const std::string& unit) {
  const std::string wanted = fmt::format("{0} to {1} {2}, or FROM..TO", min, max, unit);
  const auto check = [=](const std::string& text) -> std::string {
    const auto [from, to] = sides(text, "..");
    if (within(from, min, max) && within(to, min, max)) return "";
    return fmt::format("is '{}'; expected {}", text, wanted);
  };
  return CLI::Validator(check, fmt::format("[{}]", wanted));
}

Ramp readRamp(const std::string& text) {
  const auto [from, to] = sides(text, "..");
  return {numberIn(from), numberIn(to)};
}

CLI::Validator amount(double min, double max, const std::string& unit) {
  const std::string wanted =
      fmt::format("{0} to {1} {2}, a factor as 1.2x, or FROM..TO", min, max, unit);
  const auto check = [=](const std::string& text) -> std::string {
    const auto [from, to] = sides(text, "..");
    if (within(from, min, max) && within(to, min, max)) return "";
    if (factorOf(from) && factorOf(to)) return "";
    return fmt::format("is '{}'; expected {}", text, wanted);
  };
  return CLI::Validator(check, fmt::format("[{}]", wanted));
}

std::pair<Ramp, bool> readAmount(const std::string& text) {
  const auto [from, to] = sides(text, "..");
  if (factorOf(from)) return {{*factorOf(from), factorOf(to).value_or(0.0)}, true};
  return {readRamp(text), false};
}

CLI::Validator twoNumbers(const Ramp& first, const Ramp& second, const std::string& unit) {
  const std::string wanted = fmt::format("{} to {}, comma, {} to {} {}", first.from, first.to,
                                         second.from, second.to, unit);
  const auto check = [=](const std::string& text) -> std::string {
    const auto [a, b] = sides(text, ",");
    const bool two = text.find(',') != std::string::npos;
    if (two && within(a, first.from, first.to) && within(b, second.from, second.to)) return "";
    return fmt::format("is '{}'; expected {}", text, wanted);
  };
  return CLI::Validator(check, fmt::format("[{}]", wanted));
}

std::pair<double, double> readTwoNumbers(const std::string& text) {
  const auto [a, b] = sides(text, ",");
  return {numberIn(a), numberIn(b)};
}

CLI::Validator number(double min, double max, const std::string& unit) {
  const std::string wanted = fmt::format("{} to {}{}{}", min, max, unit.empty() ? "" : " ", unit);
  const auto check = [=](const std::string& text) -> std::string {
    return within(text, min, max) ? "" : fmt::format("is '{}'; expected {}", text, wanted);
  };
  return CLI::Validator(check, fmt::format("[{}]", wanted));
}

CLI::Validator choice(const std::vector<std::string>& names) {
  const auto check = [names](const std::string& text) -> std::string {
    if (std::find(names.begin(), names.end(), text) != names.end()) return "";
    const std::string meant = nearestWord(text, names);
    return fmt::format("is '{}'; expected {}", text,
                       meant.empty() ? "one of " + joined(names) : "'" + meant + "'");
  };
  return CLI::Validator(check, fmt::format("{{{}}}", fmt::join(names, ",")));
}

void addExamples(CLI::App& command, const std::vector<std::string>& lines) {
  command.footer(fmt::format("Examples:\n  {}", fmt::join(lines, "\n  ")));
}

void addExitStatus(CLI::App& command, const std::string& done, const std::string& none) {
  const std::string before = command.get_footer();
  command.footer(fmt::format(
      "{}Exit status: {} {};{} {} the input or the use is wrong; {} stopped by Ctrl-C.",
      before.empty() ? "" : before + "\n\n", kExitDone, done,
      none.empty() ? "" : fmt::format(" {} {};", kExitNone, none), kExitWrong, kExitStopped));
}

CLI::Validator wholeNumber(long min, long max) {
  const std::string wanted = fmt::format("{} to {}", min, max);
  const auto check = [=](const std::string& text) -> std::string {
    const std::optional<long long> value = wholeNumberOf(text);
    const bool good = value && *value >= min && *value <= max;
    return good ? "" : fmt::format("is '{}'; expected a whole number from {}", text, wanted);
  };
  return CLI::Validator(check, fmt::format("[{}]", wanted));
}

void addThreadsOption(CLI::App& command, int& threads, const std::string& what) {
  threads = usualThreads();
  command.add_option("--threads", threads, what)->check(wholeNumber(1, kMostThreads));
}

Command onThreads(int threads, const Command& command) {
  return [threads, command] {
    int status = 0;
    withThreads(threads, [&] { status = command(); });
    return status;
  };
}

void addMemoryOption(CLI::App& command, size_t& bytes) {
  command
      .add_option_function<long>(
          "--memory", [&bytes](long megabytes) { bytes = static_cast<size_t>(megabytes) << 20; },
          "Memory that reading a mesh, FBX, glTF or DAE file may fill [MB]; default: " +
              std::to_string(bytes >> 20))
      ->check(wholeNumber(1, 1 << 20));
}

}  // namespace amble
