/// OMPL logs to the console: its words are not ours.
#pragma once

namespace amble {

/// Silence, from construction on until it is destroyed.
class QuietOmpl {
 public:
  QuietOmpl();
  ~QuietOmpl();
  QuietOmpl(const QuietOmpl&) = delete;
  QuietOmpl& operator=(const QuietOmpl&) = delete;

 private:
  int level_;  // of OMPL's log before
};

}  // namespace amble
