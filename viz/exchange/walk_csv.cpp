#include "viz/exchange/walk_csv.h"

#include <charconv>
#include <initializer_list>
#include <vector>

#include "base/rotation.h"

namespace amble {
namespace {

// A table, line by line.
class Table {
 public:
  explicit Table(std::ostream& out) : out_(out) {}

  void header(std::initializer_list<std::string_view> columns) {
    for (const std::string_view column : columns) put(column);
  }
  void put(std::string_view text) { field(csvField(text)); }
  void put(int number) { field(std::to_string(number)); }
  void put(double number) {
    char text[32];
    const char* const end = std::to_chars(text, text + sizeof text, number + 0.0).ptr;  // no "-0"
    field({text, end});
  }
  void put(const Eigen::Vector3d& p) {
    for (int i = 0; i < 3; ++i) put(p[i]);
  }
  void end() {
    line_ += "\r\n";
    out_.write(line_.data(), static_cast<std::streamsize>(line_.size()));
    line_.clear();
  }

 private:
  void field(std::string_view text) {
    if (!line_.empty()) line_ += ',';
    line_ += text;
  }

  std::ostream& out_;
  std::string line_;
};

}  // namespace

std::string csvField(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

void writePathCsv(std::ostream& out, const WalkView& view) {
  const AnimationBuffer& walk = *view.animation;
  Table table(out);
  table.header({"frame", "time [s]", "arc [m]", "x [m]", "y [m]", "z [m]", "heading [deg]",
                "speed [m/s]", "turn rate [deg/s]", "left planted", "right planted"});
  table.end();
  for (int frame = 0; frame < walk.size(); ++frame) {
    const FrameState& state = walk.states[frame];
    table.put(frame);
    table.put(frame * walk.frame_time);
    table.put(state.arc);
    table.put(state.position);
    table.put(state.heading / kDegree);
    table.put(state.speed);
    table.put(state.turn_rate / kDegree);
    table.put(state.planted[kLeft] ? 1 : 0);
    table.put(state.planted[kRight] ? 1 : 0);
    table.end();
  }
}

void writeStepsCsv(std::ostream& out, const WalkView& view, std::span<const StepMeasure> steps) {
  std::vector<const Footprint*> prints;  // those that a foot was put down on
  for (const Footprint& print : view.animation->footprints)
    if (print.first_frame > 0) prints.push_back(&print);
  Table table(out);
  table.header({"step", "foot", "strike [s]", "lift-off [s]", "x [m]", "y [m]", "z [m]",
                "heading [deg]", "stride [m]", "width [m]", "lift [m]", "climb [m]", "slide [m]"});
  table.end();
  for (size_t i = 0; i < steps.size(); ++i) {
    const StepMeasure& step = steps[i];
    table.put(static_cast<int>(i) + 1);
    table.put(step.side == kLeft ? "left" : "right");
    table.put(step.strike);
    table.put(step.lift_off);
    table.put(step.at);
    table.put(prints.at(i)->heading / kDegree);
    for (const double measure : {step.stride, step.width, step.lift, step.climb, step.slide})
      table.put(measure);
    table.end();
  }
}

void writeJointsCsv(std::ostream& out, const WalkView& view,
                    std::span<const std::string> joint_names) {
  const AnimationBuffer& walk = *view.animation;
  Table table(out);
  table.header({"frame", "time [s]"});
  for (const std::string& name : joint_names)
    for (const char* axis : {" x [m]", " y [m]", " z [m]"}) table.put(name + axis);
  table.end();
  std::vector<JointFrame> joints(view.skeleton->size());
  for (int frame = 0; frame < walk.size(); ++frame) {
    forwardKinematics(*view.skeleton, walk.poses[frame], joints);
    table.put(frame);
    table.put(frame * walk.frame_time);
    for (const JointFrame& joint : joints) table.put(joint.p_WJ);
    table.end();
  }
}

}  // namespace amble
