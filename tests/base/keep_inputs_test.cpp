#include "base/keep_inputs.h"

#include <gtest/gtest.h>

#include <fstream>

#include "base/error.h"

namespace amble {
namespace {

namespace fs = std::filesystem;

TEST(KeepInputs, AnInputIsNoOutputUnderAnyNameOfIt) {
  const fs::path folder = fs::path(testing::TempDir()) / "amble_keep_inputs";
  fs::remove_all(folder);
  fs::create_directories(folder);
  const fs::path input = folder / "in.bvh", other = folder / "other.bvh";
  for (const fs::path& file : {input, other}) std::ofstream(file) << "text";
  fs::create_symlink("in.bvh", folder / "soft");
  fs::create_hard_link(input, folder / "hard");
  fs::create_directory(folder / "below");
  for (const char* name : {"in.bvh", "soft", "hard", "below/../in.bvh", "./in.bvh"}) {
    EXPECT_THROW(keepInputs(folder / name, {other, input}), InputError) << name;
    EXPECT_THROW(keepInputs(input, {folder / name}), InputError) << name;
  }
  EXPECT_NO_THROW(keepInputs(other, {input}));
  EXPECT_NO_THROW(keepInputs(folder / "new", {input}));
  EXPECT_NO_THROW(keepInputs(other, {folder / "missing"}));
  EXPECT_NO_THROW(keepInputs("-", {input, "-"}));
  fs::remove_all(folder);
}

}  // namespace
}  // namespace amble
