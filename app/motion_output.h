/// What the commands that write one motion are told of the file: BVH, or GLB with a body in it.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

namespace amble {

/// --output, --bvh-units, --names as they were given.
struct MotionOutput {
  std::string file;  ///< `-` is a BVH on standard output
  std::string bvh_units = "m";
  std::string names;  ///< of jointNamings(), or "": the skeleton's own

  bool isGlb() const { return std::filesystem::path(file).extension() == ".glb"; }
  /// Says which endings are known where `file` has another. @throws InputError
  void requireFormat() const;
  double bvhUnit() const { return bvh_units == "cm" ? 0.01 : 1.0; }  ///< [m]
};

/// Adds the options to a command; `output` must outlive it.
void addMotionOutput(CLI::App& command, MotionOutput& output);
/// --names alone. @param naming  is set to it
void addNamesOption(CLI::App& command, std::string& naming);

}  // namespace amble
