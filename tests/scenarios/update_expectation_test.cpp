#include "scenarios/update_expectation.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace amble {
namespace {

TEST(WithDigest, EveryLayoutKeepsItsText) {
  const std::string begin = "scene: a\nstart: {at: [1, 1]}  # here\ngoal: {at: [2, 2]}\n";
  const std::string digest(64, 'b'), old(64, 'a');
  const auto with = [&](const std::string& text) { return withDigest(begin + text, "x", digest); };
  EXPECT_EQ(with(""), begin + "expect:\n  bvh_sha256: " + digest + "\n");
  EXPECT_EQ(with("expect:\n"), begin + "expect:\n  bvh_sha256: " + digest + "\n");
  EXPECT_EQ(with("expect:\n    status: solved  # yes\nwalk: {speed: 1}\n"),
            begin + "expect:\n    status: solved  # yes\n    bvh_sha256: " + digest +
                "\nwalk: {speed: 1}\n");
  EXPECT_EQ(with("expect: {status: solved}\n"),
            begin + "expect: {status: solved, bvh_sha256: " + digest + "}\n");
  EXPECT_EQ(with("expect: { status: solved }  # so\n"),
            begin + "expect: { status: solved, bvh_sha256: " + digest + " }  # so\n");
  EXPECT_EQ(with("expect: {}\n"), begin + "expect: {bvh_sha256: " + digest + "}\n");
  EXPECT_EQ(with("expect:\n  bvh_sha256: " + old + "  # of then\n  status: solved\n"),
            begin + "expect:\n  bvh_sha256: " + digest + "  # of then\n  status: solved\n");
}

TEST(WithDigest, ALayoutThatItCannotKeepIsRefused) {
  const std::string text =
      "scene: a\nstart: {at: [1, 1]}\ngoal: {at: [2, 2]}\nexpect: {status:\n    solved\n  }\n";
  EXPECT_THROW(withDigest(text, "x", std::string(64, 'b')), InputError);
}

}  // namespace
}  // namespace amble
