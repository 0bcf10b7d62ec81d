#include "scenarios/update_expectation.h"

#include <algorithm>
#include <sstream>
#include <vector>

#include "base/error.h"
#include "base/strict_yaml.h"
#include "scenarios/scenario.h"

namespace amble {
namespace {

constexpr const char* kKey = "bvh_sha256";

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

// Replaces the value behind the key on its line.
bool replaceValue(std::string& line, const std::string& digest) {
  const size_t key = line.find(kKey);
  const size_t old =
      key == std::string::npos ? key : line.find_first_of("0123456789abcdef", key + 10);
  if (old == std::string::npos || line.find_first_not_of("0123456789abcdef", old) - old < 64) {
    return false;
  }
  line.replace(old, 64, digest);
  return true;
}

// Behind the last entry of `expect`, as its entries are written: in a line of its own, or within
// braces.
void insertValue(std::vector<std::string>& lines, const YamlNode& expect,
                 const std::string& digest) {
  const std::string entry = std::string(kKey) + ": " + digest;
  int last = expect.line();
  for (const auto& [key, value] : expect.entries()) last = std::max(last, value.line());
  std::string& line = lines.at(last - 1);
  const size_t first_character = line.find_first_not_of(' ');
  if (last == expect.line() && line.find('{') != std::string::npos) {
    const size_t brace = line.rfind('}');
    if (brace == std::string::npos) return;
    size_t end = brace;
    while (end > 0 && line[end - 1] == ' ') --end;
    line.insert(end, (expect.size() > 0 ? ", " : "") + entry);
    return;
  }
  lines.insert(lines.begin() + last, std::string(first_character, ' ') + entry);
}

}  // namespace

std::string withDigest(const std::string& text, const std::string& file,
                       const std::string& digest) {
  const YamlNode root = parseYaml(text, file);
  std::vector<std::string> lines = linesOf(text);
  const YamlNode expect = root["expect"];
  if (!expect || expect.isNull()) {
    if (expect) lines.erase(lines.begin() + expect.line() - 1);
    lines.push_back("expect:");
    lines.push_back(std::string("  ") + kKey + ": " + digest);
  } else if (const YamlNode old = expect[kKey]) {
    replaceValue(lines.at(old.line() - 1), digest);
  } else {
    insertValue(lines, expect, digest);
  }
  std::string updated;
  for (const std::string& line : lines) updated += line + "\n";
  // The layouts of YAML are many: what was written is read again before it is believed.
  try {
    const Scenario scenario = readScenario(ScenarioFile{file, updated});
    if (scenario.expect && scenario.expect->bvh_sha256 == digest) return updated;
  } catch (const InputError&) {
  }
  throw InputError(file, expect ? expect.line() : 0,
                   "'expect' is laid out so that it cannot be updated", "one key a line");
}

}  // namespace amble
