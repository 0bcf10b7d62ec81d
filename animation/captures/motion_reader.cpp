#include "animation/captures/motion_reader.h"

#include <fmt/format.h>

#include <cmath>

#include "animation/captures/asf_amc.h"
#include "animation/captures/bvh.h"
#include "animation/captures/capture_checks.h"
#include "animation/captures/capture_file.h"
#include "animation/captures/find_asf.h"
#include "animation/captures/motion_guesses.h"
#include "animation/captures/node_file.h"
#include "animation/captures/role_guess.h"
#include "animation/captures/root_at_hips.h"
#include "animation/captures/unit_guess.h"
#include "base/error.h"
#include "base/rotation.h"

namespace amble {
namespace {

/// A capture as its file has it, in its unit and axes.
struct WrittenMotion {
  Clip clip;
  Reading<double> frame_time;  // [s]
  std::vector<std::string> warnings;
};

Reading<double> timeReading(double seconds, bool asked, bool guessed, const char* how) {
  return {seconds, guessed, true,
          fmt::format("{:.7g} s{}", seconds,
                      asked     ? ", as asked"
                      : guessed ? how
                                : "")};
}

WrittenMotion readAmc(const std::filesystem::path& amc, const MotionReadOptions& options) {
  const std::filesystem::path asf = options.asf.empty() ? findAsf(amc) : options.asf;
  const std::string skeleton = readWholeFile(asf, kAsfFile), motion = readWholeFile(amc, kAmcFile);
  AsfAmcNotes notes;
  WrittenMotion written;
  written.clip = parseAsfAmcAsWritten({skeleton, asf.string()}, {motion, amc.string()},
                                      options.frame_time, notes);
  const bool asked = options.frame_time.has_value();
  written.frame_time = timeReading(written.clip.frame_time, asked, !asked && !notes.frame_time_said,
                                   ", guessed: the usual one of its format");
  written.warnings = std::move(notes.warnings);
  return written;
}

WrittenMotion readAsWritten(const std::filesystem::path& file, const MotionReadOptions& options) {
  const std::string ending = lowerEnding(file);
  if (file == "-" || ending == ".bvh") {
    BvhNotes notes;
    WrittenMotion written;
    written.clip =
        parseBvhAsWritten(readWholeFile(file, kBvhFile), file.string(), options.frame_time, notes);
    written.frame_time =
        timeReading(written.clip.frame_time, options.frame_time.has_value(),
                    notes.frame_time_guessed, ", guessed: the file's can only be a rate");
    written.warnings = std::move(notes.warnings);
    return written;
  }
  if (ending == ".amc") return readAmc(file, options);
  if (ending == ".asf") {
    throw InputError(file.string(), 0, "a skeleton without a motion", "the .amc that goes with it");
  }
  std::error_code ignored;
  const bool there = std::filesystem::exists(file, ignored);
  throw InputError(file.string(), 0, there ? "no kind of capture that Amble knows" : "is not there",
                   ".bvh, .amc, .fbx, .gltf, .glb, .vrma or .dae");
}

const char* axisName(UpAxis up) { return up == UpAxis::kY ? "y" : "z"; }

bool isPerson(const CapturedMotion& motion) { return motion.no_person.empty(); }

Reading<double> settleUnit(const CapturedMotion& motion, const Clip& seen, const StepRhythm& rhythm,
                           const std::optional<double>& said) {
  if (said) return {*said, false, true, fmt::format("{:g} m, as asked", *said)};
  if (!isPerson(motion)) return {1.0, true, false, "1 m, guessed: there are no legs"};
  return guessUnit(motion.roles.meanLeg(seen.skeleton), rhythm, seen.frame_time);
}

Reading<UpAxis> settleUp(const CapturedMotion& motion, const Clip& seen,
                         const std::optional<UpAxis>& said) {
  if (said) return {*said, false, true, fmt::format("{}, as asked", axisName(*said))};
  if (!isPerson(motion)) return {UpAxis::kY, true, false, "y, guessed: the usual one"};
  return guessUp(seen, motion.roles);
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

/// Whose joint is whose in `clip`, or nobody's.
void settleRoles(const Clip& clip, const std::string& file, const MotionReadOptions& options,
                 CapturedMotion& motion) {
  const RoleGuess guess = guessRoles(clip, file, options.roles);
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

void append(const std::vector<std::string>& warnings, CapturedMotion& motion) {
  motion.warnings.insert(motion.warnings.end(), warnings.begin(), warnings.end());
}

/// FBX, glTF and Collada say their unit and axes; nothing without an animation.
std::optional<CapturedMotion> readNodes(const std::filesystem::path& file,
                                        const MotionReadOptions& options) {
  CapturedMotion motion;
  NodeFileNotes notes;
  std::optional<Clip> clip = readNodeFileIfAny(file,
                                               {.metres_per_unit = options.metres_per_unit,
                                                .up = options.up,
                                                .frame_time = options.frame_time,
                                                .take = options.take,
                                                .memory = options.memory},
                                               &notes);
  if (!clip) return {};
  motion.clip = std::move(*clip);
  settleRoles(motion.clip, file.string(), options, motion);
  if (isPerson(motion) && rootAtHips(motion.clip, motion.roles)) scaleToMetres(1.0, motion.clip);
  if (options.metres_per_unit || !isPerson(motion)) {
    motion.metres_per_unit = {notes.metres_per_unit, false, true,
                              fmt::format("{:g} m, as {}", notes.metres_per_unit,
                                          options.metres_per_unit ? "asked" : "the file says")};
  } else {
    motion.metres_per_unit =
        checkSaidUnit(notes.metres_per_unit, motion.roles.meanLeg(motion.clip.skeleton));
  }
  motion.up = {
      notes.up, false, true,
      fmt::format("{}, as {}", axisName(notes.up), options.up ? "asked" : "the file says")};
  motion.frame_time =
      timeReading(motion.clip.frame_time, options.frame_time.has_value(), false, "");
  append(notes.warnings, motion);
  return motion;
}

/// A clip as written, to be looked at: with its offsets settled, in `copy` where that changes it.
const Clip& settled(const Clip& written, Clip& copy) {
  if (written.joint_positions.empty()) return written;
  copy = written;
  scaleToMetres(1.0, copy);
  return copy;
}

/// Text formats leave their unit and vertical axis open.
CapturedMotion readTexts(const std::filesystem::path& file, const MotionReadOptions& options) {
  WrittenMotion written = readAsWritten(file, options);
  CapturedMotion motion;
  motion.clip = std::move(written.clip);
  motion.frame_time = std::move(written.frame_time);
  Clip copy;
  settleRoles(settled(motion.clip, copy), file.string(), options, motion);
  if (isPerson(motion)) rootAtHips(motion.clip, motion.roles);
  motion.up = settleUp(motion, settled(motion.clip, copy), options.up);
  turnUpright(motion.up.value, motion.clip);
  const Clip& seen = settled(motion.clip, copy);
  const StepRhythm rhythm = isPerson(motion) ? stepRhythm(seen, motion.roles) : StepRhythm();
  motion.metres_per_unit = settleUnit(motion, seen, rhythm, options.metres_per_unit);
  scaleToMetres(motion.metres_per_unit.value, motion.clip);
  append(written.warnings, motion);
  if (!options.take.empty())
    motion.warnings.push_back("'" + options.take + "' is not looked for: its format has no takes");
  return motion;
}

/// What is left once a clip is in World.
CapturedMotion finished(CapturedMotion motion, const MotionReadOptions& options) {
  motion.facing = {0.0, true, true, "unknown: no person"};
  if (isPerson(motion)) motion.facing = settleFacing(motion.roles, options.facing, motion.clip);
  if (!motion.metres_per_unit.sure) {
    motion.warnings.push_back("unit " + motion.metres_per_unit.text);
  }
  if (!motion.up.sure) motion.warnings.push_back("vertical axis " + motion.up.text);
  if (!motion.facing.sure) motion.warnings.push_back("facing " + motion.facing.text);
  if (isPerson(motion)) append(captureWarnings(motion.clip, motion.roles), motion);
  return motion;
}

}  // namespace

bool isMotionFile(const std::filesystem::path& file) {
  const std::string ending = lowerEnding(file);
  return file == "-" || ending == ".bvh" || ending == ".amc" || isNodeFile(file);
}

std::optional<CapturedMotion> readMotionIfAny(const std::filesystem::path& file,
                                              const MotionReadOptions& options) {
  if (!isNodeFile(file)) return finished(readTexts(file, options), options);
  std::optional<CapturedMotion> motion = readNodes(file, options);
  if (!motion) return {};
  return finished(std::move(*motion), options);
}

CapturedMotion readMotion(const std::filesystem::path& file, const MotionReadOptions& options) {
  std::optional<CapturedMotion> motion = readMotionIfAny(file, options);
  if (!motion) {
    throw InputError(file.string(), 0, "holds no animation",
                     "animation of a skeleton as FBX, glTF, GLB, VRMA or DAE");
  }
  return std::move(*motion);
}

}  // namespace amble
