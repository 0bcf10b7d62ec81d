// amble validate WALK.bvh --scene S.yaml: any BVH against a scene.

#include <fmt/format.h>

#include <iostream>
#include <memory>

#include "app/command.h"
#include "app/say.h"
#include "app/validation_report.h"
#include "base/rotation.h"
#include "scenarios/standing_feet.h"
#include "scenarios/validate_walk.h"

namespace amble {
namespace {

using Json = nlohmann::ordered_json;

struct ValidateArguments {
  std::string walk, scene;
  double unit = 0.0;  // 0: guessed
  std::string up = "y";
  double floor = 0.0;
  bool has_floor = false, json = false;
  AllowedFindings allowed;
  double max_slope_deg = 20.0;
  ValidateOptions validate;
};

// Ground is looked for so far below a sole and no farther.
void printHover(const WalkValidation& result) {
  const StandingFeet& feet = result.feet;
  const std::string largest = feet.hover_max < kMostHover
                                  ? fmt::format("{:.1f} mm largest", 1000.0 * feet.hover_max)
                                  : fmt::format("no ground within {:g} m below", kMostHover);
  say(stdout, "  hover        {}, over {:.0f} mm in {:.1f} % of the planted time{}\n", largest,
      1000.0 * kHoverLimit, 100.0 * feet.hover_share,
      result.hovers() ? ": feet hang in the air" : "");
}

void printText(const std::string& walk, const WalkValidation& result, const GroundLimits& limits) {
  say(stdout, "{}: {} frames of {:.7g} s, {} poses checked\n", walk, result.frames,
      result.frame_time, result.poses_checked);
  say(stdout, "  body         {:.3f} m tall; file unit {:g} m; floor at {:.3f} m\n", result.stature,
      result.metres_per_unit, result.floor);
  for (const ContactSpan& contact : result.contacts) {
    say(stdout, "  contact      {:.3f} s to {:.3f} s: {} and {}\n", contact.start, contact.end,
        contact.part, contact.object);
  }
  if (result.contacts.empty()) say(stdout, "  contact      none\n");
  if (result.clearance_part.empty()) {
    say(stdout, "  clearance    {:.3f} m or more\n", result.clearance);
  } else {
    say(stdout, "  clearance    {:.3f} m, {} and {} at {:.3f} s\n", result.clearance,
        result.clearance_part, result.clearance_object, result.clearance_time);
  }
  const StandingFeet& feet = result.feet;
  say(stdout, "  foot skate   {:.1f} mm mean, {:.1f} mm largest, of {} plants{}\n",
      1000.0 * feet.skate_mean, 1000.0 * feet.skate_max, feet.plants,
      result.slides() ? fmt::format(": over {:.0f} mm, feet slide", 1000.0 * kSlideLimit) : "");
  printHover(result);
  say(stdout, "  steps        {:.3f} m up, {:.3f} m down at most{}\n", result.steps.up,
      result.steps.down,
      result.oversteps(limits) ? fmt::format(": over the {:g} m up or {:g} m down that may be",
                                             limits.max_climb, limits.max_drop)
                               : std::string());
  say(stdout, "  pops         {:.1f}{}\n", result.pops,
      result.hasPops() ? fmt::format(": over {:g}, a joint jumps or flips over", kPopsLimit) : "");
  say(stdout, "  penetration  {:.1f} mm largest\n", 1000.0 * result.ground_penetration);
}

int run(ValidateArguments options) {
  ValidateOptions& how = options.validate;
  if (options.unit > 0.0) how.metres_per_unit = options.unit;
  if (options.has_floor) how.floor = options.floor;
  how.limits.max_slope = options.max_slope_deg * kDegree;
  how.up = options.up == "y" ? UpAxis::kY : UpAxis::kZ;
  const WalkValidation result = validateWalk(options.walk, options.scene, how);
  if (options.json) {
    std::cout
        << validationJson(options.walk, result).dump(2, ' ', false, Json::error_handler_t::replace)
        << '\n';
  } else {
    printText(options.walk, result, how.limits);
  }
  return isClean(result, how.limits, options.allowed) ? kExitDone : kExitNone;
}

}  // namespace

void addValidate(CLI::App& app, Command& chosen) {
  const auto options = std::make_shared<ValidateArguments>();
  CLI::App* command = app.add_subcommand(
      "validate",
      "Check any BVH against a scene: contacts, clearance, hovering and sliding feet, steps, pops");
  command->add_option("WALK", options->walk, "BVH file")->type_name("FILE")->required();
  command->add_option("--scene", options->scene, "Scene file (YAML)")
      ->type_name("FILE")
      ->required();
  command->add_option("--unit", options->unit, "Length of the BVH's unit; default: from its legs")
      ->check(number(1e-6, 1e3, "m"));
  command->add_option("--up", options->up, "The BVH's vertical axis")
      ->check(choice({"y", "z"}))
      ->capture_default_str();
  command->add_option("--height", options->validate.height, "Stature; default: from the skeleton")
      ->check(number(0.5, 2.5, "m"));
  command->add_option("--fps", options->validate.fps, "Check between the frames too, at this rate")
      ->check(number(1, 10000, "1/s"));
  addMemoryOption(*command, options->validate.load.memory);
  command->add_option("--floor", options->floor, "Height of the floor; default: below the feet")
      ->check(number(-1e5, 1e5, "m"))
      ->each([options](const std::string&) { options->has_floor = true; });
  command->add_option("--max-slope", options->max_slope_deg, "Steepest ground of the walk")
      ->check(number(0, 45, "degrees"))
      ->capture_default_str();
  command
      ->add_option("--max-climb", options->validate.limits.max_climb, "Highest step up of the walk")
      ->check(number(0, 1, "m"))
      ->capture_default_str();
  command
      ->add_option("--max-drop", options->validate.limits.max_drop, "Highest step down of the walk")
      ->check(number(0, 1, "m"))
      ->capture_default_str();
  command->add_flag("--allow-hover", options->allowed.hover,
                    "Feet in the air are said, and are no failure");
  command->add_flag("--allow-slide", options->allowed.slide,
                    "Feet that slide are said, and are no failure");
  command->add_flag("--allow-pops", options->allowed.pops,
                    "Joints that jump are said, and are no failure");
  command->add_flag("--json", options->json, "Print results for machines");
  const std::string example =
      "amble validate out/walk.bvh --scene environments/scenes/living-room/scene.yaml";
  addExamples(*command, {example, example + " --fps 240 --json"});
  addExitStatus(*command, "all is well",
                "a contact, planted soles that hang in the air or slide, a step that is too high, "
                "or a joint that jumps");
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace amble
