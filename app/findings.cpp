#include "app/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "app/say.h"

namespace amble {
namespace {

using Json = nlohmann::ordered_json;

void printText(const Findings& findings) {
  say(stdout, "{}: {}\n", findings.file, findings.kind);
  size_t width = 0;
  for (const auto& fact : findings.facts) width = std::max(width, fact.first.size());
  for (const auto& [label, value] : findings.facts) {
    say(stdout, "  {:<{}}  {}\n", label, width, value);
  }
  for (const std::string& warning : findings.warnings) {
    say(stdout, "  warning: {}\n", warning);
  }
}

}  // namespace

void printFindings(const std::vector<Findings>& all, bool json) {
  if (!json) {
    for (const Findings& findings : all) printText(findings);
    return;
  }
  Json list = Json::array();
  for (const Findings& findings : all) {
    Json entry = {{"file", findings.file}, {"kind", findings.kind}};
    entry.update(findings.data);
    entry["warnings"] = findings.warnings;
    list.push_back(std::move(entry));
  }
  // A name in a file may be of any bytes; JSON must be UTF-8.
  std::cout << list.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

}  // namespace amble
