#include "python/arrays.h"

#include <pybind11/numpy.h>

#include "python/text.h"

namespace amble {
namespace {

namespace py = pybind11;

using Lengths = std::vector<py::ssize_t>;  // along each axis

py::array readOnly(py::array array) {
  array.attr("flags").attr("writeable") = false;
  return array;
}

// A view of one field of each of `rows`: the field's own shape is `more`, of dense T.
template <typename T, typename Row>
py::array fieldOf(const std::vector<Row>& rows, const void* first, const Lengths& more,
                  const py::object& owner) {
  Lengths shape = {static_cast<py::ssize_t>(rows.size())};
  Lengths strides = {sizeof(Row)};
  for (const py::ssize_t length : more) {  // one axis at most
    shape.push_back(length);
    strides.push_back(sizeof(T));
  }
  if (rows.empty()) return readOnly(py::array(py::dtype::of<T>(), shape));
  return readOnly(py::array(py::dtype::of<T>(), shape, strides, first, owner));
}

void addSkeleton(py::dict& out, const Skeleton& skeleton, const std::vector<std::string>& names) {
  const py::ssize_t joints = skeleton.size();
  py::array_t<std::int32_t> parents(joints);
  py::array_t<double> offsets(Lengths{joints, 3});
  for (int j = 0; j < skeleton.size(); ++j) {
    parents.mutable_at(j) = skeleton.joint(j).parent;
    for (int k = 0; k < 3; ++k) offsets.mutable_at(j, k) = skeleton.joint(j).offset[k];
  }
  out["joint_names"] = toTexts(names);
  out["parents"] = readOnly(std::move(parents));
  out["offsets"] = readOnly(std::move(offsets));
}

// @param place  puts the joints of a frame in World
template <typename Place>
void addPoses(py::dict& out, const PoseArray& poses, const Place& place, const py::object& owner) {
  const py::ssize_t frames = poses.size(), joints = poses.joints();
  py::array_t<double> turns(Lengths{frames, joints, 4});
  py::array_t<double> places(Lengths{frames, joints, 3});
  double* q = turns.mutable_data();
  double* p = places.mutable_data();
  std::vector<JointFrame> placed(static_cast<size_t>(joints));
  for (int frame = 0; frame < poses.size(); ++frame) {
    for (const Eigen::Quaterniond& turn : poses.rotations(frame))
      for (const double value : {turn.w(), turn.x(), turn.y(), turn.z()}) *q++ = value;
    place(frame, placed);
    for (const JointFrame& joint : placed)
      for (int k = 0; k < 3; ++k) *p++ = joint.p_WJ[k];
  }
  py::array roots = frames == 0 ? py::array(py::dtype::of<double>(), Lengths{0, 3})
                                : py::array(py::dtype::of<double>(), Lengths{frames, 3},
                                            poses.p_WR(0).data(), owner);
  out["root_positions"] = readOnly(std::move(roots));
  out["quaternions"] = readOnly(std::move(turns));
  out["positions"] = readOnly(std::move(places));
}

void addPath(py::dict& out, const std::vector<FrameState>& states, const py::object& owner) {
  const FrameState* const first = states.data();
  out["path_positions"] = fieldOf<double>(states, &first->position, {3}, owner);
  out["path_headings"] = fieldOf<double>(states, &first->heading, {}, owner);
  out["path_speeds"] = fieldOf<double>(states, &first->speed, {}, owner);
  out["path_turn_rates"] = fieldOf<double>(states, &first->turn_rate, {}, owner);
  out["path_arcs"] = fieldOf<double>(states, &first->arc, {}, owner);
  out["phases"] = fieldOf<double>(states, &first->phase, {}, owner);
  out["planted"] = fieldOf<bool>(states, &first->planted, {2}, owner);
}

void addFootprints(py::dict& out, const std::vector<Footprint>& prints, const py::object& owner) {
  static_assert(sizeof(Side) == sizeof(std::int32_t) && sizeof(int) == sizeof(std::int32_t));
  static_assert(offsetof(Footprint, last_frame) == offsetof(Footprint, first_frame) + sizeof(int));
  const Footprint* const first = prints.data();
  out["footprint_sides"] = fieldOf<std::int32_t>(prints, &first->side, {}, owner);
  out["footprint_positions"] = fieldOf<double>(prints, &first->position, {3}, owner);
  out["footprint_headings"] = fieldOf<double>(prints, &first->heading, {}, owner);
  out["footprint_frames"] = fieldOf<std::int32_t>(prints, &first->first_frame, {2}, owner);
}

}  // namespace

py::dict arraysOf(const Clip& clip, const std::vector<std::string>& names,
                  const py::capsule& owner) {
  py::dict out;
  out["frame_time"] = clip.frame_time;
  addSkeleton(out, clip.skeleton, names);
  addPoses(
      out, clip.poses,
      [&](int frame, std::span<JointFrame> placed) { forwardKinematics(clip, frame, placed); },
      owner);
  return out;
}

py::dict arraysOf(const AnimationBuffer& walk, const Skeleton& skeleton,
                  const std::vector<std::string>& names, const py::capsule& owner) {
  py::dict out;
  out["frame_time"] = walk.frame_time;
  addSkeleton(out, skeleton, names);
  addPoses(
      out, walk.poses,
      [&](int frame, std::span<JointFrame> placed) {
        forwardKinematics(skeleton, walk.poses[frame], placed);
      },
      owner);
  addPath(out, walk.states, owner);
  addFootprints(out, walk.footprints, owner);
  return out;
}

py::object plantedArray(const std::vector<bool>& left, const std::vector<bool>& right) {
  py::array_t<bool> planted(Lengths{static_cast<py::ssize_t>(left.size()), 2});
  for (size_t i = 0; i < left.size(); ++i) {
    planted.mutable_at(i, 0) = left[i];
    planted.mutable_at(i, 1) = right[i];
  }
  return readOnly(std::move(planted));
}

py::object numbersArray(const std::vector<double>& numbers) {
  return readOnly(
      py::array_t<double>(Lengths{static_cast<py::ssize_t>(numbers.size())}, numbers.data()));
}

}  // namespace amble
