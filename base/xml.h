/// XML as text, element by element: what SVG and JUnit files are written with. Names and texts of
/// any bytes give a file that every parser reads.
#pragma once

#include <concepts>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace amble {

/// As drawings and tables have numbers: at most three decimals, no zeros at the end, always a
/// point; "0" for what is not finite.
std::string xmlNumber(double value);

/// Text as it may stand in an element or in an attribute's quotes, of HTML too: well-formed, and
/// nothing in it that markup is made of.
std::string xmlText(std::string_view text);

struct XmlAttribute {
  XmlAttribute(std::string_view its_name, std::string_view its_value)
      : name(its_name), value(its_value) {}
  XmlAttribute(std::string_view its_name, const char* its_value)
      : name(its_name), value(its_value) {}
  XmlAttribute(std::string_view its_name, double number)
      : name(its_name), value(xmlNumber(number)) {}
  XmlAttribute(std::string_view its_name, std::integral auto number)
      : name(its_name), value(std::to_string(number)) {}

  std::string name;   ///< a name of XML: letters, digits, `-` and `:`
  std::string value;  ///< any bytes
};
using XmlAttributes = std::vector<XmlAttribute>;

/// Writes a document: one element, and others within it.
class XmlWriter {
 public:
  /// An element that is open as long as this lives.
  class Element {
   public:
    Element(const Element&) = delete;
    Element& operator=(const Element&) = delete;
    ~Element();

   private:
    friend class XmlWriter;
    Element(std::ostream& out, std::string_view name) : out_(out), name_(name) {}

    std::ostream& out_;
    const std::string name_;
  };

  /// @param out  must outlive the writer
  explicit XmlWriter(std::ostream& out) : out_(out) {}

  /// The line that a file begins with.
  void declare();
  /// An element for others to be written in; ends with the life of what is returned.
  [[nodiscard]] Element open(std::string_view name, const XmlAttributes& attributes = {});
  /// An element with nothing in it.
  void empty(std::string_view name, const XmlAttributes& attributes);
  /// An element with a text in it.
  void text(std::string_view name, const XmlAttributes& attributes, std::string_view text);

 private:
  void begin(std::string_view name, const XmlAttributes& attributes);

  std::ostream& out_;
};

}  // namespace amble
