#include "animation/captures/find_asf.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/animation/captures.h"
#include "tests/environments/test_files.h"

namespace amble {
namespace {

/// The name of the skeleton that is found for `amc`, or the refusal, where these files lie beside.
std::string foundAmong(const std::vector<std::string>& files, const std::string& amc) {
  const TestFolder folder;
  for (const std::string& file : files) folder.write(file, "");
  std::string found;
  const std::string refused =
      errorOf([&] { found = findAsf(folder.path() / amc).filename().string(); });
  return refused.empty() ? found : refused;
}

TEST(FindAsf, WhereNoneOrSeveralAreLeftTheOptionIsNamed) {
  EXPECT_NE(foundAmong({}, "07_05.amc").find("no .asf lies beside it"), std::string::npos);
  EXPECT_NE(foundAmong({"07.bvh", "07.asf.txt"}, "07_05.amc").find("no .asf"), std::string::npos);
  const std::string several = foundAmong({"08.asf", "09.asf"}, "07_05.amc");
  EXPECT_NE(several.find("several .asf lie beside it"), std::string::npos);
  EXPECT_NE(several.find("--asf"), std::string::npos);
}

TEST(FindAsf, AFolderThatIsNotThereHoldsNone) {
  EXPECT_NE(errorOf([] { findAsf("no/such/folder/07_05.amc"); }).find("no .asf"),
            std::string::npos);
}

TEST(FindAsf, TheSameNameComesBeforeTheSubjectsAndThatBeforeTheOnlyOne) {
  EXPECT_EQ(foundAmong({"07_05.asf", "07.asf", "08.asf"}, "07_05.amc"), "07_05.asf");
  EXPECT_EQ(foundAmong({"07.asf", "08.asf"}, "07_05.amc"), "07.asf");
  EXPECT_EQ(foundAmong({"07-walk.asf", "08-run.asf"}, "07_05-walk.amc"), "07-walk.asf");
  EXPECT_EQ(foundAmong({"somebody.asf"}, "07_05.amc"), "somebody.asf");
}

TEST(FindAsf, OfThoseThatTheNameBeginsWithItIsTheLongest) {
  EXPECT_EQ(foundAmong({"07.asf", "07_05.asf", "07_05-walk.asf"}, "07_05-walk-2.amc"),
            "07_05-walk.asf");
}

// `07` is no beginning of `071_05`, and `walk` none of `walker`.
TEST(FindAsf, ANameBeginsWithWholeWordsOnly) {
  EXPECT_NE(foundAmong({"07.asf", "walk.asf"}, "071_05.amc").find("several"), std::string::npos);
  EXPECT_NE(foundAmong({"07.asf", "walk.asf"}, "walker.amc").find("several"), std::string::npos);
  EXPECT_EQ(foundAmong({"07.asf", "walk.asf"}, "walk 2.amc"), "walk.asf");
}

TEST(FindAsf, TheEndingMayBeInCapitals) {
  EXPECT_EQ(foundAmong({"07.ASF", "08.asf"}, "07_05.amc"), "07.ASF");
}

TEST(FindAsf, OfSeveralOfOneSubjectNoneIsGuessed) {
  EXPECT_NE(foundAmong({"07-walk.asf", "07-run.asf"}, "07_05.amc").find("several"),
            std::string::npos);
}

TEST(FindAsf, EveryCaptureOfTheSharedFolderHasItsOwn) {
  AMBLE_NEEDS_CAPTURES();
  for (const auto& entry :
       std::filesystem::directory_iterator(sharedFolder() / "mocap/cmu_asfamc")) {
    if (entry.path().extension() != ".amc") continue;
    const std::string amc = entry.path().stem().string(), asf = findAsf(entry.path()).stem();
    EXPECT_EQ(amc.substr(0, 2), asf.substr(0, 2));
  }
}

}  // namespace
}  // namespace amble
