/// What walks of a batch share: a scene, and a walker in it with the roadmap of both.
///
/// A walk depends on no other: ground, walker and roadmap are made without regard to starts and
/// goals, so that who shares them does not matter.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "batch/job/batch_items.h"
#include "batch/run/draw_way.h"
#include "planner/legs/planner.h"
#include "scenarios/problem.h"

namespace amble {

/// Files by their path, relative to the job, and their SHA-256. What comes with Amble is
/// `amble:PATH`, wherever that lies.
using InputDigests = std::map<std::string, std::string>;

/// As messages and rows have it: paths below the job's folder are relative to it.
std::string relativeText(const BatchJob& job, std::string text);
/// The digest of all of them.
std::string digestOfInputs(const InputDigests& inputs);
InputDigests digestsOf(const BatchJob& job, const std::vector<std::filesystem::path>& files);

/// A scene as it was read, or why it could not be.
struct BatchSceneData {
  std::shared_ptr<const Scene> scene;         ///< null where it could not be read
  std::shared_ptr<const WalkedScene> walked;  ///< what its walkers share; null the same
  InputDigests inputs;
  std::string digest;
  std::string wrong;  ///< in a line
};
std::shared_ptr<const BatchSceneData> readBatchScene(const BatchJob& job, int scene,
                                                     const LoadLimits& limits);

/// A library in an item's style, with its actions.
struct BatchLibraryData {
  std::shared_ptr<const MotionLibrary> library;  ///< null where it cannot be walked with
  InputDigests inputs;
  std::string digest;
  std::string wrong;
};

/// Who draws the ways of a scene: one person for all walkers, so that a way is the same to each of
/// them. Of the default library, as tall as the tallest of the job.
struct BatchDrawer {
  std::unique_ptr<const Problem> problem;
  std::unique_ptr<const WayDrawer> drawer;
  std::string wrong;
};
/// @param library  the default one, as readDrawersLibrary reads it. @throws Stopped
std::shared_ptr<const BatchDrawer> makeBatchDrawer(const BatchJob& job, int scene,
                                                   const BatchSceneData& data,
                                                   const BatchLibraryData& library,
                                                   const LoadLimits& limits);

std::shared_ptr<const BatchLibraryData> readBatchLibrary(const BatchJob& job,
                                                         const BatchItem& item);
/// The default one, without a style.
std::shared_ptr<const BatchLibraryData> readDrawersLibrary(const BatchJob& job);

/// Somebody who can be asked to walk, or why nobody can.
struct BatchWalker {
  std::unique_ptr<const Problem> problem;  ///< of the scene alone
  std::optional<Planner> planner;          ///< where a roadmap is shared
  std::string wrong;
  double seconds = 0.0;  ///< that the roadmap took
};
/// @pre scene and library are there @throws Stopped
std::shared_ptr<const BatchWalker> makeBatchWalker(const BatchJob& job, const BatchItem& item,
                                                   const BatchSceneData& scene,
                                                   const BatchLibraryData& library,
                                                   const LoadLimits& limits);

}  // namespace amble
