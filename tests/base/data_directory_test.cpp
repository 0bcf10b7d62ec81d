#include "base/data_directory.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

#include "base/error.h"
#include "test_paths.h"

namespace amble {
namespace {

/// AMBLE_DATA as a test wants it, and as it was afterwards.
class DataDirectory : public testing::Test {
 protected:
  void SetUp() override {
    const char* value = std::getenv("AMBLE_DATA");
    if (value != nullptr) before_ = value;
    ::unsetenv("AMBLE_DATA");
  }
  void TearDown() override {
    if (before_.empty()) {
      ::unsetenv("AMBLE_DATA");
    } else {
      ::setenv("AMBLE_DATA", before_.c_str(), 1);
    }
  }
  std::string before_;
};

TEST_F(DataDirectory, RefusesANamedFolderWithoutData) {
  ::setenv("AMBLE_DATA", testing::TempDir().c_str(), 1);
  EXPECT_THROW(dataDirectory(), InputError);
  ::setenv("AMBLE_DATA", "/no/such/folder", 1);
  EXPECT_THROW(dataDirectory(), InputError);
}

TEST_F(DataDirectory, TakesTheNamedFolderFirst) {
  ::setenv("AMBLE_DATA", AMBLE_SOURCE_DIR "/.", 1);
  EXPECT_EQ(dataDirectory(), AMBLE_SOURCE_DIR "/.");
}

TEST_F(DataDirectory, FindsTheSourceTreeThatItWasBuiltFrom) {
  ::setenv("AMBLE_DATA", "", 1);  // as good as not set
  EXPECT_TRUE(std::filesystem::equivalent(dataDirectory(), AMBLE_SOURCE_DIR));
}

}  // namespace
}  // namespace amble
