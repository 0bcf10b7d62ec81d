// An AMC of any bytes, on a skeleton with every degree of freedom.
#include "animation/captures/asf_amc.h"
#include "tests/fuzz/fuzz.h"

namespace {

constexpr std::string_view kAsf =
    ":units\nlength 0.45\nangle deg\n:root\norder TX TY TZ RX RY RZ\n:bonedata\n"
    "begin name thigh direction 0 -1 0 length 7 axis 0 0 20 XYZ dof rx ry rz\nend\n"
    "begin name shin direction 0 -1 0 length 8 axis 0 0 20 ZYX dof rx tx l\nend\n"
    "begin name toe direction 0 0 1 length 2\nend\n"
    ":hierarchy\nbegin\nroot thigh\nthigh shin\nshin toe\nend\n";

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string_view amc = amble::textOf(data, size);
  amble::readOrRefuse("fuzz.amc", [&] {
    return amble::parseAsfAmc({kAsf, "fixed.asf"}, {amc, "fuzz.amc"});
  });
  return 0;
}
