#include "viz/pictures/color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string_view>
#include <vector>

#include "base/text.h"

namespace amble {

Color mix(const Color& a, const Color& b, float share) { return a + share * (b - a); }

Color sideColor(Side side) { return side == kLeft ? rgb(31, 105, 190) : rgb(225, 112, 20); }

Color timeColor(double share) {
  static const std::array<Color, 5> kStops = {rgb(20, 150, 160), rgb(60, 100, 205),
                                              rgb(150, 70, 190), rgb(225, 75, 105),
                                              rgb(245, 165, 40)};
  const double at = std::clamp(share, 0.0, 1.0) * (kStops.size() - 1);
  const int i = std::min(static_cast<int>(at), static_cast<int>(kStops.size()) - 2);
  return mix(kStops[i], kStops[i + 1], static_cast<float>(at - i));
}

namespace {

struct Material {
  const char* word;  // in lower case; the first that a name holds counts
  Color color;
};

const std::vector<Material>& materials() {
  static const Color wood = rgb(158, 116, 78), dark_wood = rgb(104, 72, 50);
  static const std::vector<Material> all = {
      {"leaves", rgb(84, 132, 76)},
      {"stems", rgb(106, 128, 70)},
      {"pot", rgb(176, 108, 80)},
      {"plant", rgb(84, 132, 76)},
      {"white-key", rgb(240, 236, 224)},
      {"black-key", rgb(34, 34, 38)},
      {"key", rgb(52, 48, 50)},
      {"strings", rgb(196, 170, 110)},
      {"plate", rgb(188, 150, 84)},
      {"pedal", rgb(200, 168, 96)},
      {"music", rgb(244, 242, 234)},
      {"shade", rgb(240, 222, 180)},
      {"bulb", rgb(255, 246, 214)},
      {"pillow", rgb(212, 150, 78)},
      {"canvas", rgb(120, 150, 160)},
      {"bookshelf", rgb(150, 110, 76)},
      {"books", rgb(150, 100, 86)},
      {"magazine", rgb(190, 200, 205)},
      {"bowl", rgb(90, 140, 140)},
      {"vase", rgb(176, 96, 72)},
      {"piano-stool", rgb(120, 44, 40)},
      {"piano", rgb(58, 52, 54)},
      {"sofa", rgb(86, 110, 136)},
      {"armchair", rgb(110, 132, 110)},
      {"lamp", rgb(120, 112, 100)},
      {"low-table", wood},
      {"table", wood},
      {"chair", rgb(176, 134, 92)},
      {"stool", wood},
      {"desk", wood},
      {"shelf", rgb(190, 164, 128)},
      {"cupboard", rgb(200, 184, 156)},
      {"door", rgb(214, 206, 190)},
      {"picture", dark_wood},
      {"skirting", rgb(238, 236, 230)},
      {"bed", rgb(150, 160, 184)},
      {"rug", rgb(150, 70, 62)},
      {"carpet", rgb(150, 70, 62)},
      {"column", rgb(206, 202, 194)},
  };
  return all;
}

}  // namespace

std::optional<Color> namedColor(const std::string& object, const std::string& part) {
  for (const std::string& name : {lowerCase(part), lowerCase(object)})
    for (const Material& material : materials())
      if (name.find(material.word) != std::string::npos) return material.color;
  return std::nullopt;
}

std::string familyName(const std::string& object) {
  size_t end = object.size();
  while (end > 0 && isDigit(object[end - 1])) --end;
  if (end == object.size()) return object;
  while (end > 0 && std::string_view("-_. #").find(object[end - 1]) != std::string_view::npos)
    --end;
  return end > 0 ? object.substr(0, end) : object;
}

namespace {

unsigned hashOf(const std::string& text) {
  unsigned hash = 2166136261u;  // FNV-1a
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
  return hash;
}

}  // namespace

Color otherColor(const std::string& object) {
  // Less of a colour than bodies, path and prints have, and lighter: what is walked on too.
  static const std::array<Color, 10> kQuiet = {
      rgb(176, 184, 190), rgb(196, 184, 166), rgb(178, 188, 172), rgb(190, 180, 170),
      rgb(170, 178, 190), rgb(198, 178, 170), rgb(192, 190, 174), rgb(170, 184, 180),
      rgb(200, 190, 176), rgb(186, 178, 188)};
  return kQuiet[hashOf(familyName(object)) % kQuiet.size()];
}

Color motleyColor(int piece) {
  static const std::array<Color, 10> kMotley = {
      rgb(120, 140, 150), rgb(150, 112, 82),  rgb(140, 155, 125), rgb(176, 140, 104),
      rgb(112, 124, 150), rgb(165, 120, 110), rgb(160, 155, 130), rgb(105, 130, 125),
      rgb(180, 160, 120), rgb(140, 125, 145)};
  return kMotley[hashOf(std::to_string(piece)) % kMotley.size()];
}

bool isMotley(const std::string& part) {
  return lowerCase(part).find("books") == 0 && part.size() == 5;
}

Color tinted(const Color& color, int i) {
  const auto scatter = [](double value) {
    return static_cast<float>(value - std::floor(value)) - 0.5f;
  };
  const float shift = scatter(i * 0.6180339887498949);
  return (color * (1.0f + 0.22f * shift)).cwiseMin(1.0f);
}

std::string hexColor(const Color& color) {
  char text[8];
  const auto byte = [](float v) { return static_cast<unsigned>(colorByte(v)); };
  std::snprintf(text, sizeof text, "#%02x%02x%02x", byte(color.x()), byte(color.y()),
                byte(color.z()));
  return text;
}

}  // namespace amble
