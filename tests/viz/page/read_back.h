/// What a page's bytes hold, as its program reads them.
#pragma once

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "viz/page/page_bytes.h"

namespace amble {

/// Bytes of RFC 4648's base64.
inline std::string decodedBase64(const std::string& text) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0, count = 0;
  for (const char c : text) {
    const size_t digit = digits.find(c);
    if (digit == std::string::npos) continue;
    bits = bits << 6 | static_cast<unsigned>(digit);
    count += 6;
    if (count >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 0xff);
  }
  return bytes;
}

template <typename Value>
std::vector<double> valuesAt(const std::string& bytes, size_t offset, size_t count) {
  std::vector<double> values;
  for (size_t i = 0; i < count; ++i) {
    Value value{};
    std::memcpy(&value, bytes.data() + offset + sizeof(Value) * i, sizeof(Value));
    values.push_back(static_cast<double>(value));
  }
  return values;
}

/// The array that `ref` names, times its scale; without one 16-bit numbers with a sign are of
/// `unit`.
inline std::vector<double> readBack(const PageBytes& bytes, const nlohmann::json& ref,
                                    double unit = 1.0) {
  std::ostringstream base64;
  bytes.writeBase64(base64);
  const std::string all = decodedBase64(base64.str());
  const size_t offset = ref["o"], count = ref["n"];
  const std::string type = ref["t"];
  if (type == "f32") return valuesAt<float>(all, offset, count);
  if (type == "u8") return valuesAt<std::uint8_t>(all, offset, count);
  if (type == "u16") return valuesAt<std::uint16_t>(all, offset, count);
  if (type == "u32") return valuesAt<std::uint32_t>(all, offset, count);
  std::vector<double> values = valuesAt<std::int16_t>(all, offset, count);
  for (double& value : values) value *= ref.value("scale", unit);
  return values;
}

}  // namespace amble
