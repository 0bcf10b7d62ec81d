/// The workbench (Shanbhag's thesis, appendix A): what is known of captures and of a library, to be
/// looked at as curves beside the motion itself.
///
/// One JSON for the page and for people's own programs: they differ in how arrays of numbers are
/// written only (NumbersText), so that whatever the page shows can be read elsewhere. Metres,
/// seconds, degrees; frames are those of the file.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "viz/page/clip_page.h"
#include "viz/page/page_bytes.h"

namespace amble {

struct BenchLibrary;  // viz/page/library_bench.h
struct BenchGraph;    // viz/page/graph_bench.h

/// An array of numbers as JSON, of which so many digits behind the point can be seen.
using NumbersText = std::function<std::string(std::span<const double> values, int digits)>;
/// As a JSON list, with a digit more.
NumbersText plainNumbers();
/// As numbers among the page's bytes: of 16 bits and a scale where those are fine enough, else of
/// 32 (viz/page/web/data.js).
NumbersText pageNumbers(PageBytes& bytes);

/// A capture, with what `amble analyse` says of it.
struct BenchClip {
  const ShownClip* shown = nullptr;                        ///< never null
  std::string analysis;                                    ///< a JSON object; "": nothing is known
  std::vector<std::pair<std::string, std::string>> facts;  ///< the same for people: label, value
};

/// Borrowed: what the pointers name outlives it.
struct Bench {
  std::vector<BenchClip> clips;           ///< in the order of the page's takes
  const BenchLibrary* library = nullptr;  ///< that they are of; null: they are captures
  const BenchGraph* graph = nullptr;      ///< the same
};

std::string benchClipJson(const BenchClip& clip, const NumbersText& numbers);
std::string benchJson(const Bench& bench, const NumbersText& numbers);

}  // namespace amble
