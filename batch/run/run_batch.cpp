#include "batch/run/run_batch.h"

#include <mutex>

#include "base/error.h"
#include "base/freed_memory.h"
#include "base/parallel.h"
#include "base/stopwatch.h"
#include "batch/run/batch_folder.h"
#include "batch/run/batch_walker.h"
#include "batch/run/make_walk.h"
#include "batch/run/shelf.h"
#include "batch/run/whole_walk.h"
#include "environments/scene/kept_meshes.h"

namespace amble {
namespace {

// Freed memory goes back whenever a scene is done with, and after so many walks of one: a run of a
// hundred thousand keeps to what its scenes need.
constexpr int kGiveBackEvery = 32;

// How often each of a numbered kind is used by the items.
template <typename NumberOf>
std::vector<int> usesOf(std::span<const BatchItem> items, int count, const NumberOf& number_of) {
  std::vector<int> uses(static_cast<size_t>(count), 0);
  for (const BatchItem& item : items) ++uses[static_cast<size_t>(number_of(item))];
  return uses;
}

// Of each item which walker it is of, from 0. @pre those of one are together
std::vector<int> walkersOf(std::span<const BatchItem> items) {
  std::vector<int> walkers(items.size(), 0);
  for (size_t i = 1; i < items.size(); ++i)
    walkers[i] = walkers[i - 1] + (sameWalker(items[i - 1], items[i]) ? 0 : 1);
  return walkers;
}

class BatchRun {
 public:
  BatchRun(const BatchJob& job, const std::filesystem::path& folder, const BatchOptions& options)
      : job_(job),
        options_(options),
        folder_(folder),
        all_(listItems(job)),
        items_(itemsOf(all_, options.shard)),
        walker_of_(walkersOf(items_)),
        scenes_(usesOf(items_, static_cast<int>(job.scenes.size()),
                       [](const BatchItem& item) { return item.scene; })),
        drawers_(usesOf(items_, static_cast<int>(job.scenes.size()),
                        [](const BatchItem& item) { return item.scene; })),
        libraries_(usesOf(
            items_, static_cast<int>(job.libraries.size() * job.styles.size() * job.actions.size()),
            [&](const BatchItem& item) { return libraryOf(item); })),
        walkers_(usesOf(items_, items_.empty() ? 0 : walker_of_.back() + 1, [&](const auto& item) {
          return walker_of_[static_cast<size_t>(&item - items_.data())];
        })) {
    limits_.memory = options.memory;
    limits_.stop.flag = options.stop;
    limits_.meshes = &meshes_;
    summary_.keys.resize(items_.size());
    summary_.total = static_cast<int>(items_.size());
  }

  BatchSummary run() {
    const Stopwatch watch;
    try {
      parallelFor(summary_.total, options_.threads, [&](int i, int) { doItem(i); });
    } catch (const Stopped&) {
      summary_.stopped = true;
    }
    summary_.seconds = watch.seconds();
    return summary_;
  }

 private:
  void add(double& sum, double seconds) {
    const std::lock_guard lock(mutex_);
    sum += seconds;
  }
  template <typename Work>
  auto timed(double& sum, const Work& work) {
    const Stopwatch watch;
    auto result = work();
    add(sum, watch.seconds());
    return result;
  }

  // Of the library in the item's style, with its actions.
  int libraryOf(const BatchItem& item) const {
    return (item.library * static_cast<int>(job_.styles.size()) + item.style) *
               static_cast<int>(job_.actions.size()) +
           item.actions;
  }

  void doItem(int i) {
    limits_.stop.check();
    const BatchItem& item = items_[static_cast<size_t>(i)];
    const bool kept = isKept(i, item);
    walkers_.used(walker_of_[static_cast<size_t>(i)]);
    drawers_.used(item.scene);
    libraries_.used(libraryOf(item));
    const bool scene_over = scenes_.used(item.scene);
    const int done = count(kept);
    if (scene_over || done % kGiveBackEvery == 0) giveBackFreedMemory();
  }

  // Whether it was there before; else it is made.
  bool isKept(int i, const BatchItem& item) {
    const auto scene = scenes_.get(item.scene, [&] {
      return timed(summary_.loading, [&] { return readBatchScene(job_, item.scene, limits_); });
    });
    const auto library = libraries_.get(libraryOf(item), [&] {
      return timed(summary_.loading, [&] { return readBatchLibrary(job_, item); });
    });
    const std::string key = itemKey(describeItem(job_, item, scene->digest, library->digest));
    summary_.keys[static_cast<size_t>(i)] = key;
    if (isWhole(job_, folder_, key)) return true;
    folder_.remove(key);  // what has lost a file
    make(i, key, *scene, *library);
    return false;
  }

  void make(int i, const std::string& key, const BatchSceneData& scene,
            const BatchLibraryData& library) {
    const BatchItem& item = items_[static_cast<size_t>(i)];
    std::shared_ptr<const BatchWalker> walker;
    std::shared_ptr<const BatchDrawer> drawer;
    if (scene.wrong.empty() && library.wrong.empty()) {
      if (drawnWay(job_, item) >= 0)
        drawer = drawers_.get(item.scene, [&] {
          return timed(summary_.loading, [&] { return makeDrawer(item.scene, scene); });
        });
      walker = walkers_.get(walker_of_[static_cast<size_t>(i)],
                            [&] { return makeWalker(item, scene, library); });
    }
    MadeWalk made =
        makeWalk({job_, item, key, scene, library, drawer.get(), walker.get(), options_.stop});
    add(summary_.planning, made.planning);
    add(summary_.labelling, made.labelling);
    timed(summary_.writing, [&] {
      folder_.make(key, [&](const std::filesystem::path& folder) {
        writeWalk(job_, made, folder, options_);
      });
      return 0;
    });
    const std::lock_guard lock(mutex_);
    ++summary_.made_by_status[made.row.status];
    if (made.row.status == "error") ++summary_.errors[made.row.reason];
  }

  std::shared_ptr<const BatchDrawer> makeDrawer(int scene, const BatchSceneData& data) {
    const auto library = drawers_library_.get(0, [&] { return readDrawersLibrary(job_); });
    return makeBatchDrawer(job_, scene, data, *library, limits_);
  }

  std::shared_ptr<const BatchWalker> makeWalker(const BatchItem& item, const BatchSceneData& scene,
                                                const BatchLibraryData& library) {
    const Stopwatch watch;
    auto made = makeBatchWalker(job_, item, scene, library, limits_);
    add(summary_.loading, watch.seconds() - made->seconds);
    add(summary_.planning, made->seconds);
    return made;
  }

  // How many are done.
  int count(bool kept) {
    const std::lock_guard lock(mutex_);
    ++(kept ? summary_.kept : summary_.made);
    const int done = summary_.kept + summary_.made;
    if (options_.progress) options_.progress({done, summary_.total, summary_.made});
    return done;
  }

  const BatchJob& job_;
  const BatchOptions& options_;
  const BatchFolder folder_;
  const std::vector<BatchItem> all_;
  const std::span<const BatchItem> items_;
  const std::vector<int> walker_of_;  // by item of the shard
  LoadLimits limits_;
  KeptMeshes meshes_;
  Shelf<BatchSceneData> scenes_;
  Shelf<BatchLibraryData> drawers_library_{std::vector<int>{1}};
  Shelf<BatchDrawer> drawers_;
  Shelf<BatchLibraryData> libraries_;  // by libraryOf()
  Shelf<BatchWalker> walkers_;
  std::mutex mutex_;  // of the summary
  BatchSummary summary_;
};

}  // namespace

BatchSummary runBatch(const BatchJob& job, const std::filesystem::path& folder,
                      const BatchOptions& options) {
  return BatchRun(job, folder, options).run();
}

}  // namespace amble
