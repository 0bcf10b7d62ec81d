#include "animation/synthesis/captured_turns.h"

#include <cmath>
#include <limits>

namespace amble {

CapturedTurns::CapturedTurns(const MotionLibrary& library, double scale) {
  for (const Motion& motion : library.motions) {
    if (motion.kind != MotionKind::kTurnOnSpot || motion.turn.empty()) continue;
    turns_.push_back({&motion, motion.turn});
    TurnSequence& sequence = turns_.back().sequence;
    sequence.duration *= std::sqrt(scale);  // Froude's law
    sequence.spline.topRows(3) *= scale;
  }
}

CapturedTurns::Taken CapturedTurns::take(double angle) const {
  Taken best;
  double least = std::numeric_limits<double>::infinity();
  const Side inside = angle > 0.0 ? kLeft : kRight;
  for (int i = 0; i < size(); ++i) {
    const TurnSequence& sequence = turns_[i].sequence;
    const double whole = angle / sequence.angle;  // how often it is made as it was captured
    if (!(whole > 0.0)) continue;
    const int most = static_cast<int>(std::floor(whole / kLeast));
    for (int times = 1; times <= most; ++times) {
      const double ratio = whole / times;
      if (ratio > kMost) continue;
      double off = std::abs(std::log(ratio)) + kOneMore * (times - 1);
      if (sequence.first != inside) off += kOtherFoot;
      if (off < least) best = {i, times}, least = off;
    }
  }
  return best;
}

}  // namespace amble
