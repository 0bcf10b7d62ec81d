/// How deep somebody's forearms and hands are in the rest of him: what no capture shows much of,
/// and a motion put together from two may.
#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "animation/body/clip.h"
#include "environments/body/body.h"

namespace amble {

/// What is looked at, the same for every body: a part of an arm (left ones first), and another part
/// that it may get into: head, trunk, thighs, shanks, and the other arm.
const std::vector<std::pair<std::string, std::string>>& armPairs();

/// A row a frame from `first` to `last`, a column a pair: how far the capsules of the one are in
/// those of the other [m]; negative is the room between them, and -kNoDepth where the body has no
/// such parts. @pre 0 <= first, last < frames
Eigen::MatrixXd armDepths(const Body& body, const Clip& clip, int first, int last);
inline constexpr double kNoDepth = 1e3;

/// By pair, the largest of the frames; at least 0 [m].
Eigen::VectorXd deepest(const Eigen::MatrixXd& depths);

}  // namespace amble
