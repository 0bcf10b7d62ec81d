/// Closed surfaces to make furniture of: rounded boxes, lathes, tubes and lofts.
///
/// World axes while modelling (z up, metres): a piece stands on z = 0 around the origin and its
/// front faces -y. Every function here returns closed surfaces, each vertex shared, wound
/// counter-clockwise from outside.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

namespace amble {

/// One or more closed surfaces.
struct Surface {
  std::vector<Eigen::Vector3d> vertices;      ///< [m]
  std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise from outside

  Surface& append(const Surface& other);
  Surface& move(double x, double y, double z);
  /// By `angle_deg` about the axis (0: x, 1: y, 2: z) through the origin [degrees].
  Surface& rotate(int axis, double angle_deg);
  Surface& deform(const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& map);
};

/// A piece of furniture: surfaces by the name of the part (an `o` group of the OBJ file).
struct Furniture {
  std::string name;
  std::vector<std::pair<std::string, Surface>> groups;

  /// Into the group of that name, which is made if it is new.
  void add(const std::string& group, const Surface& surface);
  int triangleCount() const;
};

/// A box centred on the origin whose edges are rounded.
struct RoundedBox {
  Eigen::Vector3d size;   ///< whole lengths [m, > 0]
  double radius = 0.005;  ///< of the edges [m, > 0, < half of each length]
  int arc = 1;            ///< divisions of half a rounded edge [>= 0]; 0 leaves edges sharp
  /// Divisions of the flat between the edges, along x, y, z [>= 1]; more where it is bent
  /// afterwards.
  std::array<int, 3> inner = {1, 1, 1};
};
Surface makeRoundedBox(const RoundedBox& box);

/// Turns the profile (radius, height) about z. It goes up on the outside; where it is not a `ring`
/// it begins and ends on the axis, and where it is one the last point joins the first. `segments`
/// round the axis [>= 3].
Surface makeLathe(const std::vector<Eigen::Vector2d>& profile, int segments, bool ring = false);

/// A smooth curve through the points (Catmull-Rom), `steps` pieces between two of them [>= 1].
std::vector<Eigen::Vector2d> smoothCurve(const std::vector<Eigen::Vector2d>& points, int steps);

/// A round bar along a polyline; radius[i] at path[i] [m, > 0].
Surface makeTube(const std::vector<Eigen::Vector3d>& path, const std::vector<double>& radius,
                 int segments);

/// A straight leg from the floor to `height` that gets thicker upwards and may be splayed.
struct Leg {
  Eigen::Vector2d foot;  ///< where it stands [m]
  Eigen::Vector2d top;   ///< where its upper end is [m]
  double height;         ///< [m, > 0]
  double foot_radius;    ///< [m, > 0]
  double top_radius;     ///< [m, > 0]
  int segments = 12;
};
Surface makeLeg(const Leg& leg);

/// One outline, counter-clockwise from above, as rings: each is moved inwards by `inset` and lifted
/// to `height`, from the lowest centre out and back to the highest: the ends are closed by fans
/// about `centre`.
/// @pre the outline is star-shaped about `centre` and stays so at every inset.
struct LoftRing {
  double inset;   ///< [m]
  double height;  ///< [m]
};
Surface makeLoft(const std::vector<Eigen::Vector2d>& outline, const Eigen::Vector2d& centre,
                 const std::vector<LoftRing>& rings);

/// Rings of a plate from `low` to `high` whose edges are rounded by `bevel` [m].
std::vector<LoftRing> plateRings(double low, double high, double bevel);

/// OBJ, y up (World (x, y, z) is file (x, z, -y)), metres, five decimals, one `o` a group. The same
/// bytes every time.
void writeObj(std::ostream& out, const Furniture& furniture);

}  // namespace amble
