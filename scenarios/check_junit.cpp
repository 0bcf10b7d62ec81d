#include "scenarios/check_junit.h"

#include <algorithm>
#include <cstdio>

namespace amble {
namespace {

std::string xmlText(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '&':
        escaped += "&amp;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      default:
        escaped += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return escaped;
}

std::string joined(const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& note : notes) text += (text.empty() ? "" : "; ") + note;
  return text;
}

std::string seconds(double time) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3f", time);
  return text;
}

}  // namespace

void writeJUnit(std::ostream& out, const std::vector<CheckRow>& rows) {
  const auto count = [&](CheckVerdict verdict) {
    return std::count_if(rows.begin(), rows.end(),
                         [&](const CheckRow& row) { return row.verdict == verdict; });
  };
  double time = 0.0;
  for (const CheckRow& row : rows) time += row.total_time;
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n"
      << "  <testsuite name=\"amble check\" tests=\"" << rows.size() << "\" failures=\""
      << count(CheckVerdict::kDiffers) << "\" errors=\"" << count(CheckVerdict::kError)
      << "\" skipped=\"" << count(CheckVerdict::kSkipped) + count(CheckVerdict::kStopped)
      << "\" time=\"" << seconds(time) << "\">\n";
  for (const CheckRow& row : rows) {
    out << "    <testcase classname=\"" << xmlText(row.file.parent_path().generic_string())
        << "\" name=\"" << xmlText(row.scenario) << "\" time=\"" << seconds(row.total_time) << "\"";
    if (row.verdict == CheckVerdict::kHolds) {
      out << "/>\n";
      continue;
    }
    const char* element = row.verdict == CheckVerdict::kDiffers ? "failure"
                          : row.verdict == CheckVerdict::kError ? "error"
                                                                : "skipped";
    out << ">\n      <" << element << " message=\"" << xmlText(joined(row.notes))
        << "\"/>\n    </testcase>\n";
  }
  out << "  </testsuite>\n</testsuites>\n";
}

}  // namespace amble
