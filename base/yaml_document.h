/// The values of a YAML text, as one array: what YamlNode walks over. libyaml tells its events;
/// what no reader of ours wants is refused there (strict_yaml.h).
#pragma once

#include <cstdint>
#include <memory>
#include <memory_resource>
#include <string>
#include <string_view>
#include <vector>

namespace amble {

enum class YamlKind : std::uint8_t { kNull, kScalar, kSequence, kMap };

/// A value. It comes before its children and they before what follows it, so that a child's next
/// neighbour is `span` further on, and the first child 1.
struct YamlValue {
  std::string_view text;    ///< of a scalar
  std::string_view key;     ///< of a map's child
  int line = 0;             ///< 1 for the first
  int key_line = 0;         ///< of a map's child
  std::uint32_t up = 0;     ///< so far back is its parent; 0: it is the root
  std::uint32_t index = 0;  ///< among its parent's children
  std::uint32_t size = 0;   ///< of its children
  std::uint32_t span = 1;   ///< values that it consists of, itself among them
  YamlKind kind = YamlKind::kNull;
  bool plain = false;  ///< a scalar without quotes

  const YamlValue* parent() const { return up == 0 ? nullptr : this - up; }
  const YamlValue* begin() const { return this + 1; }
  const YamlValue* end() const { return this + span; }
  const YamlValue* next() const { return this + span; }  ///< neighbour, or the parent's end()
};

/// It keeps the texts of its values, and stays where it is.
struct YamlDocument {
  explicit YamlDocument(std::string name) : file(std::move(name)) {}

  std::string file;
  std::vector<YamlValue> values;  ///< the root first
  std::pmr::monotonic_buffer_resource texts;
};

/// @param name  stands for the file in messages. @throws InputError where it is no such YAML.
std::shared_ptr<const YamlDocument> parseYamlDocument(const std::string& text,
                                                      const std::string& name);

}  // namespace amble
