#include "viz/page/page_bytes.h"

#include <bit>

namespace amble {

static_assert(std::endian::native == std::endian::little, "arrays are written as they lie");

template <typename Value>
std::string PageBytes::add(const char* type, std::span<const Value> values) {
  bytes_.resize((bytes_.size() + 3) / 4 * 4);
  const size_t offset = bytes_.size();
  bytes_.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  return std::string("{\"t\":\"") + type + "\",\"o\":" + std::to_string(offset) +
         ",\"n\":" + std::to_string(values.size()) + "}";
}
template std::string PageBytes::add(const char*, std::span<const float>);
template std::string PageBytes::add(const char*, std::span<const std::int16_t>);
template std::string PageBytes::add(const char*, std::span<const std::uint8_t>);
template std::string PageBytes::add(const char*, std::span<const std::uint16_t>);
template std::string PageBytes::add(const char*, std::span<const std::uint32_t>);

void PageBytes::writeBase64(std::ostream& out) const {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes_.size() + 2) / 3 * 4);
  for (size_t i = 0; i < bytes_.size(); i += 3) {
    const auto at = [&](size_t k) -> std::uint32_t {
      return k < bytes_.size() ? static_cast<unsigned char>(bytes_[k]) : 0;
    };
    const std::uint32_t three = at(i) << 16 | at(i + 1) << 8 | at(i + 2);
    text += kDigits[three >> 18];
    text += kDigits[three >> 12 & 63];
    text += i + 1 < bytes_.size() ? kDigits[three >> 6 & 63] : '=';
    text += i + 2 < bytes_.size() ? kDigits[three & 63] : '=';
  }
  out << text;
}

}  // namespace amble
