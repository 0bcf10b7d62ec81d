#include "python/clips.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "animation/body/joint_names.h"
#include "animation/captures/bvh.h"
#include "animation/library/speed_engine_reader.h"
#include "app/analysis_report.h"
#include "app/edit_report.h"
#include "app/edited.h"
#include "app/graft_report.h"
#include "app/locked_engine_walk.h"
#include "app/validation_report.h"
#include "base/error.h"
#include "base/output_file.h"
#include "base/rotation.h"
#include "base/stop_request.h"
#include "python/arrays.h"
#include "python/module.h"
#include "python/stoppable.h"
#include "python/text.h"
#include "viz/exchange/glb.h"
#include "viz/figure/captured_figure.h"

namespace amble {
namespace {

namespace py = pybind11;
using Json = nlohmann::ordered_json;
using ClipPtr = std::shared_ptr<PythonClip>;

std::string textOf(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

ClipPtr clipOf(Clip clip, const JointRoles& roles, std::string file, const Json& report) {
  const auto made = std::make_shared<PythonClip>();
  made->motion.clip = std::move(clip);
  made->motion.roles = roles;
  made->file = std::move(file);
  made->report = textOf(report);
  return made;
}

struct Reading {
  std::optional<double> unit, facing_deg, fps;
  std::optional<bool> z_up;
  std::filesystem::path asf, roles;
  std::string take;
};

ClipPtr readClip(const std::filesystem::path& file, const Reading& how) {
  const py::gil_scoped_release released;
  MotionReadOptions options;
  options.metres_per_unit = how.unit;
  if (how.z_up) options.up = *how.z_up ? UpAxis::kZ : UpAxis::kY;
  if (how.facing_deg) options.facing = *how.facing_deg * kDegree;
  if (how.fps) options.frame_time = 1.0 / *how.fps;
  options.asf = how.asf;
  options.roles = how.roles;
  options.take = how.take;
  const auto read = std::make_shared<PythonClip>();
  read->motion = readMotion(file, options);
  read->file = file.string();
  return read;
}

std::vector<std::string> namesOf(const Skeleton& skeleton) {
  std::vector<std::string> names;
  for (const Joint& joint : skeleton.joints()) names.push_back(joint.name);
  return names;
}

py::dict arraysOfClip(const ClipPtr& clip) {
  return arraysOf(clip->motion.clip, namesOf(clip->motion.clip.skeleton), ownerOf(clip));
}

void writeClip(const PythonClip& made, const std::filesystem::path& file, double bvh_unit,
               const std::string& names) {
  const py::gil_scoped_release released;
  Clip clip = made.motion.clip;
  const JointRoles& roles = made.motion.roles;
  if (!names.empty())
    clip.skeleton = renamed(clip.skeleton, jointNames(clip.skeleton, roles, names));
  if (file.extension() == ".bvh") {
    clip.joint_positions.clear();
    writeBvh(file, clip, {.metres_per_unit = bvh_unit});
  } else if (file.extension() == ".glb") {
    const Figure figure = capturedFigure(clip, roles);
    writeFile(file, [&](std::ostream& out) { writeGlb(out, clip, figure); });
  } else {
    throw InputError(file.string(), 0, "no format that is written", ".bvh or .glb");
  }
}

/// What `amble analyse --json` says of it, and who stands when, frame by frame of the file.
py::tuple analyse(const PythonClip& clip, bool as_is) {
  std::string report;
  std::array<std::vector<bool>, 2> planted;
  {
    const py::gil_scoped_release released;
    const std::vector<AnalysedClip> clips = {analyseMotion(clip.motion, clip.file, as_is)};
    const Findings findings = describeAnalysis(clips.front(), subjectLaws(clips).front());
    Json data = {{"file", findings.file}};
    data.update(findings.data);
    data["warnings"] = findings.warnings;
    report = textOf(data);
    for (const Side side : {kLeft, kRight}) {
      planted[side].assign(static_cast<size_t>(clips.front().file_frames), false);
      const std::vector<bool> stands = clips.front().analysis.plants.planted(side);
      std::copy(stands.begin(), stands.end(), planted[side].begin() + clips.front().first_frame);
    }
  }
  return py::make_tuple(toText(report), plantedArray(planted[kLeft], planted[kRight]));
}

/// Over a motion's way: from, to, and whether they are factors of what was captured.
using Amount = std::optional<std::tuple<double, double, bool>>;
using Pair = std::optional<std::pair<double, double>>;

std::optional<EditAmount> editAmount(const Amount& amount) {
  if (!amount) return std::nullopt;
  const auto& [from, to, factor] = *amount;
  return EditAmount{Ramp{from, to}, factor};
}

/// The edited clip and its report; no clip, and why, where legs are too short for it.
py::tuple edit(const PythonClip& clip, const Amount& stride, const Amount& lift,
               const Pair& incline_deg, const Pair& stairs, const Pair& arrive, bool foot_lock) {
  ClipPtr made;
  std::string refused;
  runStoppable(kMostThreads, [&](const std::atomic<bool>& stop) {
    const StopRequest asked{&stop, {}};
    CapturedMotion motion = clip.motion;
    const CapturedWalk walk = captureWalk(motion, clip.file);
    asked.check();
    EditRequest request;
    request.stride = editAmount(stride);
    request.lift = editAmount(lift);
    if (incline_deg)
      request.incline = Ramp{incline_deg->first * kDegree, incline_deg->second * kDegree};
    if (stairs) request.stairs = StairSize{stairs->first, stairs->second};
    if (arrive) request.arrive = Eigen::Vector2d(arrive->first, arrive->second);
    request.foot_lock = foot_lock;
    EditedWalk edited = editCapture(walk, request, clip.file);
    asked.check();
    refused = edited.refused;
    if (refused.empty()) {
      const EditReport report = editReport(walk, request, edited);
      const Json json = editJson(report, walk, request, edited, clip.file, "");
      made = clipOf(std::move(edited.clip), walk.roles, clip.file, json);
    }
  });
  return py::make_tuple(made, toText(refused));
}

/// The same of `amble graft`.
py::tuple graft(const PythonClip& base, const PythonClip& upper,
                const std::vector<std::string>& chains, int alternative,
                const std::optional<double>& ease, bool as_it_falls) {
  ClipPtr made;
  std::string refused;
  runStoppable(kMostThreads, [&](const std::atomic<bool>& stop) {
    const StopRequest asked{&stop, {}};
    const GraftSource below = graftSource(base.motion, base.file);
    asked.check();
    const GraftSource above = graftSource(upper.motion, upper.file);
    asked.check();
    GraftWishes wishes;
    wishes.chains = chains;
    wishes.alternative = alternative;
    wishes.ease = ease;
    Grafted grafted = graftOn(below, above, wishes, !as_it_falls);
    asked.check();
    refused = grafted.refusal;
    if (refused.empty()) {
      const Json report = graftData(below, above, grafted, wishes);
      made = clipOf(std::move(grafted.graft.clip), below.clip.roles, base.file, report);
    }
  });
  return py::make_tuple(made, toText(refused));
}

/// The clip, and speed, phase and who stands at each of its frames.
py::tuple engineClip(const SpeedEngine& engine, double from, double to, double duration, double fps,
                     double height) {
  EngineWalk walk;
  ClipPtr made;
  {
    const py::gil_scoped_release released;
    const EngineData& data = engine.data();
    const double scale = height > 0.0 ? height / data.stature : 1.0;
    walk = lockedEngineWalk(engine, {Ramp{from, to}, duration, 1.0 / fps, scale});
    made = clipOf(std::move(walk.clip), data.roles, data.file.string(), Json::object());
  }
  return py::make_tuple(made, numbersArray(walk.speeds), numbersArray(walk.phases),
                        plantedArray(walk.planted[kLeft], walk.planted[kRight]));
}

struct Validating {
  std::optional<double> unit, floor;
  bool z_up = false;
  double height = 0.0, fps = 0.0;
  double max_slope_deg = 20.0;
  std::optional<double> max_climb, max_drop;
};

/// What `amble validate --json` says, and whether all is well.
py::tuple validate(const std::filesystem::path& walk, const std::filesystem::path& scene,
                   const Validating& how) {
  std::string report;
  bool clean = false;
  {
    const py::gil_scoped_release released;
    ValidateOptions options;
    options.metres_per_unit = how.unit;
    options.floor = how.floor;
    options.up = how.z_up ? UpAxis::kZ : UpAxis::kY;
    options.height = how.height;
    options.fps = how.fps;
    options.limits.max_slope = how.max_slope_deg * kDegree;
    if (how.max_climb) options.limits.max_climb = *how.max_climb;
    if (how.max_drop) options.limits.max_drop = *how.max_drop;
    const WalkValidation found = validateWalk(walk, scene, options);
    report = textOf(validationJson(walk.string(), found));
    clean = isClean(found, options.limits);
  }
  return py::make_tuple(toText(report), clean);
}

void bindOptions(py::module_& module) {
  py::class_<Reading>(module, "Reading")
      .def(py::init<>())
      .def_readwrite("unit", &Reading::unit)
      .def_readwrite("facing", &Reading::facing_deg)
      .def_readwrite("fps", &Reading::fps)
      .def_readwrite("z_up", &Reading::z_up)
      .def_readwrite("asf", &Reading::asf)
      .def_readwrite("roles", &Reading::roles)
      .def_readwrite("take", &Reading::take);
  py::class_<Validating>(module, "Validating")
      .def(py::init<>())
      .def_readwrite("unit", &Validating::unit)
      .def_readwrite("floor", &Validating::floor)
      .def_readwrite("z_up", &Validating::z_up)
      .def_readwrite("height", &Validating::height)
      .def_readwrite("fps", &Validating::fps)
      .def_readwrite("max_slope", &Validating::max_slope_deg)
      .def_readwrite("max_climb", &Validating::max_climb)
      .def_readwrite("max_drop", &Validating::max_drop);
}

}  // namespace

void bindClips(py::module_& module) {
  bindOptions(module);
  py::class_<PythonClip, std::shared_ptr<PythonClip>>(module, "Clip")
      .def_property_readonly("file", [](const PythonClip& clip) { return toText(clip.file); })
      .def_property_readonly("name",
                             [](const PythonClip& clip) { return toText(clip.motion.clip.name); })
      .def_property_readonly("report", [](const PythonClip& clip) { return toText(clip.report); })
      .def_property_readonly("warnings",
                             [](const PythonClip& clip) { return toTexts(clip.motion.warnings); })
      .def("arrays", &arraysOfClip)
      .def("write", &writeClip)
      .def("analyse", &analyse)
      .def("edit", &edit);
  module.def("read_clip", &readClip);
  module.def("graft", &graft);
  module.def("validate", &validate);
  module.def("joint_namings", &jointNamings);
  py::class_<SpeedEngine>(module, "Engine")
      .def(py::init([](const std::filesystem::path& file) {
        return std::make_unique<SpeedEngine>(readSpeedEngine(file));
      }))
      .def("walk", &engineClip);
}

}  // namespace amble
