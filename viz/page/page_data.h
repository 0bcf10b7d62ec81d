/// Parts of a page's data, each as JSON; their arrays go to the bytes.
#pragma once

#include <string>
#include <vector>

#include "viz/page/page.h"
#include "viz/page/page_bytes.h"

namespace amble {

/// x, y and z of one point after another.
std::vector<float> flat(const std::vector<Eigen::Vector3d>& points);
/// `text` as a JSON string; bytes that are no UTF-8 are replaced.
std::string jsonString(const std::string& text);

/// Surfaces of the room, equal ones once (viz/page/web/room.js draws them).
std::string roomJson(const Scene& scene, double floor, PageBytes& bytes);
/// Joints and parts of somebody.
std::string bodyJson(const PageActor& actor);
/// The skin of a body; "null" without one.
std::string figureJson(const PageActor& actor, PageBytes& bytes);
std::string takeJson(const PageTake& take, PageBytes& bytes);
/// Path, places and roadmap of a walk.
std::string walkJson(const PageSubject& subject, PageBytes& bytes);

}  // namespace amble
