#include "environments/scene/kept_meshes.h"

#include <system_error>
#include <utility>

namespace amble {
namespace {

size_t bytesOf(const MeshFile& file) {
  size_t bytes = 0;
  for (const MeshPart& part : file.parts)
    bytes += part.mesh.vertices.size() * sizeof(Eigen::Vector3d) +
             part.mesh.triangles.size() * sizeof(std::array<int, 3>);
  return bytes;
}

}  // namespace

KeptMeshes::Stamp KeptMeshes::stampOf(const std::filesystem::path& file) {
  std::error_code unknown;
  Stamp stamp{file};
  stamp.size = std::filesystem::file_size(file, unknown);
  stamp.time = std::filesystem::last_write_time(file, unknown);
  return stamp;
}

std::shared_ptr<const MeshFile> KeptMeshes::find(const Stamp& stamp) const {
  const std::lock_guard lock(mutex_);
  for (const Kept& kept : kept_)
    if (kept.stamp == stamp) return kept.mesh;
  return nullptr;
}

void KeptMeshes::keep(const Stamp& stamp, std::shared_ptr<const MeshFile> mesh) {
  // What a file names beside itself may change while it does not.
  if (!mesh->others.empty()) return;
  const std::lock_guard lock(mutex_);
  kept_.push_back({stamp, bytesOf(*mesh), std::move(mesh)});
  bytes_ += kept_.back().bytes;
  while (bytes_ > kMost) {
    bytes_ -= kept_.front().bytes;
    kept_.pop_front();
  }
}

}  // namespace amble
