// The same motion however a glTF stores it: tight or interleaved, dense or sparse, as floats or
// small integers, in a GLB or beside it; and what is refused of it.

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "animation/captures/node_file.h"
#include "base/base64.h"
#include "base/error.h"
#include "tests/animation/captures/replaced.h"
#include "tests/animation/random_clip.h"
#include "tests/environments/test_files.h"

namespace amble {
namespace {

constexpr int kFrames = 5, kJoints = 4;  // root 0, below it 1 and 2, below 1 is 3
constexpr double kRate = 30.0;           // [Hz]

template <typename T>
void put(std::string& bytes, T number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

/// Turns and the root's places, frame by frame.
struct Moves {
  std::vector<std::array<Eigen::Quaterniond, kJoints>> turns;
  std::vector<Eigen::Vector3d> places;
};

/// Turns near each other with numbers that are not negative: unsigned integers hold them.
Moves randomMoves(unsigned seed) {
  Generator generator(seed);
  Moves moves;
  for (int i = 0; i < kFrames; ++i) {
    moves.turns.emplace_back();
    for (Eigen::Quaterniond& q : moves.turns.back()) {
      const Eigen::Vector4d v(uniform(generator, 0.1, 0.6), uniform(generator, 0.1, 0.6),
                              uniform(generator, 0.1, 0.6), uniform(generator, 0.6, 1.0));
      q.coeffs() = v.normalized();
    }
    moves.places.push_back(randomVector(generator, 2.0));
  }
  return moves;
}

/// A glTF as it grows: bytes of its one buffer, and views and accessors of it as JSON.
struct Store {
  std::string bytes, views, accessors;
  int view_count = 0, accessor_count = 0;

  int view(const std::string& data, int stride = 0) {
    while (bytes.size() % 4 != 0) bytes += '\0';
    views += std::string(view_count > 0 ? "," : "") + R"({"buffer":0,"byteOffset":)" +
             std::to_string(bytes.size()) + R"(,"byteLength":)" + std::to_string(data.size()) +
             (stride > 0 ? R"(,"byteStride":)" + std::to_string(stride) : "") + "}";
    bytes += data;
    return view_count++;
  }
  int accessor(const std::string& type, int component, const std::string& rest) {
    accessors += std::string(accessor_count > 0 ? "," : "") + R"({"type":")" + type +
                 R"(","componentType":)" + std::to_string(component) + R"(,"count":)" +
                 std::to_string(kFrames) + rest + "}";
    return accessor_count++;
  }
};

std::string inView(int view, int offset = 0) {
  return R"(,"bufferView":)" + std::to_string(view) + R"(,"byteOffset":)" + std::to_string(offset);
}

/// Which accessors a channel's sampler reads.
struct Tracks {
  int times = 0, places = 0;
  std::array<int, kJoints> turns = {};
};

std::string bufferUri(const Store& store) {
  return R"(,"uri":"data:application/octet-stream;base64,)" + base64(store.bytes) + "\"";
}

std::string jsonOf(const Store& store, const Tracks& tracks, const std::string& uri) {
  std::string samplers = R"({"input":)" + std::to_string(tracks.times) + R"(,"output":)" +
                         std::to_string(tracks.places) + "}";
  std::string channels = R"({"sampler":0,"target":{"node":0,"path":"translation"}})";
  for (int j = 0; j < kJoints; ++j) {
    samplers += R"(,{"input":)" + std::to_string(tracks.times) + R"(,"output":)" +
                std::to_string(tracks.turns[j]) + "}";
    channels += R"(,{"sampler":)" + std::to_string(j + 1) + R"(,"target":{"node":)" +
                std::to_string(j) + R"(,"path":"rotation"}})";
  }
  return R"({"asset":{"version":"2.0"},"nodes":[{"name":"a","children":[1,2]},)"
         R"({"name":"b","translation":[0,0.5,0],"children":[3]},)"
         R"({"name":"c","translation":[0.25,0,0]},{"name":"d","translation":[0,0.25,0.5]}],)"
         R"("buffers":[{"byteLength":)" +
         std::to_string(store.bytes.size()) + uri + R"(}],"bufferViews":[)" + store.views +
         R"(],"accessors":[)" + store.accessors + R"(],"animations":[{"samplers":[)" + samplers +
         R"(],"channels":[)" + channels + "]}]}";
}

std::string timesBytes() {
  std::string bytes;
  for (int i = 0; i < kFrames; ++i) put(bytes, static_cast<float>(i / kRate));
  return bytes;
}

template <typename T>
std::string turnBytes(const Moves& moves, int joint, double top) {
  std::string bytes;
  for (const auto& frame : moves.turns) {
    for (const double x : frame[joint].coeffs()) {
      put(bytes, static_cast<T>(top > 1.0 ? std::lround(top * x) : x));
    }
  }
  return bytes;
}

std::string placeBytes(const Moves& moves) {
  std::string bytes;
  for (const Eigen::Vector3d& p : moves.places) {
    for (const double x : p) put(bytes, static_cast<float>(x));
  }
  return bytes;
}

/// Turns as numbers of type T, `top` for 1.
template <typename T>
Tracks tight(const Moves& moves, int component, double top, Store& store) {
  Tracks tracks;
  tracks.times = store.accessor("SCALAR", 5126, inView(store.view(timesBytes())));
  tracks.places = store.accessor("VEC3", 5126, inView(store.view(placeBytes(moves))));
  for (int j = 0; j < kJoints; ++j) {
    tracks.turns[j] = store.accessor("VEC4", component,
                                     inView(store.view(turnBytes<T>(moves, j, top))) +
                                         (top > 1.0 ? R"(,"normalized":true)" : ""));
  }
  return tracks;
}

std::string plainText(const Moves& moves) {
  Store store;
  const Tracks tracks = tight<float>(moves, 5126, 1.0, store);
  return jsonOf(store, tracks, bufferUri(store));
}

/// The largest difference of the turns and places of two clips' joints.
double difference(const Clip& a, const Clip& b) {
  EXPECT_EQ(a.frames(), b.frames());
  EXPECT_EQ(a.skeleton.size(), b.skeleton.size());
  double most = 0.0;
  for (int i = 0; i < std::min(a.frames(), b.frames()); ++i) {
    const std::vector<JointFrame> p = jointFrames(a, i), q = jointFrames(b, i);
    for (int j = 0; j < a.skeleton.size(); ++j) {
      const int k = b.skeleton.find(a.skeleton.joint(j).name);
      EXPECT_GE(k, 0);
      if (k < 0) continue;
      most = std::max({most, (p[j].p_WJ - q[k].p_WJ).norm(),
                       (p[j].q_WJ.toRotationMatrix() - q[k].q_WJ.toRotationMatrix()).norm()});
    }
  }
  return most;
}

TEST(GltfStorage, InterleavedItIsTheSameToTheBit) {
  const Moves moves = randomMoves(801);
  Store store;
  std::string rows;  // a place and four turns a frame, behind each other
  for (int i = 0; i < kFrames; ++i) {
    for (const double x : moves.places[i]) put(rows, static_cast<float>(x));
    for (const Eigen::Quaterniond& q : moves.turns[i]) {
      for (const double x : q.coeffs()) put(rows, static_cast<float>(x));
    }
  }
  Tracks tracks;
  tracks.times = store.accessor("SCALAR", 5126, inView(store.view(timesBytes())));
  const int view = store.view(rows, 12 + 16 * kJoints);
  tracks.places = store.accessor("VEC3", 5126, inView(view));
  for (int j = 0; j < kJoints; ++j) {
    tracks.turns[j] = store.accessor("VEC4", 5126, inView(view, 12 + 16 * j));
  }
  const Clip clip = parseNodeFile(jsonOf(store, tracks, bufferUri(store)), "it.gltf");
  EXPECT_EQ(difference(clip, parseNodeFile(plainText(moves), "it.gltf")), 0.0);
}

TEST(GltfStorage, SmallIntegersHoldTurnsToTheirPrecision) {
  const Moves moves = randomMoves(802);
  const Clip exact = parseNodeFile(plainText(moves), "it.gltf");
  const auto off = [&](auto number, int component) {
    using T = decltype(number);
    Store store;
    const double top = std::numeric_limits<T>::max();
    const Tracks tracks = tight<T>(moves, component, top, store);
    // Half a unit in each of four numbers; three joints in a row add up.
    return top *
           difference(parseNodeFile(jsonOf(store, tracks, bufferUri(store)), "it.gltf"), exact);
  };
  for (const double units :
       {off(int8_t{}, 5120), off(uint8_t{}, 5121), off(int16_t{}, 5122), off(uint16_t{}, 5123)}) {
    EXPECT_GT(units, 0.0);
    EXPECT_LT(units, 12.0);
  }
}

TEST(GltfStorage, SparseOverZerosOrOverOtherValuesItIsTheSame) {
  const Moves moves = randomMoves(803);
  const Clip wanted = parseNodeFile(plainText(moves), "it.gltf");
  for (const bool over_values : {false, true}) {
    for (const int component : {5121, 5123, 5125}) {
      Store store;
      Tracks tracks = tight<float>(moves, 5126, 1.0, store);
      std::string places;
      for (int i = 0; i < kFrames; ++i) {
        if (component == 5121) put(places, static_cast<uint8_t>(i));
        if (component == 5123) put(places, static_cast<uint16_t>(i));
        if (component == 5125) put(places, static_cast<uint32_t>(i));
      }
      const int base = store.view(std::string(kFrames * 16, '\0')), at = store.view(places),
                values = store.view(turnBytes<float>(moves, 2, 1.0));
      tracks.turns[2] = store.accessor(
          "VEC4", 5126,
          (over_values ? inView(base) : "") + R"(,"sparse":{"count":)" + std::to_string(kFrames) +
              R"(,"indices":{"componentType":)" + std::to_string(component) + R"(,"bufferView":)" +
              std::to_string(at) + R"(},"values":{"bufferView":)" + std::to_string(values) + "}}");
      const Clip clip = parseNodeFile(jsonOf(store, tracks, bufferUri(store)), "it.gltf");
      EXPECT_EQ(difference(clip, wanted), 0.0) << component;
    }
  }
}

std::string glbOf(std::string json, std::string binary) {
  while (json.size() % 4 != 0) json += ' ';
  while (binary.size() % 4 != 0) binary += '\0';
  std::string glb = "glTF";
  put(glb, uint32_t{2});
  put(glb, static_cast<uint32_t>(28 + json.size() + binary.size()));
  put(glb, static_cast<uint32_t>(json.size()));
  glb += "JSON" + json;
  put(glb, static_cast<uint32_t>(binary.size()));
  return glb + std::string("BIN\0", 4) + binary;
}

TEST(GltfStorage, InAGlbOrInAFileBesideItItIsTheSame) {
  const Moves moves = randomMoves(804);
  const Clip wanted = parseNodeFile(plainText(moves), "it.gltf");
  Store store;
  const Tracks tracks = tight<float>(moves, 5126, 1.0, store);
  const std::string glb = glbOf(jsonOf(store, tracks, ""), store.bytes);
  EXPECT_EQ(difference(parseNodeFile(glb, "it.glb"), wanted), 0.0);
  const TestFolder folder;
  folder.write("a b.bin", store.bytes);
  for (const char* const uri : {"a b.bin", "a%20b.bin", "./a%20b.bin"}) {
    const auto file =
        folder.write("it.gltf", jsonOf(store, tracks, std::string(R"(,"uri":")") + uri + "\""));
    EXPECT_EQ(difference(readNodeFile(file), wanted), 0.0) << uri;
  }
}

TEST(GltfStorage, AGlbThatIsCutIsRefusedAndNeverReadBeyondItsEnd) {
  const Moves moves = randomMoves(805);
  Store store;
  const Tracks tracks = tight<float>(moves, 5126, 1.0, store);
  const std::string glb = glbOf(jsonOf(store, tracks, ""), store.bytes);
  for (size_t length = 4; length < glb.size(); length += 97) {
    const std::string error = errorOf([&] { parseNodeFile(glb.substr(0, length), "it.glb"); });
    EXPECT_TRUE(error.starts_with("it.glb: ")) << length;
    EXPECT_NE(error.find("; expected "), std::string::npos) << error;
  }
}

TEST(GltfStorage, ARestPlaceIsTheSameAsAMatrixOrAsItsParts) {
  const std::string text = plainText(randomMoves(806));
  const std::string matrix = replaced(text, R"("translation":[0,0.5,0])",
                                      R"("matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0.5,0,1])");
  const std::string parts =
      replaced(text, R"("translation":[0,0.5,0])",
               R"("translation":[0,0.5,0],"rotation":[0,0,0,1],"scale":[1,1,1])");
  const Clip wanted = parseNodeFile(text, "it.gltf");
  EXPECT_LT(difference(parseNodeFile(matrix, "it.gltf"), wanted), 1e-12);
  EXPECT_LT(difference(parseNodeFile(parts, "it.gltf"), wanted), 1e-12);
}

TEST(GltfStorage, WhatIsWrongIsNamed) {
  const std::string text = plainText(randomMoves(807));
  ASSERT_EQ(errorOf([&] { parseNodeFile(text, "it.gltf"); }), "");
  const std::vector<std::array<std::string, 3>> wrong = {
      {R"("input":0,"output":1)", R"("input":99,"output":1)", "'input' is none of the accessors"},
      {R"("input":0,"output":1)", R"("output":1)", "'input' is none of the accessors"},
      {R"("input":0,"output":1)", R"("input":-1,"output":1)", "'input' is no count"},
      {R"("input":0,"output":1)", R"("input":0.5,"output":1)", "'input' is no count"},
      {R"("input":0,"output":1)", R"("input":1,"output":1)", "an accessor of a type"},
      {R"("input":0,"output":1)", R"("input":0,"output":2)", "an accessor of a type"},
      {R"("sampler":1,)", R"("sampler":77,)", "an animation of no node or no sampler"},
      {R"({"node":1,)", R"({"node":77,)", "an animation of no node or no sampler"},
      {R"("children":[3])", R"("children":[9])", "a child that is no node"},
      {R"("children":[3])", R"("children":[2])", "a node hangs on two others"},
      {R"("children":[3])", R"("children":[1])", "a node hangs on two others"},
      {R"("componentType":5126)", R"("componentType":5130)", "an accessor of a type"},
      {R"("count":5)", R"("count":6)", "an accessor goes beyond its buffer"},
      {R"("count":5)", R"("count":4)", "not as many values as times"},
      {R"("count":5)", R"("count":99999999999)", "too many numbers in an accessor"},
      {R"("byteLength":20)", R"("byteLength":16)", "an accessor goes beyond its buffer"},
      {R"("buffer":0)", R"("buffer":1)", "a buffer view of no buffer"},
      {R"("bufferView":0)", R"("bufferView":50)", "'bufferView' is none of the bufferViews"},
      {R"("asset")", R"("assets")", "it has no asset"},
      {R"("nodes":[{"name":"a")", R"("nodes":[7,{"name":"a")", "cannot be read"},
      {R"({"asset")", R"({"extensionsRequired":["EXT_new"],"asset")",
       "needs the extension EXT_new"},
      {R"("byteOffset":0,"byteLength":20)",
       R"("byteStride":18446744073709551615,"byteOffset":0,"byteLength":20)",
       "an accessor goes beyond its buffer"}};
  for (const auto& [from, to, problem] : wrong) {
    const std::string error = errorOf([&] { parseNodeFile(replaced(text, from, to), "it.gltf"); });
    EXPECT_TRUE(error.starts_with("it.gltf: ")) << to << ": " << error;
    EXPECT_NE(error.find(problem), std::string::npos) << to << ": " << error;
    EXPECT_NE(error.find("; expected "), std::string::npos) << to << ": " << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << to << ": " << error;
  }
}

TEST(GltfStorage, NumbersThatAreNoneAreRefused) {
  for (const float bad : {std::nanf(""), INFINITY, -INFINITY}) {
    Moves moves = randomMoves(808);
    moves.places[3].y() = bad;
    EXPECT_TRUE(errorOf([&] { parseNodeFile(plainText(moves), "it.gltf"); }).starts_with("it.gltf"))
        << bad;
  }
}

}  // namespace
}  // namespace amble
