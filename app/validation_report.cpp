#include "app/validation_report.h"

namespace amble {

nlohmann::ordered_json validationJson(const std::string& walk, const WalkValidation& result) {
  using Json = nlohmann::ordered_json;
  Json contacts = Json::array();
  for (const ContactSpan& contact : result.contacts) {
    contacts.push_back({{"start", contact.start},
                        {"end", contact.end},
                        {"part", contact.part},
                        {"object", contact.object}});
  }
  return {
      {"file", walk},
      {"frames", result.frames},
      {"frame_time", result.frame_time},
      {"poses_checked", result.poses_checked},
      {"bvh_unit", result.metres_per_unit},
      {"stature", result.stature},
      {"floor", result.floor},
      {"contacts", contacts},
      {"clearance",
       {{"min", result.clearance},
        {"part", result.clearance_part},
        {"object", result.clearance_object},
        {"time", result.clearance_time}}},
      {"plants", result.feet.plants},
      {"foot_skate",
       {{"mean", result.feet.skate_mean}, {"max", result.feet.skate_max}, {"limit", kSlideLimit}}},
      {"pops", {{"value", result.pops}, {"limit", kPopsLimit}}},
      {"hover",
       {{"max", result.feet.hover_max},
        {"share", result.feet.hover_share},
        {"limit", kHoverLimit}}},
      {"steps", {{"up", result.steps.up}, {"down", result.steps.down}}},
      {"ground_penetration", {{"max", result.ground_penetration}}}};
}

bool isClean(const WalkValidation& result, const GroundLimits& limits,
             const AllowedFindings& allowed) {
  return result.contacts.empty() && (allowed.hover || !result.hovers()) &&
         (allowed.slide || !result.slides()) && (allowed.pops || !result.hasPops()) &&
         !result.oversteps(limits);
}

}  // namespace amble
