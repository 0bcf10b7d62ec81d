/// YAML as text, value by value: maps and lists with an entry a line, two blanks further in than
/// what holds them, or, in flow style, on one line. Texts of any bytes give a file that every
/// reader of YAML 1.1 or 1.2 takes, and a text stays a text there.
#pragma once

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace amble {

/// Writes one document, whose last line it leaves open:
///
///     YamlWriter out(stream);
///     out.beginMap();
///     out.key("name").text("stand");
///     out.key("frames").beginList(YamlWriter::kFlow);
///     out.whole(0).whole(90);
///     out.end().end();                  // name: stand, frames: [0, 90]
class YamlWriter {
 public:
  enum Style { kBlock, kFlow };  ///< within flow all is flow

  explicit YamlWriter(std::ostream& out) : out_(out) {}

  YamlWriter& beginMap(Style style = kBlock) { return begin(true, style); }
  YamlWriter& beginList(Style style = kBlock) { return begin(false, style); }
  YamlWriter& end();  ///< of the innermost map or list
  /// Of the map's next value.
  YamlWriter& key(std::string_view name);

  /// As it stands: a number.
  YamlWriter& plain(std::string_view scalar);
  YamlWriter& whole(long long number) { return plain(std::to_string(number)); }
  YamlWriter& truth(bool value) { return plain(value ? "true" : "false"); }
  /// In quotes where it would else be something else.
  YamlWriter& text(std::string_view value);
  YamlWriter& quoted(std::string_view value);

 private:
  struct Level {
    bool is_map;
    bool is_flow;
    int indent;      // of its entries [blanks]
    bool is_inline;  // its first entry stands behind the dash of a list
    bool is_empty = true;
    bool has_key = false;  // and waits for its value
  };

  YamlWriter& begin(bool is_map, Style style);
  bool inFlow() const { return !levels_.empty() && levels_.back().is_flow; }
  void startEntry();
  void startScalar();
  void newLine(int indent);

  std::ostream& out_;
  std::vector<Level> levels_;
};

}  // namespace amble
