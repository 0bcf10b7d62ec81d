/// Small glTF, Collada and FBX files of a clip, as text, for tests of their reader: joints only, a
/// key a frame.
#pragma once

#include <cmath>
#include <cstring>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "animation/body/clip.h"
#include "base/rotation.h"

namespace amble {

/// A clip in a file's axes and unit: joints' places and turns in their parents.
struct NodeFrames {
  const Clip& clip;
  Eigen::Quaterniond q_FileW = Eigen::Quaterniond::Identity();
  double per_metre = 1.0;  // file units

  int frames() const { return clip.frames(); }
  int joints() const { return clip.skeleton.size(); }
  const std::string& name(int joint) const { return clip.skeleton.joint(joint).name; }
  Eigen::Vector3d translation(int frame, int joint) const {
    return per_metre * (joint == 0 ? Eigen::Vector3d(q_FileW * clip.poses.p_WR(frame))
                                   : clip.skeleton.joint(joint).offset);
  }
  Eigen::Quaterniond rotation(int frame, int joint) const {
    const Eigen::Quaterniond q = clip.poses.rotations(frame)[joint];
    return joint == 0 ? q_FileW * q : q;
  }
  /// At rest a joint is where it first is, and its frame is parallel to the y-up file's.
  Eigen::Quaterniond restRotation(int joint) const {
    return joint == 0 ? q_FileW * yUpToWorld() : Eigen::Quaterniond::Identity();
  }
  std::vector<int> children(int joint) const {
    std::vector<int> found;
    for (int k = joint + 1; k < joints(); ++k) {
      if (clip.skeleton.joint(k).parent == joint) found.push_back(k);
    }
    return found;
  }
};

/// `first, second, ...` of what `item` says of 0, 1, ...
inline std::string listOf(int count, const std::function<std::string(int)>& item,
                          const char* between = ",") {
  std::string list;
  for (int i = 0; i < count; ++i) list += (i == 0 ? "" : between) + item(i);
  return list;
}

inline std::string digits(double x) {
  std::ostringstream out;
  out.precision(10);
  out << x;
  return out.str();
}

inline std::string base64(const std::vector<float>& numbers) {
  static const char* const kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes(numbers.size() * sizeof(float), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  std::string text;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    unsigned bits = 0;
    for (size_t k = 0; k < 3; ++k) {
      bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    }
    for (size_t k = 0; k < 4; ++k) {
      text += i + k <= bytes.size() ? kDigits[bits >> (18 - 6 * k) & 63u] : '=';
    }
  }
  return text;
}

/// glTF 2: metres, y up; one buffer as a data URI: times, then of each joint translations and
/// rotations, which are views and accessors 0, 1 + 2 j and 2 + 2 j.
inline std::string gltfOf(const Clip& clip) {
  const NodeFrames file{clip, yUpToWorld().conjugate()};
  const int frames = file.frames(), joints = file.joints();
  std::vector<float> numbers;
  std::vector<size_t> begins = {0};
  for (int i = 0; i < frames; ++i) numbers.push_back(static_cast<float>(i * clip.frame_time));
  for (int j = 0; j < joints; ++j) {
    begins.push_back(numbers.size());
    for (int i = 0; i < frames; ++i) {
      for (const double x : file.translation(i, j)) numbers.push_back(static_cast<float>(x));
    }
    begins.push_back(numbers.size());
    for (int i = 0; i < frames; ++i) {
      const Eigen::Vector4d q = file.rotation(i, j).coeffs();
      for (const double x : q) numbers.push_back(static_cast<float>(x));
    }
  }
  begins.push_back(numbers.size());
  const int views = 1 + 2 * joints;
  const std::string number = R"(,"componentType":5126,"count":)" + std::to_string(frames);
  const auto node = [&](int j) {
    const Eigen::Vector3d p = file.translation(0, j);
    const std::vector<int> below = file.children(j);
    return R"({"name":")" + file.name(j) + R"(","translation":[)" + digits(p.x()) + "," +
           digits(p.y()) + "," + digits(p.z()) + "]" +
           (below.empty() ? ""
                          : R"(,"children":[)" +
                                listOf(static_cast<int>(below.size()),
                                       [&](int k) { return std::to_string(below[k]); }) +
                                "]") +
           "}";
  };
  const auto view = [&](int v) {
    return R"({"buffer":0,"byteOffset":)" + std::to_string(4 * begins[v]) + R"(,"byteLength":)" +
           std::to_string(4 * (begins[v + 1] - begins[v])) + "}";
  };
  const auto accessor = [&](int v) {
    return R"({"bufferView":)" + std::to_string(v) + number + R"(,"type":")" +
           (v == 0       ? "SCALAR"
            : v % 2 == 1 ? "VEC3"
                         : "VEC4") +
           R"("})";
  };
  const auto sampler = [](int s) {
    return R"({"input":0,"output":)" + std::to_string(s + 1) + "}";
  };
  const auto channel = [](int s) {
    return R"({"sampler":)" + std::to_string(s) + R"(,"target":{"node":)" + std::to_string(s / 2) +
           R"(,"path":")" + (s % 2 == 0 ? "translation" : "rotation") + R"("}})";
  };
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[)" +
         listOf(joints, node) + R"(],"buffers":[{"byteLength":)" +
         std::to_string(4 * numbers.size()) + R"(,"uri":"data:application/octet-stream;base64,)" +
         base64(numbers) + R"("}],"bufferViews":[)" + listOf(views, view) + R"(],"accessors":[)" +
         listOf(views, accessor) + R"(],"animations":[{"channels":[)" +
         listOf(2 * joints, channel) + R"(],"samplers":[)" + listOf(2 * joints, sampler) + "]}]}\n";
}

/// Rows of a joint's transform, as Collada has them.
inline std::string matrixText(const Eigen::Vector3d& p, const Eigen::Quaterniond& q) {
  const Eigen::Matrix3d R = q.toRotationMatrix();
  return listOf(
             3,
             [&](int row) {
               return digits(R(row, 0)) + " " + digits(R(row, 1)) + " " + digits(R(row, 2)) + " " +
                      digits(p[row]);
             },
             " ") +
         " 0 0 0 1";
}

inline std::string colladaNode(const NodeFrames& file, int joint) {
  const std::string id = "j" + std::to_string(joint);
  std::string text = "<node id=\"" + id + "\" sid=\"" + id + "\" name=\"" + file.name(joint) +
                     "\" type=\"JOINT\"><matrix sid=\"transform\">" +
                     matrixText(file.translation(0, joint), file.restRotation(joint)) +
                     "</matrix>\n";
  for (const int child : file.children(joint)) text += colladaNode(file, child);
  return text + "</node>\n";
}

/// A joint's track: its times, matrices, the sampler that joins them.
inline std::string colladaTrack(const NodeFrames& file, int joint) {
  const std::string id = "t" + std::to_string(joint), count = std::to_string(file.frames());
  const auto source = [&](const std::string& what, int stride, const std::string& param,
                          const std::string& array) {
    return "<source id=\"" + id + what + "\">" + array + "<technique_common><accessor source=\"#" +
           id + what + "a\" count=\"" + count + "\" stride=\"" + std::to_string(stride) + "\">" +
           param + "</accessor></technique_common></source>\n";
  };
  const auto array = [&](const std::string& kind, const std::string& what, int stride,
                         const std::function<std::string(int)>& item) {
    return "<" + kind + " id=\"" + id + what + "a\" count=\"" +
           std::to_string(stride * file.frames()) + "\">" + listOf(file.frames(), item, " ") +
           "</" + kind + ">";
  };
  return "<animation id=\"" + id + "\">" +
         source("in", 1, R"(<param name="TIME" type="float"/>)",
                array("float_array", "in", 1,
                      [&](int i) { return digits(i * file.clip.frame_time); })) +
         source("out", 16, R"(<param name="TRANSFORM" type="float4x4"/>)",
                array("float_array", "out", 16,
                      [&](int i) {
                        return matrixText(file.translation(i, joint), file.rotation(i, joint));
                      })) +
         source("how", 1, R"(<param name="INTERPOLATION" type="name"/>)",
                array("Name_array", "how", 1, [](int) { return std::string("LINEAR"); })) +
         "<sampler id=\"" + id + "s\"><input semantic=\"INPUT\" source=\"#" + id +
         "in\"/><input semantic=\"OUTPUT\" source=\"#" + id +
         "out\"/><input semantic=\"INTERPOLATION\" source=\"#" + id + "how\"/></sampler>" +
         "<channel source=\"#" + id + "s\" target=\"j" + std::to_string(joint) +
         "/transform\"/></animation>\n";
}

inline std::string colladaOf(const Clip& clip, double metres_per_unit, bool z_up) {
  const NodeFrames file{clip, z_up ? Eigen::Quaterniond::Identity() : yUpToWorld().conjugate(),
                        1.0 / metres_per_unit};
  return "<?xml version=\"1.0\"?>\n<COLLADA "
         "xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" "
         "version=\"1.4.1\">\n<asset><unit "
         "meter=\"" +
         digits(metres_per_unit) + "\"/><up_axis>" + (z_up ? "Z_UP" : "Y_UP") +
         "</up_axis></asset>\n<library_animations>\n" +
         listOf(
             file.joints(), [&](int j) { return colladaTrack(file, j); }, "") +
         "</library_animations>\n<library_visual_scenes><visual_scene id=\"s\">\n" +
         colladaNode(file, 0) +
         "</visual_scene></library_visual_scenes>\n<scene><instance_visual_scene "
         "url=\"#s\"/></scene></COLLADA>\n";
}

/// What Maya and Mixamo put around a bone's own turn (Autodesk's FBX SDK, "Computing transformation
/// matrices"): X = T Roff Rp Rpre R Rpost^-1 Rp^-1.
struct FbxPivot {
  Eigen::Vector3d pre = Eigen::Vector3d::Zero(), post = Eigen::Vector3d::Zero();  // [rad], x y z
  Eigen::Vector3d pivot = Eigen::Vector3d::Zero(), offset = Eigen::Vector3d::Zero();

  static Eigen::Quaterniond turn(const Eigen::Vector3d& xyz) {
    return fromEuler({xyz[2], xyz[1], xyz[0]}, {'Z', 'Y', 'X'});
  }
  Eigen::Quaterniond R(const Eigen::Quaterniond& whole) const {
    return turn(pre).conjugate() * whole * turn(post);
  }
  Eigen::Vector3d T(const Eigen::Vector3d& place, const Eigen::Quaterniond& whole) const {
    return place - offset - pivot + whole * pivot;
  }
  std::string properties() const {
    const auto line = [](const std::string& name, const Eigen::Vector3d& v) {
      return "P: \"" + name + "\", \"Vector3D\", \"Vector\", \"\"," + digits(v.x()) + "," +
             digits(v.y()) + "," + digits(v.z()) + "\n";
    };
    return "P: \"RotationActive\", \"bool\", \"\", \"\",1\n" + line("PreRotation", pre / kDegree) +
           line("PostRotation", post / kDegree) + line("RotationPivot", pivot) +
           line("RotationOffset", offset);
  }
};

struct FbxMake {
  double metres_per_unit = 0.01;
  bool z_up = false;
  bool animated = true;  ///< without it the file has its joints and no animation
  std::function<FbxPivot(int joint)> pivot = {};
};

/// X, Y and Z curves of a joint's places or turns, and what they hang on. Identities: of a
/// joint's model 1000 + j, of its curve nodes 2000 and 3000 + j, of their curves 10 times that
/// and the axis.
inline std::string fbxCurves(const NodeFrames& file, int joint, const FbxPivot& pivot, bool turns,
                             std::string& links) {
  constexpr double kTicks = 46186158000.0;  // a second of FBX
  const int node = (turns ? 3000 : 2000) + joint;
  std::vector<Eigen::Vector3d> values;
  Eigen::Vector3d last = Eigen::Vector3d::Zero();
  for (int i = 0; i < file.frames(); ++i) {
    if (turns) {
      // R = Rz Ry Rx, x first about fixed axes; Lcl Rotation is x, y, z.
      const RotationOrder order = {'Z', 'Y', 'X'};
      last = unwrapEuler(toEuler(pivot.R(file.rotation(i, joint)), order), last);
      values.push_back(Eigen::Vector3d(last[2], last[1], last[0]) / kDegree);
    } else {
      values.push_back(pivot.T(file.translation(i, joint), file.rotation(i, joint)));
    }
  }
  const std::string count = std::to_string(file.frames());
  std::string text = "AnimationCurveNode: " + std::to_string(node) +
                     ", \"AnimCurveNode::" + (turns ? "R" : "T") + "\", \"\" {\n}\n";
  links += "C: \"OO\"," + std::to_string(node) + ",500\nC: \"OP\"," + std::to_string(node) + "," +
           std::to_string(1000 + joint) + ", \"Lcl " + (turns ? "Rotation" : "Translation") +
           "\"\n";
  for (int axis = 0; axis < 3; ++axis) {
    const std::string curve = std::to_string(10 * node + axis);
    text += "AnimationCurve: " + curve + ", \"AnimCurve::\", \"\" {\nDefault: 0\nKeyVer: 4008\n" +
            "KeyTime: *" + count + " {\na: " +
            listOf(file.frames(),
                   [&](int i) {
                     return std::to_string(std::llround(i * file.clip.frame_time * kTicks));
                   }) +
            "\n}\nKeyValueFloat: *" + count +
            " {\na: " + listOf(file.frames(), [&](int i) { return digits(values[i][axis]); }) +
            "\n}\n}\n";
    links += "C: \"OP\"," + curve + "," + std::to_string(node) + ", \"d|" +
             std::string(1, static_cast<char>('X' + axis)) + "\"\n";
  }
  return text;
}

/// ASCII FBX 7.4.
inline std::string fbxOf(const Clip& clip, const FbxMake& make) {
  const double metres_per_unit = make.metres_per_unit;
  const bool z_up = make.z_up, animated = make.animated;
  const NodeFrames file{clip, z_up ? Eigen::Quaterniond::Identity() : yUpToWorld().conjugate(),
                        1.0 / metres_per_unit};
  const auto setting = [](const std::string& name, const std::string& type, double value) {
    return "P: \"" + name + "\", \"" + type + "\", \"\", \"\"," + digits(value) + "\n";
  };
  std::string objects, links;
  for (int j = 0; j < file.joints(); ++j) {
    const FbxPivot pivot = make.pivot ? make.pivot(j) : FbxPivot{};
    const Eigen::Vector3d p = pivot.T(file.translation(0, j), file.restRotation(j));
    const Eigen::Vector3d turn = toEuler(pivot.R(file.restRotation(j)), {'Z', 'Y', 'X'}) / kDegree;
    const int parent = clip.skeleton.joint(j).parent;
    objects += "Model: " + std::to_string(1000 + j) + ", \"Model::" + file.name(j) +
               "\", \"LimbNode\" {\nVersion: 232\nProperties70: {\nP: \"Lcl Translation\", \"Lcl "
               "Translation\", \"\", \"A\"," +
               digits(p.x()) + "," + digits(p.y()) + "," + digits(p.z()) +
               "\nP: \"Lcl Rotation\", \"Lcl Rotation\", \"\", \"A\"," + digits(turn[2]) + "," +
               digits(turn[1]) + "," + digits(turn[0]) + "\n" +
               (make.pivot ? pivot.properties() : "") + "}\n}\n";
    links += "C: \"OO\"," + std::to_string(1000 + j) + "," +
             (parent < 0 ? "0" : std::to_string(1000 + parent)) + "\n";
    if (!animated) continue;
    objects += fbxCurves(file, j, pivot, false, links) + fbxCurves(file, j, pivot, true, links);
  }
  if (animated) {
    objects +=
        "AnimationStack: 400, \"AnimStack::Take\", \"\" {\n}\n"
        "AnimationLayer: 500, \"AnimLayer::Base\", \"\" {\n}\n";
    links += "C: \"OO\",500,400\n";
  }
  return "; FBX 7.4.0 project file\nFBXHeaderExtension: {\nFBXHeaderVersion: 1003\nFBXVersion: "
         "7400\n}\nGlobalSettings: {\nVersion: 1000\nProperties70: {\n" +
         setting("UpAxis", "int", z_up ? 2 : 1) + setting("UpAxisSign", "int", 1) +
         setting("FrontAxis", "int", z_up ? 1 : 2) +
         setting("FrontAxisSign", "int", z_up ? -1 : 1) + setting("CoordAxis", "int", 0) +
         setting("CoordAxisSign", "int", 1) +
         setting("UnitScaleFactor", "double", 100.0 * metres_per_unit) +
         setting("TimeMode", "enum", 14) +
         setting("CustomFrameRate", "double", 1.0 / clip.frame_time) + "}\n}\nObjects: {\n" +
         objects + "}\nConnections: {\n" + links + "}\n";
}

}  // namespace amble
