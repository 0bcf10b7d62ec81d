// An FBX, glTF or Collada file of any bytes, through Assimp; AMBLE_FUZZ_NAME is its name, whose end
// says which.
#include "animation/captures/assimp_motion.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  amble::readOrRefuse(AMBLE_FUZZ_NAME, [&] {
    return amble::parseAssimpMotion(amble::textOf(data, size), AMBLE_FUZZ_NAME);
  });
  return 0;
}
