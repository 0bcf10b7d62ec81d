#include "viz/page/motion_sources.h"

#include <algorithm>

#include "animation/synthesis/gait_blend.h"
#include "base/text.h"

namespace amble {
namespace {

constexpr double kSomething = 0.02;  // less of a motion is none [1]

// Names of motions, mirror images of others among them left out.
std::string namesOf(const std::vector<std::string>& motions, const MotionLibrary& library) {
  std::vector<std::string> names;
  for (const std::string& name : motions)
    if (motions.size() == 1 || !library.find(name)->source.mirrored) names.push_back(name);
  return joined(names.empty() ? motions : names);
}

}  // namespace

std::vector<PageSource> motionSources(const AnimationBuffer& walk, const MotionLibrary& library,
                                      const WalkSynthesizer& synthesizer) {
  const double scale = synthesizer.stature() / library.stature;
  const GaitBlend blend(library, scale, synthesizer.settings().speed);
  std::vector<PageSource> sources = {{"stand", {}}};
  for (const GaitBlend::Share& share : blend.shares(library, 0.0))
    sources.push_back({namesOf(share.motions, library), {}});
  for (const FrameState& state : walk.states) {
    sources[0].share.push_back(static_cast<float>(state.standing));
    const auto shares = blend.shares(library, state.blended_turn_rate);
    for (size_t i = 0; i < shares.size(); ++i)
      sources[i + 1].share.push_back(static_cast<float>((1.0 - state.standing) * shares[i].share));
  }
  for (const std::string& action : synthesizer.settings().actions)
    sources.push_back({action, std::vector<float>(walk.states.size(), 1.0f)});
  std::erase_if(sources, [](const PageSource& source) {
    return std::ranges::all_of(source.share, [](float share) { return share < kSomething; });
  });
  return sources;
}

}  // namespace amble
