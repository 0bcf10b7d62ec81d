#include "scenarios/check_junit.h"

#include <sstream>

#include "tests/scenarios/small_room.h"

namespace amble {
namespace {

TEST(WriteJUnit, CountsAndEscapes) {
  CheckRow good, bad, skipped, error;
  good.file = "s/good.yaml";
  good.scenario = "good";
  bad.scenario = "bad & \"worse\"";
  bad.verdict = CheckVerdict::kDiffers;
  bad.notes = {"length is 5 m; expected < 4", "second"};
  skipped.verdict = CheckVerdict::kSkipped;
  error.verdict = CheckVerdict::kError;
  std::ostringstream out;
  writeJUnit(out, {good, bad, skipped, error});
  const std::string xml = out.str();
  EXPECT_TRUE(holds(xml, "tests=\"4\" failures=\"1\" errors=\"1\" skipped=\"1\"")) << xml;
  EXPECT_TRUE(holds(xml, "classname=\"s\" name=\"good\"")) << xml;
  EXPECT_TRUE(holds(xml, "name=\"bad &amp; &quot;worse&quot;\"")) << xml;
  EXPECT_TRUE(holds(xml, "expected &lt; 4; second")) << xml;
}

}  // namespace
}  // namespace amble
