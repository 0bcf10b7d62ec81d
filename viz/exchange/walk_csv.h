/// A walk as tables for spreadsheets, pandas and R: its root path, its steps, its joints.
///
/// RFC 4180: fields between commas, lines that end with CR LF, quotes where a name needs them, a
/// header with the unit of each column. Numbers are the shortest that read back the same, with a
/// point in every locale. World, z up; angles in degrees.
#pragma once

#include <ostream>
#include <span>
#include <string>
#include <string_view>

#include "animation/body/step_measure.h"
#include "viz/walk_view.h"

namespace amble {

/// path.csv, a row a frame: where the root path is then, how fast it is walked, which feet stand.
/// @pre view.hasBody(), and the animation has a state a frame
void writePathCsv(std::ostream& out, const WalkView& view);

/// steps.csv, a row a print that a foot was put down on, in order.
/// @param steps  of the animation, as the report has them. @pre as above
void writeStepsCsv(std::ostream& out, const WalkView& view, std::span<const StepMeasure> steps);

/// joints.csv, a row a frame, three columns a joint: where the joint is.
/// @param joint_names  by joint. @pre view.hasBody()
void writeJointsCsv(std::ostream& out, const WalkView& view,
                    std::span<const std::string> joint_names);

/// A field as RFC 4180 has it: between quotes where it holds a comma, a quote or a line's end.
std::string csvField(std::string_view text);

}  // namespace amble
