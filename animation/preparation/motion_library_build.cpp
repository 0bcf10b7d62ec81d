#include "animation/preparation/motion_library_build.h"

#include <algorithm>

#include "animation/library/motion_library_reader.h"
#include "animation/preparation/motion_library_add.h"
#include "base/strict_yaml.h"

namespace amble {
namespace {

// Licence or credit of the first of the recipe's `sources` that the clip lies under, else the
// recipe's own.
std::string sourceOf(const std::string& clip, const std::string& key, const YamlNode& root) {
  if (const YamlNode sources = root["sources"]) {
    for (const YamlNode& source : sources.items()) {
      source.requireKeys({"under", "licence", "credit"});
      if (clip.starts_with(source.at("under").asString() + "/")) {
        return source.at(key).asString();
      }
    }
  }
  return root.at(key).asString();
}

void readWhatToTake(const YamlNode& node, const YamlNode& root, MotionRequest& request) {
  if (const YamlNode harmonics = node["harmonics"]) {
    request.harmonics = harmonics.asInt(1, 12, "harmonics");
  }
  if (const YamlNode unit = node["unit"] ? node["unit"] : root["unit"]) {
    request.read.metres_per_unit = unit.asPositive("metres a unit", 1000.0);
  }
  if (const YamlNode frames = node["frames"]) {
    const Eigen::Vector2d v = frames.asVec2("frames [first, last]");
    if (!(v[0] >= 0.0 && v[0] < v[1])) frames.fail("not a range of frames", "[first, last]");
    request.frames = {static_cast<int>(v[0]), static_cast<int>(v[1])};
  }
}

// One line of a recipe's `motions`, and its mirror image where that is asked for.
std::vector<MotionRequest> readRequests(const YamlNode& node, const YamlNode& root,
                                        const std::filesystem::path& captures) {
  node.requireKeys({"name", "kind", "turning", "style", "valid", "joints", "clip", "frames",
                    "speed", "mirror", "harmonics", "unit", "licence", "credit"});
  MotionRequest request;
  request.name = node.at("name").asString();
  request.kind = static_cast<MotionKind>(node.at("kind").indexIn(motionKindNames()));
  if (const YamlNode turning = node["turning"]) {
    request.turning = turning.asEnum<bool>({{"straight", false}, {"turn", true}});
  }
  if (const YamlNode style = node["style"]) request.style = readStyle(style, request.kind);
  if (const YamlNode valid = node["valid"]) request.valid = readValidity(valid, request.kind);
  if (const YamlNode joints = node["joints"]) request.chains = readChains(joints);
  request.source.clip = node.at("clip").asString();
  request.file = captures / request.source.clip;
  readWhatToTake(node, root, request);
  if (const YamlNode speed = node["speed"]) {
    request.source.speed = speed.asPositive("speed [m/s]", 5.0);
  }
  for (const char* key : {"licence", "credit"}) {
    const std::string value = node[key]              ? node.at(key).asString()
                              : request.source.speed ? ""  // the engine's file says it
                                                     : sourceOf(request.source.clip, key, root);
    (key[0] == 'l' ? request.source.licence : request.source.credit) = value;
  }
  const YamlNode mirror = node["mirror"];
  const int which = mirror ? mirror.indexIn({"false", "true", "both"}) : 0;
  request.source.mirrored = which == 1;
  std::vector<MotionRequest> requests = {request};
  if (which == 2) {
    request.name += "-mirrored";
    request.source.mirrored = true;
    requests.push_back(request);
  }
  return requests;
}

}  // namespace

MotionLibrary buildMotionLibrary(const std::filesystem::path& recipe,
                                 const std::filesystem::path& captures, const StopRequest& stop) {
  const YamlNode root = readYaml(recipe);
  root.requireKeys({"skeleton", "captures", "unit", "licence", "credit", "sources", "motions"});
  MotionLibrary library;
  library.file = recipe;
  library.skeleton_file = root.at("skeleton").asString();
  const std::filesystem::path folder = captures.empty() ? root.at("captures").asPath() : captures;
  std::vector<MotionRequest> requests;
  for (const YamlNode& node : root.at("motions").items()) {
    for (MotionRequest& request : readRequests(node, root, folder)) {
      requests.push_back(std::move(request));
    }
  }
  // Postures first: `stand` is the reference of every cycle.
  std::stable_partition(requests.begin(), requests.end(), [](const MotionRequest& request) {
    return request.kind == MotionKind::kPosture;
  });
  for (const MotionRequest& request : requests) {
    stop.check();
    addMotion(library, request);
  }
  return library;
}

}  // namespace amble
