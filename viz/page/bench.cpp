#include "viz/page/bench.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/text.h"
#include "viz/page/graph_bench.h"
#include "viz/page/library_bench.h"

namespace amble {

NumbersText plainNumbers() {
  return [](std::span<const double> values, int digits) {
    std::string text = "[";
    for (const double value : values) {
      if (text.size() > 1) text += ',';
      text += plainNumber(value, digits + 1);
    }
    return text + "]";
  };
}

NumbersText pageNumbers(PageBytes& bytes) {
  return [&bytes](std::span<const double> values, int digits) {
    constexpr double kMost = 32767.0;
    double most = 0.0;
    for (const double value : values) most = std::max(most, std::abs(value));
    const double scale = most > 0.0 ? most / kMost : 1.0;
    if (scale > std::pow(10.0, -digits)) {
      const std::vector<float> exact(values.begin(), values.end());
      return bytes.add(std::span<const float>(exact));
    }
    std::vector<std::int16_t> coarse;
    coarse.reserve(values.size());
    for (const double value : values)
      coarse.push_back(static_cast<std::int16_t>(std::lround(value / scale)));
    std::string reference = bytes.add(std::span<const std::int16_t>(coarse));
    reference.back() = ',';
    return reference + "\"scale\":" + shortNumber(scale, 9) + "}";
  };
}

std::string benchJson(const Bench& bench, const NumbersText& numbers) {
  std::string text = "{\"clips\":[";
  for (size_t i = 0; i < bench.clips.size(); ++i) {
    if (i > 0) text += ',';
    text += benchClipJson(bench.clips[i], numbers);
  }
  text += "]";
  if (bench.library != nullptr) text += ",\"library\":" + benchLibraryJson(*bench.library, numbers);
  if (bench.graph != nullptr) text += ",\"graph\":" + benchGraphJson(*bench.graph, numbers);
  return text + "}";
}

}  // namespace amble
