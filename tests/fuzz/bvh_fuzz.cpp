// BVH of any bytes.
#include "animation/captures/bvh.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  amble::readOrRefuse("fuzz.bvh",
                      [&] { return amble::parseBvh(amble::textOf(data, size), "fuzz.bvh"); });
  return 0;
}
