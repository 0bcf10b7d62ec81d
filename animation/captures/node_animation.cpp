#include "animation/captures/node_animation.h"

#include <algorithm>
#include <cmath>

#include "animation/captures/capture_file.h"
#include "base/error.h"
#include "base/rotation.h"

namespace amble {
namespace {

// Files keep numbers in single precision, along a chain of joints: less than that is no movement of
// a joint in its parent [m].
constexpr double kStillJoint = 5e-5;

// A transform whose axes are alike in length and at right angles to that share is a rotation and a
// scale [1].
constexpr double kUniformScale = 1e-6;

// A limb: a chain of so many joints. Fewer above which all else hangs are no hips.
constexpr int kLimbHeight = 3;

// Keys that lie evenly to that share of their distance are a file's frames [1].
constexpr double kEven = 0.02;

constexpr double kUsualFrameTime = 1.0 / 30.0;  // of uneven or sparse keys [s]

// Keys farther apart are not frames, but what movement goes on between [s].
constexpr double kSparse = 1.0 / 20.0;

constexpr double kMaxTime = 1e6;  // a key beyond that is no animation's [s]

// Of steps: a key whose time is that of a frame but for its 24 bits is not of the next frame. Of
// the time between two keys [1].
constexpr double kReached = 0.99;

/// Index of the key that is held at `t`, `part` of the way from key i to the next.
size_t heldKey(size_t i, double part) { return part > kReached ? i + 1 : i; }

/// Index of the key before `t`, and how far between it and the next `t` is [0, 1].
std::pair<size_t, double> placeIn(const std::vector<double>& times, double t) {
  const auto next = std::upper_bound(times.begin(), times.end(), t);
  if (next == times.begin()) return {0, 0.0};
  const size_t i = static_cast<size_t>(next - times.begin()) - 1;
  if (next == times.end()) return {i, 0.0};
  const double span = times[i + 1] - times[i];
  return {i, span > 0.0 ? (t - times[i]) / span : 0.0};
}

/// Hermite's spline from one value to the next, `part` of the time between them, with the slopes
/// there times that time.
template <typename V>
V hermite(const V& from, const V& out, const V& to, const V& in, double part) {
  const double p2 = part * part, p3 = p2 * part;
  return (2.0 * p3 - 3.0 * p2 + 1.0) * from + (p3 - 2.0 * p2 + part) * out +
         (3.0 * p2 - 2.0 * p3) * to + (p3 - p2) * in;
}

Eigen::Vector3d valueAt(const KeyTrack<Eigen::Vector3d>& track, double t,
                        const Eigen::Vector3d& otherwise) {
  if (track.times.empty()) return otherwise;
  const auto [i, part] = placeIn(track.times, t);
  if (track.shape == KeyShape::kStep) return track.values[heldKey(i, part)];
  if (part == 0.0) return track.values[i];
  const double span = track.times[i + 1] - track.times[i];
  if (track.shape == KeyShape::kCubic) {
    return hermite<Eigen::Vector3d>(track.values[i], span * track.out[i], track.values[i + 1],
                                    span * track.in[i + 1], part);
  }
  return (1.0 - part) * track.values[i] + part * track.values[i + 1];
}

Eigen::Quaterniond valueAt(const KeyTrack<Eigen::Quaterniond>& track, double t) {
  if (track.times.empty()) return Eigen::Quaterniond::Identity();
  const auto [i, part] = placeIn(track.times, t);
  if (track.shape == KeyShape::kStep) return track.values[heldKey(i, part)].normalized();
  if (part == 0.0) return track.values[i].normalized();
  const double span = track.times[i + 1] - track.times[i];
  if (track.shape == KeyShape::kCubic) {
    return Eigen::Quaterniond(hermite<Eigen::Vector4d>(track.values[i].coeffs(),
                                                       span * track.out[i].coeffs(),
                                                       track.values[i + 1].coeffs(),
                                                       span * track.in[i + 1].coeffs(), part))
        .normalized();
  }
  return track.values[i].slerp(part, track.values[i + 1]);
}

/// The nearest rotation; of a mirrored transform that of its mirror image.
Eigen::Quaterniond rotationOf(const Eigen::Affine3d& X) {
  const Eigen::Matrix3d& L = X.linear();
  const double square = L.squaredNorm() / 3.0;
  const bool uniform =
      (L.transpose() * L - square * Eigen::Matrix3d::Identity()).norm() < kUniformScale * square;
  if (uniform && L.determinant() > 0.0) {
    return Eigen::Quaterniond(Eigen::Matrix3d(L / std::sqrt(square))).normalized();
  }
  Eigen::JacobiSVD<Eigen::Matrix3d> svd(X.linear(), Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix3d R = svd.matrixU() * svd.matrixV().transpose();
  if (R.determinant() < 0.0) R = -R;
  return Eigen::Quaterniond(R).normalized();
}

bool finiteSlope(const Eigen::Vector3d& slope) {
  return slope.allFinite() && slope.cwiseAbs().maxCoeff() <= kMaxCaptureNumber;
}
bool finiteSlope(const Eigen::Quaterniond& slope) {
  return slope.coeffs().allFinite() && slope.coeffs().cwiseAbs().maxCoeff() <= kMaxCaptureNumber;
}

class NodeSampler {
 public:
  NodeSampler(const AnimatedNodes& scene, const std::string& file) : scene_(scene), file_(file) {}
  Clip sample(std::optional<double> frame_time);

 private:
  void requireGoodTracks() const;
  template <typename T>
  void requireGoodTrack(const KeyTrack<T>& track, const std::string& node) const;
  void findJoints();
  void findWanted();
  int findRoot() const;
  void placeNodes(std::optional<double> t, std::vector<Eigen::Affine3d>& X_WN) const;
  int frameCount(double begin, double end, double frame_time) const;
  std::vector<Joint> restJoints();
  std::pair<double, double> timeSpan() const;
  double keyDistance() const;
  double ownFrameTime() const;
  template <typename Visit>
  void visitTimes(Visit visit) const;
  void requirePlace(const Eigen::Affine3d& X_WN, int node) const;
  void setPose(int frame, const std::vector<Eigen::Affine3d>& X_WN, Clip& clip);

  const AnimatedNodes& scene_;
  const std::string& file_;
  std::vector<int> above_;                     // by node: the node above it that is no helper; -1
  std::vector<bool> wanted_;                   // by node: a joint, or above one
  std::vector<bool> placed_;                   // by node: a joint or above one
  std::vector<int> nodes_;                     // by joint: its node
  std::vector<int> joints_;                    // by node: its joint, or -1
  std::vector<int> parents_;                   // by joint
  std::vector<Eigen::Quaterniond> q_restW_J_;  // by joint: the node's rotation in World at rest
};

template <typename T>
void NodeSampler::requireGoodTrack(const KeyTrack<T>& track, const std::string& node) const {
  double last = -kMaxTime;
  for (size_t i = 0; i < track.times.size(); ++i) {
    bool good = track.times[i] >= last && track.times[i] <= kMaxTime;
    if constexpr (std::is_same_v<T, Eigen::Vector3d>) {
      good = good && track.values[i].allFinite() &&
             track.values[i].cwiseAbs().maxCoeff() <= kMaxCaptureNumber;
    } else {
      good = good && track.values[i].coeffs().allFinite() && track.values[i].norm() > 0.5;
    }
    if (good && track.shape == KeyShape::kCubic) {
      good = finiteSlope(track.in[i]) && finiteSlope(track.out[i]);
    }
    if (!good) {
      throw InputError(file_, 0, "key " + std::to_string(i) + " of '" + node + "' is none",
                       "ascending times, finite values");
    }
    last = track.times[i];
  }
}

void NodeSampler::requireGoodTracks() const {
  for (const AnimatedNode& node : scene_.nodes) {
    requireGoodTrack(node.tracks.translations, node.name);
    requireGoodTrack(node.tracks.rotations, node.name);
    requireGoodTrack(node.tracks.scales, node.name);
    if (!node.X_PN.matrix().allFinite() ||
        node.X_PN.matrix().cwiseAbs().maxCoeff() > kMaxCaptureNumber) {
      throw InputError(file_, 0, "the transform of '" + node.name + "' is not finite",
                       "finite numbers");
    }
  }
}

/// Nodes that move, and those between them. A helper's movement is that of the node it belongs to.
void NodeSampler::findWanted() {
  const size_t count = scene_.nodes.size();
  above_.assign(count, -1);
  wanted_.assign(count, false);
  std::vector<bool> below_moving(count, false);
  for (size_t n = 0; n < count; ++n) {
    const AnimatedNode& node = scene_.nodes[n];
    const int parent = node.parent;
    const bool below_helper = parent >= 0 && scene_.nodes[parent].helper;
    above_[n] = below_helper ? above_[parent] : parent;
    wanted_[n] = node.bone || !node.tracks.empty() || (below_helper && wanted_[parent]);
    below_moving[n] = parent >= 0 && (wanted_[parent] || below_moving[parent]);
  }
  for (size_t n = count; n-- > 0;) {
    const int above = above_[n];
    if (above >= 0 && wanted_[n] && !scene_.nodes[n].helper && below_moving[above]) {
      wanted_[above] = true;
    }
  }
}

/// The joint at which the largest tree of wanted nodes branches into limbs.
int NodeSampler::findRoot() const {
  const size_t count = scene_.nodes.size();
  std::vector<int> size(count, 0), height(count, 0);
  std::vector<std::vector<int>> limbs(count);  // children that are limbs, the last first
  int root = -1;
  for (size_t n = count; n-- > 0;) {
    if (!wanted_[n] || scene_.nodes[n].helper) continue;
    size[n] += 1;
    height[n] += 1;
    const int above = above_[n];
    if (above < 0 || !wanted_[above]) {
      if (root < 0 || size[n] >= size[root]) root = static_cast<int>(n);
      continue;
    }
    size[above] += size[n];
    height[above] = std::max(height[above], height[n]);
    if (height[n] >= kLimbHeight) limbs[above].push_back(static_cast<int>(n));
  }
  while (root >= 0 && limbs[root].size() == 1) root = limbs[root][0];
  return root;
}

void NodeSampler::findJoints() {
  findWanted();
  const int root = findRoot();
  if (root < 0) throw InputError(file_, 0, "holds no animation", "animated nodes of a skeleton");
  const size_t count = scene_.nodes.size();
  joints_.assign(count, -1);
  placed_.assign(count, false);
  for (size_t n = root; n < count; ++n) {
    const int above = static_cast<int>(n) == root ? -1 : above_[n];
    const bool hangs = static_cast<int>(n) == root || (above >= 0 && joints_[above] >= 0);
    if (!wanted_[n] || scene_.nodes[n].helper || !hangs) continue;
    if (nodes_.size() >= static_cast<size_t>(kMaxJoints)) {
      throw InputError(file_, 0, "too many joints", "at most 10,000");
    }
    joints_[n] = static_cast<int>(nodes_.size());
    parents_.push_back(above < 0 ? -1 : joints_[above]);
    nodes_.push_back(static_cast<int>(n));
    for (int p = static_cast<int>(n); p >= 0 && !placed_[p]; p = scene_.nodes[p].parent) {
      placed_[p] = true;
    }
  }
}

/// At rest without a time.
void NodeSampler::placeNodes(std::optional<double> t, std::vector<Eigen::Affine3d>& X_WN) const {
  X_WN.resize(scene_.nodes.size());
  for (size_t n = 0; n < scene_.nodes.size(); ++n) {
    if (t && !placed_[n]) continue;
    const AnimatedNode& node = scene_.nodes[n];
    Eigen::Affine3d X_PN = node.X_PN;
    if (t && !node.tracks.empty()) {
      X_PN = Eigen::Translation3d(valueAt(node.tracks.translations, *t, Eigen::Vector3d::Zero())) *
             valueAt(node.tracks.rotations, *t) *
             Eigen::Scaling(valueAt(node.tracks.scales, *t, Eigen::Vector3d::Ones()));
    }
    X_WN[n] = (node.parent < 0 ? scene_.X_WFile : X_WN[node.parent]) * X_PN;
  }
}

std::vector<Joint> NodeSampler::restJoints() {
  std::vector<Eigen::Affine3d> X_WN;
  placeNodes({}, X_WN);
  const Eigen::Quaterniond to_file = yUpToWorld().conjugate();
  std::vector<Joint> joints(nodes_.size());
  for (size_t j = 0; j < joints.size(); ++j) {
    const Eigen::Affine3d& X = X_WN[nodes_[j]];
    requirePlace(X, nodes_[j]);
    joints[j].name = scene_.nodes[nodes_[j]].name;
    joints[j].parent = parents_[j];
    if (parents_[j] >= 0) {
      joints[j].offset = to_file * (X.translation() - X_WN[nodes_[parents_[j]]].translation());
    }
    q_restW_J_.push_back(rotationOf(X));
  }
  for (size_t n = 0; n < scene_.nodes.size(); ++n) {
    const AnimatedNode& node = scene_.nodes[n];
    const int joint = above_[n] >= 0 ? joints_[above_[n]] : -1;
    if (joint < 0 || joints_[n] >= 0 || node.helper || node.thing) continue;
    requirePlace(X_WN[n], static_cast<int>(n));
    joints[joint].end_sites.push_back(to_file *
                                      (X_WN[n].translation() - X_WN[nodes_[joint]].translation()));
  }
  return joints;
}

template <typename Visit>
void NodeSampler::visitTimes(Visit visit) const {
  for (size_t n = 0; n < scene_.nodes.size(); ++n) {
    const NodeTracks& tracks = scene_.nodes[n].tracks;
    if (!placed_[n]) continue;
    for (const auto* times :
         {&tracks.translations.times, &tracks.rotations.times, &tracks.scales.times}) {
      if (!times->empty()) visit(*times);
    }
  }
}

/// First and last key; of tracks that do change, if there are such: others have one anywhere [s].
std::pair<double, double> NodeSampler::timeSpan() const {
  for (const size_t keys : {size_t{2}, size_t{1}}) {
    std::pair<double, double> span = {kMaxTime, -kMaxTime};
    visitTimes([&span, keys](const std::vector<double>& times) {
      if (times.size() < keys) return;
      span = {std::min(span.first, times.front()), std::max(span.second, times.back())};
    });
    if (span.second >= span.first) return span;
  }
  throw InputError(file_, 0, "holds no animation", "animated nodes of a skeleton");
}

/// The distance of the keys where most of them lie, if that is even; 0 where it is not.
double NodeSampler::keyDistance() const {
  const std::vector<double>* most = nullptr;
  visitTimes([&most](const std::vector<double>& times) {
    if (most == nullptr || times.size() > most->size()) most = &times;
  });
  if (most == nullptr || most->size() < 3) return 0.0;
  const double mean = (most->back() - most->front()) / static_cast<double>(most->size() - 1);
  for (size_t i = 1; i < most->size(); ++i) {
    if (std::abs((*most)[i] - (*most)[i - 1] - mean) > kEven * mean) return 0.0;
  }
  return mean;
}

/// The file's frames, or its keys; between sparse keys so many more that every key is a frame.
double NodeSampler::ownFrameTime() const {
  const double own = scene_.frame_time > 0.0 ? scene_.frame_time : keyDistance();
  if (!(own >= kMinFrameTime)) return kUsualFrameTime;
  return own > kSparse ? own / std::ceil(own / kUsualFrameTime - kEven) : own;
}

/// Good numbers may still multiply to none.
void NodeSampler::requirePlace(const Eigen::Affine3d& X_WN, int node) const {
  if (X_WN.matrix().allFinite() && X_WN.matrix().cwiseAbs().maxCoeff() <= kMaxCaptureNumber) return;
  throw InputError(file_, 0, "'" + scene_.nodes[node].name + "' is nowhere", "places within 1e9 m");
}

void NodeSampler::setPose(int frame, const std::vector<Eigen::Affine3d>& X_WN, Clip& clip) {
  const size_t joints = nodes_.size();
  std::vector<Eigen::Quaterniond> q_WJ(joints);
  const std::span<Eigen::Quaterniond> q = clip.poses.rotations(frame);
  for (size_t j = 0; j < joints; ++j) {
    const Eigen::Affine3d& X = X_WN[nodes_[j]];
    requirePlace(X, nodes_[j]);
    q_WJ[j] = rotationOf(X) * q_restW_J_[j].conjugate() * yUpToWorld();
    const int parent = parents_[j];
    if (parent < 0) {
      q[j] = q_WJ[j].normalized();
      clip.poses.p_WR(frame) = X.translation();
      clip.joint_positions.push_back(Eigen::Vector3d::Zero());
      continue;
    }
    q[j] = (q_WJ[parent].conjugate() * q_WJ[j]).normalized();
    clip.joint_positions.push_back(q_WJ[parent].conjugate() *
                                   (X.translation() - X_WN[nodes_[parent]].translation()));
  }
}

/// Half a frame is rounded up: a last key just short of a frame is that frame's.
int NodeSampler::frameCount(double begin, double end, double frame_time) const {
  const double frames = std::floor((end - begin) / frame_time + 0.5) + 1.0;
  const auto placed = static_cast<double>(std::count(placed_.begin(), placed_.end(), true));
  if (!(frames * static_cast<double>(nodes_.size()) <= static_cast<double>(kMaxSampledPoses)) ||
      !(frames * placed <= static_cast<double>(kMaxPlacedNodes))) {
    throw InputError(file_, 0, "too long an animation for so many joints",
                     "at most 10 million poses of joints");
  }
  return static_cast<int>(frames);
}

Clip NodeSampler::sample(std::optional<double> frame_time) {
  requireGoodTracks();
  findJoints();
  std::vector<Joint> joints = restJoints();
  const auto [begin, end] = timeSpan();
  Clip clip;
  clip.name = file_;
  clip.frame_time = frame_time.value_or(ownFrameTime());
  clip.poses = PoseArray(static_cast<int>(joints.size()));
  clip.poses.resize(frameCount(begin, end, clip.frame_time));
  clip.joint_positions.reserve(joints.size() * clip.poses.size());
  std::vector<Eigen::Affine3d> X_WN;
  for (int i = 0; i < clip.frames(); ++i) {
    placeNodes(begin + i * clip.frame_time, X_WN);
    setPose(i, X_WN, clip);
  }
  settleOffsets(1.0, joints, clip.joint_positions, kStillJoint);
  clip.skeleton = Skeleton(std::move(joints));
  return clip;
}

/// Largest distance of a track's values from its first.
double turnOf(const KeyTrack<Eigen::Quaterniond>& track) {
  double most = 0.0;
  for (const Eigen::Quaterniond& q : track.values) {
    most = std::max(most, track.values[0].angularDistance(q));
  }
  return most;
}
double wayOf(const KeyTrack<Eigen::Vector3d>& track) {
  double most = 0.0;
  for (const Eigen::Vector3d& p : track.values) most = std::max(most, (track.values[0] - p).norm());
  return most;
}

}  // namespace

double movementIn(const NodeTake& take) {
  double turns = 0.0, ways = 0.0, longest = 0.0;
  for (const NodeTracks& tracks : take.tracks) {
    turns += turnOf(tracks.rotations);
    ways += wayOf(tracks.translations);
    for (const Eigen::Vector3d& p : tracks.translations.values) {
      longest = std::max(longest, p.norm());
    }
  }
  return turns + (longest > 0.0 ? ways / longest : 0.0);
}

Clip clipOfNodes(const AnimatedNodes& scene, const std::string& file,
                 std::optional<double> frame_time) {
  return NodeSampler(scene, file).sample(frame_time);
}

}  // namespace amble
