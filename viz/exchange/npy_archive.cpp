#include "viz/exchange/npy_archive.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <stdexcept>

#include "base/text.h"

namespace amble {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie");

// Numbers of a ZIP's headers, lowest byte first.
void appendNumber(std::string& out, uint32_t number, int bytes) {
  for (int i = 0; i < bytes; ++i) out += static_cast<char>(number >> (8 * i) & 0xff);
}

template <typename T>
std::string_view bytesOf(std::span<const T> values) {
  return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

// "(121, 3)", "(5,)" or "()": a tuple as Python writes it.
std::string tupleOf(const NpyShape& shape) {
  std::vector<std::string> lengths;
  for (const size_t length : shape) lengths.push_back(std::to_string(length));
  return "(" + joined(lengths) + (shape.size() == 1 ? ",)" : ")");
}

// The characters of UTF-8 text. @pre it is what utf8Text() returns
std::vector<uint32_t> charactersOf(std::string_view text) {
  std::vector<uint32_t> characters;
  for (const char c : text) {
    const auto byte = static_cast<uint8_t>(c);
    if ((byte & 0xc0) == 0x80) {  // goes on
      characters.back() = characters.back() << 6 | (byte & 0x3f);
    } else {
      const int lead = byte < 0x80 ? 0x7f : byte < 0xe0 ? 0x1f : byte < 0xf0 ? 0x0f : 0x07;
      characters.push_back(byte & lead);
    }
  }
  return characters;
}

// What a file's local header and its entry in the directory have in common.
std::string zipFacts(const std::string& name, const std::string& bytes) {
  constexpr uint32_t kVersion = 20, kTime = 0, kDate = 1 << 5 | 1;  // 1980-01-01
  const auto size = static_cast<uint32_t>(bytes.size());
  const uLong sum = crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), size);
  std::string facts;
  for (const uint32_t number : {kVersion, 0u, 0u, kTime, kDate}) appendNumber(facts, number, 2);
  for (const uint32_t number : {static_cast<uint32_t>(sum), size, size})
    appendNumber(facts, number, 4);
  appendNumber(facts, static_cast<uint32_t>(name.size()), 2);
  appendNumber(facts, 0, 2);  // no extra fields
  return facts;
}

}  // namespace

void NpyArchive::addBytes(const std::string& name, std::string_view type, const NpyShape& shape,
                          std::string_view values) {
  constexpr size_t kAlign = 64;  // of the values, from the begin of the file
  std::string header = "{'descr': '" + std::string(type) +
                       "', 'fortran_order': False, 'shape': " + tupleOf(shape) + ", }";
  constexpr size_t kBefore = 10;  // magic, version, length of the header
  header.append(kAlign - 1 - (kBefore + header.size()) % kAlign, ' ');
  header += '\n';
  std::string file("\x93NUMPY\x01\x00", 8);
  appendNumber(file, static_cast<uint32_t>(header.size()), 2);
  file += header;
  file += values;
  entries_.push_back({name + ".npy", std::move(file)});
}

void NpyArchive::add(const std::string& name, std::span<const double> values,
                     const NpyShape& shape) {
  addBytes(name, "<f8", shape, bytesOf(values));
}

void NpyArchive::add(const std::string& name, std::span<const float> values,
                     const NpyShape& shape) {
  addBytes(name, "<f4", shape, bytesOf(values));
}

void NpyArchive::add(const std::string& name, std::span<const int32_t> values,
                     const NpyShape& shape) {
  addBytes(name, "<i4", shape, bytesOf(values));
}

void NpyArchive::addFile(const std::string& name, std::string bytes) {
  entries_.push_back({name, std::move(bytes)});
}

void NpyArchive::addBools(const std::string& name, std::span<const uint8_t> values,
                          const NpyShape& shape) {
  addBytes(name, "|b1", shape, bytesOf(values));
}

void NpyArchive::addTexts(const std::string& name, std::span<const std::string> values,
                          const NpyShape& shape) {
  std::vector<std::vector<uint32_t>> texts;
  size_t longest = 1;
  for (const std::string& value : values) {
    texts.push_back(charactersOf(utf8Text(value)));
    longest = std::max(longest, texts.back().size());
  }
  std::vector<uint32_t> padded;
  for (std::vector<uint32_t>& text : texts) {
    text.resize(longest);
    padded.insert(padded.end(), text.begin(), text.end());
  }
  addBytes(name, "<U" + std::to_string(longest), shape, bytesOf<uint32_t>(padded));
}

void NpyArchive::write(std::ostream& out) const {
  constexpr uint64_t kMost = UINT32_MAX;
  std::string directory;
  uint64_t offset = 0;
  for (const Entry& entry : entries_) {
    if (offset + entry.bytes.size() > kMost) throw std::length_error("NPZ of 4 GB or more");
    const std::string facts = zipFacts(entry.name, entry.bytes);
    const std::string header = "PK\x03\x04" + facts + entry.name;
    directory += "PK\x01\x02";
    appendNumber(directory, 20, 2);  // version that made it, of MS-DOS' kind
    directory += facts;
    for (int i = 0; i < 5; ++i) appendNumber(directory, 0, 2);  // comment, disk, attributes
    appendNumber(directory, static_cast<uint32_t>(offset), 4);
    directory += entry.name;
    out << header << entry.bytes;
    offset += header.size() + entry.bytes.size();
  }
  std::string end = "PK\x05\x06";
  const auto count = static_cast<uint32_t>(entries_.size());
  for (const uint32_t number : {0u, 0u, count, count}) appendNumber(end, number, 2);
  appendNumber(end, static_cast<uint32_t>(directory.size()), 4);
  appendNumber(end, static_cast<uint32_t>(offset), 4);
  appendNumber(end, 0, 2);  // no comment
  out << directory << end;
}

}  // namespace amble
