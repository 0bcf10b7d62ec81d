#include "batch/labels/used_motions.h"

#include <algorithm>

#include "base/text.h"
#include "scenarios/problem.h"

namespace amble {

std::vector<UsedMotion> usedMotions(const RunResult& run, const FrameLabels& labels) {
  const WalkSpec& walk = run.problem->scenario.walk;
  std::vector<UsedMotion> used;
  for (const Motion& motion : run.problem->library.motions) {
    UsedMotion found{&motion, 0.0};
    const size_t columns = labels.motions.size();
    for (size_t column = 0; column < columns; ++column) {
      if (labels.motions[column] != &motion) continue;
      for (size_t cell = column; cell < labels.shares.size(); cell += columns)
        found.share += labels.shares[cell];
    }
    found.share /= std::max(1, labels.frames);
    const bool acts =
        std::find(walk.actions.begin(), walk.actions.end(), motion.name) != walk.actions.end();
    if (acts) found.share = 1.0;
    const bool begins = motion.kind == MotionKind::kStart && walk.from_standing;
    const bool ends = motion.kind == MotionKind::kStop && walk.to_standing;
    if (found.share > 0.0 || begins || ends) used.push_back(found);
  }
  return used;
}

std::set<std::string> creditsOf(const std::vector<UsedMotion>& motions) {
  std::set<std::string> credits;
  for (const UsedMotion& used : motions) {
    const MotionSource& source = used.motion->source;
    credits.insert(withoutControls(source.licence + ": " + source.credit));
  }
  return credits;
}

}  // namespace amble
