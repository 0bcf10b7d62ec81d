#include "animation/preparation/prepare_again.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>
#include <utility>

#include "animation/library/motion_library_reader.h"
#include "animation/preparation/library_soles.h"
#include "base/error.h"
#include "base/rotation.h"

namespace amble {
namespace {

// A cycle prepared once more may differ in the last digits that the file keeps.
constexpr double kSame = 1e-4;

std::filesystem::path captureIn(const LibraryCaptures& captures, const std::string& clip) {
  for (const std::filesystem::path& folder : captures.folders) {
    if (std::filesystem::exists(folder / clip)) return folder / clip;
  }
  return captures.folders.front() / clip;
}

MotionRequest requestOf(const Motion& motion, const LibraryCaptures& captures) {
  MotionRequest request;
  request.name = motion.name;
  request.kind = motion.kind;
  if (motion.kind == MotionKind::kWalk) request.turning = motion.turning;
  request.style = motion.style;
  request.harmonics = motion.cycle.series.harmonics();
  request.chains = motion.chains;
  request.valid = motion.valid;
  request.source = motion.source;
  request.file = captureIn(captures, motion.source.clip);
  request.read = captures.read;
  const std::array<int, 2>& frames = motion.source.within.value_or(motion.source.frames);
  const bool all_told = isPose(motion.kind) || motion.kind == MotionKind::kTurnOnSpot;
  if (all_told || motion.source.within) request.frames = {frames[0], frames[1]};
  return request;
}

// The motion, prepared once more on the library's own skeleton.
Motion preparedAgain(const MotionLibrary& library, MotionRequest request,
                     std::vector<std::string>* warnings = nullptr) {
  MotionLibrary again = library;
  again.motions = {*library.find("stand")};  // what captures of other rigs are carried over by
  request.name += " again";
  addMotion(again, request, warnings);
  standOn(library.skeleton, again);  // not on the soles of that walk alone
  return again.motions.back();
}

// A library's first capture borrows the stance of the default one where it has none of its own.
Motion standBorrowedAgain(const MotionLibrary& library, const LibraryCaptures& captures) {
  MotionLibrary again = library;
  again.motions.clear();
  addMotion(again, requestOf(library.motions.at(1), captures));
  standOn(library.skeleton, again);
  return *again.find("stand");
}

bool differ(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  return a.rows() != b.rows() || a.cols() != b.cols() ||
         (a.size() > 0 && (a - b).cwiseAbs().maxCoeff() > kSame);
}

bool differ(const std::vector<Eigen::Quaterniond>& a, const std::vector<Eigen::Quaterniond>& b) {
  const auto off = [](const auto& p, const auto& q) { return p.angularDistance(q) > kSame; };
  return a.size() != b.size() || !std::equal(a.begin(), a.end(), b.begin(), std::not_fn(off));
}

// In one line why the motion is not what the library says; empty where it is.
std::string difference(const Motion& says, const Motion& is) {
  const auto off = [](double a, double b) {
    return std::abs(a - b) > kSame * std::max(1.0, std::abs(b));
  };
  const WalkCycle &a = says.cycle, &b = is.cycle;
  if (off(a.speed, b.speed)) return fmt::format("speed {:.4f}, measured {:.4f}", a.speed, b.speed);
  if (off(a.turn_rate, b.turn_rate)) {
    return fmt::format("turn rate {:.2f}, measured {:.2f} degrees/s", a.turn_rate / kDegree,
                       b.turn_rate / kDegree);
  }
  if (off(a.period, b.period))
    return fmt::format("period {:.4f}, measured {:.4f}", a.period, b.period);
  if (differ(a.series.alpha, b.series.alpha) || differ(a.series.beta, b.series.beta))
    return "another cycle";
  if (off(says.posture.root_height, is.posture.root_height) ||
      differ(says.posture.rotations, is.posture.rotations))
    return "another posture";
  if (off(says.transition.acceleration, is.transition.acceleration)) return "another transition";
  if (differ(says.transition.sequence.spline, is.transition.sequence.spline))
    return "another sequence of the transition";
  if (off(says.turn.angle, is.turn.angle)) {
    return fmt::format("turns by {:.1f}, measured {:.1f} degrees", says.turn.angle / kDegree,
                       is.turn.angle / kDegree);
  }
  if (differ(says.turn.spline, is.turn.spline) || differ(says.turn.turned, is.turn.turned))
    return "another sequence of the turn";
  return "";
}

bool mayHaveBorrowed(const MotionLibrary& library, const Motion& motion) {
  return motion.name == "stand" && library.motions.size() > 1 &&
         &motion == &library.motions.front() && library.file != motionLibraryFile("default");
}

// In one line what is wrong with what was prepared again; empty where nothing is.
std::string problemOf(const Motion& motion, const std::function<Motion()>& again) {
  try {
    return difference(motion, again());
  } catch (const InputError& error) {
    return error.what();
  }
}

// As the motion was asked for, as far as its capture tells: harmonics that are as many as would be
// chosen are chosen anew, and a turn that would be found is looked for.
MotionRequest askedFor(const MotionLibrary& library, const Motion& motion,
                       const LibraryCaptures& captures) {
  const MotionRequest told = requestOf(motion, captures);
  if (!std::filesystem::exists(told.file)) {
    throw InputError(told.file.string(), 0,
                     "is not there: " + motion.name +
                         " of the library was made with a borrowed stand, and has to be made again",
                     "the clip there, or --captures DIR, its folder");
  }
  MotionRequest open = told;
  open.harmonics = 0;
  if (motion.kind == MotionKind::kTurnOnSpot && !motion.source.within) open.frames.reset();
  std::string problem;
  for (const MotionRequest& request : {open, told}) {
    problem = problemOf(motion, [&] { return preparedAgain(library, request); });
    if (problem.empty()) return request;
  }
  throw InputError(told.file.string(), 0,
                   "does not give " + motion.name + " of the library again: " + problem,
                   "the clip and the options that it was made with");
}

}  // namespace

std::string problemOf(const MotionLibrary& library, const Motion& motion,
                      const LibraryCaptures& captures) {
  const std::string problem =
      problemOf(motion, [&] { return preparedAgain(library, requestOf(motion, captures)); });
  if (problem.empty() || !mayHaveBorrowed(library, motion)) return problem;
  MotionLibrary begun = library;
  return problemOf(motion, [&] {
    begun.motions.front() = standBorrowedAgain(library, captures);
    if (hasBorrowedStand(library)) return begun.motions.front();
    return preparedAgain(begun, requestOf(motion, captures));
  });
}

bool hasBorrowedStand(const MotionLibrary& library) {
  const Motion* const stand = library.find("stand");
  if (stand == nullptr) return false;
  const MotionLibrary other = openMotionLibrary("default");
  const auto all = [](const MotionSource& source) {
    return std::tie(source.clip, source.frames, source.mirrored, source.licence, source.credit);
  };
  return all(stand->source) == all(other.find("stand")->source);
}

void replaceStand(MotionLibrary& library, const MotionRequest& request,
                  const LibraryCaptures& captures, std::vector<std::string>* warnings) {
  MotionLibrary fresh = library;
  fresh.motions = {preparedAgain(library, request, warnings)};
  fresh.motions.front().name = request.name;
  for (const Motion& motion : library.motions) {
    if (motion.name != request.name) addMotion(fresh, askedFor(library, motion, captures));
  }
  library = std::move(fresh);
}

}  // namespace amble
