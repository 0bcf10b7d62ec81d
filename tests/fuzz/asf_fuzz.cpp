// An ASF of any bytes, with an AMC that names no bone but the root.
#include "animation/captures/asf_amc.h"
#include "tests/fuzz/fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  constexpr std::string_view kAmc = ":DEGREES\n1\nroot 1 2 3 4 5 6\n2\nroot 1 2 3 4 5 6\n";
  const std::string_view asf = amble::textOf(data, size);
  try {
    amble::checkClip(amble::parseAsfAmc({asf, "fuzz.asf"}, {kAmc, "fixed.amc"}));
  } catch (const amble::InputError& error) {
    amble::promise(error.file() == "fuzz.asf" || error.file() == "fixed.amc");
    amble::promise(error.line() >= 1);
  }
  return 0;
}
