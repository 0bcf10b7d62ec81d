#include "viz/pictures/report_page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "base/base64.h"
#include "base/rotation.h"
#include "base/text.h"
#include "base/xml.h"
#include "viz/pictures/report_page_style.h"

namespace amble {
namespace {

std::string metres(double length) { return plainNumber(length, 3) + " m"; }
std::string seconds(double time) { return plainNumber(time, 3) + " s"; }
std::string millimetres(double length) { return plainNumber(1000.0 * length, 1) + " mm"; }
std::string degrees(double angle) { return plainNumber(angle * 180.0 / kPi, 2) + "\u00b0"; }

std::string placeText(const Eigen::Vector3d& p) {
  return plainNumber(p.x(), 2) + ", " + plainNumber(p.y(), 2) + ", " + plainNumber(p.z(), 2);
}

// Rules and the like are words with underscores.
std::string spaced(std::string_view words) {
  std::string text(words);
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

std::string percents(double share) {
  return plainNumber(100.0 * std::clamp(share, 0.0, 1.0), 2) + "%";
}

// What a measure is shown in, and how many of these make one of its own unit.
struct ShownUnit {
  std::string name;
  double scale = 1.0;  // [> 0]
};

// So that its bar is a number that reads: lengths by thousands, shares as per cent.
ShownUnit unitFor(const QualityLine& line) {
  if (line.unit == "1")
    return line.bar > 0.0 && line.bar < 1.0 ? ShownUnit{" %", 100.0} : ShownUnit{"", 1.0};
  if (line.unit == "degrees") return {"\u00b0", 1.0};
  if (line.unit == "degrees/s") return {"\u00b0/s", 1.0};
  std::string unit = line.unit;
  if (unit == "m/s2") unit = "m/s\u00b2";
  if (unit == "m/s3") unit = "m/s\u00b3";
  if (line.unit != "m" && line.unit != "m/s") return {" " + unit, 1.0};
  if (line.bar >= 1.0 || line.bar <= 0.0) return {" " + unit, 1.0};
  if (line.bar >= 1e-3) return {" m" + unit, 1e3};
  if (line.bar >= 1e-6) return {" \u00b5" + unit, 1e6};
  return {" n" + unit, 1e9};
}

// Value and bar with four digits of the bar, and more where they would be alike but are not.
std::array<std::string, 2> qualityTexts(const QualityLine& line) {
  constexpr int kMostDigits = 9;
  const ShownUnit unit = unitFor(line);
  const double value = unit.scale * line.value, bar = unit.scale * line.bar;
  int digits = bar > 0.0 ? std::max(0, 3 - static_cast<int>(std::floor(std::log10(bar)))) : 3;
  digits = std::min(digits, kMostDigits);
  while (value != bar && digits < kMostDigits &&
         plainNumber(value, digits) == plainNumber(bar, digits))
    ++digits;
  return {plainNumber(value, digits) + unit.name, plainNumber(bar, digits) + unit.name};
}

class Writer {
 public:
  Writer(std::ostream& out, const ReportPage& page) : out_(out), xml_(out), page_(page) {}

  void write() {
    out_ << "<!DOCTYPE html>\n";
    const auto html = xml_.open("html", {{"lang", "en"}});
    writeHead();
    const auto body = xml_.open("body");
    writeTop();
    writePictures();
    if (solved())
      writeFigures();
    else
      writeWhy();
    writeQuality();
    writeTimes();
    writeRefusals();
    writeSteps();
    writeInputs();
    writeCommand();
  }

 private:
  bool solved() const { return report_.status == PlanStatus::kSolved; }

  void writeHead() {
    const auto head = xml_.open("head");
    xml_.empty("meta", {{"charset", "utf-8"}});
    xml_.empty("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}});
    xml_.empty("meta",
               {{"http-equiv", "Content-Security-Policy"},
                {"content", "default-src 'none'; img-src data:; style-src 'unsafe-inline'"}});
    xml_.text("title", {}, report_.scenario + " - report");
    out_ << "<style>" << kReportPageStyle << "</style>\n";
  }

  void writeTop() {
    xml_.text("h1", {}, report_.scenario);
    const auto lead = xml_.open("p", {{"class", "lead"}});
    xml_.text("span", {{"class", solved() ? "status solved" : "status"}},
              spaced(statusName(report_.status)) + ":");
    xml_.text("span", {}, summary());
  }

  std::string summary() const {
    if (!solved()) {
      return (report_.why.empty() ? "nothing was tried" : report_.why) +
             (report_.proved ? "; no walk exists" : "; none was found");
    }
    std::string text = metres(report_.length) + " in " + seconds(report_.duration) + ", " +
                       counted(static_cast<long long>(report_.steps.size()), "step");
    if (!report_.clearance.object.empty()) {
      text += "; nearest passes " + report_.clearance.part + " at " +
              metres(report_.clearance.min) + " from " + report_.clearance.object;
    }
    return text;
  }

  void writePictures() {
    writePicture("picture", "image/png", page_.picture,
                 solved() ? "The walk in its room; colours are times."
                          : "The room; green is what one gets to, red what stood in the way.");
    writePicture("plan", "image/svg+xml", page_.plan, "Seen from above.");
  }

  void writePicture(const char* kind, const char* type, const std::string& bytes,
                    const char* caption) {
    if (bytes.empty()) return;
    const auto figure = xml_.open("figure", {{"class", kind}});
    xml_.empty("img", {{"src", "data:" + std::string(type) + ";base64," + base64(bytes)},
                       {"alt", report_.scenario + ": " + caption}});
    xml_.text("figcaption", {}, caption);
  }

  void fact(const char* name, const std::string& value, const std::string& note = {}) {
    const auto box = xml_.open("div");
    xml_.text("dt", {}, name);
    const auto told = xml_.open("dd");
    xml_.text("span", {}, value);
    if (!note.empty()) xml_.text("small", {}, note);
  }

  void writeFigures() {
    const auto section = xml_.open("section");
    xml_.text("h2", {}, "The walk");
    const auto facts = xml_.open("dl", {{"class", "facts"}});
    fact("length", metres(report_.length));
    fact("duration", seconds(report_.duration),
         counted(report_.frames, "frame") + " of " + plainNumber(1000.0 * report_.frame_time, 2) +
             " ms");
    fact("steps", std::to_string(report_.steps.size()));
    const ClearanceReport& clearance = report_.clearance;
    if (!clearance.object.empty()) {
      fact("least clearance", metres(clearance.min),
           clearance.part + " and " + clearance.object + " at " + seconds(clearance.time));
    }
    fact("foot skate at most", millimetres(report_.foot_skate_max),
         "mean " + millimetres(report_.foot_skate_mean));
    fact("soles below the ground", millimetres(report_.ground_penetration), "at most");
    fact("off the goal", millimetres(report_.goal_position_error),
         degrees(report_.goal_heading_error));
    fact("stature", metres(report_.stature));
  }

  void writeWhy() {
    if (!report_.obstruction) return;
    const Obstruction& why = *report_.obstruction;
    const auto section = xml_.open("section");
    xml_.text("h2", {}, "What stood in the way");
    const auto facts = xml_.open("dl", {{"class", "facts"}});
    fact("rule", spaced(walkRuleName(why.rule)),
         why.count > 1 ? counted(why.count, "refusal") : std::string());
    if (!why.part.empty()) fact("part of the body", why.part);
    if (!why.object.empty()) {
      fact(why.other.empty() ? "thing" : "between", why.object,
           why.other.empty() ? std::string() : "and " + why.other);
    }
    fact("where", placeText(why.at), "x, y, z in metres");
    if (why.width) fact("there is", metres(*why.width));
    if (why.needed) fact("needed", metres(*why.needed));
    if (why.free) fact("nearest place that would do", placeText(*why.free));
    if (page_.reached != nullptr) {
      const ReachedRegion& reached = *page_.reached;
      fact("one gets as far as", placeText(reached.near),
           metres((reached.far - reached.near).norm()) + " from where the goal is got to");
    }
    fact("proved", report_.proved ? "yes" : "no",
         report_.proved ? "no walk exists" : "none was found");
  }

  void writeHeadings(std::initializer_list<const char*> names) {
    const auto head = xml_.open("thead");
    const auto row = xml_.open("tr");
    for (const char* name : names) xml_.text("th", {{"scope", "col"}}, name);
  }

  // A bar of so much of its track.
  void gauge(double share) {
    const auto cell = xml_.open("td", {{"class", "gauge"}});
    const auto track = xml_.open("span", {{"class", "track"}});
    xml_.text("span", {{"style", "width:" + percents(share)}}, "");
  }

  void writeQuality() {
    if (report_.quality.empty()) return;
    const auto section = xml_.open("section");
    xml_.text("h2", {}, "Quality against its bars");
    const auto table = xml_.open("table");
    writeHeadings({"measure", "value", "bar", "", "share of the bar"});
    const auto body = xml_.open("tbody");
    for (const QualityLine& line : report_.quality) {
      const auto [value, bar] = qualityTexts(line);
      const auto row = xml_.open("tr");
      xml_.text("td", {}, spaced(line.measure));
      xml_.text("td", {}, value);
      xml_.text("td", {}, bar);
      xml_.text("td", {{"class", line.holds() ? "holds" : "fails"}},
                line.holds() ? "holds" : "over");
      gauge(line.bar > 0.0 ? line.value / line.bar : (line.holds() ? 0.0 : 1.0));
    }
  }

  void writeTimes() {
    const RunTimes& times = report_.times;
    const std::array<std::pair<const char*, double>, 4> phases = {{{"load", times.load},
                                                                   {"roadmap", times.roadmap},
                                                                   {"search", times.search},
                                                                   {"refine", times.refine}}};
    const double all = times.load + times.planning();
    const auto section = xml_.open("section");
    xml_.text("h2", {}, "Time by phase: " + seconds(all));
    if (all > 0.0) {
      const auto bar = xml_.open("div", {{"class", "phases"}});
      for (const auto& [name, time] : phases)
        xml_.text("span", {{"class", name}, {"style", "width:" + percents(time / all)}}, "");
    }
    {
      const auto facts = xml_.open("dl", {{"class", "facts"}});
      for (const auto& [name, time] : phases) writePhase(name, time, all);
    }
    const LoadTimes& loading = times.loading;
    xml_.text("p", {{"class", "quiet"}},
              "Of loading: scene " + seconds(loading.scene) + ", library " +
                  seconds(loading.library) + ", ground " + seconds(loading.ground) +
                  ", character " + seconds(loading.character) + ", collision " +
                  seconds(loading.collision) + ".");
    if (!report_.stopped_by.empty())
      xml_.text("p", {{"class", "quiet"}}, "Ended by: " + spaced(report_.stopped_by) + ".");
  }

  void writePhase(const char* name, double time, double all) {
    const auto box = xml_.open("div");
    {
      const auto term = xml_.open("dt");
      xml_.text("span", {{"class", std::string("key ") + name}}, "");
      xml_.text("span", {}, name);
    }
    xml_.text("dd", {}, seconds(time) + (all > 0.0 ? ", " + percents(time / all) : std::string()));
  }

  void writeRefusals() {
    const auto section = xml_.open("section");
    xml_.text("h2", {}, "Search, and what was refused");
    {
      const RoadmapReport& map = report_.roadmap;
      const auto facts = xml_.open("dl", {{"class", "facts"}});
      fact("planner", report_.planner, "seed " + std::to_string(report_.seed));
      fact("guards", std::to_string(map.guards));
      fact("connectors", std::to_string(map.connectors));
      fact("edges", std::to_string(map.edges));
      fact("samples", std::to_string(map.samples),
           map.coverage > 0.0 ? percents(map.coverage) + " covered" : std::string());
      fact("poses checked", std::to_string(report_.poses_checked));
    }
    if (report_.refusals.empty()) return;
    std::vector<std::pair<std::string, long long>> rules(report_.refusals.begin(),
                                                         report_.refusals.end());
    std::stable_sort(rules.begin(), rules.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    const auto table = xml_.open("table");
    writeHeadings({"refused by the rule", "times", ""});
    const auto body = xml_.open("tbody");
    for (const auto& [rule, times] : rules) {
      const auto row = xml_.open("tr");
      xml_.text("td", {}, spaced(rule));
      xml_.text("td", {}, std::to_string(times));
      gauge(static_cast<double>(times) / static_cast<double>(std::max(1LL, rules[0].second)));
    }
  }

  void writeSteps() {
    if (report_.steps.empty()) return;
    const auto section = xml_.open("section");
    xml_.text("h2", {}, "Steps");
    const auto table = xml_.open("table", {{"class", "steps"}});
    writeHeadings({"foot", "strike [s]", "lift-off [s]", "at x, y, z [m]", "stride [m]", "lift [m]",
                   "climb [m]", "slide [mm]"});
    const auto body = xml_.open("tbody");
    for (const StepMeasure& step : report_.steps) {
      const auto row = xml_.open("tr");
      for (const std::string& value :
           {std::string(step.side == kLeft ? "left" : "right"), fixedNumber(step.strike, 2),
            fixedNumber(step.lift_off, 2), placeText(step.at), fixedNumber(step.stride, 3),
            fixedNumber(step.lift, 3), fixedNumber(step.climb, 3),
            fixedNumber(1000.0 * step.slide, 1)})
        xml_.text("td", {}, value);
    }
  }

  void writeInputs() {
    const auto section = xml_.open("section");
    xml_.text("h2", {}, "Inputs");
    const auto table = xml_.open("table");
    writeHeadings({"file, from the scenario's folder", "SHA-256"});
    const auto body = xml_.open("tbody");
    for (const auto& [file, digest] : report_.inputs) {
      const auto row = xml_.open("tr");
      xml_.text("td", {}, file);
      const auto cell = xml_.open("td", {{"class", "hash"}});
      xml_.text("code", {}, digest);
    }
  }

  void writeCommand() {
    const auto section = xml_.open("section");
    xml_.text("h2", {}, "The same again");
    if (!page_.command.empty()) xml_.text("code", {}, page_.command);
    xml_.text("p", {{"class", "quiet"}}, "amble " + report_.version);
  }

  std::ostream& out_;
  XmlWriter xml_;
  const ReportPage& page_;
  const Report& report_ = page_.report;
};

}  // namespace

void writeReportPage(std::ostream& out, const ReportPage& page) { Writer(out, page).write(); }

}  // namespace amble
