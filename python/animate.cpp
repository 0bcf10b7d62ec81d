// Walks without a scene, and the libraries that they are made of.

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "animation/body/joint_names.h"
#include "animation/captures/bvh.h"
#include "animation/library/library_parts_writer.h"
#include "animation/library/library_style.h"
#include "animation/library/motion_library_reader.h"
#include "animation/library/motion_library_writer.h"
#include "animation/preparation/motion_library_build.h"
#include "app/animated.h"
#include "app/library_addition.h"
#include "app/library_found.h"
#include "base/rotation.h"
#include "python/arrays.h"
#include "python/clips.h"
#include "python/module.h"
#include "python/stoppable.h"
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
  std::shared_ptr<AnimatedWalk> made;
  runStoppable(kMostThreads, [&](const std::atomic<bool>& stop) {
    made = std::make_shared<AnimatedWalk>(animateWalk(asked.request(), StopRequest{&stop, {}}));
  });
  return made;
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
  if (motion.source.speed) source["speed"] = *motion.source.speed;
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
  const auto library = std::make_shared<MotionLibrary>();
  runStoppable(kMostThreads, [&](const std::atomic<bool>& stop) {
    *library = buildMotionLibrary(recipe, captures, StopRequest{&stop, {}});
  });
  return library;
}

std::shared_ptr<MotionLibrary> newLibrary(const std::filesystem::path& file) {
  const py::gil_scoped_release released;
  return std::make_shared<MotionLibrary>(libraryAt(file));
}

struct AdditionAsked {
  std::string kind = "walk";
  LibraryAddition how;
};

// All of them, or none.
void addTo(MotionLibrary& library, const std::vector<std::filesystem::path>& clips,
           const AdditionAsked& asked) {
  MotionLibrary longer = library;
  runStoppable(kMostThreads, [&](const std::atomic<bool>& stop) {
    LibraryAddition how = asked.how;
    const auto& kinds = motionKindNames();
    how.kind =
        static_cast<MotionKind>(std::find(kinds.begin(), kinds.end(), asked.kind) - kinds.begin());
    for (const std::filesystem::path& clip : clips) {
      for (const MotionRequest& request : requestsOf(clip, how)) {
        StopRequest{&stop, {}}.check();
        addMotion(longer, request);
      }
    }
  });
  longer.skeleton_file = skeletonNameFor(longer.skeleton, longer.skeleton_file, longer.file);
  library = std::move(longer);
}

/// What `amble library find --json` says, and of clips that cannot be read what is wrong.
py::tuple findIn(const std::vector<std::string>& paths, const std::string& type, double at_least,
                 int threads) {
  std::string text;
  std::vector<std::string> wrong;
  runStoppable(threads, [&](const std::atomic<bool>& stop) {
    MotionSearch search;
    search.paths = paths;
    search.type = type;
    search.at_least = at_least;
    search.threads = threads;
    search.done = [&](int, int) { return !stop; };
    text = foundJson(findMotions(search, wrong), type)
               .dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  });
  return py::make_tuple(toText(text), toTexts(wrong));
}

void bindAddition(py::module_& module) {
  py::class_<AdditionAsked>(module, "AdditionAsked")
      .def(py::init<>())
      .def_readwrite("kind", &AdditionAsked::kind)
      .def_property(
          "name", [](const AdditionAsked& asked) { return asked.how.name; },
          [](AdditionAsked& asked, const std::string& name) { asked.how.name = name; })
      .def("choose", [](AdditionAsked& asked, const std::optional<bool>& turning,
                        const std::string& style, const std::vector<std::string>& chains,
                        const std::optional<std::pair<int, int>>& frames,
                        const std::optional<bool>& mirror, const std::string& licence,
                        const std::string& credit, const std::vector<double>& speeds) {
        LibraryAddition& how = asked.how;
        how.turning = turning;
        how.style = style;
        how.chains = chains;
        how.frames = frames;
        how.mirror = mirror;
        how.licence = licence;
        how.credit = credit;
        how.speeds = speeds;
      });
  module.def("new_library", &newLibrary);
  module.def("find_motions", &findIn);
  module.def("motion_kinds", &motionKindNames);
  module.def("chain_names", &chainNames);
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
  bindAddition(module);
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
      .def("add", &addTo)
      .def("write", [](const MotionLibrary& library, const std::filesystem::path& file) {
        const py::gil_scoped_release released;
        writeMotionLibrary(library, file);
      });
  module.def("open_library", &openLibrary);
  module.def("build_library", &buildLibrary);
}

}  // namespace amble
