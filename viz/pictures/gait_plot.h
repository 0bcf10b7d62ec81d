/// The picture of a clip's feet: what Johansen's page shows of his analysis, and figures 3.4 to 3.6
/// of Shanbhag's thesis.
#pragma once

#include <filesystem>
#include <ostream>
#include <string>

#include "animation/analysis/clip_analysis.h"

namespace amble {

/// From top to bottom over time: a band of the motion's types; for each foot the heights of heel
/// and toe over their standing, their speeds along the floor, and bars for heel on the ground, toe
/// on the ground and the foot planted, with its four events marked through all of them; an axis in
/// seconds and in frames of the file. The same analysis gives the same bytes.
/// @param first_frame  of the file that is frame 0 of the analysis
void writeGaitPlot(std::ostream& out, const ClipAnalysis& analysis, const std::string& title,
                   int first_frame = 0);
/// Written beside and renamed. @throws InputError if it cannot be written.
void writeGaitPlot(const std::filesystem::path& file, const ClipAnalysis& analysis,
                   const std::string& title, int first_frame = 0);

}  // namespace amble
