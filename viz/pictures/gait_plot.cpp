#include "viz/pictures/gait_plot.h"

#include <algorithm>
#include <cmath>

#include "base/output_file.h"
#include "base/text.h"
#include "viz/pictures/color.h"
#include "viz/pictures/svg.h"

namespace amble {
namespace {

// Sizes in picture units, which are pixels at 100 %.
constexpr double kLeft0 = 92, kRight0 = 20, kTop = 64;  // margins about the panels
constexpr double kSecond = 220, kNarrow = 760,
                 kWide = 6000;  // of time; limits of the panels' width
constexpr double kBand = 22, kHeights = 120, kSpeeds = 90, kBar = 11, kGap = 8, kFootGap = 26;
constexpr double kMark = 5;        // half size of an event's mark
constexpr int kMostPoints = 6000;  // of a curve: more cannot be seen

constexpr double kLeastHeight = 0.05, kLeastSpeed = 0.5;  // top of an axis at least [m, m/s]

const Color kInk = rgb(40, 40, 44), kFaint = rgb(214, 214, 218), kPaper = rgb(250, 250, 250);

const XmlAttributes kHair = {{"stroke-width", 0.7}};
const XmlAttributes kHeelStroke = {{"stroke-width", 1.6}};
const XmlAttributes kToeStroke = {{"stroke-width", 1.3}, {"stroke-dasharray", "5 3"}};

Color typeColor(MotionType type) {
  switch (type) {
    case MotionType::kStand:
      return rgb(120, 128, 140);
    case MotionType::kWalk:
      return rgb(70, 150, 96);
    case MotionType::kRun:
      return rgb(196, 120, 40);
    case MotionType::kJump:
      return rgb(150, 84, 168);
    default:
      return rgb(206, 204, 198);
  }
}

/// Writes elements; knows where time is.
class Plot {
 public:
  Plot(XmlWriter& xml, const ClipAnalysis& analysis, int first_frame)
      : xml_(xml), analysis_(analysis), first_(first_frame) {
    const double seconds = std::max(0.1, analysis.frames() * analysis.frame_time);
    width_ = std::clamp(seconds * kSecond, kNarrow, kWide);
    unit_ = width_ / std::max(1, analysis.frames());
  }

  double width() const { return width_; }
  /// Middle of a frame.
  double x(double frame) const { return kLeft0 + (frame + 0.5) * unit_; }

  void line(double x1, double y1, double x2, double y2, const Color& color,
            const XmlAttributes& style) {
    xml_.empty(
        "line",
        XmlAttributes{{"x1", x1}, {"y1", y1}, {"x2", x2}, {"y2", y2}, {"stroke", hexColor(color)}} +
            style);
  }
  void box(double x1, double y1, double w, double h, const Color& color) {
    xml_.empty("rect",
               {{"x", x1}, {"y", y1}, {"width", w}, {"height", h}, {"fill", hexColor(color)}});
  }
  void text(double x, double y, const std::string& what, const char* anchor = "start",
            double size = 11, const Color& color = kInk) {
    xml_.text("text",
              {{"x", x},
               {"y", y},
               {"font-size", size},
               {"text-anchor", anchor},
               {"fill", hexColor(color)}},
              what);
  }
  /// Pointing up or down, filled or not.
  void mark(double x, double y, bool up, bool filled, const Color& color) {
    const double tip = up ? y - kMark : y + kMark, base = up ? y + kMark : y - kMark;
    const std::array<Eigen::Vector2d, 3> corners = {Eigen::Vector2d(x, tip),
                                                    Eigen::Vector2d(x - kMark, base),
                                                    Eigen::Vector2d(x + kMark, base)};
    xml_.empty("path", {{"class", "mark"},
                        {"d", svgPath(corners, true)},
                        {"fill", hexColor(filled ? color : kPaper)},
                        {"stroke", hexColor(color)}});
  }
  void curve(const Eigen::VectorXd& values, double bottom, double per_unit, const Color& color,
             const XmlAttributes& style) {
    const int step = std::max(1, static_cast<int>(values.size()) / kMostPoints);
    std::vector<Eigen::Vector2d> points;
    for (int i = 0; i < values.size(); i += step) {
      points.emplace_back(x(i), bottom - per_unit * values[i]);
    }
    xml_.empty("path",
               XmlAttributes{
                   {"d", svgPath(points, false)}, {"fill", "none"}, {"stroke", hexColor(color)}} +
                   style);
  }
  /// Of frames [from, to], both between frames.
  void bar(double from, double to, double y, const Color& color) {
    const double last = analysis_.frames() - 0.5;
    from = std::clamp(from, -0.5, last);
    to = std::clamp(to, -0.5, last);
    if (to > from) box(x(from), y, x(to) - x(from), kBar, color);
  }

  void band(double top) {
    for (const MotionSegment& segment : analysis_.kind.segments) {
      const double from = x(segment.first - 0.5), to = x(segment.last + 0.5);
      box(from, top, to - from, kBand, typeColor(segment.type));
      const std::string name(motionTypeName(segment.type));
      if (to - from > 9.0 * static_cast<double>(name.size())) {
        text(0.5 * (from + to), top + 0.7 * kBand, name, "middle", 12, kPaper);
      }
    }
    text(kLeft0 - 6, top + 0.7 * kBand, "type", "end");
  }

  void axis(double top, double bottom) {
    const double seconds = analysis_.frames() * analysis_.frame_time;
    const double step = seconds * kSecond > kWide ? std::ceil(seconds / 25.0) : 0.5;
    for (double t = 0.0; t <= seconds + first_ * analysis_.frame_time; t += step) {
      const double frame = t / analysis_.frame_time - first_;
      if (frame < -0.5 || frame > analysis_.frames() - 0.5) continue;
      line(x(frame), top, x(frame), bottom, kFaint, kHair);
      text(x(frame), bottom + 13, xmlNumber(t) + " s", "middle");
      text(x(frame), bottom + 26, xmlNumber(std::round(t / analysis_.frame_time)), "middle", 9);
    }
    text(kLeft0 - 30, bottom + 13, "time", "end");
    text(kLeft0 - 30, bottom + 26, "frame", "end", 9);
  }

  /// Two curves over a scale of their own. @return its bottom
  double panel(double top, double height, double most, const std::string& label,
               const std::array<const Eigen::VectorXd*, 2>& heel_toe, const Color& color) {
    const double bottom = top + height, per_unit = height / most;
    line(kLeft0, bottom, kLeft0 + width_, bottom, kInk, kHair);
    text(kLeft0 - 6, top + 9, xmlNumber(most), "end", 9);
    text(kLeft0 - 6, bottom, "0", "end", 9);
    text(kLeft0 - 24, top + 0.5 * height + 4, label, "end");
    curve(*heel_toe[0], bottom, per_unit, color, kHeelStroke);
    curve(*heel_toe[1], bottom, per_unit, color, kToeStroke);
    return bottom;
  }

  double foot(Side side, double top) {
    const Color color = sideColor(side);
    const FootCurves& curves = analysis_.curves[side];
    const auto most = [](const Eigen::VectorXd& a, const Eigen::VectorXd& b, double least) {
      const double largest = std::max({a.maxCoeff(), b.maxCoeff(), least});
      return std::ceil(largest / least) * least;
    };
    text(kLeft0, top - 4, side == kLeft ? "left foot" : "right foot", "start", 12, color);
    double y = panel(top, kHeights, most(curves.heel_height, curves.toe_height, kLeastHeight),
                     "height [m]", {&curves.heel_height, &curves.toe_height}, color);
    y = panel(y + kGap, kSpeeds, most(curves.heel_speed, curves.toe_speed, kLeastSpeed),
              "speed [m/s]", {&curves.heel_speed, &curves.toe_speed}, color);
    y = bars(side, y + kGap, color);
    events(side, top, y, color);
    return y;
  }

 private:
  /// Heel and toe on the ground (figure 3.6's stage 1), and the foot planted (stage 2).
  double bars(Side side, double top, const Color& color) {
    const std::vector<SwingEvents>& swings = analysis_.events.swings[side];
    const std::vector<FootPlant>& plants = analysis_.plants.plants[side];
    const double last = analysis_.frames() - 0.5;
    for (const bool heel : {true, false}) {
      double from = -0.5;
      const double y = heel ? top : top + kBar + 3;
      for (const SwingEvents& swing : swings) {
        const PointEvents& point = heel ? swing.heel : swing.toe;
        if (!std::isnan(point.lift)) bar(from, point.lift, y, mix(color, kPaper, 0.45f));
        from = std::isnan(point.landing) ? last : point.landing;
      }
      if (!plants.empty()) bar(from, last, y, mix(color, kPaper, 0.45f));
      text(kLeft0 - 6, y + kBar - 2, heel ? "heel down" : "toe down", "end", 9);
    }
    const double y = top + 2 * (kBar + 3);
    for (const FootPlant& plant : plants) {
      bar(plant.first == 0 ? -0.5 : plant.strike, plant.lift_off, y, color);
    }
    text(kLeft0 - 6, y + kBar - 2, "planted", "end", 9);
    return y + kBar;
  }

  void events(Side side, double top, double bottom, const Color& color) {
    const XmlAttributes whole = {{"stroke-width", 0.8}};
    const XmlAttributes faint = {{"stroke-width", 0.6}, {"stroke-dasharray", "2 3"}};
    const double y = top + kMark + 1;
    for (const SwingEvents& swing : analysis_.events.swings[side]) {
      const auto put = [&](double frame, bool up, bool filled) {
        if (std::isnan(frame)) return;
        line(x(frame), y, x(frame), bottom, color, filled ? whole : faint);
        mark(x(frame), filled ? y : y + 2.6 * kMark, up, filled, color);
      };
      put(swing.lift, true, false);
      put(swing.lift_off, true, true);
      put(swing.strike, false, true);
      put(swing.landing, false, false);
    }
  }

  XmlWriter& xml_;
  const ClipAnalysis& analysis_;
  int first_;
  double width_ = 0.0, unit_ = 1.0;
};

void legend(Plot& plot, double y) {
  double at = kLeft0;
  const auto entry = [&](const char* what, double space, const auto& draw) {
    draw(at);
    plot.text(at + 26, y + 4, what);
    at += space;
  };
  entry("heel", 70, [&](double x) { plot.line(x, y, x + 20, y, kInk, kHeelStroke); });
  entry("toe", 70, [&](double x) { plot.line(x, y, x + 20, y, kInk, kToeStroke); });
  entry("lift", 66, [&](double x) { plot.mark(x + 14, y, true, false, kInk); });
  entry("lift-off", 84, [&](double x) { plot.mark(x + 14, y, true, true, kInk); });
  entry("strike", 78, [&](double x) { plot.mark(x + 14, y, false, true, kInk); });
  entry("landing", 84, [&](double x) { plot.mark(x + 14, y, false, false, kInk); });
}

std::string shares(const ClipClass& kind) {
  std::vector<std::string> texts;
  for (int i = 0; i < kMotionTypes; ++i) {
    if (kind.share[i] <= 0.0) continue;
    texts.push_back(std::string(motionTypeName(static_cast<MotionType>(i))) + " " +
                    fixedNumber(100.0 * kind.share[i], 0) + " %");
  }
  return joined(texts);
}

}  // namespace

void writeGaitPlot(std::ostream& out, const ClipAnalysis& analysis, const std::string& title,
                   int first_frame) {
  XmlWriter xml(out);
  Plot plot(xml, analysis, first_frame);
  const double foot = kHeights + kSpeeds + 2 * kGap + 3 * kBar + 6;
  const double panels = kTop + kBand + kFootGap, bottom = panels + 2 * foot + kFootGap + kGap;
  const double width = kLeft0 + plot.width() + kRight0, height = bottom + 60;
  xml.declare();
  const auto svg = xml.open("svg", svgRoot(width, height));
  xml.text("title", {}, title);
  plot.box(0, 0, width, height, kPaper);
  plot.text(kLeft0, 22, title, "start", 15);
  plot.text(kLeft0, 40, shares(analysis.kind));
  legend(plot, 52);
  if (analysis.frames() == 0) return;
  plot.axis(kTop, bottom);
  plot.band(kTop);
  const double next = plot.foot(kLeft, panels);
  plot.foot(kRight, next + kFootGap);
}

void writeGaitPlot(const std::filesystem::path& file, const ClipAnalysis& analysis,
                   const std::string& title, int first_frame) {
  writeFile(file, [&](std::ostream& out) { writeGaitPlot(out, analysis, title, first_frame); });
}

}  // namespace amble
