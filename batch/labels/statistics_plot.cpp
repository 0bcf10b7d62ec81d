#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "base/xml.h"
#include "batch/labels/batch_statistics.h"
#include "viz/pictures/color.h"
#include "viz/pictures/svg.h"

namespace amble {
namespace {

// Sizes in picture units, which are pixels at 100 %.
constexpr double kPanelWidth = 300, kPanelHeight = 150, kPanelGap = 46, kPlotMargin = 40,
                 kPlotHead = 70;
constexpr double kRowHeight = 20, kNameWidth = 190;
constexpr int kColumns = 3, kBins = 24;
constexpr size_t kMostBars = 12, kLongestName = 30;  // the rest are one bar; letters of a name

const Color kPlotInk = rgb(40, 40, 44), kPlotFaint = rgb(206, 206, 212);
const Color kPlotPaper = rgb(250, 250, 250), kPlotBar = rgb(70, 120, 168);
const Color kRefusedBar = rgb(190, 96, 60);

class StatisticsPlot {
 public:
  explicit StatisticsPlot(XmlWriter& xml) : xml_(xml) {}

  void box(const Eigen::Vector2d& at, double width, double height, const Color& color,
           const std::string& tip = "") {
    const auto group = xml_.open("g");
    if (!tip.empty()) xml_.text("title", {}, tip);
    xml_.empty("rect", {{"x", at.x()},
                        {"y", at.y()},
                        {"width", width},
                        {"height", height},
                        {"fill", hexColor(color)}});
  }
  void text(double x, double y, const std::string& what, const char* anchor = "start",
            double size = 11) {
    xml_.text("text",
              {{"x", x},
               {"y", y},
               {"font-size", size},
               {"text-anchor", anchor},
               {"fill", hexColor(kPlotInk)}},
              what);
  }

  // A histogram with its scale, its median marked.
  void histogram(const Eigen::Vector2d& at, const Measure& measure) {
    const std::string unit = measure.unit.empty() ? "" : " [" + measure.unit + "]";
    text(at.x(), at.y() - 8, measure.name + unit, "start", 13);
    const Histogram bins = histogramOf(measure, kBins);
    if (bins.counts.empty()) return;
    const auto count = static_cast<double>(bins.counts.size());
    const int most = *std::max_element(bins.counts.begin(), bins.counts.end());
    const double step = kPanelWidth / count, bottom = at.y() + kPanelHeight;
    for (size_t i = 0; i < bins.counts.size(); ++i) {
      const double height = kPanelHeight * bins.counts[i] / most;
      const double from = bins.from + bins.width * static_cast<double>(i);
      box({at.x() + step * static_cast<double>(i), bottom - height}, std::max(1.0, step - 1.0),
          height, kPlotBar,
          shortNumber(from) + " to " + shortNumber(from + bins.width) + ": " +
              std::to_string(bins.counts[i]));
    }
    const double middle = spreadOf(measure).median;
    box({at.x() + step * (middle - bins.from) / bins.width, at.y()}, 1.0, kPanelHeight, kPlotInk,
        "median");
    box({at.x(), bottom}, kPanelWidth, 1.0, kPlotInk);
    text(at.x(), bottom + 15, shortNumber(bins.from));
    text(at.x() + kPanelWidth, bottom + 15, shortNumber(bins.from + count * bins.width), "end");
    text(at.x() + 0.5 * kPanelWidth, bottom + 15, "median " + shortNumber(middle, 3), "middle");
    text(at.x() + kPanelWidth, at.y() - 8, std::to_string(most) + " at most", "end", 9);
  }

  // The longest first. @return the height taken
  double bars(const Eigen::Vector2d& at, const std::string& title, const Times& amounts,
              const Color& color) {
    std::vector<std::pair<std::string, double>> sorted(amounts.begin(), amounts.end());
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    if (sorted.size() > kMostBars) {
      double rest = 0.0;
      for (size_t i = kMostBars - 1; i < sorted.size(); ++i) rest += sorted[i].second;
      sorted.resize(kMostBars - 1);
      sorted.emplace_back(std::to_string(amounts.size() - kMostBars + 1) + " others", rest);
    }
    double most = 0.0;
    for (const auto& bar : sorted) most = std::max(most, bar.second);
    text(at.x(), at.y() - 8, title, "start", 13);
    double y = at.y();
    for (const auto& [name, amount] : sorted) {
      const double share = amount / most;
      box({at.x() + kNameWidth, y + 3}, std::max(1.0, share * kPanelWidth), kRowHeight - 6, color,
          name);
      text(at.x() + kNameWidth - 8, y + 14, shortened(name.empty() ? "none" : name), "end");
      text(at.x() + kNameWidth + share * kPanelWidth + 6, y + 14, plainNumber(amount, 1));
      y += kRowHeight;
    }
    return y - at.y() + kPanelGap;
  }

  static double barsHeight(const Times& amounts) {
    return static_cast<double>(std::min(amounts.size(), kMostBars)) * kRowHeight + kPanelGap;
  }

 private:
  // The end of a long name tells more than its beginning. Letters outside ASCII count as several.
  static std::string shortened(const std::string& name) {
    if (name.size() <= kLongestName) return name;
    size_t from = name.size() - kLongestName;
    while (from < name.size() && (static_cast<unsigned char>(name[from]) & 0xC0u) == 0x80u) ++from;
    return "\u2026" + name.substr(from);
  }

  XmlWriter& xml_;
};

struct Bars {
  const char* title;
  Times amounts;
  Color color;
};

Times amountsOf(const Counts& counts) { return {counts.begin(), counts.end()}; }

std::vector<Bars> barsOf(const BatchStatistics& of) {
  return {{"what came of them", amountsOf(of.statuses), kPlotBar},
          {"walks refused, by rule", amountsOf(of.refusals), kRefusedBar},
          {"what is done, for how long [s]", of.activities, kPlotBar},
          {"captured motions in use [s]", of.motions, kPlotBar},
          {"walks by scene", amountsOf(of.scenes), kPlotBar},
          {"walks by style", amountsOf(of.styles), kPlotBar},
          {"walks by action", amountsOf(of.actions), kPlotBar}};
}

}  // namespace

void writeStatisticsPlot(std::ostream& out, const BatchStatistics& statistics,
                         const std::string& title) {
  const std::vector<Bars> all = barsOf(statistics);
  const auto count = static_cast<int>(statistics.measures.size());
  const int rows = (count + kColumns - 1) / kColumns;
  const double row = kPanelHeight + kPanelGap + 16;
  double height = kPlotHead + rows * row + kPlotMargin;
  for (const Bars& bars : all)
    if (!bars.amounts.empty()) height += StatisticsPlot::barsHeight(bars.amounts);
  const double width = 2 * kPlotMargin + kColumns * kPanelWidth + (kColumns - 1) * kPanelGap;
  XmlWriter xml(out);
  xml.declare();
  const auto svg = xml.open("svg", svgRoot(width, height));
  xml.text("title", {}, title);
  StatisticsPlot plot(xml);
  plot.box({0, 0}, width, height, kPlotPaper);
  plot.text(kPlotMargin, 28, title, "start", 16);
  plot.text(kPlotMargin, 46,
            counted(statistics.solved, "walk") + " of " + std::to_string(statistics.walks) +
                " asked for");
  double y = kPlotHead + 20;
  for (int i = 0; i < count; ++i) {
    const double x = kPlotMargin + (i % kColumns) * (kPanelWidth + kPanelGap);
    plot.histogram({x, y + (i / kColumns) * row}, statistics.measures[static_cast<size_t>(i)]);
  }
  y += rows * row;
  for (const Bars& bars : all)
    if (!bars.amounts.empty())
      y += plot.bars({kPlotMargin, y}, bars.title, bars.amounts, bars.color);
}

}  // namespace amble
