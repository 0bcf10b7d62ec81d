/// report.html: a report as a page for people, to read and to print.
#pragma once

#include <ostream>
#include <string>

#include "planner/plan_request.h"
#include "scenarios/report.h"

namespace amble {

struct ReportPage {
  const Report& report;                    ///< outlives the page
  std::string command = {};                ///< that repeats the run; empty: not told
  std::string picture = {};                ///< PNG, as bytes; empty: none
  std::string plan = {};                   ///< SVG, as text; empty: none
  const ReachedRegion* reached = nullptr;  ///< without a walk: how far one gets
};

/// One file that asks for nothing else and runs no script: the picture; the walk's figures, or why
/// there is none and what would be needed; quality against its bars; time by phase; the roadmap and
/// what was refused, by rule; the steps; the inputs with their hashes; the command. Light or dark
/// as the reader has it, light where it is printed. Names are of any bytes. The same report gives
/// the same bytes, times aside.
void writeReportPage(std::ostream& out, const ReportPage& page);

}  // namespace amble
