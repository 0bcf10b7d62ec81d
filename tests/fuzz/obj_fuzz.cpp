// OBJ of any bytes. The reader that we call is compiled here, so that it is watched too.
#define TINYOBJLOADER_IMPLEMENTATION
#define TINYOBJLOADER_USE_DOUBLE
#include <tiny_obj_loader.h>

#include <algorithm>

#include "environments/scene/obj_import.h"
#include "tests/fuzz/fuzz.h"

namespace {

// Parts of triangles whose corners are there and finite.
void checkMesh(const amble::MeshFile& file) {
  amble::promise(!file.parts.empty());
  for (const amble::MeshPart& part : file.parts) {
    const int vertices = static_cast<int>(part.mesh.vertices.size());
    for (const Eigen::Vector3d& p : part.mesh.vertices) amble::promise(p.allFinite());
    amble::promise(!part.mesh.triangles.empty());
    for (const auto& t : part.mesh.triangles)
      for (const int corner : t) amble::promise(corner >= 0 && corner < vertices);
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string text(amble::textOf(data, size));
  try {
    checkMesh(amble::parseObj(text, "fuzz.obj"));
  } catch (const amble::InputError& error) {
    amble::promise(error.file() == "fuzz.obj" && !error.problem().empty());
    amble::promise(std::string_view(error.what()).find('\n') == std::string_view::npos);
    amble::promise(error.line() <= 1 + std::count(text.begin(), text.end(), '\n') +
                                       std::count(text.begin(), text.end(), '\r'));
  }
  return 0;
}
