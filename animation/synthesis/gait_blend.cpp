#include "animation/synthesis/gait_blend.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "animation/library/foot_cycle.h"
#include "animation/steps/spot_step.h"

namespace amble {
namespace {

// Rotations do not scale; the root's three lengths do.
Eigen::MatrixXd interleaved(const FourierSeries& series, int harmonics, double scale) {
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(series.channels(), 2 * harmonics + 2);
  for (int k = 0; k <= series.harmonics(); ++k) {
    m.col(2 * k) = series.alpha.col(k);
    m.col(2 * k + 1) = series.beta.col(k);
  }
  m.topRows(3) *= scale;
  return m;
}

// Where one foot of a walk is put down, on average.
PrintPlace meanPrint(const std::vector<const WalkCycle*>& cycles, Side side, double scale) {
  const double share = 1.0 / static_cast<double>(cycles.size());
  PrintPlace mean;
  for (const WalkCycle* cycle : cycles) {
    const double half = (side == kLeft ? 0.5 : -0.5) * cycle->step_width;
    mean.forward += share * cycle->foot_forward[side] * scale;
    mean.left += share * (cycle->prints_left + half) * scale;
    mean.toe_out += share * cycle->toe_out[side];
  }
  return mean;
}

// Cycles in order of `size`, parted where it grows by more than kSamePace from a group's first.
template <typename Size>
std::vector<std::vector<const WalkCycle*>> grouped(std::vector<const WalkCycle*> cycles,
                                                   Size size) {
  std::stable_sort(cycles.begin(), cycles.end(),
                   [&](const WalkCycle* a, const WalkCycle* b) { return size(*a) < size(*b); });
  std::vector<std::vector<const WalkCycle*>> groups;
  for (const WalkCycle* cycle : cycles) {
    if (groups.empty() ||
        size(*cycle) > (1.0 + GaitBlend::kSamePace) * size(*groups.back().front())) {
      groups.emplace_back();
    }
    groups.back().push_back(cycle);
  }
  return groups;
}

// Where `value` lies among growing `at(i)`: the one below and the share of the next; held at the
// ends.
struct Between {
  size_t low = 0;
  double share = 0.0;
};
template <typename At>
Between between(size_t count, At at, double value) {
  if (count < 2 || value <= at(0)) return {0, 0.0};
  for (size_t i = 1; i < count; ++i) {
    if (value < at(i)) return {i - 1, (value - at(i - 1)) / (at(i) - at(i - 1))};
  }
  return {count - 1, 0.0};
}

// Paces stay in one order, so that what a frame is does not depend on those beside it.
void addWeight(LaneBlend& blend, const LanePace& pace, int frame, double weight) {
  int i = 0;
  while (i < blend.count && blend.paces[i].pace < &pace) ++i;
  if (i == blend.count || blend.paces[i].pace != &pace) {
    std::copy_backward(blend.paces + i, blend.paces + blend.count, blend.paces + blend.count + 1);
    blend.paces[i] = {&pace, {}};
    ++blend.count;
  }
  blend.paces[i].weight[frame] = weight;
}

// Harmonics in which turns are otherwise than straight walks: from there on none.
void keepOfTurns(Eigen::MatrixXd& coefficients) {
  const Eigen::Index kept =
      std::min<Eigen::Index>(2 * GaitBlend::kTurnHarmonics + 2, coefficients.cols());
  coefficients.rightCols(coefficients.cols() - kept).setZero();
}

// Amplitudes times `warp`.
Eigen::MatrixXd warped(Eigen::MatrixXd coefficients, double warp) {
  const Eigen::Index amplitudes = coefficients.cols() - 2;
  coefficients.rightCols(amplitudes) *= warp;
  return coefficients;
}

// Of a walk beside standing: no faster than captured steps there, which people take short.
double speedBeside(const Transition& transition) {
  const TransitionSequence& sequence = transition.sequence;
  if (sequence.empty()) return transition.first_speed;
  return std::min(transition.first_speed, 2.0 * sequence.advance / sequence.step_time);
}

FootCycle scaledFoot(FootCycle foot, double scale) {
  for (double& c : foot.height) c *= scale;
  for (double& c : foot.sideways) c *= scale;
  return foot;
}

FootCycle meanFootOf(const std::vector<const WalkCycle*>& cycles, Side side, double scale) {
  std::vector<FootCycle> feet;
  for (const WalkCycle* cycle : cycles) feet.push_back(scaledFoot(cycle->feet[side], scale));
  return meanFoot(feet);
}

FootCycle mixed(const FootCycle& a, const FootCycle& b, double share) {
  FootCycle foot = a;
  const auto mix = [&](double& x, double y) { x += share * (y - x); };
  for (size_t k = 0; k < foot.progress.size(); ++k) {
    mix(foot.progress[k], b.progress[k]);
    mix(foot.height[k], b.height[k]);
    mix(foot.sideways[k], b.sideways[k]);
    mix(foot.roll[k], b.roll[k]);
    mix(foot.yaw[k], b.yaw[k]);
  }
  for (size_t i = 0; i < foot.pitch.size(); ++i) mix(foot.pitch[i], b.pitch[i]);
  return foot;
}

}  // namespace

GaitBlend::GaitBlend(const MotionLibrary& library, double scale, double speed) {
  Cycles straight;
  std::array<Cycles, 2> turns;
  int harmonics = 0;
  for (const Motion& motion : library.motions) {
    if (motion.kind != MotionKind::kWalk) continue;
    harmonics = std::max(harmonics, motion.cycle.series.harmonics());
    Cycles& list = !motion.turning ? straight : turns[motion.cycle.turn_rate > 0.0 ? 0 : 1];
    list.push_back(&motion.cycle);
  }
  if (straight.empty()) throw std::invalid_argument("a motion library without a straight walk");
  const auto groups = grouped(straight, [](const WalkCycle& c) { return c.speed; });
  std::vector<Pace> paces;
  for (const Cycles& cycles : groups) paces.push_back(meanPace(cycles, harmonics, scale));
  fitLaw(paces, scale * library.roles.legLength(library.skeleton, kLeft));
  takeOnset(library, scale);
  mixStraight(paces, groups, scale, speed);
  addSlower(paces, groups, scale);
  for (const Cycles& side : turns) {
    addTurns(grouped(side, [](const WalkCycle& c) { return std::abs(c.turn_rate); }), harmonics,
             scale);
  }
  const bool both = !turns_[0].empty() && !turns_[1].empty();
  layOut();
  joinTransitions(library, scale, speed);
  max_turn_rate_ =
      both ? (1.0 + kSamePace) * std::min(turns_[0].back().turn_rate, -turns_[1].back().turn_rate)
           : kNoTurns;
}

GaitBlend::Pace GaitBlend::meanPace(const Cycles& cycles, int harmonics, double scale) {
  const double share = 1.0 / static_cast<double>(cycles.size());
  Pace pace;
  for (const WalkCycle* cycle : cycles) {
    const Eigen::MatrixXd one = interleaved(cycle->series, harmonics, scale);
    if (pace.coefficients.size() == 0) {
      pace.coefficients = Eigen::MatrixXd::Zero(one.rows(), one.cols());
    }
    pace.coefficients += share * one;
    pace.speed += share * cycle->speed * std::sqrt(scale);
    pace.turn_rate += share * cycle->turn_rate / std::sqrt(scale);
    pace.step += share * cycle->stepLength() * scale;
    pace.supports += share * cycle->doubleSupports();
  }
  return pace;
}

// Least squares of log step over log speed; through the slowest walk's speed.
void GaitBlend::fitLaw(const std::vector<Pace>& paces, double leg_length) {
  const double n = static_cast<double>(paces.size());
  double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const Pace& pace : paces) {
    x += std::log(pace.speed) / n;
    y += std::log(pace.step) / n;
    xx += std::log(pace.speed) * std::log(pace.speed) / n;
    xy += std::log(pace.speed) * std::log(pace.step) / n;
  }
  double power = StrideLaw::kStepPower;
  if (paces.back().speed > kSpreadOfSpeeds * paces.front().speed) {
    power = std::clamp((xy - x * y) / (xx - x * x), kLeastPower, kMostPower);
  }
  const double slowest = paces.front().speed;
  law_ = StrideLaw(slowest, std::exp(y + power * (std::log(slowest) - x)), power);
  std::vector<StrideLaw::Support> supports;
  for (const Pace& pace : paces) supports.push_back({pace.speed, pace.supports});
  law_.setSupports(supports, leg_length);
}

// How walks begin and end: the mean of the library's starts, and of its stops.
void GaitBlend::takeOnset(const MotionLibrary& library, double scale) {
  StrideLaw::Onset onset;
  double acceleration = 0.0;
  int both = 0;
  for (const auto& [kind, speed] : {std::pair(MotionKind::kStart, &onset.first_speed),
                                    std::pair(MotionKind::kStop, &onset.last_speed)}) {
    double sum = 0.0;
    int count = 0;
    for (const Motion& motion : library.motions) {
      if (motion.kind != kind) continue;
      sum += speedBeside(motion.transition) * std::sqrt(scale);
      acceleration += motion.transition.acceleration;
      ++count;
    }
    if (count > 0) *speed = sum / count;
    both += count;
  }
  if (both > 0) onset.acceleration = acceleration / both;
  law_.setOnset(onset);
}

// Channels, feet and their prints at the plan's speed. Cycles are mixed at its step.
void GaitBlend::mixStraight(const std::vector<Pace>& paces, const std::vector<Cycles>& cycles,
                            double scale, double speed) {
  const Between where = between(
      paces.size(), [&](size_t i) { return paces[i].speed; }, speed);
  const size_t high = std::min(where.low + 1, paces.size() - 1);
  straight_.speed = speed;
  straight_.step = law_.stepLength(speed);
  straight_.coefficients =
      Eigen::MatrixXd::Zero(paces[0].coefficients.rows(), paces[0].coefficients.cols());
  for (const auto& [index, share] :
       {std::pair(where.low, 1.0 - where.share), {high, where.share}}) {
    straight_.coefficients +=
        share * warped(paces[index].coefficients, straight_.step / paces[index].step);
    if (share > 0.0) straight_.sources.emplace_back(cycles[index], share);
    const double each = share / static_cast<double>(cycles[index].size());
    for (const WalkCycle* cycle : cycles[index]) {
      step_width_ += each * cycle->step_width * scale;
      const auto& [left, right] = cycle->foot_forward;
      foot_forward_ += each * 0.5 * (left + right) * scale;
      stagger_ += each * 0.5 * (left - right) * scale;
      for (const Side side : {kLeft, kRight}) toe_out_[side] += each * cycle->toe_out[side];
    }
  }
  for (const Side side : {kLeft, kRight}) {
    feet_.walk[side] = mixed(meanFootOf(cycles[where.low], side, scale),
                             meanFootOf(cycles[high], side, scale), where.share);
  }
  feet_.spot = spotStep(scale);
}

// Captured paces below the plan's speed, their prints where the plan's are: around the path's
// points.
void GaitBlend::addSlower(const std::vector<Pace>& paces, const std::vector<Cycles>& cycles,
                          double scale) {
  std::vector<double> speeds;
  for (const Pace& pace : paces) speeds.push_back(pace.speed);
  feet_.departures.setPaces(speeds, straight_.speed);
  for (size_t i = feet_.departures.slower.size(); i-- > 0;) {
    Pace pace = paces[i];
    pace.sources = {{cycles[i], 1.0}};
    OtherFeet& feet = feet_.slower.emplace_back();
    const PrintPlace left = meanPrint(cycles[i], kLeft, scale),
                     right = meanPrint(cycles[i], kRight, scale);
    pace.coefficients(0, 0) -= 0.5 * (left.forward + right.forward) - foot_forward_;
    for (const Side side : {kLeft, kRight}) {
      const double sign = side == kLeft ? 0.5 : -0.5;
      feet.cycles[side] = meanFootOf(cycles[i], side, scale);
      feet.prints[side] = {sign * (left.forward - right.forward), sign * (left.left - right.left),
                           (side == kLeft ? left : right).toe_out};
    }
    Pace replaced = straight_;
    replaced.coefficients -= warped(pace.coefficients, straight_.step / pace.step);
    keepOfTurns(replaced.coefficients);
    slower_.push_back(std::move(pace));
    replaced_.push_back(std::move(replaced));
  }
}

// Captured starts and stops, joined to the straight walk at the speed that they lead to.
void GaitBlend::joinTransitions(const MotionLibrary& library, double scale, double speed) {
  Eigen::VectorXd walk;
  const WalkAt walk_at = [&](double clock, Side side, bool start, std::span<double> channels) {
    const double phase = (side == kLeft ? 0.5 : 0.0) + 0.5 * (start ? clock + 1.0 : 1.0 - clock);
    const double fastest = start ? law_.onset().first_speed : law_.onset().last_speed;
    const double beside = std::min(speed, fastest);
    evaluate(phase - std::floor(phase), 0.0, law_.stepLength(beside), walk,
             feet_.departures.slowerBy(beside));
    std::copy(walk.begin(), walk.end(), channels.begin());
  };
  transitions_ = TransitionBlend(library, scale, speed, walk_at);
  transitions_.addSwings(feet_);
  StrideLaw::Onset onset = law_.onset();
  onset.start_sway = transitions_.startSway();
  onset.stop_sway = transitions_.stopSway();
  law_.setOnset(onset);
}

// What turns add to the straight walk at their step.
void GaitBlend::addTurns(const std::vector<Cycles>& turns, int harmonics, double scale) {
  for (const Cycles& cycles : turns) {
    Pace turn = meanPace(cycles, harmonics, scale);
    turn.sources = {{cycles, 1.0}};
    turn.coefficients -= warped(straight_.coefficients, turn.step / straight_.step);
    keepOfTurns(turn.coefficients);
    const int way = turn.turn_rate > 0.0 ? 0 : 1;
    law_.addTurn(way, {std::abs(turn.turn_rate),
                       turn.step / law_.stepLength(turn.speed),
                       {turn.speed, turn.supports}});
    addTurnFeet(cycles, scale, std::abs(turn.turn_rate), way);
    turns_[way].push_back(std::move(turn));
  }
}

// How those turns put down their feet, and where.
void GaitBlend::addTurnFeet(const Cycles& cycles, double scale, double rate, int way) {
  feet_.departures.turns[way].push_back(rate);
  OtherFeet& feet = feet_.turns[way].emplace_back();
  for (const Side side : {kLeft, kRight}) {
    feet.cycles[side] = meanFootOf(cycles, side, scale);
    feet.prints[side] = meanPrint(cycles, side, scale);
    feet.prints[side].forward -= foot_forward_;  // which the path's points have been moved by
  }
}

// Of which frames are blended: what is left of the straight walk, what turns add to it, slower
// walks, and what turns add more to these.
std::vector<const GaitBlend::Pace*> GaitBlend::allPaces() const {
  std::vector<const Pace*> all = {&straight_};
  for (const std::vector<Pace>* some : {&turns_[0], &turns_[1], &slower_, &replaced_})
    for (const Pace& pace : *some) all.push_back(&pace);
  return all;
}

// Harmonics that a pace has none of are left out.
void GaitBlend::layOut() {
  for (const Pace* pace : allPaces()) {
    int harmonics = static_cast<int>(pace->coefficients.cols()) / 2 - 1;
    while (harmonics > 0 && pace != &straight_ &&
           pace->coefficients.middleCols(2 * harmonics, 2).isZero(0.0))
      --harmonics;
    rows_.emplace_back(channels(), 2 * harmonics + 1);
    rows_.back() << pace->coefficients.col(0), pace->coefficients.middleCols(2, 2 * harmonics);
    paces_.push_back({rows_.back().data(), harmonics, pace->step});
  }
}

// Of all paces, where a walk is so much slower than the plan's and turns at a rate.
void GaitBlend::weigh(double slower, double turn_rate, int frame, LaneBlend& blend) const {
  const WalkShares shares = feet_.departures.at(slower, turn_rate);
  const LanePace* const turns = paces_.data() + 1 + (shares.way == 0 ? 0 : turns_[0].size());
  const LanePace* const slow = paces_.data() + 1 + turns_[0].size() + turns_[1].size();
  const auto add = [&](const LanePace* paces, const CapturedShares& part, double of) {
    if (of * part.of_low > 0.0) addWeight(blend, paces[part.low], frame, of * part.of_low);
    if (of * part.of_next > 0.0) addWeight(blend, paces[part.low + 1], frame, of * part.of_next);
  };
  if (shares.plans > 0.0) addWeight(blend, paces_[0], frame, shares.plans);
  add(turns, shares.turning, 1.0);
  add(slow, shares.slower, 1.0);
  add(slow + slower_.size(), shares.slower, shares.turning.of_low + shares.turning.of_next);
}

std::vector<GaitBlend::Share> GaitBlend::shares(const MotionLibrary& library, double slower,
                                                double turn_rate) const {
  const WalkShares now = feet_.departures.at(slower, turn_rate);
  std::vector<Share> shares;
  const auto add = [&](const Pace& pace, double weight) {
    for (const auto& [cycles, share] : pace.sources) {
      std::vector<std::string> names;
      for (const Motion& motion : library.motions)
        if (std::find(cycles.begin(), cycles.end(), &motion.cycle) != cycles.end())
          names.push_back(motion.name);
      const auto same = std::ranges::find(shares, names, &Share::motions);
      Share& of = same != shares.end() ? *same : shares.emplace_back(Share{names, 0.0});
      of.share += weight * share;
    }
  };
  const auto addAll = [&](const std::vector<Pace>& paces, const CapturedShares& part, double of) {
    for (size_t i = 0; i < paces.size(); ++i) {
      const double own = i == part.low ? part.of_low : i == part.low + 1 ? part.of_next : 0.0;
      add(paces[i], of * own);
    }
  };
  add(straight_, now.straight * now.plans);
  addAll(slower_, now.slower, now.straight);
  for (const int way : {0, 1})
    addAll(turns_[way], way == now.way ? now.turning : CapturedShares{}, 1.0);
  return shares;
}

void GaitBlend::evaluate(const Frames& frames, std::span<double> values) const {
  LaneBlend blend;
  for (int frame = 0; frame < 4; ++frame) {
    blend.phase[frame] = frames.phase[frame];
    blend.step_length[frame] = frames.step_length[frame];
    weigh(frames.slower[frame], frames.turn_rate[frame], frame, blend);
  }
  cycleKernel().blend(blend, channels(), values.data());
}

void GaitBlend::evaluate(double phase, double turn_rate, double step_length,
                         Eigen::VectorXd& channels, double slower) const {
  channels.resize(straight_.coefficients.rows());
  std::vector<double> values(4 * channels.size());
  const auto four = [](double value) { return std::array{value, value, value, value}; };
  evaluate(Frames{four(phase), four(turn_rate), four(step_length), four(slower)}, values);
  channels =
      Eigen::Map<const Eigen::VectorXd, 0, Eigen::InnerStride<4>>(values.data(), channels.size());
}

}  // namespace amble
