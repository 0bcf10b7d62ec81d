#include "animation/captures/capture_file.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iostream>

#include "base/error.h"

namespace amble {
std::string lowerEnding(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

std::string readText(std::istream& in, const std::string& name, const std::string& expected) {
  std::string text;
  // Pieces grow with the text, so that a small file costs little and a large one is not copied
  // often.
  for (size_t piece = 1 << 14; in; piece *= 2) {
    const size_t begin = text.size();
    text.resize(begin + piece);
    in.read(text.data() + begin, static_cast<std::streamsize>(piece));
    text.resize(begin + static_cast<size_t>(in.gcount()));
  }
  if (in.bad()) throw InputError(name, 0, "cannot be read", expected);
  return text;
}

std::string readText(const std::filesystem::path& file, const std::string& expected) {
  if (file == "-") return readText(std::cin, "-", expected);
  std::error_code unknown;
  if (std::filesystem::is_directory(file, unknown)) {
    throw InputError(file.string(), 0, "is a folder", expected);
  }
  std::ifstream in(file, std::ios::binary);
  if (!in) throw InputError(file.string(), 0, "cannot be opened", expected);
  return readText(in, file.string(), expected);
}

Eigen::Vector3d fileToWorld(const Eigen::Vector3d& p_file, UpAxis up) {
  return up == UpAxis::kY ? Eigen::Vector3d(p_file.x(), -p_file.z(), p_file.y()) : p_file;
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
