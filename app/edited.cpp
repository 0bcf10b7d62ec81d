#include "app/edited.h"

#include <fmt/format.h>

#include "base/error.h"

namespace amble {
namespace {

// What is asked for must be within what captured walks are edited to (thesis, chapter 6).
void checkEditAmount(const std::string& option, const std::optional<EditAmount>& asked,
                     double captured, double least, double most) {
  if (!asked) return;
  const Ramp factor = asked->factorOf(captured);
  for (const double value : {factor.from, factor.to}) {
    if (value >= least - 1e-9 && value <= most + 1e-9) continue;
    throw InputError("amble edit: " + option, 0,
                     fmt::format("is {:.3g} of what was captured", value),
                     fmt::format("{:g}x to {:g}x, {:.3f} to {:.3f} m, of the {:.3f} m in this clip",
                                 least, most, least * captured, most * captured, captured));
  }
}

void checkEdit(const EditRequest& request, const CapturedWalk& walk, const std::string& file) {
  if (request.foot_lock && walk.analysis.gait.plants.empty()) {
    throw InputError(file, 0, "shows no foot that stands", "a motion with feet to be held");
  }
  if (!request.changesWalk()) return;
  const std::string why = whyNoWalk(walk);
  if (!why.empty()) {
    throw InputError(file, 0, "is no walk: it " + why,
                     "a walk of two steps or more; --footlock alone takes any motion");
  }
  checkEditAmount("--stride", request.stride, walk.analysis.gait.step_length, EditLimits::kShortest,
                  EditLimits::kLongest);
  checkEditAmount("--lift", request.lift, walk.analysis.gait.lift, EditLimits::kLowest,
                  EditLimits::kHighest);
}

}  // namespace

EditedWalk editCapture(const CapturedWalk& walk, const EditRequest& request,
                       const std::string& file) {
  checkEdit(request, walk, file);
  return editWalk(walk, request);
}

}  // namespace amble
