/// Mesh files that were read, kept for the scenes that are read next and name them too.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>

#include "environments/scene/mesh_reader.h"

namespace amble {

/// Threads may ask and keep at a time.
class KeptMeshes {
 public:
  /// When there is more than so much, what was kept first goes [bytes].
  static constexpr size_t kMost = size_t{32} << 20;

  /// Which file it was: who writes it again changes its time or its size.
  struct Stamp {
    std::filesystem::path file;
    std::uintmax_t size = 0;
    std::filesystem::file_time_type time = {};

    bool operator==(const Stamp& other) const = default;
  };
  /// As it is now.
  static Stamp stampOf(const std::filesystem::path& file);

  /// What was read of it, or null.
  std::shared_ptr<const MeshFile> find(const Stamp& stamp) const;
  /// @param stamp  of before it was read
  void keep(const Stamp& stamp, std::shared_ptr<const MeshFile> mesh);

 private:
  struct Kept {
    Stamp stamp;
    size_t bytes = 0;
    std::shared_ptr<const MeshFile> mesh;
  };

  mutable std::mutex mutex_;
  std::deque<Kept> kept_;
  size_t bytes_ = 0;  // of all
};

}  // namespace amble
