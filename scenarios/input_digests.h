/// Which bytes a run was made of, so that a report can be told from that of other inputs.
#pragma once

#include <map>
#include <string>

#include "scenarios/problem.h"

namespace amble {

/// SHA-256 of every file that the problem was read from, and of a kept roadmap if there is one, by
/// its path relative to the scenario's folder. To be asked as soon as the problem is there: files
/// may change while a walk is planned. The scenario's is that of the bytes that were read; a pipe
/// has none.
std::map<std::string, std::string> inputDigests(const Problem& problem,
                                                const std::filesystem::path& roadmap = {});

}  // namespace amble
