#include "base/strict_yaml.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <deque>
#include <sstream>
#include <unordered_map>

namespace amble {
namespace {

// What a file holds may be long; a message is one line.
std::string quote(const std::string& text) {
  constexpr size_t kLongest = 60;
  if (text.size() <= kLongest) return "'" + text + "'";
  return "'" + text.substr(0, kLongest) + "...'";
}

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

bool isDigit(char c) { return c >= '0' && c <= '9'; }

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

}  // namespace

struct YamlNode::Data {
  enum class Kind { kNull, kScalar, kSequence, kMap };

  Kind kind = Kind::kNull;
  int line = 0;
  bool plain = true;  // a scalar without quotes
  std::string text;   // of a scalar
  const std::string* file = nullptr;
  const Data* parent = nullptr;
  size_t index = 0;                   // among the parent's children
  std::vector<const Data*> children;  // of a map or sequence
  std::vector<std::string> keys;      // of a map, one a child, in the order of the file
  std::vector<int> key_lines;

  bool isScalar() const { return kind == Kind::kScalar; }

  std::string path() const {
    if (parent == nullptr) return "";
    std::string before = parent->path();
    if (parent->kind == Kind::kSequence) return before + "[" + std::to_string(index) + "]";
    return before + (before.empty() ? "" : ".") + parent->keys[index];
  }

  [[noreturn]] void fail(const std::string& problem, const std::string& expected) const {
    throw InputError(*file, line, problem, expected);
  }

  // "start.at is 'x'", "start.at is a map", "the document is empty".
  std::string state() const {
    const std::string where = path();
    const std::string subject = where.empty() ? "the document" : where;
    switch (kind) {
      case Kind::kNull:
        return subject + " is empty";
      case Kind::kScalar:
        return subject + " is " + quote(text);
      case Kind::kSequence:
        return subject + " is a list";
      case Kind::kMap:
        break;
    }
    return subject + " is a map";
  }
};

// Makes a document of the parser's events, and refuses there what no reader of ours wants.
struct YamlNode::Builder : YAML::EventHandler {
  using Kind = Data::Kind;

  struct Document {
    std::string file;
    std::deque<Data> nodes;  // the root first; addresses stay
  };
  struct Open {
    Data* node;
    bool has_key = false;
    std::unordered_map<std::string, int> lines_of_keys;  // looked up only, never walked through
  };

  explicit Builder(const std::string& file) { document->file = file; }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnSequenceEnd() override { open.pop_back(); }
  void OnMapEnd() override { open.pop_back(); }
  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override {
    if (wantsKey()) refuse(mark, "an empty key", "a name before the colon");
    add(Kind::kNull, mark);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    refuse(mark, "an alias (*name)", "the value itself");
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                const std::string& value) override {
    refuseTag(mark, tag);
    if (wantsKey()) return addKey(mark, value);
    Data& node = add(Kind::kScalar, mark);
    node.plain = tag != "!";
    node.text = value;
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    begin(Kind::kSequence, mark, tag);
  }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {
    begin(Kind::kMap, mark, tag);
  }

  [[noreturn]] void refuse(const YAML::Mark& mark, const std::string& problem,
                           const std::string& expected) const {
    throw InputError(document->file, mark.line + 1, problem, expected);
  }
  void refuseTag(const YAML::Mark& mark, const std::string& tag) const {
    if (!tag.empty() && tag != "?" && tag != "!") {
      refuse(mark, "a tag (" + quote(tag) + ")", "a value without a tag");
    }
  }
  bool wantsKey() const {
    return !open.empty() && open.back().node->kind == Kind::kMap && !open.back().has_key;
  }
  void addKey(const YAML::Mark& mark, const std::string& key) {
    Open& map = open.back();
    const auto [place, is_new] = map.lines_of_keys.emplace(key, mark.line + 1);
    if (!is_new) {
      refuse(mark, "the key " + quote(key) + " is given twice",
             "it once (it is on line " + std::to_string(place->second) + " too)");
    }
    map.node->keys.push_back(key);
    map.node->key_lines.push_back(mark.line + 1);
    map.has_key = true;
  }
  Data& add(Kind kind, const YAML::Mark& mark) {
    if (document->nodes.size() >= kMaxYamlValues) {
      refuse(mark, "too many values", "at most " + std::to_string(kMaxYamlValues));
    }
    Data& node = document->nodes.emplace_back();
    node.kind = kind;
    node.line = mark.line + 1;
    node.file = &document->file;
    if (!open.empty()) {
      Open& above = open.back();
      node.parent = above.node;
      node.index = above.node->children.size();
      above.node->children.push_back(&node);
      above.has_key = false;
    }
    return node;
  }
  void begin(Kind kind, const YAML::Mark& mark, const std::string& tag) {
    refuseTag(mark, tag);
    if (wantsKey()) refuse(mark, "a key that is a list or a map", "a name before the colon");
    if (static_cast<int>(open.size()) >= kMaxYamlDepth) {
      refuse(mark, "nested too deeply", "at most " + std::to_string(kMaxYamlDepth) + " levels");
    }
    open.push_back({&add(kind, mark), false, {}});
  }

  std::shared_ptr<Document> document = std::make_shared<Document>();
  std::vector<Open> open;
};

YamlNode::YamlNode() = default;
YamlNode::YamlNode(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
YamlNode YamlNode::child(const Data* data) const {
  return YamlNode(std::shared_ptr<const Data>(data_, data));
}
const YamlNode::Data& YamlNode::data() const {
  assert(data_ != nullptr && "ask the node itself first: if (const YamlNode n = map[key])");
  return *data_;
}
bool YamlNode::isMap() const { return data().kind == Data::Kind::kMap; }
bool YamlNode::isSequence() const { return data().kind == Data::Kind::kSequence; }
bool YamlNode::isScalar() const { return data().isScalar(); }
bool YamlNode::isNull() const { return data().kind == Data::Kind::kNull; }
int YamlNode::line() const { return data().line; }
const std::string& YamlNode::file() const { return *data().file; }
std::string YamlNode::path() const { return data().path(); }
void YamlNode::fail(const std::string& problem, const std::string& expected) const {
  data().fail(problem, expected);
}

const YamlNode::Data& YamlNode::map() const {
  if (!isMap()) fail(data().state(), "a map (key: value)");
  return data();
}
const YamlNode::Data& YamlNode::sequence(const std::string& wanted) const {
  if (!isSequence()) fail(data().state(), wanted);
  return data();
}

void YamlNode::requireKeys(std::initializer_list<std::string_view> known) const {
  requireKeys(std::vector<std::string>(known.begin(), known.end()));
}

void YamlNode::requireKeys(const std::vector<std::string>& known) const {
  const Data& node = map();
  for (size_t i = 0; i < node.keys.size(); ++i) {
    if (std::find(known.begin(), known.end(), node.keys[i]) != known.end()) continue;
    const std::string meant = nearestWord(node.keys[i], known);
    const std::string where = node.path();
    throw InputError(*node.file, node.key_lines[i],
                     "unknown key " + quote(node.keys[i]) + (where.empty() ? "" : " in " + where),
                     meant.empty() ? listed(known) : "'" + meant + "'");
  }
}

YamlNode YamlNode::operator[](std::string_view key) const {
  const Data& node = map();
  const auto found = std::find(node.keys.begin(), node.keys.end(), key);
  if (found == node.keys.end()) return {};
  return child(node.children[found - node.keys.begin()]);
}

YamlNode YamlNode::at(std::string_view key) const {
  const YamlNode value = (*this)[key];
  if (!value) {
    const std::string where = path();
    fail((where.empty() ? "" : where + ": ") + "the key " + quote(std::string(key)) + " is missing",
         "'" + std::string(key) + ":' and its value");
  }
  return value;
}

std::vector<std::pair<std::string, YamlNode>> YamlNode::entries() const {
  const Data& node = map();
  std::vector<std::pair<std::string, YamlNode>> all;
  all.reserve(node.keys.size());
  for (size_t i = 0; i < node.keys.size(); ++i)
    all.emplace_back(node.keys[i], child(node.children[i]));
  return all;
}

std::vector<YamlNode> YamlNode::items() const {
  std::vector<YamlNode> all;
  for (const Data* item : sequence("a list").children) all.push_back(child(item));
  return all;
}

int YamlNode::size() const { return static_cast<int>(data().children.size()); }

std::string YamlNode::asString() const {
  if (!isScalar() || data().text.empty()) fail(data().state(), "text");
  return data().text;
}

double YamlNode::asDouble(double min, double max, std::string_view what) const {
  const std::string wanted = std::string(what) + rangeText(min, max);
  double number = 0.0;
  if (!isScalar() || !data().plain || !parseDecimal(data().text, number)) {
    fail(data().state(), wanted + (what == "number" ? "" : ", a number"));
  }
  if (number < min || number > max) fail(data().state(), wanted);
  return number;
}

double YamlNode::asPositive(std::string_view what, double max) const {
  const double number = asDouble(-kInfinity, max, what);
  if (number <= 0.0) fail(data().state(), std::string(what) + " above 0");
  return number;
}

int YamlNode::asInt(int min, int max, std::string_view what) const {
  int number = 0;
  if (!isScalar() || !data().plain || !parseWhole(data().text, number) || number < min ||
      number > max) {
    fail(data().state(), std::string(what) + rangeText(min, max));
  }
  return number;
}

bool YamlNode::asBool() const {
  const bool plain = isScalar() && data().plain;
  if (!plain || (data().text != "true" && data().text != "false")) {
    fail(data().state(), "true or false");
  }
  return data().text == "true";
}

Eigen::VectorXd YamlNode::asVec(int n, std::string_view what, double min, double max) const {
  const std::string wanted = std::to_string(n) + " " + std::string(what) + " in brackets";
  const Data& node = sequence(wanted);
  if (static_cast<int>(node.children.size()) != n) {
    fail(node.state() + " of " + std::to_string(node.children.size()), wanted);
  }
  Eigen::VectorXd numbers(n);
  for (int i = 0; i < n; ++i) numbers[i] = child(node.children[i]).asDouble(min, max);
  return numbers;
}

std::filesystem::path YamlNode::asPath() const {
  const std::filesystem::path named = asString();
  const std::filesystem::path folder = std::filesystem::path(file()).parent_path();
  return (folder / named).lexically_normal();
}

int YamlNode::indexIn(const std::vector<std::string>& names) const {
  if (!isScalar()) fail(data().state(), listed(names));
  const auto found = std::find(names.begin(), names.end(), data().text);
  if (found == names.end()) {
    const std::string meant = nearestWord(data().text, names);
    fail(data().state(), meant.empty() ? listed(names) : "'" + meant + "'");
  }
  return static_cast<int>(found - names.begin());
}

namespace {

// Of a line that could not be read and the one before it, the first that a tab indents; 0: none.
int tabBefore(const std::string& text, int line) {
  std::istringstream in(text);
  std::string read;
  for (int at = 1; at <= line && std::getline(in, read); ++at) {
    const size_t begin = std::min(read.find_first_not_of(" \t"), read.size());
    if (at + 1 >= line && read.find('\t') < begin) return at;
  }
  return 0;
}

}  // namespace

YamlNode parseYaml(const std::string& text, const std::string& name) {
  YamlNode::Builder builder(name);
  std::istringstream in(text);
  try {
    YAML::Parser parser(in);
    parser.HandleNextDocument(builder);
    if (builder.document->nodes.empty()) throw InputError(name, 0, "is empty", "YAML");
    const size_t nodes = builder.document->nodes.size();
    builder.open.clear();
    parser.HandleNextDocument(builder);
    if (builder.document->nodes.size() != nodes) {
      throw InputError(name, builder.document->nodes[nodes].line, "a second document",
                       "one document a file");
    }
  } catch (const YAML::Exception& error) {
    const int line = error.mark.is_null() ? 0 : error.mark.line + 1;
    if (const int tab = tabBefore(text, line)) {
      throw InputError(name, tab, "a tab before its text", "spaces: YAML indents by nothing else");
    }
    throw InputError(name, line, error.msg, "YAML");
  }
  const YamlNode::Data* root = &builder.document->nodes.front();
  return YamlNode(std::shared_ptr<const YamlNode::Data>(builder.document, root));
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
