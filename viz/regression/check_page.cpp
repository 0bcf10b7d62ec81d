#include "viz/regression/check_page.h"

#include <algorithm>

#include "base/base64.h"
#include "base/text.h"
#include "base/xml.h"
#include "viz/regression/check_page_text.h"

namespace amble {
namespace {

constexpr CheckVerdict kVerdicts[] = {CheckVerdict::kHolds, CheckVerdict::kDiffers,
                                      CheckVerdict::kError, CheckVerdict::kSkipped,
                                      CheckVerdict::kStopped};

// For the order in which a person looks at them.
int badness(const CheckRow& row) {
  switch (row.verdict) {
    case CheckVerdict::kError:
      return 5;
    case CheckVerdict::kDiffers:
      return 4;
    case CheckVerdict::kStopped:
      return 3;
    case CheckVerdict::kSkipped:
      return 2;
    case CheckVerdict::kHolds:
      return row.changes.empty() ? 0 : 1;
  }
  return 0;
}

void writePicture(XmlWriter& xml, const std::string& png, const std::string& what,
                  const std::string& caption) {
  const XmlWriter::Element figure = xml.open("figure");
  if (png.empty()) {
    xml.text("div", {{"class", "none"}}, "no picture");
  } else {
    const XmlWriter::Element button =
        xml.open("button", {{"type", "button"}, {"title", "Enlarge"}});
    xml.empty(
        "img",
        {{"src", "data:image/png;base64," + base64(png)}, {"alt", what}, {"loading", "lazy"}});
  }
  if (!caption.empty()) xml.text("figcaption", {}, caption);
}

void writePictures(XmlWriter& xml, const CheckRow& row) {
  if (row.run.status.empty()) return;
  const XmlWriter::Element pictures = xml.open("div", {{"class", "pictures"}});
  if (row.changes.empty()) {
    writePicture(xml, row.picture, row.scenario, "");
    return;
  }
  writePicture(xml, row.accepted->picture, row.scenario + ", as it was accepted",
               "accepted: " + row.accepted->figures.status);
  writePicture(xml, row.picture, row.scenario + ", now", "now: " + row.run.status);
}

std::string shown(const RunFigure& figure, const RunFigures& figures) {
  if (figure.of_walk && !figures.hasWalk()) return "-";
  return figure.text(figures) + " " + figure.unit;
}

std::string changeOf(const RunFigure& figure, const CheckRow& row) {
  if (!row.accepted) return "";
  const RunFigures& before = row.accepted->figures;
  if (figure.of_walk && !(before.hasWalk() && row.run.hasWalk())) return "";
  return figure.change(before, row.run);
}

void writeFigure(XmlWriter& xml, const RunFigure& figure, const CheckRow& row) {
  const std::string change = changeOf(figure, row);
  const bool marked = figure.of_walk && !change.empty();
  const XmlWriter::Element line = xml.open("tr", {{"class", marked ? "changed" : "same"}});
  xml.text("th", {{"scope", "row"}}, figure.name);
  if (row.accepted) xml.text("td", {}, shown(figure, row.accepted->figures));
  xml.text("td", {}, shown(figure, row.run));
  if (row.accepted) xml.text("td", {}, change);
}

void writeFigures(XmlWriter& xml, const CheckRow& row) {
  if (row.run.status.empty()) return;
  const XmlWriter::Element box = xml.open("div", {{"class", "figures"}});
  const XmlWriter::Element table = xml.open("table");
  if (row.accepted) {
    const XmlWriter::Element head = xml.open("thead");
    const XmlWriter::Element line = xml.open("tr");
    for (const char* title : {"", "accepted", "now", "change"}) xml.text("th", {}, title);
  }
  const XmlWriter::Element body = xml.open("tbody");
  const bool walks = row.run.hasWalk() || (row.accepted && row.accepted->figures.hasWalk());
  for (const RunFigure& figure : kFigures)
    if (walks || !figure.of_walk) writeFigure(xml, figure, row);
}

// Changes that the table of figures does not show.
std::vector<std::string> notesOf(const CheckRow& row) {
  std::vector<std::string> notes = row.notes;
  const bool seen = std::any_of(kFigures.begin(), kFigures.end(), [&](const RunFigure& figure) {
    return figure.of_walk && !changeOf(figure, row).empty();
  });
  if (!row.changes.empty() && !seen) notes.insert(notes.begin(), row.changes);
  return notes;
}

XmlAttributes attributesOf(const CheckRow& row) {
  XmlAttributes attributes = {
      {"class", verdictName(row.verdict) + (row.changes.empty() ? "" : " changed")},
      {"data-name", row.scenario},
      {"data-worst", badness(row)}};
  if (!row.run.status.empty()) attributes.emplace_back("data-planning", row.run.planning_time);
  if (row.run.hasWalk()) {
    attributes.emplace_back("data-length", row.run.length);
    attributes.emplace_back("data-clearance", row.run.clearance);
    attributes.emplace_back("data-skate", 1000.0 * row.run.foot_skate);
  }
  return attributes;
}

void writeCard(XmlWriter& xml, const CheckRow& row) {
  const XmlWriter::Element card = xml.open("article", attributesOf(row));
  {
    const XmlWriter::Element header = xml.open("header");
    xml.text("span", {{"class", "verdict"}}, verdictName(row.verdict));
    xml.text("h2", {{"title", row.file.string()}}, row.scenario);
    xml.text("span", {{"class", "status"}}, row.run.status + (row.updated ? ", accepted" : ""));
  }
  writePictures(xml, row);
  if (!row.why.empty()) xml.text("p", {{"class", "why"}}, row.why);
  writeFigures(xml, row);
  const std::vector<std::string> notes = notesOf(row);
  if (notes.empty()) return;
  const XmlWriter::Element list = xml.open("ul", {{"class", "notes"}});
  for (const std::string& note : notes) xml.text("li", {}, note);
}

long long countOf(const std::vector<CheckRow>& rows, CheckVerdict verdict) {
  return std::count_if(rows.begin(), rows.end(),
                       [&](const CheckRow& row) { return row.verdict == verdict; });
}

void writeSummary(XmlWriter& xml, const std::vector<CheckRow>& rows) {
  std::vector<std::string> counts;
  for (const CheckVerdict verdict : kVerdicts) {
    const long long count = countOf(rows, verdict);
    if (count > 0) counts.push_back(std::to_string(count) + " " + verdictName(verdict));
  }
  xml.text("p", {},
           counted(static_cast<long long>(rows.size()), "scenario") +
               (counts.empty() ? "" : ": " + joined(counts)));
  RunFigures before, now;  // of those that were accepted
  for (const CheckRow& row : rows) {
    if (!row.accepted || row.run.status.empty()) continue;
    before.planning_time += row.accepted->figures.planning_time;
    now.planning_time += row.run.planning_time;
  }
  const RunFigure& planning = kFigures.back();
  if (before.planning_time <= 0.0) return;
  const std::string change = planning.change(before, now);
  xml.text("p", {},
           "Planning took " + shown(planning, now) + ", when accepted " + shown(planning, before) +
               (change.empty() ? "" : " (" + change + ")"));
}

void writeChoice(XmlWriter& xml, const std::string& value, const std::string& text, bool checked) {
  const XmlWriter::Element label = xml.open("label");
  XmlAttributes attributes = {{"type", "radio"}, {"name", "kind"}, {"value", value}};
  if (checked) attributes.emplace_back("checked", "");
  xml.empty("input", attributes);
  xml.text("span", {}, text);
}

void writeOrders(XmlWriter& xml) {
  constexpr std::pair<const char*, const char*> kOrders[] = {{"worst", "what differs first"},
                                                             {"files", "as they were run"},
                                                             {"name", "by name"},
                                                             {"length", "longest first"},
                                                             {"clearance", "nearest first"},
                                                             {"skate", "most skate first"},
                                                             {"planning", "slowest first"}};
  const XmlWriter::Element select =
      xml.open("select", {{"name", "order"}, {"aria-label", "Order"}});
  for (const auto& [value, text] : kOrders) xml.text("option", {{"value", value}}, text);
}

void writeTools(XmlWriter& xml, const std::vector<CheckRow>& rows) {
  const XmlWriter::Element tools = xml.open("div", {{"id", "tools"}, {"hidden", ""}});
  const XmlWriter::Element form = xml.open("form");
  xml.empty("input", {{"type", "search"},
                      {"name", "search"},
                      {"placeholder", "Search names"},
                      {"aria-label", "Search names"}});
  {
    const XmlWriter::Element kinds = xml.open("fieldset", {{"aria-label", "Which to show"}});
    writeChoice(xml, "all", "all " + std::to_string(rows.size()), true);
    const auto changed = std::count_if(rows.begin(), rows.end(),
                                       [](const CheckRow& row) { return !row.changes.empty(); });
    if (changed > 0) writeChoice(xml, "changed", "changed " + std::to_string(changed), false);
    for (const CheckVerdict verdict : kVerdicts) {
      const long long count = countOf(rows, verdict);
      const std::string name = verdictName(verdict);
      if (count > 0) writeChoice(xml, name, name + " " + std::to_string(count), false);
    }
  }
  writeOrders(xml);
  xml.text("span", {{"id", "shown"}, {"aria-live", "polite"}}, "");
}

void writeDialog(XmlWriter& xml) {
  const XmlWriter::Element dialog = xml.open("dialog", {{"aria-label", "Enlarged picture"}});
  {
    const XmlWriter::Element line = xml.open("p");
    xml.text("span", {}, "");
    xml.text("button", {{"type", "button"}, {"id", "other"}}, "Before / after");
    xml.text("button", {{"type", "button"}, {"id", "close"}}, "Close");
  }
  xml.empty("img", {{"alt", ""}});
}

}  // namespace

void writeCheckPage(std::ostream& out, const std::vector<CheckRow>& rows) {
  XmlWriter xml(out);
  out << "<!DOCTYPE html>\n";
  const XmlWriter::Element html = xml.open("html", {{"lang", "en"}});
  {
    const XmlWriter::Element head = xml.open("head");
    xml.empty("meta", {{"charset", "utf-8"}});
    xml.empty("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}});
    xml.empty("meta", {{"http-equiv", "Content-Security-Policy"},
                       {"content",
                        "default-src 'none'; img-src data:; style-src 'unsafe-inline'; "
                        "script-src 'unsafe-inline'"}});
    xml.text("title", {}, "amble check");
    const XmlWriter::Element style = xml.open("style");
    out << kCheckPageStyle;
  }
  const XmlWriter::Element body = xml.open("body");
  {
    const XmlWriter::Element header = xml.open("header");
    xml.text("h1", {}, "amble check");
    writeSummary(xml, rows);
  }
  writeTools(xml, rows);
  {
    const XmlWriter::Element main = xml.open("main");
    for (const CheckRow& row : rows) writeCard(xml, row);
  }
  writeDialog(xml);
  const XmlWriter::Element script = xml.open("script");
  out << kCheckPageScript;
}

}  // namespace amble
