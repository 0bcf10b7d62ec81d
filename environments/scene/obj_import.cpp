// Reading OBJ through tinyobjloader 2.0: it passes over lines that it does not know, takes 0 for
// what is no number, and leaves indices to its caller. Lines are therefore looked at before it has
// them, and indices after.

#include "environments/scene/obj_import.h"

#define TINYOBJLOADER_USE_DOUBLE  // as the library is that we link
#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <istream>
#include <map>
#include <streambuf>
#include <string_view>

#include "base/error.h"
#include "base/files.h"
#include "base/text.h"
#include "environments/scene/mesh_import.h"
#include "environments/scene/polygon.h"

namespace amble {
namespace {

constexpr const char* kByteOrderMark = "\xEF\xBB\xBF";
constexpr const char* kNoName = "defaultobject";  // of faces before the first object, as in Assimp
constexpr int kMostDigits = 9;                    // of an index

constexpr auto kIsBlank = [](char c) { return c == ' ' || c == '\t'; };

// Lines that a backslash joins to the next become one, with empty lines behind it for those that
// are gone, but no comments, which may end in the path of a folder; ends of lines that are a
// carriage return alone become line feeds.
std::string plainLines(std::string text) {
  for (size_t at = text.find('\r'); at != std::string::npos; at = text.find('\r', at + 1))
    if (at + 1 == text.size() || text[at + 1] != '\n') text[at] = '\n';
  if (text.find('\\') == std::string::npos) return text;
  std::string plain;
  size_t joined = 0;
  bool comment = false;
  for (size_t i = 0; i < text.size(); ++i) {
    const size_t end = i + (text.compare(i + 1, 1, "\r") == 0 ? 2 : 1);
    comment = text[i] != '\n' && (comment || text[i] == '#');
    if (!comment && text[i] == '\\' && end < text.size() && text[end] == '\n') {
      plain += ' ';
      ++joined;
      i = end;
      continue;
    }
    plain += text[i];
    if (text[i] == '\n') plain.append(std::exchange(joined, 0), '\n');
  }
  return plain;
}

// A text that is handed out line by line, each looked at before, so that it is known which one is
// being read.
class ObjLines : public std::streambuf {
 public:
  ObjLines(std::string file, std::string text)
      : file_(std::move(file)), text_(plainLines(std::move(text))) {
    if (text_.starts_with(kByteOrderMark)) end_ = std::strlen(kByteOrderMark);
  }

  /// Number of the line that was handed out last; 1: the first.
  int line() const { return line_; }
  /// Numbers behind the `v` that was handed out last.
  size_t numbers() const { return numbers_; }
  /// Of faces that are none, so far; empty where there are none.
  std::string warning() const {
    if (few_corners_ == 0) return "";
    return file_ + ':' + std::to_string(first_of_few_) +
           ": a face of fewer than 3 corners is passed over" +
           (few_corners_ == 1 ? "" : ", one of " + std::to_string(few_corners_) + " such");
  }

 protected:
  int_type underflow() override {
    if (end_ >= text_.size()) return traits_type::eof();
    const size_t begin = end_;
    end_ = std::min(text_.find('\n', begin), text_.size() - 1) + 1;
    ++line_;
    char* const first = text_.data() + begin;
    setg(first, first, checkedLine(first, text_.data() + end_));
    return traits_type::to_int_type(*first);
  }

 private:
  // Returns where it ends: before a comment behind a vertex or a face.
  char* checkedLine(char* first, char* end) {
    first = std::find_if_not(first, end, kIsBlank);
    if (trimmed({first, end}) == "f") {
      noteFewCorners();
      return end;
    }
    if (end - first < 2 || !kIsBlank(first[1]) || (*first != 'v' && *first != 'f')) return end;
    char* const comment = std::find(first, end, '#');
    const std::string_view behind = trimmed({first + 1, comment});
    if (*first == 'f' && !isFace(behind)) {
      throw InputError(file_, line_, "is no face: " + quotedShort(trimmed({first, comment})),
                       "`f` and corners such as 1, 1/2, 1/2/3 or -1//3");
    }
    if (*first == 'f' && corners_ < 3) noteFewCorners();
    if (*first == 'v' && !isVertex(behind)) {
      // Some programs write decimals with a comma.
      std::replace(first, comment, ',', '.');
      if (!isVertex(behind)) {
        throw InputError(file_, line_, "is no vertex: " + quotedShort(trimmed({first, comment})),
                         "`v` and three finite numbers or more");
      }
    }
    if (comment == end) return end;
    *comment = '\n';
    return comment + 1;
  }

  // There are such files, with lines as faces, and other programs pass over them, too.
  void noteFewCorners() {
    if (few_corners_++ == 0) first_of_few_ = line_;
  }

  bool isVertex(std::string_view behind) {
    for (numbers_ = 0; !behind.empty(); ++numbers_) {
      const auto end = std::find_if(behind.begin(), behind.end(), kIsBlank);
      if (!numberOf({behind.begin(), end})) return false;
      const auto next = std::find_if_not(end, behind.end(), kIsBlank);
      behind.remove_prefix(static_cast<size_t>(next - behind.begin()));
    }
    return numbers_ >= 3;
  }

  // Indices that stand where indices do, none longer than an int.
  bool isFace(std::string_view behind) {
    corners_ = 0;
    int digits = 0;
    char before = ' ';
    for (const char c : behind) {
      corners_ += kIsBlank(before) && !kIsBlank(c);
      if (isDigit(c)) {
        if (++digits > kMostDigits) return false;
      } else {
        const bool fits = kIsBlank(c) || c == '/' || (c == '-' && !isDigit(before));
        if (!fits || before == '-') return false;
        digits = 0;
      }
      before = c;
    }
    return true;
  }

  std::string file_, text_;
  size_t end_ = 0;  // of what was handed out
  int line_ = 0;
  size_t numbers_ = 0;
  int corners_ = 0;                         // of the face that was looked at last
  int few_corners_ = 0, first_of_few_ = 0;  // faces; line
};

struct ObjFace {
  size_t begin, end;  // its corners among its object's
  int line;
};

struct ObjObject {
  std::vector<std::string> names;
  std::vector<int> corners;  // vertices of the file, from 0 on
  std::vector<ObjFace> faces;
};

// What the reader tells, until all vertices are known.
class ObjContents {
 public:
  ObjContents(const std::string& file, const ObjLines& lines) : file_(file), lines_(lines) {}

  void addVertex(const Eigen::Vector3d& numbers, double weight) {
    // Of six numbers the last three are a colour.
    const float divisor = lines_.numbers() == 4 ? rounded(weight) : 1.0f;
    const Eigen::Vector3f p(rounded(numbers.x()), rounded(numbers.y()), rounded(numbers.z()));
    vertices_.push_back((p / divisor).cast<double>());
    if (!vertices_.back().allFinite())
      fail("a vertex that is not finite", "finite numbers below 3e38, a weight that is not 0");
  }

  void addFace(const tinyobj::index_t* corners, int count) {
    if (count < 3) return;  // the lines warn of it
    ObjObject& object = current();
    if (count > kMostCorners)
      fail("a face of " + quotedShort(object.names.empty() ? "" : object.names.front()) + " has " +
               std::to_string(count) + " corners",
           "at most " + std::to_string(kMostCorners) + " in a face");
    const size_t begin = object.corners.size();
    for (int k = 0; k < count; ++k) object.corners.push_back(vertexOf(corners[k].vertex_index));
    object.faces.push_back({begin, object.corners.size(), lines_.line()});
    noteMaterial(object);
  }

  void beginObject(std::string_view name) {
    name = trimmed(name);
    name = {name.begin(), std::find_if(name.begin(), name.end(), kIsBlank)};
    if (name.empty()) return;
    const auto named = named_.find(name);
    if (named == named_.end()) return addObject(std::string(name));
    current_ = named->second;
    faces_material_.clear();
  }

  // One that is named again where it goes on is no other.
  void beginGroup(const std::string& name) {
    if (group_ == name) return;
    group_ = name;
    addObject(name);
  }

  void useMaterial(std::string_view name) {
    name = trimmed(name);
    if (!name.empty()) material_ = name;
  }

  MeshFile meshFile() const {
    MeshFile result;
    bool has_faces = false;
    std::vector<int> places(vertices_.size(), -1);
    for (const ObjObject& object : objects_) {
      has_faces = has_faces || !object.faces.empty();
      MeshPart part{object.names, cleanMesh(meshOf(object, places))};
      if (!part.mesh.triangles.empty()) result.parts.push_back(std::move(part));
    }
    if (!has_faces) throw InputError(file_, 0, "holds no faces", "a mesh of faces");
    if (result.parts.empty())
      throw InputError(file_, 0, "holds no triangles", "at least one with an area");
    return result;
  }

 private:
  [[noreturn]] void fail(const std::string& problem, const std::string& expected) const {
    throw InputError(file_, lines_.line(), problem, expected);
  }

  // Whole and fraction each, which is not always the float that is nearest: so a mesh is the same
  // in OBJ as in PLY, STL and Collada.
  static float rounded(double number) {
    const double whole = std::trunc(number);
    return static_cast<float>(whole) + static_cast<float>(number - whole);
  }

  int vertexOf(int index) const {
    if (index > 0) return index - 1;
    const int vertex = static_cast<int>(vertices_.size()) + index;
    if (index == 0 || vertex < 0)
      fail("a face has vertex " + std::to_string(index),
           "vertices from 1 on, or from -1 back to the first before it");
    return vertex;
  }

  ObjObject& current() {
    if (objects_.empty()) addObject(kNoName);
    return objects_[current_];
  }

  // An object's faces are called by materials too, as by Assimp: by those that come after others.
  void noteMaterial(ObjObject& object) {
    std::vector<std::string>& names = object.names;
    if (!faces_material_.empty() && material_ != faces_material_ &&
        std::find(names.begin(), names.end(), material_) == names.end())
      names.push_back(material_);
    faces_material_ = material_;
  }

  void addObject(const std::string& name) {
    current_ = objects_.size();
    objects_.emplace_back();
    if (!name.empty()) objects_.back().names.push_back(name);
    named_.emplace(name, current_);
    faces_material_.clear();
  }

  // Its vertices in the order in which faces name them. `places` are -1 throughout, and again
  // afterwards.
  TriangleMesh meshOf(const ObjObject& object, std::vector<int>& places) const {
    TriangleMesh mesh;
    mesh.triangles.reserve(object.faces.size());
    std::vector<int> corners;
    for (const ObjFace& face : object.faces) {
      corners.clear();
      for (size_t i = face.begin; i < face.end; ++i) {
        const int vertex = object.corners[i];
        if (vertex >= static_cast<int>(vertices_.size()))
          throw InputError(file_, face.line, "a face has vertex " + std::to_string(vertex + 1),
                           "vertices from 1 to " + std::to_string(vertices_.size()));
        if (places[vertex] < 0) {
          places[vertex] = static_cast<int>(mesh.vertices.size());
          mesh.vertices.push_back(vertices_[vertex]);
        }
        corners.push_back(places[vertex]);
      }
      addTriangles(corners, mesh);
    }
    for (const int vertex : object.corners) places[vertex] = -1;
    return mesh;
  }

  static void addTriangles(const std::vector<int>& corners, TriangleMesh& mesh) {
    if (corners.size() == 3) {
      mesh.triangles.push_back({corners[0], corners[1], corners[2]});
      return;
    }
    std::vector<Eigen::Vector3d> polygon;
    for (const int corner : corners) polygon.push_back(mesh.vertices[corner]);
    for (const std::array<int, 3>& t : cutPolygon(polygon))
      mesh.triangles.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
  }

  const std::string& file_;
  const ObjLines& lines_;
  std::vector<Eigen::Vector3d> vertices_;
  std::vector<ObjObject> objects_;
  std::map<std::string, size_t, std::less<>> named_;  // the first of each name
  size_t current_ = 0;                                // object
  std::string group_, material_;
  std::string faces_material_;  // of the object's last face since it began
};

// Calls what `contents` has for each thing that the reader finds.
tinyobj::callback_t callbacks() {
  tinyobj::callback_t calls;
  calls.vertex_cb = [](void* contents, double x, double y, double z, double w) {
    static_cast<ObjContents*>(contents)->addVertex({x, y, z}, w);
  };
  calls.index_cb = [](void* contents, tinyobj::index_t* corners, int count) {
    static_cast<ObjContents*>(contents)->addFace(corners, count);
  };
  calls.object_cb = [](void* contents, const char* name) {
    static_cast<ObjContents*>(contents)->beginObject(name);
  };
  calls.group_cb = [](void* contents, const char** names, int count) {
    static_cast<ObjContents*>(contents)->beginGroup(
        joined(std::vector<std::string>(names, names + count), " "));
  };
  calls.usemtl_cb = [](void* contents, const char* name, int) {
    static_cast<ObjContents*>(contents)->useMaterial(name);
  };
  return calls;
}

}  // namespace

MeshFile parseObj(std::string text, const std::string& name) {
  ObjLines lines(name, std::move(text));
  std::istream in(&lines);
  in.exceptions(std::ios::badbit);  // what a line is refused by goes through
  ObjContents contents(name, lines);
  tinyobj::LoadObjWithCallback(in, callbacks(), &contents);
  MeshFile mesh = contents.meshFile();
  if (std::string warning = lines.warning(); !warning.empty())
    mesh.warnings.push_back(std::move(warning));
  return mesh;
}

}  // namespace amble
