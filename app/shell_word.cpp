#include "app/shell_word.h"

#include <algorithm>

#include "base/text.h"

namespace amble {

std::string shellWord(std::string_view text) {
  constexpr std::string_view kPlain = "_-./,:=@%+";
  const auto plain = [&](char c) {
    return isLetter(c) || isDigit(c) || kPlain.find(c) != std::string_view::npos;
  };
  if (!text.empty() && std::all_of(text.begin(), text.end(), plain)) return std::string(text);
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

}  // namespace amble
