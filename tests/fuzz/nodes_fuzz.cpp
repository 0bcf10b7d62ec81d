// Animated nodes of any numbers: what is left of an FBX, glTF or Collada file once Assimp has read
// it.
#include <cmath>
#include <cstring>

#include "animation/captures/node_animation.h"
#include "tests/fuzz/fuzz.h"

namespace {

// Shorter would be long runs of the same [s].
constexpr double kMinFrameTime = 0.02;

/// Takes numbers off the front of the bytes; 0 where they end.
struct Bytes {
  const uint8_t* at;
  size_t left;

  int next() {
    if (left == 0) return 0;
    --left;
    return *at++;
  }
  /// Mostly small, now and then anything that a float may be.
  double number() {
    if (next() % 8 != 0) return (next() - 128) / 16.0;
    float value = 0.0f;
    if (left < sizeof value) return 0.0;
    std::memcpy(&value, at, sizeof value);
    at += sizeof value;
    left -= sizeof value;
    return value;
  }
  Eigen::Vector3d vector() {
    const double x = number(), y = number();
    return {x, y, number()};
  }
};

template <typename T, typename Value>
void fill(Bytes& bytes, amble::KeyTrack<T>& track, Value value) {
  double time = 0.0;
  for (int keys = bytes.next() % 4; keys > 0; --keys) {
    time += bytes.next() / 64.0;
    track.times.push_back(time);
    track.values.push_back(value());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Bytes bytes{data, size};
  amble::AnimatedNodes scene;
  const double frame_time = bytes.number();
  while (bytes.left > 0 && scene.nodes.size() < 64) {
    amble::AnimatedNode node;
    const int flags = bytes.next();
    const int count = static_cast<int>(scene.nodes.size());
    node.name = "n" + std::to_string(count);
    node.parent = count == 0 ? -1 : bytes.next() % (count + 1) - 1;
    node.helper = flags % 4 == 1;
    node.bone = flags % 4 == 2;
    node.thing = flags % 4 == 3;
    node.X_PN.translation() = bytes.vector();
    fill(bytes, node.tracks.translations, [&] { return bytes.vector(); });
    fill(bytes, node.tracks.rotations, [&] {
      const Eigen::Vector3d v = bytes.vector();
      return Eigen::Quaterniond(bytes.number(), v.x(), v.y(), v.z()).normalized();
    });
    fill(bytes, node.tracks.scales, [&] { return bytes.vector(); });
    scene.nodes.push_back(node);
  }
  std::optional<double> asked;
  if (frame_time > kMinFrameTime) asked = frame_time;
  amble::readOrRefuse("fuzz.fbx", [&] { return amble::clipOfNodes(scene, "fuzz.fbx", asked); });
  return 0;
}
