// Who moves on a page, and how.
#include <cmath>
#include <nlohmann/json.hpp>

#include "viz/figure/figure.h"
#include "viz/page/page_data.h"

namespace amble {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kStep = 1.0 / 32767.0;  // of a coarse rotation's parts: 4e-5 rad or so

Json triple(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }

Json jointJson(const Joint& joint) {
  Json tips = Json::array();
  for (const Eigen::Vector3d& tip : joint.end_sites) tips.push_back(triple(tip));
  return {{"name", joint.name},
          {"parent", joint.parent},
          {"offset", triple(joint.offset)},
          {"tips", std::move(tips)}};
}

Json partJson(const BodyPart& part) {
  return {{"name", part.name},     {"joint", part.joint},   {"from", triple(part.from)},
          {"to", triple(part.to)}, {"radius", part.radius}, {"side", part.sole}};
}

std::string dumped(const Json& json) {
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

Json array(const std::string& reference) { return Json::parse(reference); }

Json rotationsOf(const PageTake& take, PageBytes& bytes) {
  std::vector<float> values;
  for (int frame = 0; frame < take.poses->size(); ++frame)
    for (const Eigen::Quaterniond& q : take.poses->rotations(frame))
      for (const double part : {q.x(), q.y(), q.z(), q.w()})
        values.push_back(static_cast<float>(part));
  if (!take.coarse) return array(bytes.add(std::span<const float>(values)));
  std::vector<std::int16_t> coarse;
  for (const float value : values)
    coarse.push_back(static_cast<std::int16_t>(std::lround(value / kStep)));
  return array(bytes.add(std::span<const std::int16_t>(coarse)));
}

Json plantedJson(const std::array<std::vector<FrameSpan>, 2>& planted) {
  Json sides = Json::array();
  for (const std::vector<FrameSpan>& spans : planted) {
    sides.push_back(Json::array());
    for (const FrameSpan& span : spans) sides.back().push_back({span.first, span.last});
  }
  return sides;
}

Json printJson(const Footprint& print, double sole) {
  Json outline = Json::array();
  for (const Eigen::Vector2d& p : placedShoe(print, sole)) outline.push_back({p.x(), p.y()});
  return {{"outline", std::move(outline)}, {"side", static_cast<int>(print.side)},
          {"at", triple(print.position)},  {"heading", print.heading},
          {"first", print.first_frame},    {"last", print.last_frame}};
}

Json clearanceJson(const PageClearance& clearance, PageBytes& bytes) {
  if (clearance.distance.empty()) return nullptr;
  std::vector<float> points;
  for (size_t i = 0; i < clearance.distance.size(); ++i)
    for (const Eigen::Vector3f* p : {&clearance.on_body[i], &clearance.on_it[i]})
      points.insert(points.end(), p->data(), p->data() + 3);
  return {{"distance", array(bytes.add(std::span<const float>(clearance.distance)))},
          {"points", array(bytes.add(std::span<const float>(points)))},
          {"part", clearance.part},
          {"object", clearance.object}};
}

template <typename Row>
void addAll(const Row& row, std::vector<typename Row::value_type>& values) {
  values.insert(values.end(), row.begin(), row.end());
}

Json figureJson(const Figure& figure, PageBytes& bytes) {
  std::vector<float> vertices, normals, weights, bind;
  std::vector<std::uint8_t> colors;
  std::vector<std::uint16_t> joints;
  std::vector<std::uint32_t> triangles;
  for (size_t i = 0; i < figure.vertices.size(); ++i) {
    vertices.insert(vertices.end(), figure.vertices[i].data(), figure.vertices[i].data() + 3);
    normals.insert(normals.end(), figure.normals[i].data(), figure.normals[i].data() + 3);
    addAll(figure.colors[i], colors);
    addAll(figure.joints[i], joints);
    addAll(figure.weights[i], weights);
  }
  for (const auto& triangle : figure.triangles) addAll(triangle, triangles);
  for (const JointFrame& frame : figure.bind) {
    const Eigen::Vector3d& p = frame.p_WJ;
    const Eigen::Quaterniond& q = frame.q_WJ;
    for (const double value : {p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), q.w()})
      bind.push_back(static_cast<float>(value));
  }
  return {{"vertices", array(bytes.add(std::span<const float>(vertices)))},
          {"normals", array(bytes.add(std::span<const float>(normals)))},
          {"colors", array(bytes.add(std::span<const std::uint8_t>(colors)))},
          {"joints", array(bytes.add(std::span<const std::uint16_t>(joints)))},
          {"weights", array(bytes.add(std::span<const float>(weights)))},
          {"triangles", array(bytes.add(std::span<const std::uint32_t>(triangles)))},
          {"bind", array(bytes.add(std::span<const float>(bind)))}};
}

}  // namespace

std::vector<float> flat(const std::vector<Eigen::Vector3d>& points) {
  std::vector<float> values;
  values.reserve(points.size() * 3);
  for (const Eigen::Vector3d& p : points)
    for (int i = 0; i < 3; ++i) values.push_back(static_cast<float>(p[i]));
  return values;
}

std::string jsonString(const std::string& text) { return dumped(text); }

std::string bodyJson(const PageActor& actor) {
  Json joints = Json::array(), body = Json::array();
  for (const Joint& joint : actor.skeleton->joints()) joints.push_back(jointJson(joint));
  if (actor.body != nullptr)
    for (const BodyPart& part : actor.body->parts) body.push_back(partJson(part));
  return dumped({{"joints", joints},
                 {"parts", body},
                 {"head", actor.body != nullptr ? actor.body->head : -1}});
}

std::string figureJson(const PageActor& actor, PageBytes& bytes) {
  if (actor.figure != nullptr) return dumped(figureJson(*actor.figure, bytes));
  if (actor.body == nullptr) return "null";
  return dumped(figureJson(makeFigure(*actor.skeleton, *actor.body), bytes));
}

std::string takeJson(const PageTake& take, PageBytes& bytes) {
  std::vector<Eigen::Vector3d> root;
  for (int frame = 0; frame < take.poses->size(); ++frame) root.push_back(take.poses->p_WR(frame));
  Json json = {{"name", take.name},
               {"actor", take.actor},
               {"frames", take.poses->size()},
               {"frame_time", take.frame_time},
               {"every", take.every},
               {"root", array(bytes.add(std::span<const float>(flat(root))))},
               {"rotations", rotationsOf(take, bytes)},
               {"planted", plantedJson(take.planted)},
               {"events", Json::array()},
               {"prints", Json::array()},
               {"sources", Json::array()},
               {"clearance", clearanceJson(take.clearance, bytes)}};
  if (take.joint_positions != nullptr && !take.joint_positions->empty())
    json["positions"] = array(bytes.add(std::span<const float>(flat(*take.joint_positions))));
  if (!take.way.empty()) json["way"] = array(bytes.add(std::span<const float>(flat(take.way))));
  if (!take.headings.empty())
    json["headings"] = array(bytes.add(std::span<const float>(take.headings)));
  if (take.stop) {
    json["stop"] = {{"frame", take.stop->frame},
                    {"part", take.stop->part},
                    {"object", take.stop->object},
                    {"at", triple(take.stop->at)}};
  }
  for (const PageEvent& event : take.events)
    json["events"].push_back(
        {{"name", event.name}, {"side", static_cast<int>(event.side)}, {"frame", event.frame}});
  for (const Footprint& print : take.footprints)
    json["prints"].push_back(printJson(print, take.sole));
  for (const PageSource& source : take.sources)
    json["sources"].push_back(
        {{"name", source.name}, {"share", array(bytes.add(std::span<const float>(source.share)))}});
  return dumped(json);
}

}  // namespace amble
