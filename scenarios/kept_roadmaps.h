/// Roadmaps in files, and what they are of.
#pragma once

#include <filesystem>

#include "planner/legs/planner.h"
#include "planner/roadmap/kept_roadmap.h"
#include "scenarios/problem.h"

namespace amble {

/// What makes a roadmap of the problem another one than that of a different problem: the scene's
/// files and their SHA-256, the library's, who walks, and how. Not seed and max_failures, which say
/// how well the same space was looked at; nor start, goal and queries.
RoadmapSource roadmapSource(const Problem& problem);

/// A scenario of a scene alone, with the default character, to make a roadmap of.
Scenario sceneAlone(const std::filesystem::path& scene);

/// A roadmap from a file. @throws InputError if it is none, or one of another problem: the line
/// says what has changed.
KeptRoadmap openRoadmap(const std::filesystem::path& file, const Problem& problem);

}  // namespace amble
