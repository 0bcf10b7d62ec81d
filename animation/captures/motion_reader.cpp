#include "animation/captures/motion_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <memory>

#include "animation/captures/asf_amc.h"
#include "animation/captures/assimp_motion.h"
#include "animation/captures/bvh.h"
#include "animation/captures/motion_guesses.h"
#include "animation/captures/role_guess.h"
#include "base/error.h"
#include "base/rotation.h"

namespace amble {
namespace {

/// A capture whose unit and vertical axis are not settled yet.
struct OpenMotion {
  std::function<Clip(double metres_per_unit, UpAxis up)> read;
  std::shared_ptr<AsfAmcNotes> notes;  // of what was read last; null for other formats
};

OpenMotion openAmc(const std::filesystem::path& amc, const MotionReadOptions& options) {
  const std::filesystem::path asf = options.asf.empty() ? findAsf(amc) : options.asf;
  const auto notes = std::make_shared<AsfAmcNotes>();
  const auto read = [=, skeleton = readText(asf, "an ASF file"),
                     motion = readText(amc, "an AMC file"),
                     frame_time = options.frame_time](double unit, UpAxis up) {
    *notes = {};
    return parseAsfAmc({skeleton, asf.string()}, {motion, amc.string()},
                       {.metres_per_unit = unit, .up = up, .frame_time = frame_time}, notes.get());
  };
  return {read, notes};
}

OpenMotion openMotion(const std::filesystem::path& file, const MotionReadOptions& options) {
  const std::string ending = lowerEnding(file);
  if (file == "-" || ending == ".bvh") {
    const auto read = [name = file.string(), text = readText(file, "a BVH file")](double unit,
                                                                                  UpAxis up) {
      return parseBvh(text, name, {.metres_per_unit = unit, .up = up});
    };
    return {read, nullptr};
  }
  if (ending == ".amc") return openAmc(file, options);
  if (ending == ".asf") {
    throw InputError(file.string(), 0, "a skeleton without a motion", "the .amc that goes with it");
  }
  throw InputError(file.string(), 0, "no kind of capture that Amble knows",
                   ".bvh, .amc, .fbx, .gltf, .glb or .dae");
}

const char* axisName(UpAxis up) { return up == UpAxis::kY ? "y" : "z"; }

Reading<double> settleUnit(const CapturedMotion& motion, const std::optional<double>& said) {
  const Clip& raw = motion.clip;
  const JointRoles& roles = motion.roles;
  if (said) return {*said, false, true, fmt::format("{:g} m, as asked", *said)};
  if (!motion.no_person.empty()) return {1.0, true, false, "1 m, guessed: there are no legs"};
  const double leg =
      0.5 * (roles.legLength(raw.skeleton, kLeft) + roles.legLength(raw.skeleton, kRight));
  Reading<double> unit{guessUnit(raw.skeleton, roles), true, leg > 0.0, ""};
  unit.text = leg > 0.0
                  ? fmt::format("{:g} m, guessed: legs of {:.2f} m", unit.value, leg * unit.value)
                  : "1 m, guessed: the legs have no length";
  return unit;
}

Reading<UpAxis> settleUp(const CapturedMotion& motion, const std::optional<UpAxis>& said) {
  if (said) return {*said, false, true, fmt::format("{}, as asked", axisName(*said))};
  if (!motion.no_person.empty()) return {UpAxis::kY, true, false, "y, guessed: the usual one"};
  return guessUp(motion.clip, motion.roles);
}

Reading<double> settleFrameTime(const Clip& clip, const AsfAmcNotes* notes,
                                const std::optional<double>& said) {
  Reading<double> time{clip.frame_time, false, true, fmt::format("{:.7g} s", clip.frame_time)};
  if (notes == nullptr) return time;
  time.guessed = !said && !notes->frame_time_said;
  time.text += time.guessed ? ", guessed: the usual one of its format" : said ? ", as asked" : "";
  return time;
}

void turnTo(double heading, double target, Clip& clip) {
  const Eigen::Quaterniond turn = aboutZ(target - heading);
  for (int i = 0; i < clip.frames(); ++i) {
    clip.poses.p_WR(i) = turn * clip.poses.p_WR(i);
    clip.poses.rotations(i)[0] = turn * clip.poses.rotations(i)[0];
  }
}

Reading<double> settleFacing(const JointRoles& roles, const std::optional<double>& said,
                             Clip& clip) {
  Reading<double> facing = guessFacing(clip, roles);
  if (!said) return facing;
  turnTo(facing.value, *said, clip);
  facing.value = *said;
  facing.text = fmt::format("{:.1f} degrees, as asked", *said / kDegree);
  facing.guessed = false;
  return facing;
}

/// Whose joint is whose, or nobody's.
void settleRoles(const std::string& file, const MotionReadOptions& options,
                 CapturedMotion& motion) {
  const RoleGuess guess = guessRoles(motion.clip, file, options.roles);
  motion.roles = guess.roles;
  motion.no_person = guess.missing;
  if (guess.missing.empty()) {
    for (const std::string& unsure : guess.unsure) motion.warnings.push_back("unsure of " + unsure);
    return;
  }
  if (options.person) {
    throw InputError(file, 0, "no joint looks like " + guess.missing,
                     "a person's skeleton, or a file of roles (--roles)");
  }
  motion.warnings.push_back("no person: no joint looks like " + guess.missing);
}

bool isNodeFile(const std::filesystem::path& file) {
  const std::string ending = lowerEnding(file);
  return ending == ".fbx" || ending == ".gltf" || ending == ".glb" || ending == ".dae";
}

/// A unit that the file says and its legs contradict is kept, and told.
Reading<double> saidUnit(const CapturedMotion& motion, double unit, bool asked) {
  Reading<double> reading{unit, false, true,
                          fmt::format("{:g} m, {}", unit, asked ? "as asked" : "as the file says")};
  const double likely = guessUnit(motion.clip.skeleton, motion.roles);
  if (asked || !motion.no_person.empty() || likely == 1.0) return reading;
  reading.sure = false;
  reading.text += fmt::format(", but the legs look like {:g} m", unit * likely);
  return reading;
}

/// FBX, glTF and Collada say their unit and axes.
CapturedMotion readNodes(const std::filesystem::path& file, const MotionReadOptions& options) {
  CapturedMotion motion;
  AssimpMotionNotes notes;
  motion.clip = readAssimpMotion(file,
                                 {.metres_per_unit = options.metres_per_unit,
                                  .up = options.up,
                                  .frame_time = options.frame_time},
                                 &notes);
  settleRoles(file.string(), options, motion);
  motion.metres_per_unit =
      saidUnit(motion, notes.metres_per_unit, options.metres_per_unit.has_value());
  motion.up = {
      notes.up, false, true,
      fmt::format("{}, as {}", axisName(notes.up), options.up ? "asked" : "the file says")};
  motion.frame_time = {
      motion.clip.frame_time, false, true,
      fmt::format("{:.7g} s{}", motion.clip.frame_time, options.frame_time ? ", as asked" : "")};
  motion.warnings.insert(motion.warnings.end(), notes.warnings.begin(), notes.warnings.end());
  return motion;
}

/// Text formats leave their unit and vertical axis open.
CapturedMotion readTexts(const std::filesystem::path& file, const MotionReadOptions& options) {
  const OpenMotion open = openMotion(file, options);
  CapturedMotion motion;
  const UpAxis as_written = UpAxis::kZ;
  motion.clip = open.read(1.0, as_written);
  settleRoles(file.string(), options, motion);
  motion.metres_per_unit = settleUnit(motion, options.metres_per_unit);
  motion.up = settleUp(motion, options.up);
  // Read again rather than converted: what a micrometre is depends on the unit.
  if (motion.metres_per_unit.value != 1.0 || motion.up.value != as_written) {
    motion.clip = open.read(motion.metres_per_unit.value, motion.up.value);
  }
  motion.frame_time = settleFrameTime(motion.clip, open.notes.get(), options.frame_time);
  if (open.notes) {
    const std::vector<std::string>& warnings = open.notes->warnings;
    motion.warnings.insert(motion.warnings.end(), warnings.begin(), warnings.end());
  }
  return motion;
}

}  // namespace

bool isMotionFile(const std::filesystem::path& file) {
  const std::string ending = lowerEnding(file);
  return file == "-" || ending == ".bvh" || ending == ".amc" || isNodeFile(file);
}

CapturedMotion readMotion(const std::filesystem::path& file, const MotionReadOptions& options) {
  CapturedMotion motion = isNodeFile(file) ? readNodes(file, options) : readTexts(file, options);
  if (motion.no_person.empty()) {
    motion.facing = settleFacing(motion.roles, options.facing, motion.clip);
  } else {
    motion.facing = {0.0, true, true, "unknown: no person"};
  }
  if (!motion.metres_per_unit.sure) {
    motion.warnings.push_back("unit " + motion.metres_per_unit.text);
  }
  if (!motion.up.sure) motion.warnings.push_back("vertical axis " + motion.up.text);
  if (!motion.facing.sure) motion.warnings.push_back("facing " + motion.facing.text);
  return motion;
}

}  // namespace amble
