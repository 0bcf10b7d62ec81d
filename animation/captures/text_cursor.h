/// A cursor over a capture file's text: words, labels and numbers, with the line for messages.
///
/// Lines end in LF, CRLF or CR LF mixed; a UTF-8 byte order mark at the begin is passed over. Words
/// are parted by blanks, tabs and line ends. Numbers never depend on the locale.
#pragma once

#include <string>
#include <string_view>

#include "base/text.h"

namespace amble {

class TextCursor {
 public:
  /// `text` must outlive the cursor; `name` stands for the file in messages.
  TextCursor(std::string_view text, std::string name);

  const std::string& name() const { return name_; }
  int line() const { return line_; }     ///< from 1
  size_t size() const { return size_; }  ///< of the whole text [bytes]
  size_t remaining() const { return static_cast<size_t>(end_ - at_); }  ///< [bytes]

  /// The next word on this line or a later one. @throws InputError at the end of the file.
  std::string_view word();
  /// The word that word() would read, without going on; empty at the end of the file.
  std::string_view peekWord();
  /// What is left of this line, trimmed.
  std::string_view restOfLine();
  /// The next word has to be this one, whatever its case. @throws InputError
  void expectWord(std::string_view expected);
  /// The next thing has to be `label:`, with or without blanks before the colon. @throws InputError
  void expectLabel(std::string_view label);
  /// A number on this line or a later one. @throws InputError unless it is finite and at most `max`
  /// in size.
  double number(double max);
  /// A whole number >= 0. @throws InputError
  int count();
  /// The next number of this line; false at the line's end. @throws InputError as number().
  bool numberInLine(double max, double& value);
  /// Whether nothing but blanks is left of this line.
  bool atLineEnd();
  void expectLineEnd();
  /// Goes to the next line that is not blank; false at the end of the file.
  bool skipBlankLines();

  [[noreturn]] void fail(const std::string& problem, const std::string& expected) const;
  /// The same about a word that was just read.
  [[noreturn]] void failAt(std::string_view word, const std::string& expected) const;

 private:
  void skipBlanks();
  void skipSpace();
  double parseNumber(double max);
  double parseAnyNumber(double max);

  const char* at_;
  const char* end_;
  size_t size_;
  int line_ = 1;
  std::string name_;
};

}  // namespace amble
