#include "base/byte_pack.h"

#include <gtest/gtest.h>

namespace amble {
namespace {

struct Things {
  double number = 0.0;
  bool flag = false;
  std::string text;
  std::vector<Eigen::Vector3d> points;
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
};

template <typename Each, typename T>
void visit(Each& each, T& things) {
  each(things.number);
  each(things.flag);
  each(things.text);
  each(things.points);
  each(things.turn);
}

std::string packedThings() {
  const Things things{
      -1.5, true, std::string("a\0b", 3), {{1, 2, 3}, {4, 5, 6}}, {0.5, 0.5, -0.5, 0.5}};
  Packer pack;
  visit(pack, things);
  return pack.bytes();
}

TEST(BytePack, BytesThatEndTooSoonAreRefused) {
  const std::string bytes = packedThings();
  for (size_t length = 0; length < bytes.size(); ++length) {
    Unpacker unpack(std::string_view(bytes).substr(0, length));
    Things things;
    EXPECT_THROW(visit(unpack, things), std::runtime_error) << length;
  }
}

TEST(BytePack, ACountBeyondTheBytesTakesNoMemory) {
  Packer pack;
  pack(~size_t{0});
  const std::string bytes = pack.bytes();
  Unpacker unpack(bytes);
  std::vector<double> values;
  EXPECT_THROW(unpack(values), std::runtime_error);
}

TEST(BytePack, WhatIsPackedComesBack) {
  const std::string bytes = packedThings();
  Unpacker unpack(bytes);
  Things things;
  visit(unpack, things);
  EXPECT_EQ(things.number, -1.5);
  EXPECT_TRUE(things.flag);
  EXPECT_EQ(things.text, std::string("a\0b", 3));
  ASSERT_EQ(things.points.size(), 2u);
  EXPECT_EQ(things.points[1], Eigen::Vector3d(4, 5, 6));
  EXPECT_EQ(things.turn.coeffs(), Eigen::Quaterniond(0.5, 0.5, -0.5, 0.5).coeffs());
}

}  // namespace
}  // namespace amble
