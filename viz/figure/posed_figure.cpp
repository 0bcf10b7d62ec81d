#include "viz/figure/posed_figure.h"

namespace amble {

using Eigen::Vector3f;

PosedFigure poseFigure(const Figure& figure, const std::vector<JointFrame>& frames) {
  std::vector<Eigen::Isometry3f> carry(frames.size());
  for (size_t j = 0; j < frames.size(); ++j) {
    const Eigen::Quaterniond turn = frames[j].q_WJ * figure.bind[j].q_WJ.conjugate();
    carry[j].linear() = turn.cast<float>().toRotationMatrix();
    carry[j].translation() = (frames[j].p_WJ - turn * figure.bind[j].p_WJ).cast<float>();
    carry[j].makeAffine();
  }
  PosedFigure posed;
  posed.vertices.assign(figure.vertices.size(), Vector3f::Zero());
  posed.normals.assign(figure.vertices.size(), Vector3f::Zero());
  for (size_t i = 0; i < figure.vertices.size(); ++i) {
    for (int k = 0; k < 4; ++k) {
      const float weight = figure.weights[i][k];
      if (weight == 0.0F) continue;
      const Eigen::Isometry3f& X = carry[figure.joints[i][k]];
      posed.vertices[i] += weight * (X * figure.vertices[i]);
      posed.normals[i] += weight * (X.linear() * figure.normals[i]);
    }
    posed.normals[i].normalize();
  }
  return posed;
}

}  // namespace amble
