// An FBX, glTF or Collada file of any bytes; AMBLE_FUZZ_NAME is its name, whose end says which.
#include "animation/captures/node_file.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  amble::readOrRefuse(AMBLE_FUZZ_NAME, [&] {
    return amble::parseNodeFile(amble::textOf(data, size), AMBLE_FUZZ_NAME);
  });
  return 0;
}
