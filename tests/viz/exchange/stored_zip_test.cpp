#include "viz/exchange/stored_zip.h"

#include <gtest/gtest.h>

#include <sstream>

#include "base/error.h"
#include "viz/exchange/npy_archive.h"

namespace amble {
namespace {

std::string archive() {
  NpyArchive of;
  const std::vector<float> values = {1.0f, 2.5f};
  of.addFile("a/row.json", "{}\n");
  of.add("numbers", values, {2});
  std::ostringstream out;
  of.write(out);
  return out.str();
}

TEST(StoredZip, GivesBackWhatWasStored) {
  const auto entries = readStoredZip(archive(), "it");
  ASSERT_EQ(entries.size(), 2u);
  EXPECT_EQ(entries[0].name, "a/row.json");
  EXPECT_EQ(entries[0].bytes, "{}\n");
  EXPECT_EQ(entries[1].name, "numbers.npy");
  EXPECT_NE(entries[1].bytes.find("'<f4'"), std::string::npos);
}

TEST(StoredZip, RefusesWhatIsCutOffAnywhereDeflatedOrNone) {
  const std::string zip = archive();
  for (size_t length = 0; length < zip.find("PK\1\2") + 4; ++length)
    EXPECT_THROW(readStoredZip(std::string_view(zip).substr(0, length), "it"), InputError)
        << length;
  std::string deflated = zip;
  deflated[8] = 8;
  EXPECT_THROW(readStoredZip(deflated, "it"), InputError);
  EXPECT_THROW(readStoredZip("nothing of the kind", "it"), InputError);
}

}  // namespace
}  // namespace amble
