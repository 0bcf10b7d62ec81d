#include "animation/captures/capture_file.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "base/error.h"
#include "base/rotation.h"

namespace amble {
namespace {

/// What the first bytes say of the encoding; null where it is text in bytes.
const char* wideEncoding(std::string_view text) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) return "UTF-16";
  const bool wide = text.size() > 1 && (text[0] == '\0') != (text[1] == '\0');
  return wide ? "UTF-16 without its mark" : nullptr;
}

}  // namespace

std::string lowerEnding(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

std::string_view plainText(std::string_view text, const std::string& name, std::string& mended,
                           std::vector<std::string>& warnings) {
  if (const char* const encoding = wideEncoding(text)) {
    throw InputError(name, 1, std::string("the text is ") + encoding, "ASCII or UTF-8");
  }
  const size_t last = text.find_last_not_of(std::string_view("\0\x1A\r\n", 4));
  const size_t begin = last == text.npos ? 0 : last + 1;
  size_t end = text.size();
  for (const auto& [byte, what] : {std::pair{'\0', "a NUL"}, std::pair{'\x1A', "a Ctrl-Z"}}) {
    const size_t at = text.find(byte, begin);
    if (at == text.npos) continue;
    end = std::min(end, at);
    warnings.push_back(std::string(what) + " behind the last line is passed over");
  }
  text = text.substr(0, end);
  const size_t first_end = text.find_first_of("\r\n");
  if (first_end == text.npos || text.find('\n', first_end) != text.npos) return text;
  mended = text;
  std::replace(mended.begin(), mended.end(), '\r', '\n');
  warnings.push_back("lines end in CR alone, as on old Macs");
  return mended;
}

void turnUpright(UpAxis up, Clip& clip) {
  if (up == UpAxis::kZ) return;
  for (int i = 0; i < clip.frames(); ++i) {
    clip.poses.p_WR(i) = fileToWorld(clip.poses.p_WR(i), up);
    Eigen::Quaterniond& q_WR = clip.poses.rotations(i)[0];
    q_WR = yUpToWorld() * q_WR;
  }
}

void scaleToMetres(double metres_per_unit, Clip& clip) {
  for (int i = 0; i < clip.frames(); ++i) clip.poses.p_WR(i) *= metres_per_unit;
  for (Eigen::Vector3d& p : clip.joint_positions) p *= metres_per_unit;
  std::vector<Joint> joints = clip.skeleton.joints();
  settleOffsets(metres_per_unit, joints, clip.joint_positions);
  for (Joint& joint : joints) {
    joint.offset *= metres_per_unit;
    for (Eigen::Vector3d& tip : joint.end_sites) tip *= metres_per_unit;
  }
  clip.skeleton = Skeleton(std::move(joints));
}

void settleOffsets(double metres_per_unit, std::vector<Joint>& joints_in_file_units,
                   std::vector<Eigen::Vector3d>& joint_positions, double tolerance) {
  if (joint_positions.empty()) return;
  const size_t joints = joints_in_file_units.size();
  std::vector<bool> moves(joints, false);
  for (size_t i = joints; i < joint_positions.size(); ++i) {
    const Eigen::Vector3d change = joint_positions[i] - joint_positions[i % joints];
    if (change.cwiseAbs().maxCoeff() > tolerance) moves[i % joints] = true;
  }
  for (size_t j = 1; j < joints; ++j) {
    if (!moves[j]) joints_in_file_units[j].offset = joint_positions[j] / metres_per_unit;
  }
  if (std::find(moves.begin(), moves.end(), true) == moves.end()) joint_positions = {};
}

}  // namespace amble
