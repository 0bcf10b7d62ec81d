/// YAML that is what it says: nothing unknown, nothing twice, no number that only looks like one.
///
/// YAML's own readers take a doubled key silently, `010` as 8 and `yes` as true. Here a doubled
/// key, an alias, a tag, a nesting deeper than kMaxYamlDepth, more values than kMaxYamlValues, a
/// second document and bytes that are no text are refused when it is read, and scalars are read by
/// the accessors below, which say what they expected. Every error is an InputError with file and
/// line.
///
///     const YamlNode root = readYaml(file);
///     root.requireKeys({"scene", "character", "start", "goal"});
///     const std::string scene = root.at("scene").asString();
///     if (const YamlNode c = root["character"]) height = c.asDouble(0.5, 2.5, "height [m]");
///     for (const YamlNode& item : root.at("via").items()) ...
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <initializer_list>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/files.h"

namespace amble {

struct YamlDocument;
struct YamlValue;

inline constexpr int kMaxYamlDepth = 100;  ///< deeper is hostile, not data
/// Maps, lists and scalars of a document: each costs about 100 bytes and half a
/// microsecond. A scene of
/// a hundred thousand objects has 1.2 million.
inline constexpr size_t kMaxYamlValues = 2'000'000;
inline constexpr FileKind kAnyYaml = {"a YAML file", size_t{64} << 20};

/// A node of a document that is kept alive by its nodes. A value: copies share the document, which
/// never changes.
class YamlNode {
 public:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  YamlNode();  ///< nothing
  /// Whether there is a node: false for operator[] of a missing key. `key:` without a value is a
  /// node, a null.
  explicit operator bool() const { return value_ != nullptr; }

  bool isMap() const;
  bool isSequence() const;
  bool isScalar() const;
  bool isNull() const;
  int line() const;  ///< 1 for the first
  const std::string& file() const;
  /// Where the node hangs, for messages: `objects[2].box.size`; empty for the root.
  std::string path() const;

  // Maps. All but isMap() throw InputError on a node that is not one.

  /// Refuses any key but these, naming the likely misspelt one.
  void requireKeys(std::initializer_list<std::string_view> known) const;
  void requireKeys(const std::vector<std::string>& known) const;
  /// The value, or nothing where the key is missing.
  YamlNode operator[](std::string_view key) const;
  /// The value. @throws InputError where the key is missing.
  YamlNode at(std::string_view key) const;
  bool has(std::string_view key) const { return static_cast<bool>((*this)[key]); }
  /// In the order of the file.
  std::vector<std::pair<std::string, YamlNode>> entries() const;

  // Sequences. @throws InputError on a node that is not one.

  std::vector<YamlNode> items() const;
  int size() const;  ///< of a sequence or map

  // Scalars, which throw InputError for another type or a value out of range. `what` names the
  // quantity and its unit in the message: "expected a height [m] of 0.5 to 2.5". Ranges include
  // their ends.

  std::string asString() const;  ///< any scalar that is not empty
  /// Decimal and finite.
  double asDouble(double min = -kInfinity, double max = kInfinity,
                  std::string_view what = "number") const;
  double asPositive(std::string_view what = "number", double max = kInfinity) const;  ///< > 0
  int asInt(int min, int max, std::string_view what = "whole number") const;
  bool asBool() const;  ///< `true` or `false` only
  /// A sequence of exactly n finite numbers.
  Eigen::VectorXd asVec(int n, std::string_view what = "numbers", double min = -kInfinity,
                        double max = kInfinity) const;
  Eigen::Vector2d asVec2(std::string_view what = "numbers") const { return asVec(2, what); }
  /// A relative path is relative to the folder of the file that names it.
  std::filesystem::path asPath() const;
  /// The value that belongs to the scalar: `role.asEnum<Role>({{"auto", Role::kAuto}, {"ground",
  /// Role::kGround}})`.
  template <typename T>
  T asEnum(std::initializer_list<std::pair<std::string_view, T>> values) const {
    std::vector<std::string> names;
    for (const auto& value : values) names.emplace_back(value.first);
    return (values.begin() + indexIn(names))->second;
  }
  /// The index of the scalar among `names`.
  int indexIn(const std::vector<std::string>& names) const;

  /// An error at this node's line: `FILE:LINE: problem; expected ...`, for rules that only the
  /// caller knows.
  [[noreturn]] void fail(const std::string& problem, const std::string& expected = "") const;

 private:
  friend YamlNode parseYaml(const std::string& text, const std::string& name);
  YamlNode(std::shared_ptr<const YamlDocument> document, const YamlValue* value);
  const YamlValue& value() const;
  const YamlValue& map() const;
  const YamlValue& sequence(const std::string& wanted) const;

  std::shared_ptr<const YamlDocument> document_;
  const YamlValue* value_ = nullptr;
};

/// @param file  `-` is standard input. @throws InputError if it is missing, unreadable, too large
/// or not such YAML.
YamlNode readYaml(const std::filesystem::path& file, const FileKind& kind = kAnyYaml);
/// @param name  stands for the file in messages, and paths are relative to its folder.
YamlNode parseYaml(const std::string& text, const std::string& name);

/// The candidate that `word` is likely a misspelling of (edit distance at most a third of its
/// length, at least 1), or "".
std::string nearestWord(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace amble
