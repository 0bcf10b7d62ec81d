#include "base/strict_yaml.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>

#include "base/text.h"
#include "base/yaml_document.h"

namespace amble {
namespace {

std::string toText(double number) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, number);
  return {text, end.ptr};
}

std::string rangeText(double min, double max) {
  const bool has_min = min != -YamlNode::kInfinity;
  const bool has_max = max != YamlNode::kInfinity;
  if (has_min && has_max) return " from " + toText(min) + " to " + toText(max);
  if (has_min) return " of at least " + toText(min);
  if (has_max) return " of at most " + toText(max);
  return "";
}

// Digits without a leading zero (`010` is 8 to some readers and 10 to others), or none.
size_t countDigits(std::string_view text) {
  const size_t count = std::find_if_not(text.begin(), text.end(), isDigit) - text.begin();
  return count > 1 && text[0] == '0' ? std::string_view::npos : count;
}

// [-+]?(0|[1-9][0-9]*)?(\.[0-9]*)?([eE][-+]?[0-9]+)? with a digit before the exponent, finite.
bool parseDecimal(std::string_view text, double& number) {
  if (!text.empty() && text[0] == '+') text.remove_prefix(1);
  std::string_view rest = text;
  if (!rest.empty() && rest[0] == '-') rest.remove_prefix(1);
  const size_t whole = countDigits(rest);
  if (whole == std::string_view::npos) return false;
  if (whole == 0 && (rest.size() < 2 || rest[0] != '.' || !isDigit(rest[1]))) return false;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), number);
  return end.ec == std::errc() && end.ptr == text.data() + text.size() && std::isfinite(number);
}

bool parseWhole(std::string_view text, int& number) {
  if (!text.empty() && text[0] == '+') text.remove_prefix(1);
  std::string_view rest = text;
  if (!rest.empty() && rest[0] == '-') rest.remove_prefix(1);
  if (countDigits(rest) != rest.size() || rest.empty()) return false;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), number);
  return end.ec == std::errc() && end.ptr == text.data() + text.size();
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
    text += names[i];
  }
  return text;
}

// Edits (insert, delete, replace, swap of neighbours) from a to b: optimal string alignment.
size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::vector<size_t>> d(a.size() + 1, std::vector<size_t>(b.size() + 1));
  for (size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
  for (size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    for (size_t j = 1; j <= b.size(); ++j) {
      const size_t replaced = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
      }
    }
  }
  return d[a.size()][b.size()];
}

std::string pathOf(const YamlValue& value) {
  const YamlValue* parent = value.parent();
  if (parent == nullptr) return "";
  std::string before = pathOf(*parent);
  if (parent->kind == YamlKind::kSequence) return before + "[" + std::to_string(value.index) + "]";
  return before + (before.empty() ? "" : ".") + std::string(value.key);
}

// "start.at is 'x'", "start.at is a map", "the document is empty".
std::string stateOf(const YamlValue& value) {
  const std::string where = pathOf(value);
  const std::string subject = where.empty() ? "the document" : where;
  switch (value.kind) {
    case YamlKind::kNull:
      return subject + " is empty";
    case YamlKind::kScalar:
      return subject + " is " + quotedShort(value.text);
    case YamlKind::kSequence:
      return subject + " is a list";
    case YamlKind::kMap:
      break;
  }
  return subject + " is a map";
}

}  // namespace

YamlNode::YamlNode() = default;
YamlNode::YamlNode(std::shared_ptr<const YamlDocument> document, const YamlValue* value)
    : document_(std::move(document)), value_(value) {}

const YamlValue& YamlNode::value() const {
  assert(value_ != nullptr && "ask the node itself first: if (const YamlNode n = map[key])");
  return *value_;
}
bool YamlNode::isMap() const { return value().kind == YamlKind::kMap; }
bool YamlNode::isSequence() const { return value().kind == YamlKind::kSequence; }
bool YamlNode::isScalar() const { return value().kind == YamlKind::kScalar; }
bool YamlNode::isNull() const { return value().kind == YamlKind::kNull; }
int YamlNode::line() const { return value().line; }
const std::string& YamlNode::file() const {
  value();
  return document_->file;
}
std::string YamlNode::path() const { return pathOf(value()); }
void YamlNode::fail(const std::string& problem, const std::string& expected) const {
  throw InputError(file(), line(), problem, expected);
}

const YamlValue& YamlNode::map() const {
  if (!isMap()) fail(stateOf(value()), "a map (key: value)");
  return value();
}
const YamlValue& YamlNode::sequence(const std::string& wanted) const {
  if (!isSequence()) fail(stateOf(value()), wanted);
  return value();
}

void YamlNode::requireKeys(std::initializer_list<std::string_view> known) const {
  requireKeys(std::vector<std::string>(known.begin(), known.end()));
}

void YamlNode::requireKeys(const std::vector<std::string>& known) const {
  const YamlValue& node = map();
  for (const YamlValue* child = node.begin(); child != node.end(); child = child->next()) {
    if (std::find(known.begin(), known.end(), child->key) != known.end()) continue;
    const std::string key(child->key), meant = nearestWord(key, known), where = path();
    throw InputError(file(), child->key_line,
                     "unknown key " + quotedShort(key) + (where.empty() ? "" : " in " + where),
                     meant.empty() ? listed(known) : "'" + meant + "'");
  }
}

YamlNode YamlNode::operator[](std::string_view key) const {
  const YamlValue& node = map();
  for (const YamlValue* child = node.begin(); child != node.end(); child = child->next()) {
    if (child->key == key) return YamlNode(document_, child);
  }
  return {};
}

YamlNode YamlNode::at(std::string_view key) const {
  YamlNode found = (*this)[key];
  if (!found) {
    const std::string where = path();
    fail((where.empty() ? "" : where + ": ") + "the key " + quotedShort(key) + " is missing",
         "'" + std::string(key) + ":' and its value");
  }
  return found;
}

std::vector<std::pair<std::string, YamlNode>> YamlNode::entries() const {
  const YamlValue& node = map();
  std::vector<std::pair<std::string, YamlNode>> all;
  all.reserve(node.size);
  for (const YamlValue* child = node.begin(); child != node.end(); child = child->next()) {
    all.emplace_back(child->key, YamlNode(document_, child));
  }
  return all;
}

std::vector<YamlNode> YamlNode::items() const {
  const YamlValue& node = sequence("a list");
  std::vector<YamlNode> all;
  all.reserve(node.size);
  for (const YamlValue* child = node.begin(); child != node.end(); child = child->next()) {
    all.push_back(YamlNode(document_, child));
  }
  return all;
}

int YamlNode::size() const { return static_cast<int>(value().size); }

std::string YamlNode::asString() const {
  if (!isScalar() || value().text.empty()) fail(stateOf(value()), "text");
  return std::string(value().text);
}

double YamlNode::asDouble(double min, double max, std::string_view what) const {
  const YamlValue& scalar = value();
  double number = 0.0;
  const bool is_number = scalar.plain && parseDecimal(scalar.text, number);
  if (is_number && number >= min && number <= max) return number;
  const std::string wanted = std::string(what) + rangeText(min, max);
  fail(stateOf(scalar), wanted + (is_number || what == "number" ? "" : ", a number"));
}

double YamlNode::asPositive(std::string_view what, double max) const {
  const double number = asDouble(-kInfinity, max, what);
  if (number <= 0.0) fail(stateOf(value()), std::string(what) + " above 0");
  return number;
}

int YamlNode::asInt(int min, int max, std::string_view what) const {
  int number = 0;
  if (!value().plain || !parseWhole(value().text, number) || number < min || number > max) {
    fail(stateOf(value()), std::string(what) + rangeText(min, max));
  }
  return number;
}

bool YamlNode::asBool() const {
  if (!value().plain || (value().text != "true" && value().text != "false")) {
    fail(stateOf(value()), "true or false");
  }
  return value().text == "true";
}

Eigen::VectorXd YamlNode::asVec(int n, std::string_view what, double min, double max) const {
  const bool is_right = isSequence() && size() == n;
  if (!is_right) {
    const std::string wanted = std::to_string(n) + " " + std::string(what) + " in brackets";
    const YamlValue& list = sequence(wanted);
    fail(stateOf(list) + " of " + std::to_string(list.size), wanted);
  }
  Eigen::VectorXd numbers(n);
  YamlNode item(document_, value().begin());
  for (int i = 0; i < n; ++i, item.value_ = item.value_->next()) {
    numbers[i] = item.asDouble(min, max);
  }
  return numbers;
}

std::filesystem::path YamlNode::asPath() const {
  const std::filesystem::path named = asString();
  const std::filesystem::path folder = std::filesystem::path(file()).parent_path();
  return (folder / named).lexically_normal();
}

int YamlNode::indexIn(const std::vector<std::string>& names) const {
  if (!isScalar()) fail(stateOf(value()), listed(names));
  const auto found = std::find(names.begin(), names.end(), value().text);
  if (found == names.end()) {
    const std::string meant = nearestWord(value().text, names);
    fail(stateOf(value()), meant.empty() ? listed(names) : "'" + meant + "'");
  }
  return static_cast<int>(found - names.begin());
}

YamlNode parseYaml(const std::string& text, const std::string& name) {
  std::shared_ptr<const YamlDocument> document = parseYamlDocument(text, name);
  const YamlValue* root = document->values.data();
  return YamlNode(std::move(document), root);
}

YamlNode readYaml(const std::filesystem::path& file, const FileKind& kind) {
  return parseYaml(readWholeFile(file, kind), file.string());
}

std::string nearestWord(std::string_view word, const std::vector<std::string>& candidates) {
  constexpr size_t kLongest = 64;  // a longer word is no misspelling
  if (word.size() > kLongest) return "";
  std::string nearest;
  size_t least = std::max<size_t>(1, word.size() / 3) + 1;
  for (const std::string& candidate : candidates) {
    const size_t distance = editDistance(word, candidate);
    if (distance < least) {
      least = distance;
      nearest = candidate;
    }
  }
  return nearest;
}

}  // namespace amble
