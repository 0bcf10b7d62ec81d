#include "planner/roadmap/roadmap_file.h"

#include <bit>
#include <cmath>
#include <set>
#include <utility>

#include "base/byte_pack.h"
#include "base/error.h"
#include "base/files.h"
#include "base/output_file.h"
#include "base/rotation.h"
#include "base/sha256.h"

namespace amble {
namespace {

static_assert(std::endian::native == std::endian::little, "files are little-endian");

constexpr FileKind kRoadmapKind = {"a roadmap (amble roadmap build)", kMaxRoadmapFile};
constexpr std::string_view kTitle = "amble roadmap 1\n";
constexpr std::string_view kAnyTitle = "amble roadmap ";
constexpr size_t kDigest = 64;     // of SHA-256, in hexadecimal [bytes]
constexpr double kFarthest = 1e6;  // of a coordinate [m]
constexpr int kMostFailures = 1000000;
constexpr std::uint64_t kMostSeed = 2147483647;

template <typename Pack>
void packSource(const RoadmapSource& source, Pack& pack) {
  for (const auto& [name, values] : source.parts()) {
    pack(values->size());
    for (const auto& [key, value] : *values) {
      pack(key);
      pack(value);
    }
  }
}

// What its numbers must be; a text is what they are not.
const char* faultOf(const KeptRoadmap& roadmap) {
  if (roadmap.seed > kMostSeed || roadmap.max_failures < 1 ||
      roadmap.max_failures > kMostFailures || roadmap.samples < 0 ||
      !(roadmap.coverage >= 0.0 && roadmap.coverage <= 1.0))
    return "counts that no search has";
  for (const KeptRoadmap::Node& node : roadmap.nodes) {
    if (!(node.stance.position.cwiseAbs().maxCoeff() <= kFarthest) ||
        !node.stance.position.allFinite() || !(std::abs(node.stance.heading) <= 2.0 * kPi))
      return "a node that is nowhere";
    if (node.kind != NodeKind::kGuard && node.kind != NodeKind::kConnector)
      return "a node of no kind";
  }
  const int nodes = static_cast<int>(roadmap.nodes.size());
  std::set<std::pair<int, int>> pairs;
  for (const KeptRoadmap::Edge& edge : roadmap.edges) {
    if (edge.from < 0 || edge.from >= nodes || edge.to < 0 || edge.to >= nodes)
      return "an edge to a node that is not there";
    if (edge.from == edge.to || !pairs.insert({edge.from, edge.to}).second)
      return "an edge twice, or from a node to itself";
    if (!(edge.cost >= 0.0) || !std::isfinite(edge.cost)) return "an edge that costs no time";
  }
  return nullptr;
}

RoadmapSource unpackSource(Unpacker& unpack) {
  RoadmapSource source;
  for (RoadmapSource::Values* values :
       {&source.scene, &source.library, &source.character, &source.settings}) {
    for (size_t left = unpack.takeCount(); left > 0; --left) {
      std::string key;
      unpack(key);
      unpack((*values)[key]);
    }
  }
  return source;
}

// @throws std::runtime_error where the bytes end
KeptRoadmap unpackAll(std::string_view bytes) {
  Unpacker unpack(bytes);
  KeptRoadmap roadmap;
  roadmap.source = unpackSource(unpack);
  unpack(roadmap.seed);
  unpack(roadmap.max_failures);
  unpack(roadmap.samples);
  unpack(roadmap.coverage);
  for (size_t left = unpack.takeCount(); left > 0; --left) {
    KeptRoadmap::Node node;
    unpack(node.stance.position);
    unpack(node.stance.heading);
    unpack(node.kind);
    roadmap.nodes.push_back(node);
  }
  for (size_t left = unpack.takeCount(); left > 0; --left) {
    KeptRoadmap::Edge edge;
    unpack(edge.from);
    unpack(edge.to);
    unpack(edge.cost);
    roadmap.edges.push_back(edge);
  }
  return roadmap;
}

}  // namespace

std::string packRoadmap(const KeptRoadmap& roadmap) {
  Packer pack;
  packSource(roadmap.source, pack);
  pack(roadmap.seed);
  pack(roadmap.max_failures);
  pack(roadmap.samples);
  pack(roadmap.coverage);
  pack(roadmap.nodes.size());
  for (const KeptRoadmap::Node& node : roadmap.nodes) {
    pack(node.stance.position);
    pack(node.stance.heading);
    pack(node.kind);
  }
  pack(roadmap.edges.size());
  for (const KeptRoadmap::Edge& edge : roadmap.edges) {
    pack(edge.from);
    pack(edge.to);
    pack(edge.cost);
  }
  std::string bytes = std::string(kTitle) + pack.bytes();
  return bytes + sha256(bytes);
}

KeptRoadmap unpackRoadmap(std::string_view bytes, const std::string& name) {
  const auto fail = [&](const std::string& problem) {
    throw InputError(name, 0, problem, "one that `amble roadmap build` has written");
  };
  if (!bytes.starts_with(kAnyTitle)) fail("is no roadmap");
  if (!bytes.starts_with(kTitle)) fail("is a roadmap of another format, or cut off");
  const size_t signed_size = bytes.size() - std::min(bytes.size(), kDigest);
  if (signed_size < kTitle.size() ||
      sha256(bytes.substr(0, signed_size)) != bytes.substr(signed_size))
    fail("is a damaged roadmap: its bytes are not those that were written");
  const std::string_view body = bytes.substr(kTitle.size(), signed_size - kTitle.size());
  KeptRoadmap roadmap;
  try {
    roadmap = unpackAll(body);
  } catch (const std::runtime_error&) {
    fail("is a damaged roadmap: it ends too soon");
  }
  if (const char* fault = faultOf(roadmap))
    fail(std::string("is a damaged roadmap: it has ") + fault);
  if (packRoadmap(roadmap) != bytes) fail("is a damaged roadmap: it goes on after its end");
  return roadmap;
}

void writeRoadmap(const KeptRoadmap& roadmap, const std::filesystem::path& file) {
  writeFile(file, [&](std::ostream& out) { out << packRoadmap(roadmap); });
}

KeptRoadmap readRoadmap(const std::filesystem::path& file) {
  return unpackRoadmap(readWholeFile(file, kRoadmapKind), file.string());
}

}  // namespace amble
