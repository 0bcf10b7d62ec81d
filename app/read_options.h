/// How the commands that take captures are told what their files leave open, and say what was
/// guessed.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "animation/captures/motion_reader.h"
#include "app/findings.h"

namespace amble {

/// Most frames a second that a clip may have [1/s]: no capture has more, and none needs them.
inline constexpr double kMostFrames = 1000.0;

/// --unit, --up, --facing, --asf, --roles, --file-fps, --take, --memory as they were given.
struct ReadOptions {
  double unit = 0.0;        // [m]; 0: not given
  std::string up;           // "y", "z" or "": not given
  double facing_deg = 0.0;  // [degrees]
  bool has_facing = false;
  std::string asf, roles;                // files, or ""
  std::string take;                      // "": not given
  double file_fps = 0.0;                 // [1/s]; 0: not given
  size_t memory = GuardLimits{}.memory;  // [bytes]

  MotionReadOptions forReader() const;
  /// What is read for a clip: itself, the skeleton of an AMC, the roles.
  std::vector<std::filesystem::path> filesOf(const std::filesystem::path& clip) const;
};

/// Adds the options to a command; `options` must outlive it.
void addReadOptions(CLI::App& command, ReadOptions& options);

/// What was guessed, as facts, data and warnings.
void addReadings(const CapturedMotion& motion, Findings& out);

}  // namespace amble
