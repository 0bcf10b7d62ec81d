// make_furniture FOLDER: writes the meshes of environments/scenes there, as they are committed:
// FOLDER/living-room/meshes/*.obj, FOLDER/goal-inside-closed-cupboard/meshes/cupboard.obj and
// FOLDER/rolling-terrain/meshes/terrain.obj.
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "environments/furniture/furniture.h"

namespace {

void writePiece(const std::filesystem::path& folder, const amble::Furniture& piece) {
  std::filesystem::create_directories(folder);
  const std::filesystem::path file = folder / (piece.name + ".obj");
  std::ofstream out(file, std::ios::binary);
  amble::writeObj(out, piece);
  out.close();
  if (!out) throw std::runtime_error(file.string() + ": cannot be written");
  std::printf("%6d triangles  %s\n", piece.triangleCount(), file.string().c_str());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: make_furniture FOLDER\n");
    return 2;
  }
  try {
    const std::filesystem::path folder = argv[1];
    for (const amble::Furniture& piece : amble::makeLivingRoomFurniture())
      writePiece(folder / "living-room" / "meshes", piece);
    writePiece(folder / "goal-inside-closed-cupboard" / "meshes", amble::makeCupboard());
    writePiece(folder / "rolling-terrain" / "meshes", amble::makeTerrain());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
  return 0;
}
