#include "viz/page/page_bytes.h"

#include <bit>

#include "base/base64.h"

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

void PageBytes::writeBase64(std::ostream& out) const { out << base64(bytes_); }

}  // namespace amble
