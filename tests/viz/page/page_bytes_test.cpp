#include "viz/page/page_bytes.h"

#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

namespace amble {
namespace {

std::string base64(const std::string& text) {
  PageBytes bytes;
  bytes.add(std::span<const std::uint8_t>(reinterpret_cast<const std::uint8_t*>(text.data()),
                                          text.size()));
  std::ostringstream out;
  bytes.writeBase64(out);
  return out.str();
}

// RFC 4648, section 10.
TEST(PageBytes, Base64IsThatOfTheStandard) {
  const std::pair<const char*, const char*> examples[] = {{"", ""},
                                                          {"f", "Zg=="},
                                                          {"fo", "Zm8="},
                                                          {"foo", "Zm9v"},
                                                          {"foob", "Zm9vYg=="},
                                                          {"fooba", "Zm9vYmE="},
                                                          {"foobar", "Zm9vYmFy"}};
  for (const auto& [plain, coded] : examples) EXPECT_EQ(base64(plain), coded);
  EXPECT_EQ(base64(std::string("\xff\xfe\xfd\x00", 4)), "//79AA==");
}

TEST(PageBytes, ArraysBeginWhereTypedArraysMay) {
  PageBytes bytes;
  const std::array<std::uint8_t, 3> odd = {1, 2, 3};
  const std::array<std::uint16_t, 1> two = {4};
  const std::array<float, 2> numbers = {1.5f, -2.0f};
  EXPECT_EQ(bytes.add(std::span<const std::uint8_t>(odd)), R"({"t":"u8","o":0,"n":3})");
  EXPECT_EQ(bytes.add(std::span<const std::uint16_t>(two)), R"({"t":"u16","o":4,"n":1})");
  EXPECT_EQ(bytes.add(std::span<const float>(numbers)), R"({"t":"f32","o":8,"n":2})");
  EXPECT_EQ(bytes.size(), 16u);
}

}  // namespace
}  // namespace amble
