#include "base/xml.h"

#include <cmath>

#include "base/text.h"

namespace amble {

std::string xmlText(std::string_view text) {
  std::string safe;
  for (const char c : utf8Text(text)) {
    switch (c) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      default:
        safe += c;
    }
  }
  return safe;
}

std::string xmlNumber(double value) {
  constexpr int kDecimals = 3;
  return std::isfinite(value) ? plainNumber(value, kDecimals) : "0";
}

XmlWriter::Element::~Element() { out_ << "</" << name_ << ">\n"; }

void XmlWriter::declare() { out_ << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"; }

void XmlWriter::begin(std::string_view name, const XmlAttributes& attributes) {
  out_ << '<' << name;
  for (const XmlAttribute& attribute : attributes) {
    out_ << ' ' << attribute.name << "=\"" << xmlText(attribute.value) << '"';
  }
}

XmlWriter::Element XmlWriter::open(std::string_view name, const XmlAttributes& attributes) {
  begin(name, attributes);
  out_ << ">\n";
  return {out_, name};
}

void XmlWriter::empty(std::string_view name, const XmlAttributes& attributes) {
  begin(name, attributes);
  out_ << "/>\n";
}

void XmlWriter::text(std::string_view name, const XmlAttributes& attributes,
                     std::string_view text) {
  begin(name, attributes);
  out_ << '>' << xmlText(text) << "</" << name << ">\n";
}

}  // namespace amble
