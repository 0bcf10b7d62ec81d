#include "python/walk_arrays.h"

#include <pybind11/numpy.h>

#include <initializer_list>
#include <vector>

#include "python/text.h"

namespace amble {
namespace {

namespace py = pybind11;

py::array readOnly(py::array array) {
  array.attr("flags").attr("writeable") = false;
  return array;
}

// A view of one field of each of `rows`; `more` is the field's own shape, of dense T.
template <typename T, typename Row>
py::array fieldOf(const std::vector<Row>& rows, const void* first, std::vector<py::ssize_t> more,
                  const py::object& owner) {
  std::vector<py::ssize_t> shape = {static_cast<py::ssize_t>(rows.size())};
  std::vector<py::ssize_t> strides = {sizeof(Row)};
  py::ssize_t stride = sizeof(T);
  for (size_t i = more.size(); i-- > 0; stride *= more[i])
    strides.insert(strides.begin() + 1, stride);
  shape.insert(shape.end(), more.begin(), more.end());
  if (rows.empty()) return readOnly(py::array(py::dtype::of<T>(), shape));
  return readOnly(py::array(py::dtype::of<T>(), shape, strides, first, owner));
}

void addSkeleton(py::dict& out, const Skeleton& skeleton, const Report& report) {
  const py::ssize_t joints = skeleton.size();
  py::array_t<std::int32_t> parents(joints);
  py::array_t<double> offsets({joints, py::ssize_t{3}});
  for (int j = 0; j < skeleton.size(); ++j) {
    parents.mutable_at(j) = skeleton.joint(j).parent;
    for (int k = 0; k < 3; ++k) offsets.mutable_at(j, k) = skeleton.joint(j).offset[k];
  }
  out["joint_names"] = toTexts(report.joint_names);
  out["parents"] = readOnly(std::move(parents));
  out["offsets"] = readOnly(std::move(offsets));
}

void addPoses(py::dict& out, const Skeleton& skeleton, const PoseArray& poses,
              const py::object& owner) {
  const py::ssize_t frames = poses.size(), joints = skeleton.size();
  py::array_t<double> turns({frames, joints, py::ssize_t{4}});
  py::array_t<double> places({frames, joints, py::ssize_t{3}});
  double* q = turns.mutable_data();
  double* p = places.mutable_data();
  std::vector<JointFrame> placed(static_cast<size_t>(joints));
  for (int frame = 0; frame < poses.size(); ++frame) {
    for (const Eigen::Quaterniond& turn : poses.rotations(frame))
      for (const double value : {turn.w(), turn.x(), turn.y(), turn.z()}) *q++ = value;
    forwardKinematics(skeleton, poses[frame], placed);
    for (const JointFrame& joint : placed)
      for (int k = 0; k < 3; ++k) *p++ = joint.p_WJ[k];
  }
  out["root_positions"] = readOnly(
      py::array(py::dtype::of<double>(), {frames, py::ssize_t{3}}, poses.p_WR(0).data(), owner));
  out["quaternions"] = readOnly(std::move(turns));
  out["positions"] = readOnly(std::move(places));
}

void addPath(py::dict& out, const std::vector<FrameState>& states, const py::object& owner) {
  const FrameState& first = states.front();
  out["path_positions"] = fieldOf<double>(states, first.position.data(), {3}, owner);
  out["path_headings"] = fieldOf<double>(states, &first.heading, {}, owner);
  out["path_speeds"] = fieldOf<double>(states, &first.speed, {}, owner);
  out["path_turn_rates"] = fieldOf<double>(states, &first.turn_rate, {}, owner);
  out["path_arcs"] = fieldOf<double>(states, &first.arc, {}, owner);
  out["phases"] = fieldOf<double>(states, &first.phase, {}, owner);
  out["planted"] = fieldOf<bool>(states, first.planted.data(), {2}, owner);
}

void addFootprints(py::dict& out, const std::vector<Footprint>& prints, const py::object& owner) {
  static_assert(sizeof(Side) == sizeof(std::int32_t));
  const Footprint* const first = prints.data();
  const auto field = [&]<typename T>(const void* at, std::vector<py::ssize_t> more, T) {
    return fieldOf<T>(prints, at, std::move(more), owner);
  };
  static_assert(offsetof(Footprint, last_frame) == offsetof(Footprint, first_frame) + sizeof(int));
  out["footprint_sides"] = field(&first->side, {}, std::int32_t{});
  out["footprint_positions"] = field(first->position.data(), {3}, double{});
  out["footprint_headings"] = field(&first->heading, {}, double{});
  out["footprint_frames"] = field(&first->first_frame, {2}, std::int32_t{});
}

}  // namespace

py::dict walkArrays(const std::shared_ptr<const PythonWalk>& walk) {
  const AnimationBuffer& buffer = walk->result.outcome.walk.buffer;
  const py::capsule owner(new std::shared_ptr<const PythonWalk>(walk), [](void* kept) {
    delete static_cast<std::shared_ptr<const PythonWalk>*>(kept);
  });
  py::dict out;
  const Skeleton& skeleton = walk->result.problem->synthesizer.skeleton();
  out["frame_time"] = buffer.frame_time;
  addSkeleton(out, skeleton, walk->result.report);
  addPoses(out, skeleton, buffer.poses, owner);
  addPath(out, buffer.states, owner);
  addFootprints(out, buffer.footprints, owner);
  return out;
}

}  // namespace amble
