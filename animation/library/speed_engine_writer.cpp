#include "animation/library/speed_engine_writer.h"

#include <yaml-cpp/yaml.h>

#include "animation/library/library_parts_writer.h"
#include "animation/library/speed_engine_reader.h"
#include "base/error.h"
#include "base/rotation.h"
#include "base/strict_yaml.h"

namespace amble {
namespace {

using YAML::BeginMap;
using YAML::BeginSeq;
using YAML::EndMap;
using YAML::EndSeq;
using YAML::Flow;
using YAML::Key;
using YAML::Value;

void putLine(YAML::Emitter& out, const char* key, const SpeedLine& line, double unit = 1.0) {
  putList(out, key, std::array<double, 2>{line.at_zero, line.slope}, unit);
}

void putLines(YAML::Emitter& out, const char* key, const std::array<SpeedLine, 2>& lines,
              double unit = 1.0) {
  out << Key << key << Value << Flow << BeginSeq;
  for (const SpeedLine& line : lines) {
    putList(out, std::array<double, 2>{line.at_zero, line.slope}, unit);
  }
  out << EndSeq;
}

void putClip(YAML::Emitter& out, const EngineClip& clip) {
  out << BeginMap;
  put(out, "speed", clip.speed);
  put(out, "frequency", clip.frequency);
  out << Key << "cycles" << Value << clip.cycles;
  if (clip.left_out) {
    out << Key << "left_out" << Value << Flow << BeginMap;
    out << Key << "between" << Value << (clip.left_out->between ? "true" : "false");
    put(out, "joints", clip.left_out->joints / kDegree);
    put(out, "legs", clip.left_out->legs / kDegree);
    put(out, "nearest_joints", clip.left_out->nearest_joints / kDegree);
    put(out, "nearest_legs", clip.left_out->nearest_legs / kDegree);
    out << EndMap;
  }
  putCapture(out, clip.capture);
  putSource(out, clip.source);
  out << EndMap;
}

void putLaw(YAML::Emitter& out, const FrequencyFit& fit) {
  out << Key << "law" << Value << Flow << BeginMap;
  put(out, "factor", fit.law.factor);
  put(out, "power", fit.law.power);
  out << Key << "own_power" << Value << (fit.own_power ? "true" : "false");
  put(out, "residual", fit.residual);
  out << Key << "samples" << Value << fit.samples << EndMap;
}

void putSpace(YAML::Emitter& out, const char* gait, const GaitSpace& space) {
  out << Key << gait << Value << BeginMap;
  out << Key << "clips" << Value << BeginSeq;
  for (const EngineClip& clip : space.clips) putClip(out, clip);
  out << EndSeq;
  putLaw(out, space.law);
  putLines(out, "support", space.support);
  putLine(out, "step_width", space.step_width);
  putLines(out, "foot_forward", space.foot_forward);
  putLines(out, "toe_out", space.toe_out, kDegree);
  putMatrix(out, "root", space.root);
  putMatrix(out, "mean", space.mean);
  out << Key << "components" << Value << BeginSeq;
  for (const PrincipalComponent& component : space.components) {
    out << BeginMap;
    put(out, "share", component.share);
    putLine(out, "coefficient", component.coefficient);
    putMatrix(out, "direction", component.direction);
    out << EndMap;
  }
  out << EndSeq << EndMap;
}

void writeEngine(std::ostream& stream, const EngineData& engine) {
  stream << "# Made by `amble library engine build` from the captures that are named below; not "
            "edited by hand.\n"
         << "# Metres, seconds, degrees; rotation vectors in radians. Rows: channels; columns: "
            "phases.\n";
  YAML::Emitter out(stream);
  out << BeginMap << Key << "skeleton" << Value << engine.skeleton_file;
  put(out, "stature", engine.stature);
  putRoles(out, engine.skeleton, engine.roles);
  putRotations(out, "mean_posture", engine.mean_posture);
  putPosture(out, engine.stand);
  putSource(out, engine.stand_source);
  if (engine.walk) putSpace(out, "walk", *engine.walk);
  if (engine.run) putSpace(out, "run", *engine.run);
  out << EndMap;
  stream << '\n';
}

void requireEngineIfThere(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return;
  if (isSpeedEngine(file)) return;
  throw InputError(file.string(), 0, "is no speed engine; one is not written over it",
                   "a new file, or an engine");
}

}  // namespace

void writeSpeedEngine(const EngineData& engine, const std::filesystem::path& file) {
  requireEngineIfThere(file);
  writeWithSkeleton(engine.skeleton, engine.skeleton_file, file,
                    [&](std::ostream& out) { writeEngine(out, engine); });
}

}  // namespace amble
