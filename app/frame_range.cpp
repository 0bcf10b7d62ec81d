#include "app/frame_range.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "base/error.h"

namespace amble {
namespace {

/// A frame, or a time with an `s` behind it, as the nearest frame; `otherwise` where nothing is
/// said.
int frameOf(const std::string& option, const std::string& text, char between, const Clip& clip,
            int otherwise) {
  if (text.empty()) return otherwise;
  const bool seconds = text.back() == 's';
  const char* const end = text.data() + text.size() - (seconds ? 1 : 0);
  double value = 0.0;
  const auto parsed = std::from_chars(text.data(), end, value);
  const bool whole = seconds || value == std::floor(value);
  if (parsed.ec != std::errc() || parsed.ptr != end || !std::isfinite(value) || !whole) {
    throw InputError(option, 0, "'" + text + "'", frameRangeForm(between));
  }
  const double frame = seconds ? std::round(value / clip.frame_time) : value;
  if (!(frame >= 0.0 && frame < clip.frames())) {
    throw InputError(option, 0, "'" + text + "' is not in the clip",
                     fmt::format("0 to {}, or 0s to {:g}s", clip.frames() - 1, clip.duration()));
  }
  return static_cast<int>(frame);
}

}  // namespace

std::pair<int, int> readFrameRange(const std::string& option, const std::string& text, char between,
                                   const Clip& clip) {
  const size_t at = text.find(between);
  if (at == std::string::npos) {
    throw InputError(option, 0, "'" + text + "'", frameRangeForm(between));
  }
  const int first = frameOf(option, text.substr(0, at), between, clip, 0);
  const int last = frameOf(option, text.substr(at + 1), between, clip, clip.frames() - 1);
  if (first > last) {
    throw InputError(option, 0, "'" + text + "' ends before it begins", frameRangeForm(between));
  }
  return {first, last};
}

std::string frameRangeForm(char between) {
  return fmt::format("A{0}B, frames as 10{0}200, or seconds as 0.5s{0}2s; either may be left out",
                     between);
}

}  // namespace amble
