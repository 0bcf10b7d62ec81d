#include "viz/figure/skin_weights.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace amble {

using Eigen::Vector3d;

namespace {

constexpr int kRounds = 4;  // of evening out: by eye, at bent knees and raised arms

using Shares = std::map<int, double>;  // by joint

class Weigher {
 public:
  Weigher(const std::vector<LoftGroup>& groups, const Skeleton& skeleton, double reach)
      : groups_(groups), reach_(reach) {
    std::set<int> used;
    for (const LoftGroup& group : groups)
      for (const Loft& loft : group.lofts) used.insert(loft.joints.begin(), loft.joints.end());
    for (const int joint : used) {
      int above = skeleton.joint(joint).parent;
      while (above >= 0 && !used.contains(above)) above = skeleton.joint(above).parent;
      if (above < 0) continue;
      linked_.insert({joint, above});
      linked_.insert({above, joint});
    }
    // Joints of one loft belong together, wherever they hang.
    for (const LoftGroup& group : groups)
      for (const Loft& loft : group.lofts) {
        linked_.insert({loft.joints[0], loft.joints[1]});
        linked_.insert({loft.joints[1], loft.joints[0]});
      }
  }

  Shares at(const Vector3d& p) const {
    std::vector<std::pair<const Loft*, LoftDistance>> all;
    for (const LoftGroup& group : groups_)
      for (const Loft& loft : group.lofts) all.emplace_back(&loft, distanceTo(loft, p));
    const auto nearest = std::min_element(all.begin(), all.end(), [](const auto& a, const auto& b) {
      return a.second.distance < b.second.distance;
    });
    const int own = nearest->first->joints[nearest->second.along < 0.5 ? 0 : 1];
    Shares shares;
    for (const auto& [loft, there] : all) {
      const double farther = (there.distance - nearest->second.distance) / reach_;
      const double share = std::exp(-2.0 * farther);
      if (share < 1e-3) continue;
      const double s = there.along * there.along * (3.0 - 2.0 * there.along);
      give(shares, own, loft->joints[0], share * (1.0 - s));
      give(shares, own, loft->joints[1], share * s);
    }
    return shares;
  }

 private:
  // Of several lofts of one joint the nearest counts.
  void give(Shares& shares, int own, int joint, double share) const {
    if (joint != own && !linked_.contains({own, joint})) return;
    double& known = shares[joint];
    known = std::max(known, share);
  }

  const std::vector<LoftGroup>& groups_;
  const double reach_;
  std::set<std::pair<int, int>> linked_;
};

void scaleToOne(Shares& shares) {
  double sum = 0.0;
  for (const auto& [joint, share] : shares) sum += share;
  for (auto& [joint, share] : shares) share /= sum;
}

std::vector<Shares> evenedOut(const std::vector<Shares>& shares,
                              const std::vector<std::vector<int>>& neighbours) {
  std::vector<Shares> evened(shares.size());
  for (size_t v = 0; v < shares.size(); ++v) {
    for (const auto& [joint, share] : shares[v]) evened[v][joint] += share;
    const double each =
        neighbours[v].empty() ? 0.0 : 1.0 / static_cast<double>(neighbours[v].size());
    for (const int w : neighbours[v])
      for (const auto& [joint, share] : shares[w]) evened[v][joint] += each * share;
    scaleToOne(evened[v]);
  }
  return evened;
}

}  // namespace

SkinWeights skinWeights(const TriangleMesh& mesh, const std::vector<LoftGroup>& groups,
                        const Skeleton& skeleton, double reach) {
  const Weigher weigher(groups, skeleton, reach);
  std::vector<Shares> shares;
  for (const Vector3d& p : mesh.vertices) {
    shares.push_back(weigher.at(p));
    scaleToOne(shares.back());
  }
  std::vector<std::vector<int>> neighbours(mesh.vertices.size());
  for (const auto& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) neighbours[t[i]].push_back(t[(i + 1) % 3]);
  for (int round = 0; round < kRounds; ++round) shares = evenedOut(shares, neighbours);
  SkinWeights out;
  for (const Shares& all : shares) {
    std::vector<std::pair<double, int>> most;
    for (const auto& [joint, share] : all) most.emplace_back(-share, joint);
    std::sort(most.begin(), most.end());
    most.resize(4, {0.0, most.front().second});
    double sum = 0.0;
    for (const auto& [share, joint] : most) sum -= share;
    std::array<std::uint16_t, 4> joints{};
    std::array<float, 4> weights{};
    for (int k = 0; k < 4; ++k) {
      weights[k] = static_cast<float>(-most[k].first / sum);
      joints[k] = weights[k] > 0.0F ? static_cast<std::uint16_t>(most[k].second) : 0;
    }
    out.joints.push_back(joints);
    out.weights.push_back(weights);
  }
  return out;
}

}  // namespace amble
