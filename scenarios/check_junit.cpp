#include "scenarios/check_junit.h"

#include <algorithm>

#include "base/text.h"
#include "base/xml.h"

namespace amble {
namespace {

// What is said of a test that is not as it should be; none of one that is.
const char* elementOf(CheckVerdict verdict) {
  switch (verdict) {
    case CheckVerdict::kHolds:
      return nullptr;
    case CheckVerdict::kDiffers:
      return "failure";
    case CheckVerdict::kError:
      return "error";
    case CheckVerdict::kSkipped:
    case CheckVerdict::kStopped:
      return "skipped";
  }
  return nullptr;
}

void writeCase(XmlWriter& xml, const CheckRow& row) {
  const XmlAttributes attributes = {{"classname", row.file.parent_path().generic_string()},
                                    {"name", row.scenario},
                                    {"time", row.total_time}};
  const char* const element = elementOf(row.verdict);
  if (element == nullptr) {
    xml.empty("testcase", attributes);
    return;
  }
  const XmlWriter::Element open = xml.open("testcase", attributes);
  std::vector<std::string> notes = row.notes;
  if (!row.changes.empty()) notes.push_back(row.changes);
  xml.empty(element, {{"message", joined(notes, "; ")}});
}

}  // namespace

void writeJUnit(std::ostream& out, const std::vector<CheckRow>& rows) {
  const auto count = [&](CheckVerdict verdict) {
    return std::count_if(rows.begin(), rows.end(),
                         [&](const CheckRow& row) { return row.verdict == verdict; });
  };
  double time = 0.0;
  for (const CheckRow& row : rows) time += row.total_time;
  XmlWriter xml(out);
  xml.declare();
  const XmlWriter::Element suites = xml.open("testsuites");
  const XmlWriter::Element suite = xml.open(
      "testsuite", {{"name", "amble check"},
                    {"tests", rows.size()},
                    {"failures", count(CheckVerdict::kDiffers)},
                    {"errors", count(CheckVerdict::kError)},
                    {"skipped", count(CheckVerdict::kSkipped) + count(CheckVerdict::kStopped)},
                    {"time", time}});
  for (const CheckRow& row : rows) writeCase(xml, row);
}

}  // namespace amble
