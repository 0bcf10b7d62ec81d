#include "app/read_options.h"

#include "animation/captures/capture_file.h"
#include "animation/captures/find_asf.h"
#include "app/command.h"
#include "base/rotation.h"

namespace amble {

MotionReadOptions ReadOptions::forReader() const {
  MotionReadOptions options;
  if (unit > 0.0) options.metres_per_unit = unit;
  if (!up.empty()) options.up = up == "y" ? UpAxis::kY : UpAxis::kZ;
  if (has_facing) options.facing = facing_deg * kDegree;
  if (file_fps > 0.0) options.frame_time = 1.0 / file_fps;
  options.take = take;
  options.asf = asf;
  options.roles = roles;
  options.memory = memory;
  return options;
}

std::vector<std::filesystem::path> ReadOptions::filesOf(const std::filesystem::path& clip) const {
  std::vector<std::filesystem::path> files = {clip};
  if (!roles.empty()) files.emplace_back(roles);
  if (lowerEnding(clip) == ".amc")
    files.push_back(asf.empty() ? findAsf(clip) : std::filesystem::path(asf));
  return files;
}

void addReadOptions(CLI::App& command, ReadOptions& options) {
  command
      .add_option("--unit", options.unit,
                  "Length of the files' unit; default: theirs or from the legs")
      ->check(number(1e-6, 1e3, "m"));
  command
      .add_option("--up", options.up,
                  "The files' vertical axis; default: theirs or from the motion")
      ->check(choice({"y", "z"}));
  command
      .add_option("--facing", options.facing_deg,
                  "Turn the clip so that the person first faces this way; 0 is +x")
      ->check(number(-360, 360, "degrees"))
      ->each([&options](const std::string&) { options.has_facing = true; });
  command.add_option("--asf", options.asf, "Skeleton of AMC files; default: the one beside")
      ->type_name("FILE");
  command
      .add_option("--roles", options.roles,
                  "YAML of `role: joint name`, for rigs whose names say too little")
      ->type_name("FILE");
  command
      .add_option("--file-fps", options.file_fps,
                  "Frames a second of BVH and AMC files, whatever they say; FBX, glTF and DAE are "
                  "sampled at it")
      ->check(number(1, kMostFrames, "1/s"));
  command
      .add_option("--take", options.take,
                  "Animation of FBX, glTF and DAE files; default: the one in which most moves")
      ->type_name("NAME");
  addMemoryOption(command, options.memory);
}

void addReadings(const CapturedMotion& motion, Findings& out) {
  out.facts.emplace_back("unit", motion.metres_per_unit.text);
  out.facts.emplace_back("up", motion.up.text);
  out.facts.emplace_back("facing", motion.facing.text);
  if (!motion.frame_time.text.ends_with(" s"))
    out.facts.emplace_back("frame time", motion.frame_time.text);
  out.data["unit"] = {{"metres", motion.metres_per_unit.value},
                      {"guessed", motion.metres_per_unit.guessed},
                      {"sure", motion.metres_per_unit.sure}};
  out.data["up"] = {{"axis", motion.up.value == UpAxis::kY ? "y" : "z"},
                    {"guessed", motion.up.guessed},
                    {"sure", motion.up.sure}};
  out.data["facing"] = {{"degrees", motion.facing.value / kDegree},
                        {"guessed", motion.facing.guessed},
                        {"sure", motion.facing.sure}};
  out.data["frame_time"] = motion.frame_time.value;
  out.data["frame_time_guessed"] = motion.frame_time.guessed;
  for (const std::string& role : roleNames()) {
    const int joint = roleJoint(motion.roles, role);
    if (joint >= 0) out.data["roles"][role] = motion.clip.skeleton.joint(joint).name;
  }
  out.warnings.insert(out.warnings.end(), motion.warnings.begin(), motion.warnings.end());
}

}  // namespace amble
