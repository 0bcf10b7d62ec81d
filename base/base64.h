/// Bytes as text that stands in pages and JSON (RFC 4648, section 4).
#pragma once

#include <string>
#include <string_view>

namespace amble {

/// With `+`, `/` and, at the end, `=`: four characters for three bytes, no line ends.
std::string base64(std::string_view bytes);

}  // namespace amble
