#include <optional>

#include "animation/bvh.h"
#include "animation/error.h"
#include "animation/floor_fit.h"
#include "animation/mirror_clip.h"
#include "animation/motion_library.h"
#include "animation/rotation.h"
#include "animation/strict_yaml.h"

namespace amble {
namespace {

constexpr int kDefaultHarmonics = 8;

// One line of a recipe's `motions`.
struct RecipeMotion {
  Motion motion;
  int harmonics = kDefaultHarmonics;
  std::optional<std::pair<int, int>> frames;
};

RecipeMotion readRecipeMotion(const YamlNode& node, const YamlNode& root) {
  node.requireKeys(
      {"name", "kind", "turning", "clip", "frames", "mirror", "harmonics", "licence", "credit"});
  RecipeMotion recipe;
  recipe.motion.name = node.at("name").asString();
  recipe.motion.kind = node.at("kind").asEnum<MotionKind>(
      {{"walk", MotionKind::kWalk}, {"posture", MotionKind::kPosture}});
  if (recipe.motion.kind == MotionKind::kWalk) {
    recipe.motion.turning = node.at("turning").asEnum<bool>({{"straight", false}, {"turn", true}});
  }
  recipe.motion.source.clip = node.at("clip").asString();
  if (const YamlNode mirror = node["mirror"]) recipe.motion.source.mirrored = mirror.asBool();
  if (const YamlNode harmonics = node["harmonics"]) {
    recipe.harmonics = harmonics.asInt(1, 12, "harmonics");
  }
  if (const YamlNode frames = node["frames"]) {
    const Eigen::Vector2d v = frames.asVec2("frames [first, last]");
    if (!(v[0] >= 0.0 && v[0] < v[1])) frames.fail("not a range of frames", "[first, last]");
    recipe.frames = {static_cast<int>(v[0]), static_cast<int>(v[1])};
  }
  for (const char* key : {"licence", "credit"}) {
    const YamlNode value = node[key] ? node[key] : root.at(key);
    (key[0] == 'l' ? recipe.motion.source.licence : recipe.motion.source.credit) = value.asString();
  }
  return recipe;
}

// A capture in metres, levelled, of the library's skeleton.
struct LevelClip {
  Clip clip;
  JointRoles roles;
};

LevelClip readLevelClip(const std::filesystem::path& file, std::optional<double> unit) {
  LevelClip level;
  level.clip = readBvh(file);
  level.roles = guessJointRoles(level.clip.skeleton, file.string());
  const double metres = unit ? *unit : guessUnit(level.clip.skeleton, level.roles);
  level.clip = readBvh(file, {.metres_per_unit = metres});
  for (const Side side : {kLeft, kRight}) {
    if (level.roles.legs[side].toe < 0) {
      throw InputError(file.string(), 0, "a foot without a toe joint", "a rig with both");
    }
  }
  const double stature = statureOf(level.clip.skeleton, level.roles);
  const FootShape shape = makeFootShape(level.clip.skeleton, level.roles, kLeft, stature);
  level.clip = levelClip(level.clip, fitFloor(level.clip, level.roles), shape.ankle_height);
  return level;
}

void requireSameSkeleton(const MotionLibrary& library, const Clip& clip, const std::string& file) {
  bool same = clip.skeleton.size() == library.skeleton.size();
  for (int i = 0; same && i < clip.skeleton.size(); ++i) {
    same = clip.skeleton.joint(i).name == library.skeleton.joint(i).name &&
           (i == 0 ||
            (clip.skeleton.joint(i).offset - library.skeleton.joint(i).offset).norm() < 1e-3);
  }
  if (!same) throw InputError(file, 0, "another skeleton than the library's", "one subject");
}

class LibraryBuilder {
 public:
  LibraryBuilder(const std::filesystem::path& recipe, const std::filesystem::path& captures)
      : root_(readYaml(recipe)) {
    root_.requireKeys({"skeleton", "captures", "unit", "licence", "credit", "motions"});
    captures_ = captures.empty() ? root_.at("captures").asPath() : captures;
    if (const YamlNode unit = root_["unit"]) unit_ = unit.asPositive("metres a unit", 1000.0);
    library_.file = recipe;
    library_.skeleton_file = root_.at("skeleton").asString();
  }

  MotionLibrary build() {
    std::vector<RecipeMotion> recipes;
    for (const YamlNode& node : root_.at("motions").items()) {
      recipes.push_back(readRecipeMotion(node, root_));
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
    LevelClip level = readLevelClip(file, unit_);
    if (library_.skeleton.size() == 0) adopt(level);
    requireSameSkeleton(library_, level.clip, file.string());
    level.clip.skeleton = library_.skeleton;
    if (recipe.motion.source.mirrored) level.clip = mirrorClip(level.clip, library_.roles);
    if (recipe.motion.kind == MotionKind::kPosture) {
      addPosture(recipe, level.clip);
    } else {
      addWalk(recipe, level.clip, file.string());
    }
    library_.motions.push_back(recipe.motion);
  }

  // The first capture's skeleton is the library's.
  void adopt(const LevelClip& level) {
    std::vector<Joint> joints = level.clip.skeleton.joints();
    joints[0].offset.setZero();
    library_.skeleton = Skeleton(std::move(joints));
    library_.roles = level.roles;
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
