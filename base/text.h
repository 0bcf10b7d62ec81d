/// Small things done with text. None depends on the locale; letters are those of ASCII.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace amble {

inline bool isDigit(char c) { return c >= '0' && c <= '9'; }
inline bool isLetter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
inline char lowerCase(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
std::string lowerCase(std::string_view text);
/// Whether two words are the same but for the case of their letters.
bool sameWord(std::string_view a, std::string_view b);

/// Blank, tab, line end, vertical tab or form feed.
inline bool isSpace(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f';
}
/// Without the space at both ends.
std::string_view trimmed(std::string_view text);
/// What stands before and behind the first `separator`; none where there is no such.
std::optional<std::pair<std::string_view, std::string_view>> splitAt(std::string_view text,
                                                                     std::string_view separator);
/// The parts one after another with `between` between them, and `last` before the last of them.
std::string joined(const std::vector<std::string>& parts, std::string_view between = ", ");
std::string joined(const std::vector<std::string>& parts, std::string_view between,
                   std::string_view last);
/// "1 walk", "2 walks", "0 walks".
std::string counted(long long count, std::string_view thing);
/// Control characters as blanks: a message is one line, and what it quotes may hold anything.
std::string withoutControls(std::string text);
/// In quotes, and cut where it is long: what a file holds may be, a message is one line.
std::string quotedShort(std::string_view text);
/// `%20` and its like as the bytes that they stand for, as in the addresses of files that a glTF or
/// Collada file names (RFC 3986, 2.1); what is none of them stays.
std::string withoutPercents(std::string_view text);
/// Bytes of the character that `text` begins with, in UTF-8 and such as XML may hold: no control
/// character but tab and line ends; 0: none such.
size_t characterLength(std::string_view text);
/// `text` as UTF-8 that XML may hold: a byte that begins no such character becomes U+FFFD, and so
/// do control characters other than tab and line end.
std::string utf8Text(std::string_view text);

/// Decimal, with `digits` of them behind the point, none of them left out: 1.50. Never "-0.00".
/// @pre value is finite, digits 0 to 17
std::string fixedNumber(double value, int digits);
/// Decimal, with at most so many digits behind the point and no zeros at the end: 1.5. "0" for what
/// rounds to it. @pre as above
std::string plainNumber(double value, int most_digits);
/// With so many digits in all, as printf's %g has them: 1234, 0.01234, 1.234e+06.
std::string shortNumber(double value, int digits = 4);
/// The whole of `text` as a number: decimal, finite, with or without a sign before it; else none.
std::optional<double> numberOf(std::string_view text);
std::optional<long long> wholeNumberOf(std::string_view text);

}  // namespace amble
