#include "animation/steps/speed_profile.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/ease.h"
#include "base/parts.h"

namespace amble {
namespace {

// Speed against the wanted one when steps are `stretch` times the wanted ones. A walk whose steps
// give way by a few percent keeps its speed and changes its cadence; steps much shorter change
// both, as short steps are slow ones. Longer ones do not: nobody is asked to walk faster because a
// stretch comes out as so many steps.
double pace(double stretch) {
  const double u = std::min(std::log(stretch), 0.0);
  return std::exp(1.5 * u * u * u / (u * u + StepFit::kSteady * StepFit::kSteady));
}

// Where f, that falls smoothly from f_low to f_high, is 0: secants that keep it between them (the
// Illinois method), to rounding.
template <typename Function>
double rootWithin(const Function& f, double low, double f_low, double high, double f_high) {
  constexpr int kMostSteps = 50;
  constexpr double kRounding = 1e-14;
  double root = f_low == 0.0 ? low : high, before = 0.0;  // f at the last root
  for (int i = 0; i < kMostSteps && f_low > 0.0 && f_high < 0.0; ++i) {
    const double next = high - f_high * (high - low) / (f_high - f_low);
    const bool settled = std::abs(next - root) < kRounding;
    root = next;
    if (settled) break;
    const double value = f(root);
    if (value == 0.0) break;
    if (value > 0.0) {
      low = root, f_low = value;
      if (before > 0.0) f_high *= 0.5;
    } else {
      high = root, f_high = value;
      if (before < 0.0) f_low *= 0.5;
    }
    before = value;
  }
  return root;
}

}  // namespace

BesideStanding::BesideStanding(const StrideLaw& law, bool from_stands, bool to_stands) {
  const auto step = [&](bool stands, double speed) {
    return Step{speed, stands ? 0.5 * law.stepLength(speed) : -HUGE_VAL};
  };
  first_ = step(from_stands, law.onset().first_speed);
  last_ = step(to_stands, law.onset().last_speed);
}

SpeedProfile::SpeedProfile(const RootPath& path, const SpeedLimits& limits,
                           const SpeedProfileEnds& ends)
    : limits_(limits), ends_(ends), length_(path.length()) {
  if (!(length_ > StepFit::kShortestPath)) {
    refusal_ = Refusal::kStepLength;
    return;
  }
  usual_step_ = limits_.law.stepLength(limits_.speed);
  limitSpeed(path);
  if (refusal_ == Refusal::kNone) chooseSteps();
  if (refusal_ == Refusal::kNone) time();
}

// On the straight, on its ground.
double SpeedProfile::allowedSpeed(double arc) const {
  const double speed =
      limits_.stride ? limits_.speed * limits_.stride(arc) / usual_step_ : limits_.speed;
  return limits_.pace ? speed * limits_.pace(arc) : speed;
}

// The path at evenly spaced knots, each asked once.
class SpeedProfile::PathKnots {
 public:
  PathKnots(const RootPath& path, int count, bool turns)
      : path_(path), spacing_(path.length() / count), curvature_(count + 1, -1.0) {
    if (turns) headings_.resize(count + 1);
  }

  double spacing() const { return spacing_; }
  /// Without its sign [1/m].
  double curvature(int i) {
    if (curvature_[i] >= 0.0) return curvature_[i];
    double curvature = 0.0;
    if (headings_.empty()) {
      curvature = path_.curvatureAt(spacing_ * i);
    } else {
      const RootPath::Sample on = path_.at(spacing_ * i);
      headings_[i] = on.heading;
      curvature = on.curvature;
    }
    return curvature_[i] = std::abs(curvature);
  }
  /// Of all knots, once their curvatures were asked for; empty where they are not needed [rad].
  const std::vector<double>& headings() const { return headings_; }

 private:
  const RootPath& path_;
  double spacing_;
  std::vector<double> curvature_, headings_;
};

// Whether a walk turns too fast beside a stance that walks, for certain: it would have to be slower
// there than the stance is, however it slows down. By knots from the stance on, as far as that may
// be so.
bool SpeedProfile::turnsTooFastBeside(bool at_end, int count, PathKnots& path) const {
  constexpr double kSure = 1e-4;  // against rounding and limitSpeed's tolerance [1]
  const double wanted = allowedSpeed(at_end ? length_ : 0.0) * (1.0 - kSure);
  const double gain = 2.0 * limits_.law.onset().acceleration * path.spacing();
  for (int i = 0; i <= count; ++i) {
    const double least = wanted * wanted - i * gain;
    if (least <= 0.0) return false;
    const double curvature = path.curvature(at_end ? count - i : i);
    const double fastest = limits_.max_turn_rate / std::max(curvature, 1e-9);
    if (fastest * fastest < least) return true;
  }
  return false;
}

// Wanted speed at every knot: the plan's, less in turns, with bounded changes; as step length.
void SpeedProfile::limitSpeed(const RootPath& path) {
  const int count = std::max(8, partsOf(length_, StepFit::kSpacing));
  PathKnots on(path, count, limits_.law.hasTurns() && !limits_.stride);
  for (const bool at_end : {true, false}) {
    const bool stands = at_end ? ends_.to_standing : ends_.from_standing;
    if (stands || !turnsTooFastBeside(at_end, count, on)) continue;
    refusal_ = Refusal::kTurnRate;
    return;
  }
  const double spacing = on.spacing();
  const double fade = std::min(StepFit::kFadeSteps * usual_step_, 0.5 * length_);
  std::vector<double> speed(count + 1);
  knots_.resize(count + 1);
  const BesideStanding beside(limits_.law, ends_.from_standing, ends_.to_standing);
  for (int i = 0; i <= count; ++i) {
    knots_[i].arc = spacing * i;
    speed[i] = std::min(allowedSpeed(knots_[i].arc),
                        limits_.max_turn_rate / std::max(on.curvature(i), 1e-9));
    speed[i] = std::min(speed[i], beside.fastest(knots_[i].arc, length_ - knots_[i].arc));
    knots_[i].window = (ends_.from_standing ? 1.0 : smoothstep(knots_[i].arc / fade)) *
                       (ends_.to_standing ? 1.0 : smoothstep((length_ - knots_[i].arc) / fade));
  }
  const double gain = 2.0 * limits_.law.onset().acceleration * spacing;
  for (int i = 1; i <= count; ++i) {
    speed[i] = std::min(speed[i], std::sqrt(speed[i - 1] * speed[i - 1] + gain));
  }
  for (int i = count - 1; i >= 0; --i) {
    speed[i] = std::min(speed[i], std::sqrt(speed[i + 1] * speed[i + 1] + gain));
  }
  constexpr double kTolerance = 1e-6;
  const double first = allowedSpeed(0.0), last = allowedSpeed(length_);
  if ((!ends_.from_standing && speed.front() < first * (1.0 - kTolerance)) ||
      (!ends_.to_standing && speed.back() < last * (1.0 - kTolerance))) {
    refusal_ = Refusal::kTurnRate;
    return;
  }
  if (!ends_.from_standing) speed.front() = first;
  if (!ends_.to_standing) speed.back() = last;
  for (int i = 0; i <= count; ++i) {
    knots_[i].speed = speed[i];
    if (limits_.stride) {
      knots_[i].wanted = limits_.stride(knots_[i].arc);
    } else {  // most knots are as fast as the one before
      const bool same = i > 0 && speed[i] == speed[i - 1];
      knots_[i].wanted = same ? knots_[i - 1].wanted : limits_.law.stepLength(speed[i]);
    }
  }
  if (!on.headings().empty()) turnSteps(on.headings());
}

// Steps in turns are as captured ones. Headings are those of the path at each knot; turns are
// looked at over a step: where curvature jumps, steps go on smoothly.
void SpeedProfile::turnSteps(const std::vector<double>& headings) {
  const double spacing = knots_[1].arc;
  const int last = static_cast<int>(knots_.size()) - 1;
  for (int i = 0; i <= last; ++i) {
    Knot& knot = knots_[i];
    const int half = std::max(1, static_cast<int>(0.5 * knot.wanted / spacing));
    const int from = std::max(i - half, 0), to = std::min(i + half, last);
    const double rate = (headings[to] - headings[from]) / ((to - from) * spacing) * knot.speed;
    if (rate != 0.0) knot.wanted *= 1.0 + knot.window * (limits_.law.turnedShare(rate) - 1.0);
  }
}

// Steps stretched by `delta` where they may be, and what follows from that.
void SpeedProfile::stretch(double delta) {
  for (Knot& k : knots_) {
    k.step = k.wanted * (1.0 + delta * k.window);
    k.per_metre = 1.0 / k.step;
  }
  knots_[0].steps = 0.0;
  for (size_t i = 1; i < knots_.size(); ++i) {
    const Knot& before = knots_[i - 1];
    knots_[i].steps = before.steps +
                      0.5 * (knots_[i].arc - before.arc) * (before.per_metre + knots_[i].per_metre);
  }
  start_arc_ = ends_.from_standing ? 0.5 * knots_.front().step : 0.0;
  stop_arc_ = ends_.to_standing ? length_ - 0.5 * knots_.back().step : length_;
}

double SpeedProfile::countSteps() const {
  const int standing = (ends_.from_standing ? 1 : 0) + (ends_.to_standing ? 1 : 0);
  if (start_arc_ > stop_arc_) return standing * length_ / (start_arc_ + length_ - stop_arc_);
  return standing + integralAt(stop_arc_, &Knot::steps, &Knot::per_metre) -
         integralAt(start_arc_, &Knot::steps, &Knot::per_metre);
}

// The number of steps that needs the least stretching, and that stretch.
void SpeedProfile::chooseSteps() {
  const double captured = limits_.law.capturedStep();
  stretch(0.0);
  const double natural = countSteps();
  std::array<int, 4> candidates;
  const int first = static_cast<int>(std::floor(natural)) - 1;
  for (int i = 0; i < 4; ++i) candidates[i] = first + i;
  std::stable_sort(candidates.begin(), candidates.end(),
                   [&](int a, int b) { return std::abs(a - natural) < std::abs(b - natural); });
  for (const int n : candidates) {
    if (n < 2 || (ends_.parity && n % 2 != *ends_.parity)) continue;
    const double low = StepFit::kLeastStretch - 1.0, high = StepFit::kMostStretch - 1.0;
    const auto beyond = [&](double delta) {
      stretch(delta);
      return countSteps() - n;
    };
    const double at_low = beyond(low), at_high = beyond(high);
    if (at_low < 0.0 || at_high > 0.0) continue;
    beyond(rootWithin(beyond, low, at_low, high, at_high));
    bool walkable = true;
    for (const Knot& k : knots_) {
      walkable = walkable &&
                 k.step >= StrideLaw::kShortestStep * captured * (1.0 - StepFit::kRounding) &&
                 k.step <= StrideLaw::kLongestStep * captured * (1.0 + StepFit::kRounding);
    }
    if (!walkable) continue;
    steps_ = n;
    return;
  }
  refusal_ = Refusal::kStepLength;
}

// Slowness at every knot such that the whole takes a whole number of frames: cadence gives way by
// less than a frame.
void SpeedProfile::time() {
  std::vector<double> walked(knots_.size());  // speed, stretched steps considered
  double stretched = 0.0, share = 0.0;
  for (size_t i = 0; i < knots_.size(); ++i) {  // most steps are stretched as the one before
    const Knot& k = knots_[i];
    if (i == 0 || k.step / k.wanted != stretched) share = pace(stretched = k.step / k.wanted);
    walked[i] = k.speed * share;
  }
  const auto total = [&](double eta) {
    for (size_t i = 0; i < knots_.size(); ++i)
      knots_[i].slowness = (1.0 + eta * knots_[i].window) / walked[i];
    knots_[0].time = 0.0;
    for (size_t i = 1; i < knots_.size(); ++i) {
      knots_[i].time = knots_[i - 1].time + 0.5 * (knots_[i].arc - knots_[i - 1].arc) *
                                                (knots_[i - 1].slowness + knots_[i].slowness);
    }
    const double first = integralAt(start_arc_, &Knot::time, &Knot::slowness);
    const double last = integralAt(stop_arc_, &Knot::time, &Knot::slowness);
    // Half the speed on average while starting and stopping, of the speed that they join at.
    start_time_ = 2.0 * start_arc_ * valueAt(start_arc_, &Knot::slowness);
    stop_time_ = 2.0 * (length_ - stop_arc_) * valueAt(stop_arc_, &Knot::slowness);
    start_sway_ = limits_.law.onset().start_sway * start_time_;
    stop_sway_ = limits_.law.onset().stop_sway * stop_time_;
    return start_sway_ + start_time_ + (last - first) + stop_time_ + stop_sway_;
  };
  const double natural = total(0.0);
  frames_ = std::max(2, static_cast<int>(std::lround(natural / limits_.frame_time)));
  const double wanted = frames_ * limits_.frame_time;
  const double slope = total(1.0) - natural;  // the total is linear in eta
  total((wanted - natural) / slope);
  steps_before_ = integralAt(start_arc_, &Knot::steps, &Knot::per_metre);
  time_before_ = integralAt(start_arc_, &Knot::time, &Knot::slowness);
}

SpeedProfile::Place SpeedProfile::placeAt(double arc) const {
  const int last = static_cast<int>(knots_.size()) - 2;
  const int i = std::clamp(static_cast<int>(arc / knots_[1].arc), 0, last);
  return {i, arc - knots_[i].arc};
}

// Linear between knots.
double SpeedProfile::valueAt(const Place& at, double Knot::*value) const {
  const Knot &a = knots_[at.knot], &b = knots_[at.knot + 1];
  return a.*value + at.beyond / knots_[1].arc * (b.*value - a.*value);
}

// Integral of a rate up to an arc, cubic between knots.
double SpeedProfile::integralAt(const Place& at, double Knot::*value, double Knot::*rate) const {
  const Knot &a = knots_[at.knot], &b = knots_[at.knot + 1];
  const double h = b.arc - a.arc, t = at.beyond / h;
  const double ra = a.*rate, rb = b.*rate;
  return a.*value + h * t * (ra + 0.5 * t * (rb - ra));  // the rate is linear between knots
}

// Arc at which the integral reaches a value.
double SpeedProfile::arcWhere(double value, double Knot::*integral, double Knot::*rate) const {
  const auto after = std::upper_bound(knots_.begin(), knots_.end(), value,
                                      [&](double v, const Knot& k) { return v < k.*integral; });
  const size_t i =
      std::clamp<size_t>(static_cast<size_t>(after - knots_.begin()), 1, knots_.size() - 1);
  const Knot &a = knots_[i - 1], &b = knots_[i];
  const double h = b.arc - a.arc;
  const double ra = a.*rate, rb = b.*rate;
  // h t (ra + t (rb - ra) / 2) = value: the stable root of a quadratic with positive rates.
  const double q = (value - a.*integral) / h;
  const double root = std::sqrt(std::max(0.0, ra * ra + 2.0 * (rb - ra) * q));
  return a.arc + h * std::clamp(2.0 * q / (ra + root), 0.0, 1.0);
}

double SpeedProfile::arcAtStep(int step) const {
  if (step <= 0) return 0.0;
  if (step >= steps_) return length_;
  return arcWhere(steps_before_ + step - (ends_.from_standing ? 1 : 0), &Knot::steps,
                  &Knot::per_metre);
}

SpeedProfile::Sample SpeedProfile::at(int frame) const {
  const double t = frame * limits_.frame_time - start_sway_;
  const double total = frames_ * limits_.frame_time - start_sway_ - stop_sway_;
  // Who starts or stops shifts his weight for the step that he starts or has stopped with.
  const auto first = [&] { return valueAt(ends_.from_standing ? start_arc_ : 0.0, &Knot::step); };
  const auto last = [&] { return valueAt(ends_.to_standing ? stop_arc_ : length_, &Knot::step); };
  if (frame <= 0 || t < 0.0) {
    return {0.0, ends_.from_standing ? 0.0 : 1.0 / knots_.front().slowness, 0.0, first(),
            start_time_ > 0.0 ? std::min(t, 0.0) / start_time_ : 0.0};
  }
  if (frame >= frames_ || t > total) {
    return {length_, ends_.to_standing ? 0.0 : 1.0 / knots_.back().slowness,
            static_cast<double>(steps_), last(),
            stop_time_ > 0.0 ? std::max(t - total, 0.0) / stop_time_ : 0.0};
  }
  // Starting: speed grows as a smoothstep, so the arc is tau^3 - tau^4 / 2 of twice the distance.
  const auto eased = [](double tau) { return tau * tau * tau * (1.0 - 0.5 * tau); };
  if (t < start_time_) {
    const double tau = t / start_time_, whole = 2.0 * start_arc_;
    return {whole * eased(tau), smoothstep(tau) * whole / start_time_, tau, first()};
  }
  if (t > total - stop_time_) {
    const double tau = (total - t) / stop_time_, whole = 2.0 * (length_ - stop_arc_);
    return {length_ - whole * eased(tau), smoothstep(tau) * whole / stop_time_, steps_ - tau,
            last()};
  }
  const double arc = arcWhere(time_before_ + t - start_time_, &Knot::time, &Knot::slowness);
  const Place on = placeAt(arc);
  const double progress = integralAt(on, &Knot::steps, &Knot::per_metre) - steps_before_ +
                          (ends_.from_standing ? 1.0 : 0.0);
  return {arc, 1.0 / valueAt(on, &Knot::slowness), progress, valueAt(on, &Knot::step)};
}

}  // namespace amble
