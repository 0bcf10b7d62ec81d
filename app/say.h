/// Text for people, on standard output or error: what a file names may hold any bytes, and none of
/// them shall steer a terminal.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <string_view>
#include <type_traits>

#include "base/text.h"

namespace amble {

/// What is printed of a value: of text, each control character as a blank; of others, themselves.
template <typename T>
auto printable(const T& value) {
  if constexpr (std::is_convertible_v<const T&, std::string_view>) {
    return withoutControls(std::string(std::string_view(value)));
  } else {
    return value;
  }
}

template <typename T>
using Printable = decltype(printable(std::declval<const T&>()));

/// As fmt::print does, with `printable` arguments; line ends are the format's.
template <typename... Args>
void say(std::FILE* out, fmt::format_string<Printable<Args>...> format, const Args&... args) {
  fmt::print(out, format, printable(args)...);
}

}  // namespace amble
