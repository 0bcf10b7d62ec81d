/// When a search stops: at its counted limit, and, without deciding anything, at a time limit or
/// when it is told to.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>

namespace amble {

/// How far a search is, for a progress bar.
struct SearchProgress {
  const char* phase = "";  ///< "roadmap", "refine", ...
  long long done = 0;      ///< of `total`; a search that is lucky ends sooner
  long long total = 0;
  int guards = 0;
  int connectors = 0;
};

struct SearchLimits {
  std::uint64_t seed = 1;
  /// M: failures in a row to add a guard [1 to 1e6]; other planners say what they count.
  int max_failures = 500;
  int threads = 1;  ///< [1 to 64]; changes no result
  std::optional<std::chrono::steady_clock::time_point>
      deadline;                             ///< only stops; whoever asks reports that it did
  const std::atomic<bool>* stop = nullptr;  ///< Ctrl-C
  std::function<void(const SearchProgress&)> progress;  ///< called from the calling thread
  std::function<bool()> interrupted;  ///< another's word to stop; called from any thread

  bool timeIsUp() const { return deadline && std::chrono::steady_clock::now() >= *deadline; }
  bool stopped() const {
    return (stop && stop->load(std::memory_order_relaxed)) || timeIsUp() ||
           (interrupted && interrupted());
  }
};

}  // namespace amble
