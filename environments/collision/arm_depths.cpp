#include "environments/collision/arm_depths.h"

#include <algorithm>
#include <cmath>

#include "environments/collision/segment_distance.h"

namespace amble {
namespace {

// Parts by name: a limb or the trunk may be of several capsules.
std::vector<int> partsOf(const Body& body, const std::string& name) {
  std::vector<int> parts;
  for (size_t i = 0; i < body.parts.size(); ++i) {
    if (body.parts[i].name == name) parts.push_back(static_cast<int>(i));
  }
  return parts;
}

struct PlacedBody {
  std::vector<JointFrame> joints;
  std::vector<Eigen::Vector3d> from, to;
};

double depthOf(const Body& body, const PlacedBody& placed, const std::vector<int>& some,
               const std::vector<int>& others) {
  double deepest = -kNoDepth;
  for (const int a : some) {
    for (const int b : others) {
      const Segment axis{placed.from[a], placed.to[a]}, other{placed.from[b], placed.to[b]};
      const double distance = std::sqrt(squaredDistance(axis, other));
      deepest = std::max(deepest, body.parts[a].radius + body.parts[b].radius - distance);
    }
  }
  return deepest;
}

}  // namespace

const std::vector<std::pair<std::string, std::string>>& armPairs() {
  static const std::vector<std::pair<std::string, std::string>> kPairs = [] {
    std::vector<std::pair<std::string, std::string>> pairs;
    for (const std::string side : {"left ", "right "}) {
      const std::string across = side == "left " ? "right " : "left ";
      for (const std::string part : {"hand", "forearm"}) {
        for (const char* const other : {"head", "chest", "abdomen", "pelvis", "left thigh",
                                        "right thigh", "left shank", "right shank"}) {
          pairs.emplace_back(side + part, other);
        }
        for (const std::string other : {"hand", "forearm", "upper arm"})
          pairs.emplace_back(side + part, across + other);
      }
    }
    return pairs;
  }();
  return kPairs;
}

Eigen::MatrixXd armDepths(const Body& body, const Clip& clip, int first, int last) {
  const auto& pairs = armPairs();
  std::vector<std::pair<std::vector<int>, std::vector<int>>> parts;
  for (const auto& [part, other] : pairs)
    parts.emplace_back(partsOf(body, part), partsOf(body, other));
  PlacedBody placed{std::vector<JointFrame>(clip.skeleton.size()),
                    std::vector<Eigen::Vector3d>(body.parts.size()),
                    std::vector<Eigen::Vector3d>(body.parts.size())};
  Eigen::MatrixXd depths(last - first + 1, static_cast<Eigen::Index>(pairs.size()));
  for (int i = first; i <= last; ++i) {
    forwardKinematics(clip, i, placed.joints);
    placeBody(body, placed.joints, placed.from, placed.to);
    for (size_t k = 0; k < parts.size(); ++k) {
      depths(i - first, static_cast<Eigen::Index>(k)) =
          depthOf(body, placed, parts[k].first, parts[k].second);
    }
  }
  return depths;
}

Eigen::VectorXd deepest(const Eigen::MatrixXd& depths) {
  if (depths.rows() == 0) return Eigen::VectorXd::Zero(depths.cols());
  return depths.colwise().maxCoeff().transpose().cwiseMax(0.0);
}

}  // namespace amble
