#include "app/command.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>

namespace amble {
namespace {

template <typename T>
bool parseAll(std::string_view text, T& value) {
  const char* begin = text.data() + (!text.empty() && text[0] == '+' ? 1 : 0);
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(begin, end, value);
  return parsed.ec == std::errc() && parsed.ptr == end;
}

// Both sides of a separator; the whole twice where there is none.
std::pair<std::string_view, std::string_view> split(std::string_view text,
                                                    std::string_view separator) {
  const size_t at = text.find(separator);
  if (at == std::string_view::npos) return {text, text};
  return {text.substr(0, at), text.substr(at + separator.size())};
}

bool within(std::string_view text, double min, double max) {
  double value = 0.0;
  return parseAll(text, value) && std::isfinite(value) && value >= min && value <= max;
}

double numberIn(std::string_view text) {
  double value = 0.0;
  parseAll(text, value);
  return value;
}

}  // namespace

CLI::Validator ramp(double min, double max, const std::string& unit) {
  const std::string wanted = fmt::format("{0} to {1} {2}, or FROM..TO", min, max, unit);
  const auto check = [=](const std::string& text) -> std::string {
    const auto [from, to] = split(text, "..");
    if (within(from, min, max) && within(to, min, max)) return "";
    return fmt::format("is '{}'; expected {}", text, wanted);
  };
  return CLI::Validator(check, fmt::format("[{}]", wanted));
}

Ramp readRamp(const std::string& text) {
  const auto [from, to] = split(text, "..");
  return {numberIn(from), numberIn(to)};
}

CLI::Validator twoNumbers(const Ramp& first, const Ramp& second, const std::string& unit) {
  const std::string wanted = fmt::format("{} to {}, comma, {} to {} {}", first.from, first.to,
                                         second.from, second.to, unit);
  const auto check = [=](const std::string& text) -> std::string {
    const auto [a, b] = split(text, ",");
    const bool two = text.find(',') != std::string::npos;
    if (two && within(a, first.from, first.to) && within(b, second.from, second.to)) return "";
    return fmt::format("is '{}'; expected {}", text, wanted);
  };
  return CLI::Validator(check, fmt::format("[{}]", wanted));
}

std::pair<double, double> readTwoNumbers(const std::string& text) {
  const auto [a, b] = split(text, ",");
  return {numberIn(a), numberIn(b)};
}

CLI::Validator number(double min, double max, const std::string& unit) {
  const std::string wanted = fmt::format("{} to {}{}{}", min, max, unit.empty() ? "" : " ", unit);
  const auto check = [=](const std::string& text) -> std::string {
    double value = 0.0;
    const bool good = parseAll(text, value) && std::isfinite(value) && value >= min && value <= max;
    return good ? "" : fmt::format("is '{}'; expected {}", text, wanted);
  };
  return CLI::Validator(check, fmt::format("[{}]", wanted));
}

CLI::Validator wholeNumber(long min, long max) {
  const std::string wanted = fmt::format("{} to {}", min, max);
  const auto check = [=](const std::string& text) -> std::string {
    long value = 0;
    const bool good = parseAll(text, value) && value >= min && value <= max;
    return good ? "" : fmt::format("is '{}'; expected a whole number from {}", text, wanted);
  };
  return CLI::Validator(check, fmt::format("[{}]", wanted));
}

}  // namespace amble
