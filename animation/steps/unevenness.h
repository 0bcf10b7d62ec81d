/// Which differences of height are what to a foot: rounding, a rug, uneven ground, a step. From the
/// lowest to the highest; what is taken for one thing here is taken for it everywhere.
#pragma once

namespace amble {

struct Unevenness {
  /// Normals as near to the vertical are vertical: rounding of a mesh's normals, which would make a
  /// level floor uneven [1].
  static constexpr double kVertical = 1e-9;
  /// What sticks out of a sole's plane by less is pressed flat: half of the penetration that
  /// QUALITY.md allows [m].
  static constexpr double kPressed = 0.0025;
  /// Heights within so much of a print's plane are its plane: more, and a foot does not rise over a
  /// cable; less, and it rises over a floor's own triangles [m].
  static constexpr double kSame = 0.005;
  /// What the captured swing clears by itself: things no higher over the line between prints are
  /// not looked at [m].
  static constexpr double kCleared = 0.006;
  /// Ground this uneven under a sole is still one surface: the sole lies in its mean plane, and the
  /// print's own ground may rise through it by so much [m].
  static constexpr double kUneven = 0.008;
  /// Ground so far below a flat sole still supports it: rugs and seams are stood across. More, and
  /// feet are planted on kerbs' edges [m].
  static constexpr double kStraddled = 0.012;
  /// Prints within so much of the stance's height are level with it: over rugs and thresholds the
  /// walk of the level goes on, its hips without a bob [m].
  static constexpr double kLevel = 0.03;
  /// A lower step up or down is unevenness, not a step: it shortens nothing, and costs nothing [m].
  static constexpr double kLeastStep = 0.04;
  /// Feet of a stance stand no higher one over the other than this, beside what the slope gives:
  /// walks through a stance on a stair would not join [m].
  static constexpr double kStance = 0.05;
  /// A higher step than this is looked for, not just taken where the speed's own steps fall [m].
  static constexpr double kNatural = 0.06;
  /// What ends within so much above a sole is in its way; what goes on higher is a wall, which is
  /// for the collision check [m].
  static constexpr double kInTheWay = 0.35;
};

}  // namespace amble
