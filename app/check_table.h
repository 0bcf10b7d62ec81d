/// What `amble check` prints of its rows: for people, and for machines.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "scenarios/check_scenarios.h"

namespace amble {

/// The table for people, a row when it is known: what differs from the accepted run stands below
/// what is found, in the same columns.
class CheckTable {
 public:
  /// @param files  that are run: their names, and those of their queries, decide the width
  explicit CheckTable(const std::vector<ScenarioFile>& files);
  void printHead() const;
  void printRow(const CheckRow& row) const;

 private:
  void printChanges(const CheckRow& row) const;
  int width_ = 16;  // of names, or of "  since accepted" [characters]
};

/// The lines below the table.
void printCheckSummary(const std::vector<CheckRow>& rows);

nlohmann::ordered_json checkJson(const std::vector<CheckRow>& rows);

}  // namespace amble
