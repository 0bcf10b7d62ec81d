#include "app/graph_words.h"

#include <fmt/format.h>

#include "base/error.h"
#include "base/strict_yaml.h"
#include "base/text.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRangeForm = "CLIP:A-B, frames of its file, one after another with commas";

[[noreturn]] void refuse(const std::string& option, const std::string& problem,
                         const std::string& expected) {
  throw InputError("amble graph: " + option, 0, problem, expected);
}

// Where the digits at the end of `text` begin.
size_t digitsFrom(std::string_view text) {
  size_t at = text.size();
  while (at > 0 && isDigit(text[at - 1])) --at;
  return at;
}

int frameNumber(std::string_view digits, const std::string& option) {
  const auto value = wholeNumberOf(digits);
  constexpr long long kMost = 1'000'000'000;
  if (!value || *value > kMost)
    refuse(option, "frame '" + std::string(digits) + "'", "a frame of the clip's file");
  return static_cast<int>(*value);
}

int frameOf(const GraphClip& clip, int file_frame, const std::string& option) {
  const int frame = clip.fromFile(file_frame);
  if (frame < 0)
    refuse(option, fmt::format("'{}' has no frame {}", clip.name, file_frame),
           fmt::format("{} to {}", clip.inFile(clip.first), clip.inFile(clip.last())));
  return frame;
}

// The end of the first CLIP:A-B of `text`: before a comma, or its end; npos where there is none.
size_t rangeEnd(const std::string& text, size_t begin) {
  for (size_t end = begin; end <= text.size(); ++end) {
    if (end < text.size() && text[end] != ',') continue;
    const std::string_view part = std::string_view(text).substr(begin, end - begin);
    const size_t last = digitsFrom(part);
    if (last == part.size() || last < 2 || part[last - 1] != '-') continue;
    const std::string_view rest = part.substr(0, last - 1);
    const size_t first = digitsFrom(rest);
    if (first < rest.size() && first > 1 && rest[first - 1] == ':') return end;
  }
  return std::string::npos;
}

}  // namespace

KeptGraph readFreshGraph(const std::string& file) {
  KeptGraph kept = readGraph(file);
  const std::string changed = whatChanged(kept, file);
  if (!changed.empty())
    throw InputError(file, 0, "is a stale cluster graph, since these have changed: " + changed,
                     "one that `amble graph build` makes of them");
  return kept;
}

int clipNamed(const KeptGraph& kept, const std::string& name, const std::string& option) {
  const std::vector<GraphClip>& clips = kept.graph.clips;
  std::vector<int> found;
  std::vector<std::string> names;
  for (size_t i = 0; i < clips.size(); ++i) {
    if (clips[i].name == name) return static_cast<int>(i);
    const fs::path file = kept.inputs[i][0].path;
    names.push_back(clips[i].name);
    if (file == name || file.filename() == name || file.stem() == name)
      found.push_back(static_cast<int>(i));
  }
  if (found.size() == 1) return found[0];
  if (!found.empty()) {
    std::vector<std::string> called;
    for (const int i : found) called.push_back(names[i]);
    refuse(option, "several clips are called '" + name + "'", joined(called, ", ", " or "));
  }
  const std::string nearest = nearestWord(name, names);
  refuse(option, "no clip '" + name + "' in the graph",
         nearest.empty() ? "one that `amble graph show` lists" : "'" + nearest + "' perhaps");
}

int frameNamed(const KeptGraph& kept, const std::string& text, const std::string& option) {
  const size_t digits = digitsFrom(text);
  if (digits == text.size() || digits < 2 || text[digits - 1] != ':')
    refuse(option, "'" + text + "'", "CLIP:FRAME, a frame of its file");
  const int clip = clipNamed(kept, text.substr(0, digits - 1), option);
  return frameOf(kept.graph.clips[clip], frameNumber(text.substr(digits), option), option);
}

std::vector<NamedRange> rangesNamed(const KeptGraph& kept, const std::string& text,
                                    const std::string& option) {
  std::vector<NamedRange> ranges;
  for (size_t begin = 0; begin <= text.size();) {
    const size_t end = rangeEnd(text, begin);
    if (end == std::string::npos) refuse(option, "'" + text.substr(begin) + "'", kRangeForm);
    const std::string part = text.substr(begin, end - begin);
    const size_t dash = digitsFrom(part) - 1, colon = digitsFrom(part.substr(0, dash)) - 1;
    const NamedRange range{clipNamed(kept, part.substr(0, colon), option),
                           frameNumber(part.substr(colon + 1, dash - colon - 1), option),
                           frameNumber(part.substr(dash + 1), option)};
    const GraphClip& clip = kept.graph.clips[range.clip];
    frameOf(clip, range.first, option);
    frameOf(clip, range.last, option);
    if (range.first > range.last)
      refuse(option, "'" + part + "' ends before it begins", kRangeForm);
    ranges.push_back(range);
    begin = end + 1;
  }
  return ranges;
}

}  // namespace amble
