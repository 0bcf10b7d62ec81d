#include "app/graft_report.h"

#include <fmt/format.h>

#include "animation/body/joint_roles.h"
#include "base/rotation.h"
#include "base/text.h"

namespace amble {
namespace {

using Json = nlohmann::ordered_json;

std::string typeText(const MotionStretch& stretch) {
  return fmt::format("{}, frames {} to {}", motionTypeName(stretch.type), stretch.first,
                     stretch.last);
}

std::string correlationText(const Correlation& correlation, MotionType upper) {
  if (upper == MotionType::kStand) return "nobody steps: time goes on alike";
  if (upper == MotionType::kJump) {
    return fmt::format("take-off with take-off, legs {:.2f} leg lengths apart",
                       correlation.mismatch);
  }
  return fmt::format("{}, legs {:.2f} leg lengths apart",
                     correlation.same_foot ? "left with left" : "left with right, a step aside",
                     correlation.mismatch);
}

std::string armText(const ArmInBody& arm) {
  return fmt::format(
      "{} in {} by {:.0f} mm at {} of the frames {} to {} ({:.0f} mm in the sources)", arm.part,
      arm.other, 1000.0 * arm.depth, arm.frames, arm.first, arm.last, 1000.0 * arm.sources);
}

std::string clearingText(const ArmClearing& clearing) {
  std::vector<std::string> parts;
  for (const Side side : {kLeft, kRight}) {
    if (clearing.frames[side] == 0) continue;
    parts.push_back(fmt::format("the {} arm made way by up to {:.1f} degrees in {} frames",
                                side == kLeft ? "left" : "right", clearing.turned[side] / kDegree,
                                clearing.frames[side]));
  }
  return joined(parts);
}

Json armData(const std::vector<ArmInBody>& arms) {
  Json list = Json::array();
  for (const ArmInBody& arm : arms) {
    list.push_back({{"part", arm.part},
                    {"other", arm.other},
                    {"from", arm.first},
                    {"to", arm.last},
                    {"frames", arm.frames},
                    {"depth", arm.depth},
                    {"sources", arm.sources}});
  }
  return list;
}

Json alternativesData(const GraftPlan& plan) {
  Json list = Json::array();
  for (const Correlation& each : plan.alternatives) {
    list.push_back({{"shift", each.shift},
                    {"same_foot", each.same_foot},
                    {"mismatch", each.mismatch},
                    {"first", each.first},
                    {"last", each.last}});
  }
  return list;
}

Json sourceData(const GraftSource& source, const MotionStretch& window) {
  return {{"file", source.file.string()},
          {"type", motionTypeName(window.type)},
          {"first", window.first},
          {"last", window.last}};
}

Json jointNamesOf(const Skeleton& skeleton, const std::vector<int>& joints) {
  Json list = Json::array();
  for (const int j : joints) list.push_back(skeleton.joint(j).name);
  return list;
}

}  // namespace

std::vector<std::string> armWarnings(const Grafted& grafted) {
  std::vector<std::string> warnings;
  for (const ArmInBody& arm : grafted.left) warnings.push_back(armText(arm));
  if (const std::string text = clearingText(grafted.clearing); !text.empty()) {
    for (const ArmInBody& arm : grafted.found) warnings.push_back("was " + armText(arm));
    warnings.push_back(text);
  }
  return warnings;
}

Json graftData(const GraftSource& base, const GraftSource& upper, const Grafted& grafted,
               const GraftWishes& wishes) {
  Json data = {{"base", sourceData(base, grafted.plan.windows.base)},
               {"upper", sourceData(upper, grafted.plan.windows.upper)},
               {"refused", grafted.refusal}};
  if (grafted.plan.alternatives.empty()) return data;
  const Graft& graft = grafted.graft;
  data["chains"] = wishes.chains;
  data["joints"] = jointNamesOf(graft.clip.skeleton, graft.joints);
  data["kept"] = graft.kept;
  data["alternative"] = wishes.alternative;
  data["alternatives"] = alternativesData(grafted.plan);
  data["first"] = graft.first;
  data["last"] = graft.last;
  data["upper_first"] = graft.upper_frame.front();
  data["upper_last"] = graft.upper_frame.back();
  data["ease_in"] = graft.ease_in;
  data["ease_out"] = graft.ease_out;
  data["acceleration"] = {{"graft", graft.acceleration / kDegree},
                          {"sources", graft.source_acceleration / kDegree}};
  data["arm_leg_phase"] = {
      {"graft", grafted.arm_leg}, {"base", grafted.base_arm_leg}, {"upper", grafted.upper_arm_leg}};
  data["arms_in_body"] = {
      {"found", armData(grafted.found)},
      {"left", armData(grafted.left)},
      {"turned",
       {grafted.clearing.turned[kLeft] / kDegree, grafted.clearing.turned[kRight] / kDegree}},
      {"turned_frames", grafted.clearing.frames}};
  return data;
}

Findings describeGraft(const std::string& file, const GraftSource& base, const GraftSource& upper,
                       const Grafted& grafted, const GraftWishes& wishes) {
  const GraftPlan& plan = grafted.plan;
  const Graft& graft = grafted.graft;
  Findings out;
  out.file = file;
  out.kind = "graft";
  const auto fact = [&](const char* label, std::string value) {
    out.facts.emplace_back(label, std::move(value));
  };
  fact("base", base.file.string() + ": " + typeText(plan.windows.base));
  fact("upper", upper.file.string() + ": " + typeText(plan.windows.upper));
  fact("chains", fmt::format("{} ({})", joined(wishes.chains),
                             counted(static_cast<long long>(graft.joints.size()), "joint")));
  fact("grafted",
       fmt::format("frames {} to {}, upper's {:.1f} to {:.1f}; eased {:.2f} s in, {:.2f} s "
                   "out",
                   graft.first, graft.last, graft.upper_frame.front(), graft.upper_frame.back(),
                   graft.ease_in, graft.ease_out));
  const auto taken = static_cast<size_t>(wishes.alternative);
  fact("correlation",
       fmt::format("{} of {}: {}", taken, plan.alternatives.size(),
                   correlationText(plan.alternatives[taken], plan.windows.upper.type)));
  fact("joints", fmt::format("accelerate by {:.0f} degrees/s^2 at most, {:.0f} in the sources",
                             graft.acceleration / kDegree, graft.source_acceleration / kDegree));
  fact("arms against legs",
       fmt::format("{:.2f} left, {:.2f} right; base {:.2f}, {:.2f}; upper {:.2f}, {:.2f}",
                   grafted.arm_leg[kLeft], grafted.arm_leg[kRight], grafted.base_arm_leg[kLeft],
                   grafted.base_arm_leg[kRight], grafted.upper_arm_leg[kLeft],
                   grafted.upper_arm_leg[kRight]));
  for (const auto* const source : {&base, &upper}) {
    for (const std::string& warning : source->motion.warnings)
      out.warnings.push_back(source->file.string() + ": " + warning);
  }
  if (!graft.kept.empty()) {
    out.warnings.push_back("upper has nothing for " + joined(graft.kept) +
                           ": they stay as they are");
  }
  for (const std::string& warning : armWarnings(grafted)) out.warnings.push_back(warning);
  out.data = graftData(base, upper, grafted, wishes);
  return out;
}

}  // namespace amble
