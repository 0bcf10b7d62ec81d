#include "viz/exchange/collada.h"

#include <charconv>

namespace amble {
namespace {

const ColladaKind kPoints = {"float_array", "float", {"X", "Y", "Z"}, 3};

std::string colorName(size_t i) { return "color" + std::to_string(i); }

}  // namespace

void ColladaList::put(std::string_view word) {
  if (!text_.empty()) text_ += ' ';
  text_ += word;
}

void ColladaList::put(double number) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, static_cast<float>(number) + 0.0f);
  put(std::string_view(text, end.ptr));
}

void ColladaList::put(const Eigen::Vector3f& p) {
  for (int i = 0; i < 3; ++i) put(static_cast<double>(p[i]));
}

void ColladaList::put(const Eigen::Matrix4d& matrix) {
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) put(matrix(row, column));
}

XmlAttributes colladaAttributes() {
  return {{"xmlns", "http://www.collada.org/2005/11/COLLADASchema"}, {"version", "1.4.1"}};
}

void writeColladaAsset(XmlWriter& xml) {
  const auto asset = xml.open("asset");
  xml.text("created", {}, "1980-01-01T00:00:00Z");
  xml.text("modified", {}, "1980-01-01T00:00:00Z");
  xml.empty("unit", {{"name", "meter"}, {"meter", "1"}});
  xml.text("up_axis", {}, "Z_UP");
}

void writeColladaColors(XmlWriter& xml, const ColladaTriangles& triangles) {
  {
    const auto effects = xml.open("library_effects");
    size_t i = 0;
    for (const auto& [color, corners] : triangles) {
      const auto effect = xml.open("effect", {{"id", colorName(i++) + "-effect"}});
      const auto profile = xml.open("profile_COMMON");
      const auto technique = xml.open("technique", {{"sid", "common"}});
      const auto shader = xml.open("lambert");
      const auto diffuse = xml.open("diffuse");
      ColladaList rgba;
      for (const std::uint8_t channel : color) rgba.put(channel / 255.0);
      rgba.put(1.0);
      xml.text("color", {}, rgba.text());
    }
  }
  const auto materials = xml.open("library_materials");
  for (size_t i = 0; i < triangles.size(); ++i) {
    const auto material = xml.open("material", {{"id", colorName(i)}, {"name", colorName(i)}});
    xml.empty("instance_effect", {{"url", "#" + colorName(i) + "-effect"}});
  }
}

void writeColladaSource(XmlWriter& xml, const std::string& id, const ColladaKind& kind,
                        const ColladaList& list, size_t count) {
  const auto source = xml.open("source", {{"id", id}});
  xml.text(kind.array, {{"id", id + "-array"}, {"count", count * kind.stride}}, list.text());
  const auto technique = xml.open("technique_common");
  const auto accessor = xml.open(
      "accessor", {{"source", "#" + id + "-array"}, {"count", count}, {"stride", kind.stride}});
  for (const char* parameter : kind.parameters)
    xml.empty("param", {{"name", parameter}, {"type", kind.type}});
}

void writeColladaMesh(XmlWriter& xml, const std::string& name,
                      const std::vector<Eigen::Vector3f>& positions,
                      const std::vector<Eigen::Vector3f>& normals,
                      const ColladaTriangles& triangles) {
  const auto library = xml.open("library_geometries");
  const auto geometry = xml.open("geometry", {{"id", name + "-mesh"}, {"name", name}});
  const auto mesh = xml.open("mesh");
  ColladaList places, directions;
  for (const Eigen::Vector3f& p : positions) places.put(p);
  for (const Eigen::Vector3f& n : normals) directions.put(n);
  writeColladaSource(xml, name + "-positions", kPoints, places, positions.size());
  writeColladaSource(xml, name + "-normals", kPoints, directions, normals.size());
  {
    const auto vertices = xml.open("vertices", {{"id", name + "-vertices"}});
    xml.empty("input", {{"semantic", "POSITION"}, {"source", "#" + name + "-positions"}});
  }
  size_t i = 0;
  for (const auto& [color, corners] : triangles) {
    const auto group =
        xml.open("triangles", {{"material", colorName(i++)}, {"count", corners.size() / 3}});
    xml.empty("input",
              {{"semantic", "VERTEX"}, {"source", "#" + name + "-vertices"}, {"offset", 0}});
    xml.empty("input",
              {{"semantic", "NORMAL"}, {"source", "#" + name + "-normals"}, {"offset", 1}});
    ColladaList list;
    for (const ColladaCorner& corner : corners) {
      list.put(size_t{corner.position});
      list.put(size_t{corner.normal});
    }
    xml.text("p", {}, list.text());
  }
}

void bindColladaColors(XmlWriter& xml, const ColladaTriangles& triangles) {
  const auto bind = xml.open("bind_material");
  const auto technique = xml.open("technique_common");
  for (size_t i = 0; i < triangles.size(); ++i)
    xml.empty("instance_material", {{"symbol", colorName(i)}, {"target", "#" + colorName(i)}});
}

void writeColladaEnd(XmlWriter& xml) {
  const auto scene = xml.open("scene");
  xml.empty("instance_visual_scene", {{"url", "#scene"}});
}

}  // namespace amble
