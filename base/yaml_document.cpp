#include "base/yaml_document.h"

#include <yaml.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <sstream>
#include <unordered_map>

#include "base/error.h"
#include "base/strict_yaml.h"
#include "base/text.h"

namespace amble {
namespace {

constexpr char kSecondDocument[] = "a second document";
constexpr char kOneDocument[] = "one document a file";

// Freed whatever happens.
struct YamlParser {
  explicit YamlParser(const std::string& text) {
    if (yaml_parser_initialize(&it) == 0) throw std::bad_alloc();
    const auto* bytes = reinterpret_cast<const unsigned char*>(text.data());
    yaml_parser_set_input_string(&it, bytes, text.size());
  }
  YamlParser(const YamlParser&) = delete;
  YamlParser& operator=(const YamlParser&) = delete;
  ~YamlParser() { yaml_parser_delete(&it); }

  yaml_parser_t it;
};

struct YamlEvent {
  YamlEvent() = default;
  YamlEvent(const YamlEvent&) = delete;
  YamlEvent& operator=(const YamlEvent&) = delete;
  ~YamlEvent() { yaml_event_delete(&it); }

  yaml_event_t it{};
};

int lineOf(const yaml_mark_t& mark) { return static_cast<int>(mark.line) + 1; }

bool isNullWord(std::string_view text) {
  return text.empty() || text == "~" || text == "null" || text == "Null" || text == "NULL";
}

// Makes a document of the parser's events, and refuses there what no reader of ours wants.
class DocumentMaker {
 public:
  explicit DocumentMaker(const std::string& file)
      : document_(std::make_shared<YamlDocument>(file)) {}

  void take(const yaml_event_t& event) {
    const yaml_mark_t& mark = event.start_mark;
    switch (event.type) {
      case YAML_DOCUMENT_START_EVENT:
        ++documents_;
        break;
      case YAML_ALIAS_EVENT:
        refuseSecond(mark);
        refuse(mark, "an alias (*name)", "the value itself");
      case YAML_SCALAR_EVENT:
        refuseSecond(mark);
        refuseTag(mark, event.data.scalar.tag);
        takeScalar(event);
        break;
      case YAML_SEQUENCE_START_EVENT:
        refuseSecond(mark);
        refuseTag(mark, event.data.sequence_start.tag);
        begin(YamlKind::kSequence, mark);
        break;
      case YAML_MAPPING_START_EVENT:
        refuseSecond(mark);
        refuseTag(mark, event.data.mapping_start.tag);
        begin(YamlKind::kMap, mark);
        break;
      case YAML_SEQUENCE_END_EVENT:
      case YAML_MAPPING_END_EVENT:
        end();
        break;
      default:
        break;
    }
  }

  bool hasDocument() const { return documents_ > 0; }

  std::shared_ptr<const YamlDocument> finish() {
    if (document_->values.empty()) throw InputError(document_->file, 0, "is empty", "YAML");
    return document_;
  }

 private:
  struct Open {
    size_t value;
    bool has_key = false;
    std::string_view key;
    int key_line = 0;
    std::unordered_map<std::string_view, int>
        lines_of_keys;  // looked up only, never walked through
  };

  [[noreturn]] void refuse(const yaml_mark_t& mark, const std::string& problem,
                           const std::string& expected) const {
    throw InputError(document_->file, lineOf(mark), problem, expected);
  }
  void refuseSecond(const yaml_mark_t& mark) const {
    if (documents_ > 1) refuse(mark, kSecondDocument, kOneDocument);
  }
  void refuseTag(const yaml_mark_t& mark, const yaml_char_t* tag) const {
    if (tag == nullptr) return;
    refuse(mark, "a tag (" + quotedShort(reinterpret_cast<const char*>(tag)) + ")",
           "a value without a tag");
  }

  bool wantsKey() const {
    return !open_.empty() && !open_.back().has_key &&
           document_->values[open_.back().value].kind == YamlKind::kMap;
  }

  std::string_view keep(const char* text, size_t size) {
    if (size == 0) return {};
    void* kept = document_->texts.allocate(size, 1);
    std::memcpy(kept, text, size);
    return {static_cast<const char*>(kept), size};
  }

  void takeScalar(const yaml_event_t& event) {
    const auto& scalar = event.data.scalar;
    const yaml_mark_t& mark = event.start_mark;
    const std::string_view text(reinterpret_cast<const char*>(scalar.value), scalar.length);
    const bool plain = scalar.style == YAML_PLAIN_SCALAR_STYLE;
    const bool null = plain && isNullWord(text);
    if (wantsKey()) {
      if (null) refuse(mark, "an empty key", "a name before the colon");
      return takeKey(mark, text);
    }
    YamlValue& value = add(null ? YamlKind::kNull : YamlKind::kScalar, mark);
    if (null) return;
    value.plain = plain;
    value.text = keep(text.data(), text.size());
  }

  void takeKey(const yaml_mark_t& mark, std::string_view text) {
    Open& map = open_.back();
    map.key = keep(text.data(), text.size());
    map.key_line = lineOf(mark);
    const auto [place, is_new] = map.lines_of_keys.emplace(map.key, map.key_line);
    if (!is_new) {
      refuse(mark, "the key " + quotedShort(map.key) + " is given twice",
             "it once (it is on line " + std::to_string(place->second) + " too)");
    }
    map.has_key = true;
  }

  YamlValue& add(YamlKind kind, const yaml_mark_t& mark) {
    std::vector<YamlValue>& values = document_->values;
    if (values.size() >= kMaxYamlValues) {
      refuse(mark, "too many values", "at most " + std::to_string(kMaxYamlValues));
    }
    YamlValue& value = values.emplace_back();
    value.kind = kind;
    value.line = lineOf(mark);
    if (!open_.empty()) {
      Open& above = open_.back();
      value.up = static_cast<std::uint32_t>(values.size() - 1 - above.value);
      value.index = values[above.value].size++;
      value.key = above.key;
      value.key_line = above.key_line;
      above.has_key = false;
    }
    return value;
  }

  void begin(YamlKind kind, const yaml_mark_t& mark) {
    if (wantsKey()) refuse(mark, "a key that is a list or a map", "a name before the colon");
    if (static_cast<int>(open_.size()) >= kMaxYamlDepth) {
      refuse(mark, "nested too deeply", "at most " + std::to_string(kMaxYamlDepth) + " levels");
    }
    add(kind, mark);
    open_.push_back({document_->values.size() - 1, false, {}, 0, {}});
  }

  void end() {
    const size_t value = open_.back().value;
    document_->values[value].span = static_cast<std::uint32_t>(document_->values.size() - value);
    open_.pop_back();
  }

  std::shared_ptr<YamlDocument> document_;
  std::vector<Open> open_;
  int documents_ = 0;
};

// Of a line that could not be read and the one before it, the first that a tab indents, whether or
// not behind a dash; 0: none.
int tabBefore(const std::string& text, int line) {
  std::istringstream in(text);
  std::string read;
  for (int at = 1; at <= line && std::getline(in, read); ++at) {
    const size_t begin = std::min(read.find_first_not_of(" \t-"), read.size());
    if (at + 1 >= line && read.find('\t') < begin) return at;
  }
  return 0;
}

// What libyaml says: "did not find expected ',' or ']' while parsing a flow sequence". Where a
// document is whole, what follows it is another.
[[noreturn]] void failAsParser(const yaml_parser_t& parser, bool has_document,
                               const std::string& text, const std::string& name) {
  if (parser.error == YAML_MEMORY_ERROR) throw std::bad_alloc();
  const std::string problem = parser.problem == nullptr ? "cannot be read" : parser.problem;
  if (parser.error == YAML_READER_ERROR) {
    const auto end = text.begin() + std::min(parser.problem_offset, text.size());
    const auto line = 1 + std::count(text.begin(), end, '\n');
    throw InputError(name, static_cast<int>(line), problem, "YAML, in UTF-8");
  }
  const int line = lineOf(parser.problem_mark);
  if (has_document && problem == "did not find expected <document start>") {
    throw InputError(name, line, kSecondDocument, kOneDocument);
  }
  if (const int tab = tabBefore(text, line)) {
    throw InputError(name, tab, "a tab before its text", "spaces: YAML indents by nothing else");
  }
  if (parser.context == nullptr) throw InputError(name, line, problem, "YAML");
  const int from = lineOf(parser.context_mark);
  const std::string begun = from == line ? "" : " that begins on line " + std::to_string(from);
  throw InputError(name, line, problem + " " + parser.context + begun, "YAML");
}

}  // namespace

std::shared_ptr<const YamlDocument> parseYamlDocument(const std::string& text,
                                                      const std::string& name) {
  YamlParser parser(text);
  DocumentMaker maker(name);
  for (bool ended = false; !ended;) {
    YamlEvent event;
    if (yaml_parser_parse(&parser.it, &event.it) == 0) {
      failAsParser(parser.it, maker.hasDocument(), text, name);
    }
    maker.take(event.it);
    ended = event.it.type == YAML_STREAM_END_EVENT;
  }
  return maker.finish();
}

}  // namespace amble
