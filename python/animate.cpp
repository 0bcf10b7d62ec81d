// Walks without a scene, and the libraries that they are made of.

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "animation/body/joint_names.h"
#include "animation/captures/bvh.h"
#include "animation/library/library_style.h"
#include "animation/library/motion_library_reader.h"
#include "animation/library/motion_library_writer.h"
#include "animation/preparation/motion_library_build.h"
#include "app/animated.h"
#include "base/rotation.h"
#include "python/arrays.h"
#include "python/clips.h"
#include "python/module.h"
#include "python/text.h"

namespace amble {
namespace {

namespace py = pybind11;

/// As it is asked for in Python: angles in degrees.
struct AnimateAsked {
  std::string library = "default", style;
  std::optional<double> speed;
  double height = 0.0, fps = 60.0, duration = 5.0, turn_deg = 0.0;
  std::vector<std::string> actions;
  std::optional<std::pair<double, double>> stride, lift, incline_deg, stairs;

  AnimateRequest request() const {
    const auto ramp = [](const std::optional<std::pair<double, double>>& ends, double unit) {
      return ends ? std::optional(Ramp{ends->first * unit, ends->second * unit}) : std::nullopt;
    };
    return {.library = library,
            .style = style,
            .speed = speed,
            .height = height,
            .fps = fps,
            .actions = actions,
            .walk = {.duration = duration,
                     .turn_rate = turn_deg * kDegree,
                     .stride = ramp(stride, 1.0),
                     .lift = ramp(lift, 1.0),
                     .incline = ramp(incline_deg, kDegree),
                     .stairs = stairs}};
  }
};

std::shared_ptr<AnimatedWalk> animate(const AnimateAsked& asked) {
  const py::gil_scoped_release released;
  return std::make_shared<AnimatedWalk>(animateWalk(asked.request()));
}

py::dict arraysOfAnimation(const std::shared_ptr<AnimatedWalk>& made) {
  const Skeleton& skeleton = made->synthesizer->skeleton();
  return arraysOf(made->walk, skeleton, bvhJointNames(skeleton), ownerOf(made));
}

/// As a clip, which can be written, analysed, edited.
std::shared_ptr<PythonClip> clipOfAnimation(const AnimatedWalk& made) {
  const auto clip = std::make_shared<PythonClip>();
  const Skeleton& skeleton = made.synthesizer->skeleton();
  clip->motion.clip = Clip{"walk", skeleton, made.walk.frame_time, made.walk.poses, {}};
  clip->motion.roles = made.synthesizer->roles();
  clip->file = "walk";
  return clip;
}

py::dict describe(const Motion& motion) {
  py::dict out;
  out["name"] = toText(motion.name);
  out["kind"] = motionKindNames().at(static_cast<size_t>(motion.kind));
  out["style"] = toText(motion.style);
  const bool cycle = motion.kind == MotionKind::kWalk || motion.kind == MotionKind::kMovement;
  if (motion.kind == MotionKind::kWalk) out["turning"] = motion.turning;
  if (cycle) {
    out["speed"] = motion.cycle.speed;
    out["turn_rate"] = motion.cycle.turn_rate;
    out["period"] = motion.cycle.period;
  }
  out["joints"] = motion.chains.empty() ? py::object(py::str("all")) : toTexts(motion.chains);
  py::dict source;
  source["clip"] = toText(motion.source.clip);
  source["frames"] = py::make_tuple(motion.source.frames[0], motion.source.frames[1]);
  source["mirrored"] = motion.source.mirrored;
  source["licence"] = toText(motion.source.licence);
  source["credit"] = toText(motion.source.credit);
  out["source"] = source;
  return out;
}

std::shared_ptr<MotionLibrary> openLibrary(const std::string& name) {
  const py::gil_scoped_release released;
  return std::make_shared<MotionLibrary>(readMotionLibrary(motionLibraryFile(name)));
}

std::shared_ptr<MotionLibrary> buildLibrary(const std::filesystem::path& recipe,
                                            const std::filesystem::path& captures) {
  const py::gil_scoped_release released;
  return std::make_shared<MotionLibrary>(buildMotionLibrary(recipe, captures));
}

void bindAnimateAsked(py::module_& module) {
  py::class_<AnimateAsked>(module, "AnimateAsked")
      .def(py::init<>())
      .def_readwrite("library", &AnimateAsked::library)
      .def_readwrite("style", &AnimateAsked::style)
      .def_readwrite("speed", &AnimateAsked::speed)
      .def_readwrite("height", &AnimateAsked::height)
      .def_readwrite("fps", &AnimateAsked::fps)
      .def_readwrite("duration", &AnimateAsked::duration)
      .def_readwrite("turn", &AnimateAsked::turn_deg)
      .def_readwrite("actions", &AnimateAsked::actions)
      .def_readwrite("stride", &AnimateAsked::stride)
      .def_readwrite("lift", &AnimateAsked::lift)
      .def_readwrite("incline", &AnimateAsked::incline_deg)
      .def_readwrite("stairs", &AnimateAsked::stairs);
}

}  // namespace

void bindAnimate(py::module_& module) {
  bindAnimateAsked(module);
  py::class_<AnimatedWalk, std::shared_ptr<AnimatedWalk>>(module, "Animation")
      .def_property_readonly("refused",
                             [](const AnimatedWalk& made) { return toText(made.refused); })
      .def("arrays", &arraysOfAnimation)
      .def("clip", &clipOfAnimation);
  module.def("animate", &animate);
  py::class_<MotionLibrary, std::shared_ptr<MotionLibrary>>(module, "Library")
      .def_property_readonly("file", [](const MotionLibrary& library) { return library.file; })
      .def_property_readonly("stature",
                             [](const MotionLibrary& library) { return library.stature; })
      .def_property_readonly(
          "joint_names",
          [](const MotionLibrary& library) { return toTexts(bvhJointNames(library.skeleton)); })
      .def_property_readonly(
          "styles", [](const MotionLibrary& library) { return toTexts(stylesOf(library)); })
      .def_property_readonly("motions",
                             [](const MotionLibrary& library) {
                               py::list motions;
                               for (const Motion& motion : library.motions)
                                 motions.append(describe(motion));
                               return motions;
                             })
      .def("write", [](const MotionLibrary& library, const std::filesystem::path& file) {
        const py::gil_scoped_release released;
        writeMotionLibrary(library, file);
      });
  module.def("open_library", &openLibrary);
  module.def("build_library", &buildLibrary);
}

}  // namespace amble
