/// Parts of a COLLADA 1.4.1 document, z up and in metres, that skins and rooms share.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/xml.h"

namespace amble {

/// A list of numbers or words, with blanks between.
class ColladaList {
 public:
  void put(std::string_view word);
  void put(double number);  ///< as a float, in as few digits as say it
  void put(size_t number) { put(std::string_view(std::to_string(number))); }
  void put(const Eigen::Vector3f& p);
  void put(const Eigen::Matrix4d& matrix);  ///< row by row
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// Of a source: what it holds, in how many numbers each thing.
struct ColladaKind {
  const char* array;  ///< the element that lists them
  const char* type;
  std::vector<const char*> parameters;
  size_t stride;
};

/// sRGB [0 to 255].
using ColladaColor = std::array<std::uint8_t, 3>;
/// A corner of a triangle: indices of its position and its normal.
struct ColladaCorner {
  std::uint32_t position = 0, normal = 0;
};
/// Triangles by their colour, three corners each.
using ColladaTriangles = std::map<ColladaColor, std::vector<ColladaCorner>>;

/// Of the document's element, COLLADA.
XmlAttributes colladaAttributes();
/// Its first part: unit and axis. The dates are asked for, and say nothing: the same walk gives the
/// same bytes.
void writeColladaAsset(XmlWriter& xml);
/// A material for each colour.
void writeColladaColors(XmlWriter& xml, const ColladaTriangles& triangles);
void writeColladaSource(XmlWriter& xml, const std::string& id, const ColladaKind& kind,
                        const ColladaList& list, size_t count);
/// The geometry `NAME-mesh`.
void writeColladaMesh(XmlWriter& xml, const std::string& name,
                      const std::vector<Eigen::Vector3f>& positions,
                      const std::vector<Eigen::Vector3f>& normals,
                      const ColladaTriangles& triangles);
/// Of an instance: which colour is which material.
void bindColladaColors(XmlWriter& xml, const ColladaTriangles& triangles);
/// Asks for the one visual scene, "scene".
void writeColladaEnd(XmlWriter& xml);

}  // namespace amble
