/// The walks of a job, one after another.
///
/// An item depends on nothing but itself: what it is called, what is done for it and which bytes it
/// has are the same whatever else the job is of.
#pragma once

#include <string>
#include <vector>

#include "batch/job/batch_job.h"

namespace amble {

struct BatchItem {
  int number = 0;                                      ///< in the job's order [>= 0]
  int scene = 0, library = 0, style = 0, actions = 0;  ///< index of the job's
  double height = 0.0;                                 ///< [m]; 0: the library's own
  double speed = 0.0;                                  ///< [m/s]; 0: 1.2, or the style's own
  int way = 0;  ///< of the scene's: its own ones first, then those that are drawn
  std::uint64_t seed = 1;
};

/// All of them: those of one scene together, and there those of one walker. @throws InputError for
/// a sample larger than there are walks
std::vector<BatchItem> listItems(const BatchJob& job);

/// One of some parts of a job, all but equally large.
struct Shard {
  int index = 1, count = 1;  ///< [1 <= index <= count]
};
/// The items of a shard: those of one scene are together in it as far as may be.
std::span<const BatchItem> itemsOf(const std::vector<BatchItem>& items, const Shard& shard);

/// Whether two walk as the same walker in the same scene.
bool sameWalker(const BatchItem& a, const BatchItem& b);

/// What its way is called: that of a drawn one is `drawn-1`, ...
std::string wayName(const BatchJob& job, const BatchItem& item);
/// Whether the way is drawn: of the drawn ones which, from 0; else -1.
int drawnWay(const BatchJob& job, const BatchItem& item);

/// The walker of an item, and its walk where its way is not drawn: messages name the job's lines.
/// It has no name.
Scenario scenarioOf(const BatchJob& job, const BatchItem& item);

/// All that decides what a run writes for an item, in lines.
/// @param scene, library  digests of what they are read from
std::string describeItem(const BatchJob& job, const BatchItem& item, const std::string& scene,
                         const std::string& library);
/// Of what is described so: the name of the folder that it is written to.
std::string itemKey(const std::string& description);

}  // namespace amble
