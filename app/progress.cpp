#include "app/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "app/say.h"

namespace amble {
namespace {

constexpr auto kRedraw = std::chrono::milliseconds(100);  // faster is not seen
constexpr auto kNextLine = std::chrono::seconds(5);       // a log wants few lines
constexpr int kWidth = 24;                                // of the bar [characters]

bool isTerminal() {
  const char* kind = std::getenv("TERM");
  return ::isatty(STDERR_FILENO) != 0 && kind != nullptr && std::string(kind) != "dumb";
}

bool wantsColour() {
  const char* no = std::getenv("NO_COLOR");  // https://no-color.org: set and not empty
  return no == nullptr || *no == '\0';
}

}  // namespace

Progress::Progress(bool wanted)
    : wanted_(wanted),
      terminal_(isTerminal()),
      colour_(terminal_ && wantsColour()),
      last_(Clock::now()) {}

Progress::~Progress() { clear(); }

void Progress::update(const std::string& stage, double done) {
  if (!wanted_) return;
  const std::lock_guard lock(mutex_);
  const auto now = Clock::now();
  if (now - last_ < (terminal_ ? Clock::duration(kRedraw) : Clock::duration(kNextLine))) return;
  last_ = now;
  draw(stage, done);
}

void Progress::draw(const std::string& stage, double done) {
  if (!terminal_) {
    const std::string share = done < 0.0 ? "" : fmt::format(" {:.0f} %", 100.0 * done);
    say(stderr, "{}{}\n", stage, share);
    return;
  }
  const int filled = static_cast<int>(std::clamp(done, 0.0, 1.0) * kWidth);
  const std::string bar = std::string(filled, '=') + std::string(kWidth - filled, ' ');
  fmt::print(stderr, "\r{}[{}]{} {:<40}", colour_ ? "\033[36m" : "", bar, colour_ ? "\033[0m" : "",
             printable(stage));
  std::fflush(stderr);
  drawn_ = true;
}

void Progress::clear() {
  const std::lock_guard lock(mutex_);
  if (drawn_) {
    fmt::print(stderr, "\r\033[K");
    std::fflush(stderr);  // before what is printed to standard output
  }
  drawn_ = false;
}

}  // namespace amble
