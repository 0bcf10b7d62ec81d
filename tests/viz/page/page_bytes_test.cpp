#include "viz/page/page_bytes.h"

#include <gtest/gtest.h>

#include <array>
#include <sstream>

#include "base/base64.h"

namespace amble {
namespace {

TEST(PageBytes, ArraysBeginWhereTypedArraysMay) {
  PageBytes bytes;
  const std::array<std::uint8_t, 3> odd = {1, 2, 3};
  const std::array<std::uint16_t, 1> two = {4};
  const std::array<float, 2> numbers = {1.5f, -2.0f};
  EXPECT_EQ(bytes.add(std::span<const std::uint8_t>(odd)), R"({"t":"u8","o":0,"n":3})");
  EXPECT_EQ(bytes.add(std::span<const std::uint16_t>(two)), R"({"t":"u16","o":4,"n":1})");
  EXPECT_EQ(bytes.add(std::span<const float>(numbers)), R"({"t":"f32","o":8,"n":2})");
  std::ostringstream out;
  bytes.writeBase64(out);
  EXPECT_EQ(out.str(), base64(std::string("\1\2\3\0\4\0\0\0\0\0\xc0\x3f\0\0\0\xc0", 16)));
}

}  // namespace
}  // namespace amble
