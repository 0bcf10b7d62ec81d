#include "app/library_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "animation/library/motion_library_reader.h"
#include "animation/preparation/library_soles.h"
#include "animation/preparation/motion_library_add.h"
#include "app/say.h"
#include "base/error.h"
#include "base/rotation.h"

namespace amble {
namespace {

struct LibraryCheckArguments {
  std::string library = "default", captures;
};

// A cycle prepared once more may differ in the last digits that the file keeps.
constexpr double kSame = 1e-4;

MotionRequest requestOf(const Motion& motion, const std::filesystem::path& captures) {
  MotionRequest request;
  request.name = motion.name + " again";
  request.kind = motion.kind;
  if (motion.kind == MotionKind::kWalk) request.turning = motion.turning;
  request.harmonics = motion.cycle.series.harmonics();
  request.chains = motion.chains;
  request.valid = motion.valid;
  request.source = motion.source;
  request.file = captures / motion.source.clip;
  if (motion.kind == MotionKind::kPosture || motion.kind == MotionKind::kBlocking ||
      motion.kind == MotionKind::kTurnOnSpot) {
    request.frames = {motion.source.frames[0], motion.source.frames[1]};
  }
  return request;
}

// What the motion measures, prepared once more from its capture, on the library's own skeleton.
Motion preparedAgain(const MotionLibrary& library, const Motion& motion,
                     const std::filesystem::path& captures) {
  MotionLibrary again = library;
  again.motions = {*library.find("stand")};  // what captures of other rigs are carried over by
  addMotion(again, requestOf(motion, captures));
  standOn(library.skeleton, again);  // not on the soles of that walk alone
  return again.motions.back();
}

// A library's first capture borrows the stance of the default one where it has none of its own.
Motion standBorrowedAgain(const MotionLibrary& library, const std::filesystem::path& captures) {
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

std::string facts(const Motion& motion) {
  if (motion.kind != MotionKind::kWalk && motion.kind != MotionKind::kMovement) return "";
  return fmt::format(
      "{:.2f} m/s {:+.0f} degrees/s, closes to {:.0f} mm, leaves out {:.2f} degrees, "
      "feet slide {:.0f} mm",
      motion.cycle.speed, motion.cycle.turn_rate / kDegree, 1000.0 * motion.cycle.closure,
      motion.cycle.residual / kDegree, 1000.0 * motion.cycle.slide);
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

// In one line what is wrong with the motion; empty where it is what its capture gives.
std::string problemOf(const MotionLibrary& library, const Motion& motion,
                      const std::filesystem::path& captures) {
  const std::string problem =
      problemOf(motion, [&] { return preparedAgain(library, motion, captures); });
  if (problem.empty() || !mayHaveBorrowed(library, motion)) return problem;
  const std::string borrowed =
      problemOf(motion, [&] { return standBorrowedAgain(library, captures); });
  return borrowed.empty() ? "" : problem;
}

int run(const LibraryCheckArguments& options) {
  const MotionLibrary library = readMotionLibrary(motionLibraryFile(options.library));
  int wrong = 0;
  for (const Motion& motion : library.motions) {
    const std::string problem =
        options.captures.empty() ? "" : problemOf(library, motion, options.captures);
    if (!problem.empty()) ++wrong;
    say(stdout, "{:<6} {:<26} {:<12} {}\n", problem.empty() ? "ok" : "WRONG", motion.name,
        motionKindNames()[static_cast<size_t>(motion.kind)],
        problem.empty() ? facts(motion) : problem);
  }
  if (const MotionLack lack = whatItLacks(library); !lack.problem.empty()) {
    ++wrong;
    say(stdout, "WRONG  {}; expected {}\n", lack.problem, lack.expected);
  }
  say(stdout, "{} motions, {} wrong{}\n", library.motions.size(), wrong,
      options.captures.empty() ? "; captures were not read: give --captures DIR" : "");
  return wrong == 0 ? kExitDone : kExitNone;
}

}  // namespace

void addLibraryCheck(CLI::App& library, Command& chosen) {
  const auto options = std::make_shared<LibraryCheckArguments>();
  CLI::App* command =
      library.add_subcommand("check", "Check a library, and its motions against their captures");
  command->add_option("LIBRARY", options->library, "default, or a file")
      ->type_name("FILE")
      ->capture_default_str();
  command
      ->add_option("--captures", options->captures,
                   "Folder of the clips: prepare every motion again and compare")
      ->type_name("DIR");
  addExamples(*command, {"amble library check default"});
  addExitStatus(*command, "all hold", "some do not");
  command->callback([options, &chosen] { chosen = [options] { return run(*options); }; });
}

}  // namespace amble
