#include "base/yaml_writer.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "base/text.h"

namespace amble {
namespace {

// Characters that are escaped though they are none of control: they break lines, mark bytes or are
// not seen (YAML 1.1, 4.1).
constexpr std::array<std::pair<std::string_view, std::string_view>, 4> kUnseen = {
    {{"\u2028", "\\u2028"}, {"\u2029", "\\u2029"}, {"\uFEFF", "\\ufeff"}, {"\u00A0", "\\xa0"}}};

// Bytes of the character that the text begins with, where it can stand as it is; else 0.
size_t printedLength(std::string_view text) {
  if (static_cast<unsigned char>(text[0]) < 0x20) return 0;
  const auto begins = [&](const auto& unseen) { return text.starts_with(unseen.first); };
  return std::any_of(kUnseen.begin(), kUnseen.end(), begins) ? 0 : characterLength(text);
}

std::string hexEscape(unsigned char byte) {
  constexpr char kDigits[] = "0123456789abcdef";
  return {'\\', 'x', kDigits[byte >> 4], kDigits[byte & 15]};
}

// In place of a character that cannot stand as it is; it leaves the text.
std::string takeEscaped(std::string_view& text) {
  for (const auto& [character, escaped] : kUnseen) {
    if (!text.starts_with(character)) continue;
    text.remove_prefix(character.size());
    return std::string(escaped);
  }
  const auto first = static_cast<unsigned char>(text[0]);
  const auto second = static_cast<unsigned char>(text.size() > 1 ? text[1] : '\0');
  text.remove_prefix(1);
  constexpr std::string_view kNamed = "\nn\tt\rr\bb";  // each before its letter
  for (size_t i = 0; i < kNamed.size(); i += 2) {
    if (static_cast<unsigned char>(kNamed[i]) == first) return {'\\', kNamed[i + 1]};
  }
  if (first < 0x80) return hexEscape(first);
  if (first == 0xC2 && second >= 0x80 && second < 0xA0) {  // controls beyond ASCII
    text.remove_prefix(1);
    return hexEscape(second);
  }
  return "\uFFFD";  // no UTF-8
}

std::string quotedText(std::string_view text) {
  std::string quoted = "\"";
  while (!text.empty()) {
    const size_t length = printedLength(text);
    if (length == 0) {
      quoted += takeEscaped(text);
      continue;
    }
    if (text[0] == '"' || text[0] == '\\') quoted += '\\';
    quoted += text.substr(0, length);
    text.remove_prefix(length);
  }
  return quoted + '"';
}

// Whether a reader of YAML 1.1 or 1.2 may take the text for a number, a time or a truth value.
bool looksLikeAValue(std::string_view text) {
  constexpr std::array<std::string_view, 11> kWords = {"~",  "null", "true", "false", "yes", "no",
                                                       "on", "off",  "y",    "n",     "<<"};
  const std::string lower = lowerCase(text);
  if (std::find(kWords.begin(), kWords.end(), lower) != kWords.end()) return true;
  constexpr std::string_view kOfNumbers = "0123456789abcdefox_.:+-tz ";
  if (lower == ".inf" || lower == "-.inf" || lower == "+.inf" || lower == ".nan") return true;
  return (isDigit(lower[0]) || lower[0] == '.' || lower[0] == '+' || lower[0] == '-') &&
         std::any_of(lower.begin(), lower.end(), isDigit) &&
         lower.find_first_not_of(kOfNumbers) == std::string::npos;
}

// Whether the text may stand without quotes.
bool isPlain(std::string_view text, bool in_flow) {
  constexpr std::string_view kIndicators = " ,:[]{}#&*!|>'\"%@`?=";
  const auto has = [&](std::string_view part) { return text.find(part) != std::string_view::npos; };
  if (text.empty() || kIndicators.find(text.front()) != std::string_view::npos) return false;
  if (text == "-" || text.starts_with("- ") || text.back() == ' ' || text.back() == ':')
    return false;
  if (has(": ") || has(" #") || text.starts_with("---") || text.starts_with("...")) return false;
  if (in_flow && text.find_first_of(",?[]{}") != std::string_view::npos) return false;
  if (looksLikeAValue(text)) return false;
  while (!text.empty()) {
    const size_t length = printedLength(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

}  // namespace

void YamlWriter::newLine(int indent) {
  out_ << '\n';
  for (int i = 0; i < indent; ++i) out_ << ' ';
}

// What stands before an entry of the innermost level: its line, or a comma.
void YamlWriter::startEntry() {
  Level& level = levels_.back();
  if (level.is_flow) {
    if (!level.is_empty) out_ << ", ";
  } else if (!level.is_empty || !level.is_inline) {
    newLine(level.indent);
  }
  level.is_empty = false;
}

// What stands before a scalar, or before a map or a list on one line.
void YamlWriter::startScalar() {
  if (levels_.empty()) return;
  Level& level = levels_.back();
  if (level.is_map) {
    assert(level.has_key);
    level.has_key = false;
    out_ << ' ';
    return;
  }
  startEntry();
  if (!level.is_flow) out_ << "- ";
}

YamlWriter& YamlWriter::begin(bool is_map, Style style) {
  if (style == kFlow || inFlow()) {
    startScalar();
    levels_.push_back({is_map, true, 0, true});
    out_ << (is_map ? '{' : '[');
  } else if (levels_.empty()) {
    levels_.push_back({is_map, false, 0, true});
  } else {
    Level& above = levels_.back();
    const int indent = above.indent + 2;
    const bool behind_dash = !above.is_map;
    if (behind_dash) startScalar();
    above.has_key = false;
    levels_.push_back({is_map, false, indent, behind_dash});
  }
  return *this;
}

YamlWriter& YamlWriter::end() {
  const Level level = levels_.back();
  assert(!level.has_key);
  if (level.is_flow) {
    out_ << (level.is_map ? '}' : ']');
  } else if (level.is_empty) {
    if (!level.is_inline) newLine(level.indent);
    out_ << (level.is_map ? "{}" : "[]");
  }
  levels_.pop_back();
  return *this;
}

YamlWriter& YamlWriter::key(std::string_view name) {
  assert(levels_.back().is_map && !levels_.back().has_key);
  startEntry();
  out_ << (isPlain(name, inFlow()) ? std::string(name) : quotedText(name)) << ':';
  levels_.back().has_key = true;
  return *this;
}

YamlWriter& YamlWriter::plain(std::string_view scalar) {
  startScalar();
  out_ << scalar;
  return *this;
}

YamlWriter& YamlWriter::text(std::string_view value) {
  return isPlain(value, inFlow()) ? plain(value) : quoted(value);
}

YamlWriter& YamlWriter::quoted(std::string_view value) { return plain(quotedText(value)); }

}  // namespace amble
