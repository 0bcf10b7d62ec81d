#include <cmath>
#include <optional>

#include "animation/carry_over.h"
#include "animation/error.h"
#include "animation/level_capture.h"
#include "animation/mirror_clip.h"
#include "animation/motion_library.h"
#include "animation/rotation.h"
#include "animation/strict_yaml.h"

namespace amble {
namespace {

// One line of a recipe's `motions`.
struct RecipeMotion {
  Motion motion;
  int harmonics = 0;  // 0: chosen by error
  std::optional<double> unit;
  std::optional<std::pair<int, int>> frames;
  bool both = false;  // its mirror image, too
};

// Licence or credit of the first of the recipe's `sources` that the clip lies under, else the
// recipe's own.
std::string sourceOf(const RecipeMotion& recipe, const std::string& key, const YamlNode& root) {
  if (const YamlNode sources = root["sources"]) {
    for (const YamlNode& source : sources.items()) {
      source.requireKeys({"under", "licence", "credit"});
      if (recipe.motion.source.clip.starts_with(source.at("under").asString() + "/")) {
        return source.at(key).asString();
      }
    }
  }
  return root.at(key).asString();
}

RecipeMotion readRecipeMotion(const YamlNode& node, const YamlNode& root) {
  node.requireKeys({"name", "kind", "turning", "clip", "frames", "mirror", "harmonics", "unit",
                    "licence", "credit"});
  RecipeMotion recipe;
  recipe.motion.name = node.at("name").asString();
  recipe.motion.kind = node.at("kind").asEnum<MotionKind>(
      {{"walk", MotionKind::kWalk}, {"posture", MotionKind::kPosture}});
  if (recipe.motion.kind == MotionKind::kWalk) {
    recipe.motion.turning = node.at("turning").asEnum<bool>({{"straight", false}, {"turn", true}});
  }
  recipe.motion.source.clip = node.at("clip").asString();
  if (const YamlNode mirror = node["mirror"]) {
    const int which = mirror.indexIn({"false", "true", "both"});
    recipe.motion.source.mirrored = which == 1;
    recipe.both = which == 2;
  }
  if (const YamlNode harmonics = node["harmonics"]) {
    recipe.harmonics = harmonics.asInt(1, 12, "harmonics");
  }
  if (const YamlNode unit = node["unit"]) recipe.unit = unit.asPositive("metres a unit", 1000.0);
  if (const YamlNode frames = node["frames"]) {
    const Eigen::Vector2d v = frames.asVec2("frames [first, last]");
    if (!(v[0] >= 0.0 && v[0] < v[1])) frames.fail("not a range of frames", "[first, last]");
    recipe.frames = {static_cast<int>(v[0]), static_cast<int>(v[1])};
  }
  for (const char* key : {"licence", "credit"}) {
    const std::string value = node[key] ? node.at(key).asString() : sourceOf(recipe, key, root);
    (key[0] == 'l' ? recipe.motion.source.licence : recipe.motion.source.credit) = value;
  }
  return recipe;
}

bool sameSkeleton(const Skeleton& a, const Skeleton& b) {
  bool same = a.size() == b.size();
  for (int i = 0; same && i < a.size(); ++i) {
    same = a.joint(i).name == b.joint(i).name &&
           (i == 0 || (a.joint(i).offset - b.joint(i).offset).norm() < 1e-3);
  }
  return same;
}

void requireToes(const JointRoles& roles, const std::string& file) {
  for (const LegJoints& leg : roles.legs) {
    if (leg.toe < 0) throw InputError(file, 0, "a foot without a toe joint", "a rig with both");
  }
}

class LibraryBuilder {
 public:
  LibraryBuilder(const std::filesystem::path& recipe, const std::filesystem::path& captures)
      : root_(readYaml(recipe)) {
    root_.requireKeys({"skeleton", "captures", "unit", "licence", "credit", "sources", "motions"});
    captures_ = captures.empty() ? root_.at("captures").asPath() : captures;
    if (const YamlNode unit = root_["unit"]) unit_ = unit.asPositive("metres a unit", 1000.0);
    library_.file = recipe;
    library_.skeleton_file = root_.at("skeleton").asString();
  }

  MotionLibrary build() {
    std::vector<RecipeMotion> recipes;
    for (const YamlNode& node : root_.at("motions").items()) {
      recipes.push_back(readRecipeMotion(node, root_));
      if (!recipes.back().both) continue;
      recipes.push_back(recipes.back());
      recipes.back().motion.name += "-mirrored";
      recipes.back().motion.source.mirrored = true;
    }
    // Postures first: `stand` is the reference of every cycle.
    for (const bool postures : {true, false}) {
      for (RecipeMotion& recipe : recipes) {
        if ((recipe.motion.kind == MotionKind::kPosture) == postures) add(recipe);
      }
    }
    return library_;
  }

 private:
  void add(RecipeMotion& recipe) {
    const std::filesystem::path file = captures_ / recipe.motion.source.clip;
    MotionReadOptions how;
    how.metres_per_unit = recipe.unit ? recipe.unit : unit_;
    LevelCapture capture = readLevelCapture(file, how);
    if (library_.skeleton.size() == 0) adopt(capture, file.string());
    Clip clip = onLibrarySkeleton(capture);
    if (recipe.motion.source.mirrored) clip = mirrorClip(clip, library_.roles);
    if (recipe.frames) {
      recipe.frames->first -= capture.first_frame;
      recipe.frames->second -= capture.first_frame;
    }
    if (recipe.motion.kind == MotionKind::kPosture) {
      addPosture(recipe, clip);
    } else {
      addWalk(recipe, clip, file.string());
    }
    for (int& frame : recipe.motion.source.frames) frame += capture.first_frame;
    library_.motions.push_back(recipe.motion);
  }

  // Another subject's motion is carried over; larger people move slower (Froude).
  Clip onLibrarySkeleton(const LevelCapture& capture) const {
    Clip clip = capture.motion.clip;
    if (sameSkeleton(clip.skeleton, library_.skeleton)) {
      clip.skeleton = library_.skeleton;
      return clip;
    }
    const JointRoles& roles = capture.motion.roles;
    const Posture* stand = library_.find("stand") == nullptr ? nullptr : &library_.stand();
    if (stand == nullptr) root_.fail("no posture `stand`", "one before what is carried over");
    const ReferencePose from = referenceOf(clip, roles);
    const ReferencePose to = referenceOf(library_.skeleton, library_.roles, stand->rotations);
    const double ratio = library_.stature / statureOf(clip.skeleton, roles);
    Clip carried =
        carriedOver(clip, {clip.skeleton, roles, from}, {library_.skeleton, library_.roles, to});
    carried.frame_time *= std::sqrt(ratio);
    return levelled(carried, library_.roles);
  }

  // The first capture's skeleton is the library's.
  void adopt(const LevelCapture& capture, const std::string& file) {
    requireToes(capture.motion.roles, file);
    std::vector<Joint> joints = capture.motion.clip.skeleton.joints();
    joints[0].offset.setZero();
    library_.skeleton = Skeleton(std::move(joints));
    library_.roles = capture.motion.roles;
    library_.stature = statureOf(library_.skeleton, library_.roles);
  }

  void addPosture(RecipeMotion& recipe, const Clip& clip) {
    const auto frames = recipe.frames.value_or(std::pair{0, clip.frames() - 1});
    if (frames.second >= clip.frames()) {
      throw InputError(clip.name, 0, "no frame " + std::to_string(frames.second),
                       "frames up to " + std::to_string(clip.frames() - 1));
    }
    recipe.motion.posture =
        preparePosture(clip, library_.roles, library_.feet(), frames.first, frames.second);
    recipe.motion.source.frames = {frames.first, frames.second};
  }

  void addWalk(RecipeMotion& recipe, const Clip& clip, const std::string& file) {
    if (library_.find("stand") == nullptr) root_.fail("no posture `stand`", "one before the walks");
    const CycleOptions options{file, recipe.motion.turning, recipe.harmonics, recipe.frames};
    std::pair<int, int> used;
    recipe.motion.cycle = prepareWalkCycle(clip, library_.roles, library_.feet(),
                                           library_.stand().rotations, options, &used);
    recipe.motion.source.frames = {used.first, used.second};
    const double rate = std::abs(recipe.motion.cycle.turn_rate);
    if (recipe.motion.turning != (rate > kStraightTurnRate)) {
      throw InputError(file, 0,
                       "its cycle turns by " + std::to_string(rate / kDegree) + " degrees/s",
                       recipe.motion.turning ? "a turn" : "a straight walk");
    }
  }

  YamlNode root_;
  std::filesystem::path captures_;
  std::optional<double> unit_;
  MotionLibrary library_;
};

}  // namespace

MotionLibrary buildMotionLibrary(const std::filesystem::path& recipe,
                                 const std::filesystem::path& captures) {
  return LibraryBuilder(recipe, captures).build();
}

}  // namespace amble
