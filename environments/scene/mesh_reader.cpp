#include "environments/scene/mesh_reader.h"

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

std::string packed(Answer answer) {
  Packer pack;
  pack(answer.problem);
  pack(answer.expected);
  pack(answer.mesh.has_axes);
  pack(answer.mesh.others);
  pack(answer.mesh.parts.size());
  for (MeshPart& part : answer.mesh.parts) {
    pack(part.names);
    visitMesh(pack, part.mesh);
  }
  return pack.bytes();
}

Answer unpacked(const std::string& bytes) {
  Unpacker unpack(bytes);
  Answer answer;
  unpack(answer.problem);
  unpack(answer.expected);
  unpack(answer.mesh.has_axes);
  unpack(answer.mesh.others);
  answer.mesh.parts.resize(unpack.takeCount());
  for (MeshPart& part : answer.mesh.parts) {
    unpack(part.names);
    visitMesh(unpack, part.mesh);
  }
  return answer;
}

std::string readPacked(const std::filesystem::path& file) {
  Answer answer;
  try {
    checkMeshHeader(file);
    answer.mesh = importMesh(file);
  } catch (const InputError& error) {
    answer = {{}, error.problem(), error.expected()};
  }
  return packed(std::move(answer));
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
  const GuardedAnswer guarded = runGuarded([&] { return readPacked(file); }, limits);
  if (!guarded.done())
    throw InputError(file.string(), 0, "cannot be read: " + guarded.why(limits),
                     guarded.end == GuardEnd::kMemory ? std::string(kMoreMemory)
                                                      : std::string("a mesh as ") + kMeshFormats);
  Answer answer = unpacked(guarded.bytes);
  if (!answer.problem.empty()) throw InputError(file.string(), 0, answer.problem, answer.expected);
  return std::move(answer.mesh);
}

}  // namespace amble
