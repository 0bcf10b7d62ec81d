#include "animation/library/speed_engine_writer.h"

#include "animation/library/library_parts_writer.h"
#include "animation/library/speed_engine_reader.h"
#include "base/error.h"
#include "base/rotation.h"
#include "base/strict_yaml.h"

namespace amble {
namespace {

void putLine(YamlWriter& out, const char* key, const SpeedLine& line, double unit = 1.0) {
  putList(out, key, std::array<double, 2>{line.at_zero, line.slope}, unit);
}

void putLines(YamlWriter& out, const char* key, const std::array<SpeedLine, 2>& lines,
              double unit = 1.0) {
  out.key(key).beginList(YamlWriter::kFlow);
  for (const SpeedLine& line : lines) {
    putList(out, std::array<double, 2>{line.at_zero, line.slope}, unit);
  }
  out.end();
}

void putClip(YamlWriter& out, const EngineClip& clip) {
  out.beginMap();
  put(out, "speed", clip.speed);
  put(out, "frequency", clip.frequency);
  out.key("cycles").whole(clip.cycles);
  if (clip.left_out) {
    out.key("left_out").beginMap(YamlWriter::kFlow);
    out.key("between").truth(clip.left_out->between);
    put(out, "joints", clip.left_out->joints / kDegree);
    put(out, "legs", clip.left_out->legs / kDegree);
    put(out, "nearest_joints", clip.left_out->nearest_joints / kDegree);
    put(out, "nearest_legs", clip.left_out->nearest_legs / kDegree);
    out.end();
  }
  putCapture(out, clip.capture);
  putSource(out, clip.source);
  out.end();
}

void putLaw(YamlWriter& out, const FrequencyFit& fit) {
  out.key("law").beginMap(YamlWriter::kFlow);
  put(out, "factor", fit.law.factor);
  put(out, "power", fit.law.power);
  out.key("own_power").truth(fit.own_power);
  put(out, "residual", fit.residual);
  out.key("samples").whole(fit.samples).end();
}

void putSpace(YamlWriter& out, const char* gait, const GaitSpace& space) {
  out.key(gait).beginMap();
  out.key("clips").beginList();
  for (const EngineClip& clip : space.clips) putClip(out, clip);
  out.end();
  putLaw(out, space.law);
  putLines(out, "support", space.support);
  putLine(out, "step_width", space.step_width);
  putLines(out, "foot_forward", space.foot_forward);
  putLines(out, "toe_out", space.toe_out, kDegree);
  putMatrix(out, "root", space.root);
  putMatrix(out, "mean", space.mean);
  out.key("components").beginList();
  for (const PrincipalComponent& component : space.components) {
    out.beginMap();
    put(out, "share", component.share);
    putLine(out, "coefficient", component.coefficient);
    putMatrix(out, "direction", component.direction);
    out.end();
  }
  out.end().end();
}

void writeEngine(std::ostream& stream, const EngineData& engine) {
  stream << "# Made by `amble library engine build` from the captures that are named below; not "
            "edited by hand.\n"
         << "# Metres, seconds, degrees; rotation vectors in radians. Rows: channels; columns: "
            "phases.\n";
  YamlWriter out(stream);
  out.beginMap().key("skeleton").text(engine.skeleton_file);
  put(out, "stature", engine.stature);
  putRoles(out, engine.skeleton, engine.roles);
  putRotations(out, "mean_posture", engine.mean_posture);
  putPosture(out, engine.stand);
  putSource(out, engine.stand_source);
  if (engine.walk) putSpace(out, "walk", *engine.walk);
  if (engine.run) putSpace(out, "run", *engine.run);
  out.end();
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
