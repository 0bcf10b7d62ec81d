#include "animation/preparation/foot_cycle_fit.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "animation/preparation/bone_pitch.h"
#include "animation/preparation/swing_fit.h"
#include "base/ease.h"
#include "base/error.h"
#include "base/rotation.h"

namespace amble {
namespace {

constexpr int kPitchPasses = 2;  // of a mean of neighbours: captures shake
// Captured soles slide before they rest and before they leave, which detectors count to a plant,
// and ours do not: they rest so much later and leave so much earlier [cycles].
constexpr double kSlides = 0.01;

// The swing's two plants: the one it leaves and the one it comes to.
struct Swing {
  Plant from, to;
};

std::optional<Swing> swingWithin(const GaitTrack& track, Side side, double begin, double end) {
  const std::vector<Plant>& plants = track.plants(side);
  const double slides = kSlides * (end - begin);
  const auto between = [&](Plant from, Plant to) {
    for (Plant* plant : {&from, &to}) plant->strike += slides, plant->lift_off -= slides;
    return Swing{from, to};
  };
  for (size_t i = 0; i + 1 < plants.size(); ++i) {
    if (plants[i].lift_off >= begin && plants[i].lift_off < end)
      return between(plants[i], plants[i + 1]);
  }
  // Its lift-off lies a little before the cycle: take the swing that ends within.
  for (size_t i = 0; i + 1 < plants.size(); ++i) {
    if (plants[i + 1].strike >= begin && plants[i + 1].strike < end) {
      return between(plants[i], plants[i + 1]);
    }
  }
  return std::nullopt;
}

// What a captured swing is at one time, relative to its two footprints.
struct SwingSample {
  double progress, height, sideways;
  double length;  // from print to print [m]
  double yaw, roll;
  double down;  // of the bone to the toe joint, as seen from beside
};

// Of a sole against a heading: the turn about z, and the roll. Feet that have just left point
// straight down, and beyond: there a turn about z and a roll are the same, and the first is taken.
Eigen::Vector2d yawRoll(const Eigen::Quaterniond& q_WS, double heading) {
  constexpr double kSteep = 60.0 * kDegree, kOver = 20.0 * kDegree;
  const Eigen::Quaterniond q = aboutZ(-heading) * q_WS;
  const Eigen::Vector3d ahead = q * Eigen::Vector3d::UnitX(), left = q * Eigen::Vector3d::UnitY();
  const double steep = smoothstep((std::abs(std::atan2(-ahead.z(), ahead.x())) - kSteep) / kOver);
  const double across = std::atan2(-left.x(), left.y());
  if (steep >= 1.0) return {across, 0.0};
  const Eigen::Vector3d turned = toEuler(q, {'Z', 'Y', 'X'});
  return {turned[0] + steep * wrapAngle(across - turned[0]), (1.0 - steep) * turned[2]};
}

class SwingView {
 public:
  SwingView(const GaitTrack& track, Side side, const FootShape& shape, const Swing& swing,
            bool own_soles)
      : track_(track),
        side_(side),
        shape_(shape),
        swing_(swing),
        from_(track.flatFoot(side, swing.from)),
        to_(track.flatFoot(side, swing.to)),
        from_drop_(own_soles ? flatDrop(shape) : track.standingDrop(side, swing.from)),
        to_drop_(own_soles ? flatDrop(shape) : track.standingDrop(side, swing.to)) {}

  SwingSample at(double tau) const {
    const double frame = swing_.from.lift_off + tau * (swing_.to.strike - swing_.from.lift_off);
    const Eigen::Quaterniond q =
        track_.sole(side_, frame, from_.correction.slerp(tau, to_.correction));
    const double heading = from_.heading + smoothstep(tau) * wrapAngle(to_.heading - from_.heading);
    const Eigen::Vector2d turned = yawRoll(q, heading);
    const double down = seenDown(track_.footBone(side_, frame), heading) + flatDrop(shape_) -
                        from_drop_ - tau * (to_drop_ - from_drop_);
    const double pitch = pitchOfBone(down, turned[0], turned[1], shape_);
    const Eigen::Vector3d sole =
        track_.ankle(side_, frame) - aboutZ(heading + turned[0]) * rolledAnkle(shape_, pitch);
    const Eigen::Vector2d line = (to_.print - from_.print).head<2>();
    const Eigen::Vector2d gone = (sole - from_.print).head<2>();
    SwingSample sample;
    sample.progress = gone.dot(line) / line.squaredNorm();
    sample.sideways = (line.x() * gone.y() - line.y() * gone.x()) / line.norm();
    sample.length = line.norm();
    sample.height = sole.z() - from_.print.z() - tau * (to_.print.z() - from_.print.z());
    sample.yaw = turned[0], sample.roll = turned[1], sample.down = down;
    return sample;
  }

  // Pitch while the foot stands on the print that it leaves, or on the one it comes to [rad].
  double stancePitch(bool from, double x) const {
    const Plant& plant = from ? swing_.from : swing_.to;
    const double frame = plant.strike + x * (plant.lift_off - plant.strike);
    return seenDown(track_.footBone(side_, frame), (from ? from_ : to_).heading) -
           (from ? from_drop_ : to_drop_);
  }

 private:
  const GaitTrack& track_;
  Side side_;
  const FootShape& shape_;
  Swing swing_;
  GaitTrack::FlatFoot from_, to_;
  double from_drop_, to_drop_;  // of the bone to the toe joint where the soles are flat [rad]
};

// Pitch over stance and swing, sampled and a little smoothed (captures shake).
std::vector<double> pitchSamples(const SwingView& view, const FootShape& shape,
                                 const FootCycle& foot) {
  std::vector<double> raw;
  constexpr int kStance = FootCycle::kStanceSamples, kSwing = FootCycle::kSwingSamples;
  for (int i = 0; i < kStance; ++i) {
    const double x = static_cast<double>(i) / kStance;
    // Strike as it comes out of the swing, lift-off as it goes in.
    raw.push_back(view.stancePitch(x >= FootCycle::kFlat, x));
  }
  for (int i = 0; i < kSwing; ++i) {
    const double tau = static_cast<double>(i) / kSwing;
    raw.push_back(pitchOfBone(view.at(tau).down, swingPolynomial(foot.yaw, tau),
                              swingPolynomial(foot.roll, tau), shape));
  }
  const int n = static_cast<int>(raw.size());
  std::vector<double> smooth(n);
  for (int pass = 0; pass < kPitchPasses; ++pass) {
    for (int i = 0; i < n; ++i)
      smooth[i] = 0.25 * raw[(i + n - 1) % n] + 0.5 * raw[i] + 0.25 * raw[(i + 1) % n];
    raw = smooth;
  }
  // About the heel until it is flat, about the ball from then on.
  for (int i = 0; i < kStance; ++i) {
    const double x = static_cast<double>(i) / kStance;
    if (x < FootCycle::kFlat + FootCycle::kFlatFor) smooth[i] = std::min(smooth[i], 0.0);
    if (x > FootCycle::kFlat - FootCycle::kFlatFor) smooth[i] = std::max(smooth[i], 0.0);
  }
  return smooth;
}

}  // namespace

FootCycle fitSwing(const GaitTrack& track, Side side, const FootShape& shape, const Plant& from,
                   const Plant& to, bool own_soles) {
  const SwingView view(track, side, shape, {from, to}, own_soles);
  FootCycle foot;
  const SwingSample last = view.at(1.0);
  foot.slip = std::max(0.0, (1.0 - last.progress) * last.length);
  // Captured feet slip before they leave and after they land, ours stay: the fit, which is at rest
  // on the prints, catches up with the captured foot as soon as it can.
  std::vector<double> progress, height, sideways, roll, yaw;
  for (int i = 0; i < kSwingPoints; ++i) {
    const double tau = static_cast<double>(i) / (kSwingPoints - 1);
    const SwingSample sample = view.at(tau);
    progress.push_back(sample.progress + 0.5 * foot.slip / sample.length - smoothstep(tau));
    height.push_back(sample.height);
    sideways.push_back(sample.sideways);
    yaw.push_back(sample.yaw);
    roll.push_back(sample.roll);
  }
  foot.sideways = fitStray(sideways);
  foot.roll = fitStray(roll);
  foot.yaw = fitStray(yaw);
  foot.pitch = pitchSamples(view, shape, foot);
  foot.progress = fitProgress(progress);
  foot.height = fitSwingHeight(shape, foot, height);
  return foot;
}

FootCycle fitFootCycle(const GaitTrack& track, Side side, const FootShape& shape, double begin,
                       double end, const std::string& clip) {
  const std::optional<Swing> found = swingWithin(track, side, begin, end);
  if (!found) {
    throw InputError(
        clip, 0, "no whole swing of the " + std::string(side == kLeft ? "left" : "right") + " foot",
        "each foot planted before and after the cycle");
  }
  FootCycle foot = fitSwing(track, side, shape, found->from, found->to, true);
  const double period = end - begin;
  const auto phase = [&](double frame) {
    const double p = (frame - begin) / period;
    return p - std::floor(p);
  };
  foot.strike = phase(found->to.strike);
  foot.lift_off = phase(found->from.lift_off);
  return foot;
}

FootCycle fitFootCycle(const GaitTrack& track, Side side, const FootShape& shape,
                       const Stretch& stretch, const std::string& clip) {
  FootCycle foot = fitFootCycle(track, side, shape, stretch.begin, stretch.end, clip);
  if (stretch.leading == kLeft) return foot;
  foot.strike = std::fmod(foot.strike + 0.5, 1.0);
  foot.lift_off = std::fmod(foot.lift_off + 0.5, 1.0);
  return foot;
}

bool hasSwing(const GaitTrack& track, Side side, double begin, double end) {
  return swingWithin(track, side, begin, end).has_value();
}

FootPlacing measurePlacing(const GaitTrack& track, double begin, const FittedPath& path,
                           Side leading) {
  FootPlacing placing;
  std::array<Eigen::Vector2d, 2> print;  // as seen from the path
  std::array<double, 2> height = {0.0, 0.0};
  for (const Side side : {kLeft, kRight}) {
    for (const Plant& plant : track.plants(side)) {
      if (plant.strike > begin + (side == leading ? 1.0 : 0.0) || plant.lift_off < begin - 1.0)
        continue;
      const GaitTrack::FlatFoot flat = track.flatFoot(side, plant);
      height[side] = flat.print.z();
      const double u = side == leading ? 0.25 : -0.25;  // half of a step is a quarter of a cycle
      print[side] = path.seen(flat.print.head<2>(), u);
      placing.toe_out[side] = wrapAngle(flat.heading - path.headingAt(u));
      const double length = plant.lift_off - plant.strike;
      const Eigen::Vector3d mean = track.ankle(side, plant.strike + 0.5 * length);
      for (double x = 0.25; x <= 0.75; x += 0.05) {
        const Eigen::Vector3d d3 = track.ankle(side, plant.strike + x * length) - mean;
        placing.slide = std::max(placing.slide, d3.head<2>().norm());
      }
    }
  }
  placing.width = print[kLeft].y() - print[kRight].y();
  placing.left = 0.5 * (print[kLeft].y() + print[kRight].y());
  placing.height = 0.5 * (height[kLeft] + height[kRight]);
  placing.forward = {print[kLeft].x(), print[kRight].x()};
  return placing;
}

}  // namespace amble
