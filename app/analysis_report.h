/// What `amble analyse` says of clips: details of one, a table of several, rows for machines.
#pragma once

#include <ostream>
#include <vector>

#include "animation/library/frequency_law.h"
#include "app/analysed_clip.h"
#include "app/findings.h"

namespace amble {

/// Clips of one subject, told by the skeleton, and the law that its walks fit.
struct SubjectLaw {
  std::vector<int> clips;  ///< indices of its clips, walking or not
  std::vector<FrequencySample> walks;
  FrequencyFit fit;         ///< of `walks`, if any
  double leg_length = 0.0;  ///< [m]
};

/// In order of the subjects' first clips. Clips are one subject's where their skeletons have the
/// same joints and leg lengths within half a percent. Only steady walks count.
std::vector<SubjectLaw> subjectLaws(const std::vector<AnalysedClip>& clips);

/// Facts and data of one clip. @param law  of its subject
Findings describeAnalysis(const AnalysedClip& clip, const SubjectLaw& law);

/// A row a clip under a head, and a line a subject.
void printAnalysisTable(const std::vector<AnalysedClip>& clips,
                        const std::vector<SubjectLaw>& laws);

/// `frame,left,right`: 1 where the foot is planted, a row a frame of the file.
void writePlantsCsv(std::ostream& out, const AnalysedClip& clip);

}  // namespace amble
