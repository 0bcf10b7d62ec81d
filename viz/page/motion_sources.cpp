#include "viz/page/motion_sources.h"

#include <algorithm>

#include "animation/synthesis/motion_shares.h"
#include "base/text.h"

namespace amble {
namespace {

constexpr double kSomething = 0.02;  // less of a motion is none [1]

// Names of motions, mirror images of others among them left out.
std::string namesOf(const std::vector<const Motion*>& motions) {
  std::vector<std::string> all, captured;
  for (const Motion* motion : motions) {
    all.push_back(motion->name);
    if (!motion->source.mirrored) captured.push_back(motion->name);
  }
  return joined(captured.empty() ? all : captured);
}

}  // namespace

std::vector<PageSource> motionSources(const AnimationBuffer& walk, const MotionLibrary& library,
                                      const WalkSynthesizer& synthesizer) {
  const MotionShares shares(library, synthesizer);
  std::vector<PageSource> sources;
  for (const auto& motions : shares.motions()) sources.push_back({namesOf(motions), {}});
  for (const FrameState& state : walk.states) {
    const std::vector<double> now = shares.at(state);
    for (size_t i = 0; i < now.size(); ++i) sources[i].share.push_back(static_cast<float>(now[i]));
  }
  for (const std::string& action : synthesizer.settings().actions)
    sources.push_back({action, std::vector<float>(walk.states.size(), 1.0f)});
  std::erase_if(sources, [](const PageSource& source) {
    return std::ranges::all_of(source.share, [](float share) { return share < kSomething; });
  });
  return sources;
}

}  // namespace amble
