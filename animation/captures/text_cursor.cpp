#include "animation/captures/text_cursor.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/error.h"

namespace amble {
namespace {

constexpr size_t kMaxQuoted = 40;  // longest piece of a file that a message shows [bytes]

bool isBlank(char c) { return c != '\n' && isSpace(c); }

/// A piece of a file as a message may show it: its control bytes and what is no ASCII are dots.
std::string quoted(std::string_view text) {
  std::string shown(text.substr(0, kMaxQuoted));
  for (char& c : shown) {
    if (c < ' ' || c == '\x7F') c = '.';
  }
  return "'" + shown + (text.size() > kMaxQuoted ? "..." : "") + "'";
}

// Whole numbers up to 2^53 and powers of ten up to 10^22 are doubles without rounding, so that
// their product or quotient is the nearest double (Clinger 1990).
constexpr int kMostDigits = 19;  // that a uint64_t holds, whatever they are
constexpr uint64_t kMostExact = uint64_t{1} << 53;
constexpr std::array<double, 23> kPowers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                            1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                            1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

/// The digits from `at` on, behind those that are known; where they end.
const char* addDigits(const char* at, const char* end, uint64_t& digits) {
  for (; at != end && isDigit(*at); ++at) digits = 10 * digits + static_cast<uint64_t>(*at - '0');
  return at;
}

/// An exponent of up to three digits behind its e; null for any other.
const char* parseExponent(const char* at, const char* end, int& exponent) {
  const bool negative = at != end && *at == '-';
  if (at != end && (*at == '-' || *at == '+')) ++at;
  uint64_t digits = 0;
  const char* const after = addDigits(at, end - at > 3 ? at + 3 : end, digits);
  if (after == at) return nullptr;
  exponent += (negative ? -1 : 1) * static_cast<int>(digits);
  return after;
}

/// A number as captures have them, `-12.345678` or `1.2e-05` with a blank behind it, and where it
/// ends; null for any other, and for one that takes more than an exact step.
const char* parsePlain(const char* at, const char* end, double& value) {
  const bool negative = at != end && *at == '-';
  at += negative;
  // As many digits as are safe at once; a longer number has others behind them.
  const char* const begin = at;
  const char* const last = end - at > kMostDigits ? at + kMostDigits : end;
  uint64_t digits = 0;
  int exponent = 0;
  at = addDigits(at, last, digits);
  ptrdiff_t count = at - begin;
  if (at != last && *at == '.') {
    const char* const point = at++;
    at = addDigits(at, last, digits);
    exponent = static_cast<int>(point + 1 - at);
    count -= exponent;
  }
  if (count == 0 || digits > kMostExact || at == end) return nullptr;
  if ((*at | 0x20) == 'e') at = parseExponent(at + 1, end, exponent);
  if (at == nullptr || at == end || !isSpace(*at)) return nullptr;
  if (exponent < -22 || exponent > 22) return nullptr;
  value = static_cast<double>(digits);
  value = exponent < 0 ? value / kPowers[-exponent] : value * kPowers[exponent];
  if (negative) value = -value;
  return at;
}

}  // namespace

TextCursor::TextCursor(std::string_view text, std::string name)
    : at_(text.data()),
      end_(text.data() + text.size()),
      size_(text.size()),
      name_(std::move(name)) {
  if (text.starts_with("\xEF\xBB\xBF")) at_ += 3;
}

void TextCursor::skipBlanks() {
  while (at_ != end_ && isBlank(*at_)) ++at_;
}

void TextCursor::skipSpace() {
  for (; at_ != end_ && isSpace(*at_); ++at_) line_ += *at_ == '\n';
}

std::string_view TextCursor::peekWord() {
  skipSpace();
  const char* end = at_;
  while (end != end_ && !isSpace(*end)) ++end;
  return {at_, static_cast<size_t>(end - at_)};
}

std::string_view TextCursor::word() {
  const std::string_view word = peekWord();
  if (word.empty()) fail("the file ends here", "more");
  at_ += word.size();
  return word;
}

std::string_view TextCursor::restOfLine() {
  const char* begin = at_;
  while (at_ != end_ && *at_ != '\n') ++at_;
  return trimmed({begin, static_cast<size_t>(at_ - begin)});
}

void TextCursor::expectWord(std::string_view expected) {
  skipSpace();
  if (at_ == end_) fail("the file ends here", std::string(expected));
  const std::string_view found = word();
  if (!sameWord(found, expected)) failAt(found, std::string(expected));
}

void TextCursor::expectLabel(std::string_view label) {
  skipSpace();
  const std::string_view rest(at_, remaining());
  const bool same = rest.size() >= label.size() && sameWord(rest.substr(0, label.size()), label);
  if (same) {
    at_ += label.size();
    skipBlanks();
    if (at_ != end_ && *at_ == ':') {
      ++at_;
      return;
    }
  }
  fail("no '" + std::string(label) + ":'", "it here");
}

double TextCursor::parseNumber(double max) {
  double plain = 0.0;
  const char* const after = parsePlain(at_, end_, plain);
  if (after != nullptr && std::abs(plain) <= max) {
    at_ = after;
    return plain;
  }
  return parseAnyNumber(max);
}

double TextCursor::parseAnyNumber(double max) {
  const char* begin = at_;
  // from_chars knows no plus sign.
  const bool plus = *at_ == '+' && remaining() > 1 && at_[1] != '-';
  const char* digits = plus ? at_ + 1 : at_;
  double value = 0.0;
  const std::from_chars_result result = std::from_chars(digits, end_, value);
  at_ = result.ptr;
  if (result.ec == std::errc() && (at_ == end_ || isSpace(*at_)) && std::abs(value) <= max)
    return value;
  while (at_ != end_ && !isSpace(*at_)) ++at_;
  const std::string_view text(begin, static_cast<size_t>(at_ - begin));
  // Too small for a double is zero; too large is not.
  const bool tiny = result.ec == std::errc::result_out_of_range && result.ptr == at_ &&
                    (text.find("e-") != text.npos || text.find("E-") != text.npos);
  if (tiny) return 0.0;
  if (result.ec == std::errc() && result.ptr == at_ && std::isfinite(value)) {
    failAt(text, "a number of at most 1e" + std::to_string(static_cast<int>(std::log10(max))) +
                     " in size");
  }
  failAt(text, "a finite number");
}

double TextCursor::number(double max) {
  skipSpace();
  if (at_ == end_) fail("the file ends here", "a number");
  return parseNumber(max);
}

bool TextCursor::numberInLine(double max, double& value) {
  skipBlanks();
  if (at_ == end_ || *at_ == '\n') return false;
  value = parseNumber(max);
  return true;
}

int TextCursor::count() {
  const std::string_view text = word();
  int value = 0;
  const std::from_chars_result result =
      std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size() || value < 0) {
    failAt(text, "a whole number, 0 to 2147483647");
  }
  return value;
}

bool TextCursor::atLineEnd() {
  skipBlanks();
  return at_ == end_ || *at_ == '\n';
}

void TextCursor::expectLineEnd() {
  if (!atLineEnd()) failAt(word(), "the end of the line");
}

bool TextCursor::skipBlankLines() {
  skipSpace();
  return at_ != end_;
}

void TextCursor::fail(const std::string& problem, const std::string& expected) const {
  throw InputError(name_, line_, problem, expected);
}

void TextCursor::failAt(std::string_view word, const std::string& expected) const {
  fail(quoted(word), expected);
}

}  // namespace amble
