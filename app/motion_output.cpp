#include "app/motion_output.h"

#include "animation/body/joint_names.h"
#include "app/command.h"
#include "base/error.h"
#include "base/output_file.h"

namespace amble {

void MotionOutput::requireFormat() const {
  if (file == "-" || isGlb() || std::filesystem::path(file).extension() == ".bvh") return;
  if (isStream(file)) return;
  throw InputError(file, 0, "no format that is written", ".bvh or .glb");
}

void addNamesOption(CLI::App& command, std::string& naming) {
  command
      .add_option("--names", naming,
                  "Name joints as other tools do, by their roles; default: as they are")
      ->check(choice(jointNamings()));
}

void addMotionOutput(CLI::App& command, MotionOutput& output) {
  command
      .add_option("-o,--output", output.file,
                  "FILE.bvh, or FILE.glb with a body; - is a BVH on standard output")
      ->type_name("FILE")
      ->required();
  command.add_option("--bvh-units", output.bvh_units, "Unit of length in the BVH")
      ->check(choice({"m", "cm"}))
      ->capture_default_str();
  addNamesOption(command, output.names);
}

}  // namespace amble
