#include "animation/analysis/classify_clip.h"

#include <algorithm>
#include <cassert>

namespace amble {
namespace {

/// The sub-states of appendix C, and a foot for hops.
enum class State {
  kUnknownNone,
  kUnknownLeft,
  kUnknownRight,
  kUnknownBoth,
  kWalkLeft,
  kWalkRight,
  kWalkBoth,
  kJumpNone,
  kJumpBoth,
  kJumpLeft,
  kJumpRight,
  kRunLeft,
  kRunLeftNone,
  kRunRight,
  kRunRightNone,
};

MotionType typeOf(State state) {
  if (state <= State::kUnknownBoth) return MotionType::kUnknown;
  if (state <= State::kWalkBoth) return MotionType::kWalk;
  return state <= State::kJumpRight ? MotionType::kJump : MotionType::kRun;
}

State unknown(Support token) {
  switch (token) {
    case Support::kLeft:
      return State::kUnknownLeft;
    case Support::kRight:
      return State::kUnknownRight;
    case Support::kBoth:
      return State::kUnknownBoth;
    case Support::kNone:
      break;
  }
  return State::kUnknownNone;
}

/// The machine's left foot for either foot, so that each rule is written once.
struct Feet {
  Support own, other;
  State walk_own, walk_other, run_own, run_own_none, run_other, jump_own;
};

constexpr Feet kOnLeft = {Support::kLeft,  Support::kRight,     State::kWalkLeft, State::kWalkRight,
                          State::kRunLeft, State::kRunLeftNone, State::kRunRight, State::kJumpLeft};
constexpr Feet kOnRight = {Support::kRight,  Support::kLeft,   State::kWalkRight,
                           State::kWalkLeft, State::kRunRight, State::kRunRightNone,
                           State::kRunLeft,  State::kJumpRight};

// Figure C.1.
State fromUnknown(State state, Support token) {
  switch (state) {
    case State::kUnknownNone:
      if (token == Support::kBoth) return State::kJumpBoth;
      return token == Support::kLeft ? State::kRunLeft : State::kRunRight;
    case State::kUnknownBoth:
      if (token == Support::kNone) return State::kJumpNone;
      return token == Support::kLeft ? State::kWalkLeft : State::kWalkRight;
    default:
      break;
  }
  const Feet& feet = state == State::kUnknownLeft ? kOnLeft : kOnRight;
  if (token == Support::kBoth) return State::kWalkBoth;
  return token == Support::kNone ? feet.run_own_none : feet.walk_other;
}

// Figure C.2.
State fromWalk(Support token) {
  switch (token) {
    case Support::kLeft:
      return State::kWalkLeft;
    case Support::kRight:
      return State::kWalkRight;
    case Support::kBoth:
      return State::kWalkBoth;
    case Support::kNone:
      break;
  }
  return State::kUnknownNone;
}

// Figure C.3; `from` is what stood before the flight.
State fromJump(State state, Support from, Support token) {
  if (state == State::kJumpNone) {
    if (token != from) return unknown(token);
    if (token == Support::kBoth) return State::kJumpBoth;
    return token == Support::kLeft ? State::kJumpLeft : State::kJumpRight;
  }
  return token == Support::kNone ? State::kJumpNone : unknown(token);
}

// Figure C.4: the same foot again is a hop.
State fromRun(State state, Support token) {
  if (token == Support::kBoth) return State::kUnknownBoth;
  for (const Feet& feet : {kOnLeft, kOnRight}) {
    if (state == feet.run_own) return token == Support::kNone ? feet.run_own_none : feet.run_other;
    if (state == feet.run_own_none) return token == feet.own ? feet.jump_own : feet.run_other;
  }
  return unknown(token);
}

/// A stretch of equal tokens.
struct Run {
  Support token;
  int first, last;
};

std::vector<Run> runsOf(std::span<const Support> tokens) {
  std::vector<Run> runs;
  for (int i = 0; i < static_cast<int>(tokens.size()); ++i) {
    if (runs.empty() || runs.back().token != tokens[i]) runs.push_back({tokens[i], i, i});
    runs.back().last = i;
  }
  return runs;
}

/// Runs the machine and writes the types of frames on exit of each top-level state.
class Machine {
 public:
  Machine(Support first, int frames) : state_(unknown(first)), types_(frames) {}

  void enter(const Run& before, const Run& run) {
    const State next = step(before.token, run.token);
    const MotionType from = typeOf(state_), to = typeOf(next);
    if (from != to) {
      // Unknown frames are of the type that follows (exit action 1); a run whose look-ahead says
      // hop was one only up to that foot's landing.
      const bool hop = from == MotionType::kRun && to == MotionType::kJump;
      const int exit = hop ? stood_since_ : run.first;
      mark(exit, from == MotionType::kUnknown ? to : from);
      entry_ = exit;
    }
    if (run.token != Support::kNone) stood_since_ = run.first;
    state_ = next;
  }

  std::vector<MotionType> end() {
    const bool stands = state_ == State::kUnknownBoth;
    mark(static_cast<int>(types_.size()), stands ? MotionType::kStand : typeOf(state_));
    return std::move(types_);
  }

 private:
  State step(Support before, Support token) {
    if (token == Support::kNone) stood_ = before;
    switch (typeOf(state_)) {
      case MotionType::kWalk:
        return fromWalk(token);
      case MotionType::kRun:
        return fromRun(state_, token);
      case MotionType::kJump:
        return fromJump(state_, stood_, token);
      default:
        return fromUnknown(state_, token);
    }
  }

  void mark(int end, MotionType type) {
    for (int i = entry_; i < end; ++i) types_[i] = type;
  }

  State state_;
  int entry_ = 0;                   // frame at which the top-level state was entered
  int stood_since_ = 0;             // first frame of the last token but N
  Support stood_ = Support::kNone;  // token before the last N
  std::vector<MotionType> types_;
};

void summarise(ClipClass& result) {
  const int frames = static_cast<int>(result.frames.size());
  std::array<int, kMotionTypes> count = {};
  result.segments.clear();
  for (int i = 0; i < frames; ++i) {
    const MotionType type = result.frames[i];
    if (result.segments.empty() || result.segments.back().type != type)
      result.segments.push_back({type, i, i});
    result.segments.back().last = i;
    ++count[static_cast<size_t>(type)];
  }
  for (size_t i = 0; frames > 0 && i < count.size(); ++i) {
    result.share[i] = static_cast<double>(count[i]) / frames;
  }
  if (result.segments.size() == 1) result.type = result.segments[0].type;
  if (result.segments.size() > 1) result.type = MotionType::kOther;
}

bool single(Support token) { return token == Support::kLeft || token == Support::kRight; }

void fill(std::vector<Support>& tokens, const Run& run, Support token) {
  std::fill(tokens.begin() + run.first, tokens.begin() + run.last + 1, token);
}

/// Feet that leave or land almost together: B L N is B N, and N L B is N B.
void joinFeet(std::vector<Support>& tokens, double longest) {
  const std::vector<Run> runs = runsOf(tokens);
  for (size_t i = 1; i + 1 < runs.size(); ++i) {
    const bool brief = runs[i].last - runs[i].first + 1 < longest;
    const Support before = runs[i - 1].token, after = runs[i + 1].token;
    const bool leap = (before == Support::kBoth && after == Support::kNone) ||
                      (before == Support::kNone && after == Support::kBoth);
    if (brief && single(runs[i].token) && leap) fill(tokens, runs[i], Support::kBoth);
  }
}

/// Whether the flight runs[i] is the only one: at the clip's end, or between feet that both come
/// from or go to double support.
bool lone(const std::vector<Run>& runs, size_t i) {
  if (i == 0 || i + 1 == runs.size()) return true;
  if (!single(runs[i - 1].token) || !single(runs[i + 1].token)) return false;
  const bool before = i >= 2 && runs[i - 2].token == Support::kBoth;
  const bool after = i + 2 < runs.size() && runs[i + 2].token == Support::kBoth;
  return before && after;
}

/// Flights too short for a run or jump go to the foot before them, at the clip's start to that
/// after. Times in frames.
void dropBriefFlights(std::vector<Support>& tokens, double shortest, double lone_flight) {
  const std::vector<Run> runs = runsOf(tokens);
  for (size_t i = 0; i < runs.size() && runs.size() > 1; ++i) {
    if (runs[i].token != Support::kNone) continue;
    const double length = runs[i].last - runs[i].first + 1;
    if (length >= (lone(runs, i) ? std::max(shortest, lone_flight) : shortest)) continue;
    fill(tokens, runs[i], i == 0 ? runs[1].token : runs[i - 1].token);
  }
}

}  // namespace

std::string_view motionTypeName(MotionType type) {
  constexpr std::array<std::string_view, kMotionTypes> kNames = {"unknown", "stand", "walk",
                                                                 "run",     "jump",  "other"};
  return kNames[static_cast<size_t>(type)];
}

MotionType ClipClass::largest() const {
  return static_cast<MotionType>(std::max_element(share.begin(), share.end()) - share.begin());
}

ClipClass classifyTokens(std::span<const Support> tokens) {
  ClipClass result;
  if (tokens.empty()) return result;
  Machine machine(tokens[0], static_cast<int>(tokens.size()));
  const std::vector<Run> runs = runsOf(tokens);
  for (size_t i = 1; i < runs.size(); ++i) machine.enter(runs[i - 1], runs[i]);
  result.frames = machine.end();
  summarise(result);
  return result;
}

std::vector<Support> supportTokens(const FootPlants& plants) {
  const std::vector<bool> left = plants.planted(kLeft), right = plants.planted(kRight);
  std::vector<Support> tokens(plants.frames, Support::kNone);
  for (int i = 0; i < plants.frames; ++i) {
    if (left[i] && right[i]) {
      tokens[i] = Support::kBoth;
    } else if (left[i] || right[i]) {
      tokens[i] = left[i] ? Support::kLeft : Support::kRight;
    }
  }
  return tokens;
}

ClipClass classifyClip(const FootPlants& plants, double frame_time,
                       const ClassifyOptions& options) {
  assert(frame_time > 0.0);
  std::vector<Support> tokens = supportTokens(plants);
  dropBriefFlights(tokens, options.shortest_flight / frame_time, options.lone_flight / frame_time);
  joinFeet(tokens, options.together / frame_time);
  ClipClass result = classifyTokens(tokens);
  for (const Run& run : runsOf(tokens)) {
    if (run.token != Support::kBoth) continue;
    if (run.last - run.first + 1 < options.long_support / frame_time) continue;
    std::fill(result.frames.begin() + run.first, result.frames.begin() + run.last + 1,
              MotionType::kStand);
  }
  summarise(result);
  return result;
}

}  // namespace amble
