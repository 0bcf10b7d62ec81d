/// What kind of motion a clip is, from who stands when: the grammar and the state machine of
/// Shanbhag's thesis (§3.2, appendix C) over L, R, B, N.
///
///     stand: B    walk: (B L B R)+    run: (L N R N)+    jump: (B N)+ B | (L N)+ L | (R N)+ R
///
/// The thesis gives the states and what each does on entry and exit, its drawings of the
/// transitions (figures C.1 to C.4) say no more than the grammar; where it is silent:
/// - hops on one foot are jumps (grammar), so Jump has sub-states for one foot beside its two;
/// - one foot straight after the other (a double support shorter than a frame) is a step of a walk,
///   or goes on with a run;
/// - a jump from both feet that lands on one leads to Unknown.
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "animation/analysis/foot_plants.h"

namespace amble {

/// Who stands: the tokens of the grammar.
enum class Support : char { kLeft = 'L', kRight = 'R', kBoth = 'B', kNone = 'N' };

enum class MotionType { kUnknown, kStand, kWalk, kRun, kJump, kOther };
inline constexpr int kMotionTypes = 6;
/// "unknown", "stand", "walk", "run", "jump", "other"
std::string_view motionTypeName(MotionType type);

/// Frames of one type.
struct MotionSegment {
  MotionType type = MotionType::kUnknown;
  int first = 0;  ///< first and last frame, both included
  int last = 0;
};

struct ClipClass {
  MotionType type = MotionType::kUnknown;       ///< that of all frames; kOther where they differ
  std::vector<MotionType> frames;               ///< never kOther
  std::vector<MotionSegment> segments;          ///< in order, neighbours differ
  std::array<double, kMotionTypes> share = {};  ///< of the frames, by MotionType [0, 1]

  double shareOf(MotionType wanted) const { return share[static_cast<size_t>(wanted)]; }
  MotionType largest() const;  ///< type with the largest share, the first of equals
};

/// The thesis' state machine itself, a token a frame: table C.1 gives table C.2.
ClipClass classifyTokens(std::span<const Support> tokens);

/// What is done to the tokens before, and what the thesis' definition of standing adds. By trial,
/// on the captures of CMU and ACCAD; all are far from what they part (steps take 0.3 s and more).
struct ClassifyOptions {
  double shortest_flight = 0.04;  ///< a shorter one within steps is none: a fast walk's [s, >= 0]
  /// Nor is one that is shorter than this and the only one: among double supports (a run flies from
  /// every step), or at the clip's end, where nobody sees whether a foot was about to land [s, >=
  /// 0].
  double lone_flight = 0.1;
  double together = 0.12;  ///< feet that leave or land so close do it together [s, >= 0]
  /// Both feet down for longer is standing ("an extended period of time"), whatever comes before
  /// and after [s, > 0].
  double long_support = 2.0;
};

/// Tokens of a clip's frames, as planted.
std::vector<Support> supportTokens(const FootPlants& plants);

ClipClass classifyClip(const FootPlants& plants, double frame_time,
                       const ClassifyOptions& options = {});

}  // namespace amble
