#include "environments/scene/mesh_reader.h"

#include <algorithm>

#include "base/byte_pack.h"
#include "base/error.h"
#include "environments/scene/mesh_header.h"
#include "environments/scene/mesh_import.h"

namespace amble {
namespace {

// Time that reading may take: so much, and as much more as a slow machine needs for what is in the
// file [s, s a MiB]; by trial, three times what the slowest formats take.
constexpr int kLeastTime = 4;
constexpr int kTimeOfMiB = 1;

// What comes out of the guard: parts, or what was wrong.
struct Answer {
  MeshFile mesh;
  std::string problem, expected;
};

template <typename Pack, typename Mesh>
void visitMesh(Pack& pack, Mesh& mesh) {
  pack(mesh.vertices);
  size_t count = mesh.triangles.size();
  pack(count);
  mesh.triangles.resize(count);
  for (auto& t : mesh.triangles)
    for (auto& v : t) pack(v);
}

template <typename Pack>
void visitAnswer(Pack& pack, Answer& answer) {
  pack(answer.problem);
  pack(answer.expected);
  pack(answer.mesh.has_axes);
  pack(answer.mesh.others);
  size_t count = answer.mesh.parts.size();
  pack(count);
  answer.mesh.parts.resize(count);
  for (MeshPart& part : answer.mesh.parts) {
    pack(part.names);
    visitMesh(pack, part.mesh);
  }
}

Answer readUnguarded(const std::filesystem::path& file) {
  try {
    checkMeshHeader(file);
    return {importMesh(file), {}, {}};
  } catch (const InputError& error) {
    return {{}, error.problem(), error.expected()};
  }
}

// The answers of all, in their order.
GuardedAnswer readTogether(const std::vector<std::filesystem::path>& files,
                           const GuardLimits& limits) {
  return runGuarded(
      [&] {
        Packer pack;
        for (const std::filesystem::path& file : files) {
          Answer answer = readUnguarded(file);
          visitAnswer(pack, answer);
        }
        return pack.bytes();
      },
      limits);
}

bool isSmallMesh(const std::filesystem::path& file) {
  std::error_code error;
  return std::filesystem::is_regular_file(file, error) && isMeshEnding(meshEnding(file)) &&
         std::filesystem::file_size(file, error) <= kSmallMesh && !error;
}

// What can be said without opening the file. Returns its size [bytes].
size_t requireMeshFile(const std::filesystem::path& file) {
  const std::string expected = std::string("a mesh as ") + kMeshFormats;
  std::error_code error;
  if (!std::filesystem::exists(file, error))
    throw InputError(file.string(), 0, "no such file", expected);
  if (!std::filesystem::is_regular_file(file, error))
    throw InputError(file.string(), 0, "is no regular file", expected);
  if (!isMeshEnding(meshEnding(file)))
    throw InputError(file.string(), 0, "not a format for meshes", kMeshFormats);
  const size_t size = std::filesystem::file_size(file);
  if (size > kMeshFile.limit)
    throw InputError(file.string(), 0, "is too large for a mesh",
                     "at most " + sizeText(kMeshFile.limit));
  return size;
}

}  // namespace

MeshFile readMesh(const std::filesystem::path& file, size_t memory,
                  const std::function<bool()>& stopped) {
  const size_t size = requireMeshFile(file);
  const GuardLimits limits{memory, kLeastTime + kTimeOfMiB * static_cast<int>(size >> 20), stopped};
  const GuardedAnswer guarded = readTogether({file}, limits);
  if (!guarded.done())
    throw InputError(file.string(), 0, "cannot be read: " + guarded.why(limits),
                     guarded.end == GuardEnd::kMemory ? std::string(kMoreMemory)
                                                      : std::string("a mesh as ") + kMeshFormats);
  Unpacker unpack(guarded.bytes);
  Answer answer;
  visitAnswer(unpack, answer);
  if (!answer.problem.empty()) throw InputError(file.string(), 0, answer.problem, answer.expected);
  return std::move(answer.mesh);
}

std::map<std::filesystem::path, MeshFile> readSmallMeshes(
    const std::vector<std::filesystem::path>& files, size_t memory,
    const std::function<bool()>& stopped) {
  std::vector<std::filesystem::path> small;
  for (const std::filesystem::path& file : files)
    if (isSmallMesh(file)) small.push_back(file);
  std::sort(small.begin(), small.end());
  small.erase(std::unique(small.begin(), small.end()), small.end());
  std::map<std::filesystem::path, MeshFile> meshes;
  if (small.size() < 2) return meshes;
  const GuardedAnswer guarded = readTogether(small, {memory, kLeastTime, stopped});
  if (!guarded.done()) return meshes;
  Unpacker unpack(guarded.bytes);
  for (const std::filesystem::path& file : small) {
    Answer answer;
    visitAnswer(unpack, answer);
    if (answer.problem.empty()) meshes.emplace(file, std::move(answer.mesh));
  }
  return meshes;
}

}  // namespace amble
