#include "app/command.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace amble {
namespace {

template <typename T>
bool parseAll(const std::string& text, T& value) {
  const char* begin = text.data() + (!text.empty() && text[0] == '+' ? 1 : 0);
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(begin, end, value);
  return parsed.ec == std::errc() && parsed.ptr == end;
}

}  // namespace

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
