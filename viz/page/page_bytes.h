/// The numbers of a page: arrays one after another in one run of bytes, which the page holds as
/// base64 and its program looks at in place, without copying.
///
/// Little-endian, as every browser's typed arrays are on the machines that there are. An array
/// begins at a multiple of four bytes. What add() returns is JSON,
/// `{"t":"f32","o":OFFSET,"n":COUNT}`, for the page's data to name the array by.
#pragma once

#include <cstdint>
#include <ostream>
#include <span>
#include <string>

namespace amble {

class PageBytes {
 public:
  std::string add(std::span<const float> values) { return add("f32", values); }
  std::string add(std::span<const std::int16_t> values) { return add("i16", values); }
  std::string add(std::span<const std::uint8_t> values) { return add("u8", values); }
  std::string add(std::span<const std::uint16_t> values) { return add("u16", values); }
  std::string add(std::span<const std::uint32_t> values) { return add("u32", values); }

  size_t size() const { return bytes_.size(); }
  void writeBase64(std::ostream& out) const;  ///< in one line

 private:
  template <typename Value>
  std::string add(const char* type, std::span<const Value> values);

  std::string bytes_;
};

}  // namespace amble
