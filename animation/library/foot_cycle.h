/// How the feet of a captured walk go from print to print and roll: the part of a walk cycle that
/// says where soles are.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace amble {

/// Of a polynomial over a swing: coefficients of tau^0, tau^1, ...
using SwingTerms = std::array<double, 5>;

/// How one foot goes from a footprint to the next, and rolls. tau runs over the swing, 0 at
/// lift-off and 1 at strike.
///
/// The polynomials are kept times tau^2 (1 - tau)^2, so that a swing begins and ends at rest on its
/// footprints: captured feet slide, ours do not.
struct FootCycle {
  double strike = 0.0;    ///< captured phase at which the heel lands [cycles, 0 <= . < 1]
  double lift_off = 0.0;  ///< captured phase at which the toe leaves [cycles, 0 <= . < 1]
  /// How far the captured sole slides on after it has landed [m, 0 to 1]. Ours lands halfway.
  double slip = 0.0;
  /// Progress from print to print beyond 3 tau^2 - 2 tau^3 [1]; height over the line between them
  /// [m]; straying to the left of that line [m]; roll and yaw of the sole against the heading that
  /// turns from print to print [rad]. Coefficients of tau^0, tau^1, ...
  SwingTerms progress = {}, height = {}, sideways = {}, roll = {}, yaw = {};
  /// Pitch of the sole, toes down positive [rad], over one cycle of the foot: kStanceSamples from
  /// strike to lift-off, then kSwingSamples from lift-off to the next strike, where it begins anew.
  /// 0 while the foot is flat.
  std::vector<double> pitch;
  /// How far the toes are rolled over their tips, which stay where they stand while the foot does:
  /// captured feet do so at last before they leave. Coefficients of cubic B-splines, a sample of
  /// the pitch apart, the first around kToesFrom [rad, 0 to pi / 2].
  static constexpr int kToeSplines = 24;
  std::array<double, kToeSplines> toes = {};

  static constexpr int kStanceSamples = 32;
  static constexpr int kSwingSamples = 32;
  /// Here of its stance every foot is flat: its pitch is that of the landing before, that of the
  /// rise after. So long before and after, that a frame shows it.
  static constexpr double kFlat = 0.4, kFlatFor = 0.1;
  static constexpr int kToesFrom = 20;
};

/// Mean of the feet of several cycles; phases by the shorter way around the cycle. @pre one or more
FootCycle meanFoot(const std::vector<FootCycle>& feet);

/// Sum of coefficients[k] tau^k, times tau^2 (1 - tau)^2. @param tau  [0, 1]
inline double swingPolynomial(const SwingTerms& coefficients, double tau) {
  const double window = tau * tau * (1.0 - tau) * (1.0 - tau);
  double sum = 0.0;
  for (std::size_t k = coefficients.size(); k-- > 0;) sum = sum * tau + coefficients[k];
  return window * sum;
}
/// Share of the way from print to print that is done at tau [0, 1].
double swingProgress(const FootCycle& foot, double tau);
/// Pitch at x: 0 to 1 is the stance from strike to lift-off, 1 to 2 the swing [rad]. Smooth, with
/// period 2. @param x  [0, 2]
double footPitch(const FootCycle& foot, double x);
/// FootCycle::toes at x, as of footPitch [rad, >= 0].
double toeRoll(const FootCycle& foot, double x);
/// What the spline of FootCycle::toes[k] is at x [0 to 2/3].
double toeSpline(int k, double x);

}  // namespace amble
