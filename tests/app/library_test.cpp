// amble library add, show, check and build, from the outside.

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>

#include "test_paths.h"
#include "tests/app/program.h"

namespace amble {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const std::string kCaptures = captureFolder();
const std::string kWalk = kCaptures + "accad_female1/Female1_B03_Walk1.bvh";
const std::string kTurn = kCaptures + "accad_female1/Female1_B09_WalkTurnLeft90.bvh";
const std::string kStand = kCaptures + "accad_female1/Female1_A01_Stand.bvh";

class Library : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    if (!fs::exists(kWalk)) GTEST_SKIP() << "no captures in " << AMBLE_SHARED;
    write(
        "in/floor.yaml",
        "name: floor\nobjects:\n  - {name: floor, box: {size: [8, 4, 0.1]}, at: [4, 2, -0.05]}\n");
  }
  void copy(const std::string& from, const std::string& to) const {
    fs::create_directories((folder_ / to).parent_path());
    fs::copy_file(from, folder_ / to);
  }
  void add(const std::string& arguments) const {
    const Ran ran = run("library add " + arguments);
    ASSERT_EQ(ran.status, 0) << arguments << ": " << ran.err;
  }
  /// A library that was made of one clip is shown, and a person walks with it, touching nothing.
  void expectWalks(const std::string& library) const {
    const Ran shown = run("library show --json '" + library + "'");
    ASSERT_EQ(shown.status, 0) << shown.err;
    const json found = json::parse(shown.out)[0];
    EXPECT_EQ(found["motions"].size(), 3u) << library;  // stand, the walk and its mirror image
    EXPECT_TRUE(found["warnings"].empty()) << found["warnings"];
    write("in/scenario.yaml",
          "scene: floor.yaml\n"
          "character: {library: '../" +
              library +
              "'}\n"
              "start: {at: [1, 2], heading: 0}\ngoal: {at: [5, 2], heading: 0}\n");
    const Ran planned = run("plan in/scenario.yaml -o out --formats bvh,json");
    EXPECT_EQ(planned.status, 0) << library << ": " << planned.err << planned.out;
    // Who knows the walk's file only finds the same.
    const Ran found_again = run("validate out/walk.bvh --scene in/floor.yaml");
    EXPECT_EQ(found_again.status, 0) << library << ": " << found_again.out << found_again.err;
  }
};

// One clip of each rig that there is.
TEST_F(Library, OfOneClipOfAnyRigWalks) {
  int made = 0;
  for (const char* const clip :
       {"accad_female1/Female1_B03_Walk1.bvh", "accad_male1/Male1_B3_Walk.bvh",
        "cmu_asfamc/07_05-walk.amc", "cmu_daz/07_01.bvh", "cmu_max/131_01.bvh",
        "cmu_max/scaled_131_01.bvh", "cmu_mb2/07_01.bvh", "cmu_style_loops/142_08_EDIT_LOOP.bvh",
        "cmu_style_loops/120_19_EDIT_LOOP.bvh", "formats/mass_walk.bvh",
        "../gait/trials/zoo_HC002D06.bvh", "../cases/captures/a30_mixamo_names_walk.bvh"}) {
    SCOPED_TRACE(clip);
    const std::string library = "made/" + std::to_string(++made) + ".yaml";
    const Ran ran = run("library add '" + library + "' '" + kCaptures + clip + "'");
    ASSERT_EQ(ran.status, 0) << ran.err;
    // Of what is guessed, as toes that a rig has not, and of nothing else.
    std::istringstream lines(ran.err);
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with("warning")) continue;
      EXPECT_NE(line.find("unsure of"), std::string::npos) << line;
    }
    expectWalks(library);
  }
}

TEST_F(Library, OfALoopOfOneCycleIsThatCycle) {
  const Ran made =
      run("library add loop.yaml '" + kCaptures + "cmu_style_loops/142_08_EDIT_LOOP.bvh'");
  ASSERT_EQ(made.status, 0) << made.err;
  const json found = json::parse(run("library show --json loop.yaml").out)[0];
  ASSERT_EQ(found["motions"].size(), 3u);
  EXPECT_NEAR(found["motions"][1]["speed"].get<double>(), 1.49, 0.03);
  EXPECT_NEAR(found["motions"][1]["period"].get<double>(), 1.1, 0.02);
}

// MotionBuilder's names of a rig, and what Mixamo and Biped call the same joints.
std::string renamed(std::string text, const std::string& make) {
  const std::map<std::string, std::string> biped = {
      {"Hips", "Bip01 Pelvis"},       {"ToSpine", "Bip01 Spine"},       {"Spine", "Bip01 Spine1"},
      {"Spine1", "Bip01 Spine2"},     {"Neck", "Bip01 Neck"},           {"Head", "Bip01 Head"},
      {"UpLeg", "Bip01 % Thigh"},     {"Leg", "Bip01 % Calf"},          {"Foot", "Bip01 % Foot"},
      {"ToeBase", "Bip01 % Toe0"},    {"Shoulder", "Bip01 % Clavicle"}, {"Arm", "Bip01 % UpperArm"},
      {"ForeArm", "Bip01 % Forearm"}, {"Hand", "Bip01 % Hand"}};
  std::string result;
  std::smatch match;
  const std::regex joint("(ROOT|JOINT) (Left|Right)?([A-Za-z0-9]+)");
  while (std::regex_search(text, match, joint)) {
    std::string name = "mixamorig:" + match[2].str() + match[3].str();
    if (make == "biped" && biped.contains(match[3].str())) {
      name = biped.at(match[3].str());
      if (const size_t side = name.find('%'); side != name.npos) name[side] = match[2].str()[0];
    }
    result += match.prefix().str() + match[1].str() + " " + name;
    text = match.suffix().str();
  }
  return result + text;
}

TEST_F(Library, OfAClipWithMixamosOrBipedsNamesWalks) {
  copy(kWalk, "in/walk.bvh");
  const std::string own = read("in/walk.bvh");
  for (const std::string make : {"mixamo", "biped"}) {
    SCOPED_TRACE(make);
    write("in/" + make + ".bvh", renamed(own, make));
    add(make + ".yaml in/" + make + ".bvh");
    expectWalks(make + ".yaml");
    // The same subject again is known as such: nothing is carried over.
    add(make + ".yaml in/" + make + ".bvh --name again --no-mirror");
    const json motions =
        json::parse(run("library show --json " + make + ".yaml").out)[0]["motions"];
    EXPECT_EQ(motions.back()["speed"], motions[1]["speed"]);
  }
}

TEST_F(Library, MotionsAndFilesMayBeCalledAnything) {
  const std::string file = "in/my walk: #3 * [left] & 'right'.bvh";
  fs::copy_file(kWalk, folder_ / file);
  add("made.yaml \"" + file + "\"");
  add("made.yaml \"" + file +
      "\" --name '- *a: #b {c} & !d' --no-mirror --credit '@e, f: \"g\" \\\\'");
  const Ran shown = run("library show --json made.yaml");
  ASSERT_EQ(shown.status, 0) << shown.err;
  const json motions = json::parse(shown.out)[0]["motions"];
  ASSERT_EQ(motions.size(), 4u);
  EXPECT_EQ(motions[1]["name"], "my walk: #3 * [left] & 'right'");
  EXPECT_EQ(motions[1]["source"]["clip"], "my walk: #3 * [left] & 'right'.bvh");
  EXPECT_EQ(motions[3]["name"], "- *a: #b {c} & !d");
  EXPECT_EQ(motions[3]["source"]["credit"], "@e, f: \"g\" \\\\");
}

TEST_F(Library, FoldersThatAreNotThereAreMade) {
  add("new/dir/mine.yaml " + kWalk);
  EXPECT_EQ(files(),
            (std::set<std::string>{"in/floor.yaml", "new/dir/mine.bvh", "new/dir/mine.yaml"}));
  write("in/file", "no folder");
  expectRefused("library add in/file/mine.yaml " + kWalk, {"in/file", "no folder"});
  expectRefused("library add mine.bvh " + kWalk, {"mine.bvh: ", "NAME.yaml"});
}

TEST_F(Library, WithoutAStraightWalkIsSaidWhenItIsMade) {
  const Ran made = run("library add turns.yaml " + kTurn);
  EXPECT_EQ(made.status, 0);
  EXPECT_NE(made.err.find("no straight walk"), std::string::npos) << made.err;
  EXPECT_NE(run("library show turns.yaml").out.find("no straight walk"), std::string::npos);
  EXPECT_EQ(run("library check turns.yaml").status, 1);
  const Ran more = run("library add turns.yaml " + kWalk);
  EXPECT_EQ(more.status, 0);
  EXPECT_EQ(more.err.find("no straight walk"), std::string::npos) << more.err;
  EXPECT_EQ(run("library check turns.yaml").status, 0);
}

TEST_F(Library, NeverWritesOverTheCaptureThatItReads) {
  copy(kWalk, "in/mine.bvh");
  const std::string own = read("in/mine.bvh");
  add("in/mine.yaml in/mine.bvh");
  EXPECT_EQ(read("in/mine.bvh"), own);
  EXPECT_EQ(run("library show in/mine.yaml").status, 0);
  add("in/mine.yaml in/mine.bvh --name again --no-mirror");
  EXPECT_EQ(read("in/mine.bvh"), own);
  EXPECT_TRUE(fs::exists(folder_ / "in/mine-skeleton.bvh"));
}

TEST_F(Library, OfAnotherEndingOrAnOldNameKeepsItsSkeleton) {
  add("in/p.yml " + kWalk);
  const std::string own = read("in/p.bvh");
  add("in/p.yaml " + kCaptures + "accad_male1/Male1_B3_Walk.bvh");
  EXPECT_EQ(read("in/p.bvh"), own);
  EXPECT_EQ(run("library engine build " + kWalk + " -o in/p.engine.yaml").status, 0);
  fs::rename(folder_ / "in/p.yml", folder_ / "in/q.yaml");
  fs::remove(folder_ / "in/p.yaml");
  add("in/p.yaml " + kCaptures + "accad_male1/Male1_B3_Walk.bvh");
  EXPECT_EQ(read("in/p.bvh"), own);
  EXPECT_EQ(run("library show in/q.yaml").status, 0);
}

TEST_F(Library, WhoseFeetComeToStandOtherwiseLeavesASkeletonThatAnotherHasTooAsItIs) {
  add("in/one.yaml " + kWalk);
  fs::copy_file(folder_ / "in/one.yaml", folder_ / "in/other.yaml");
  const std::string shared = read("in/one.bvh");
  add("in/one.yaml " + kTurn);
  EXPECT_EQ(read("in/one.bvh"), shared);
  EXPECT_NE(read("in/one.yaml").find("skeleton: one-skeleton.bvh"), std::string::npos);
  add("in/one.yaml " + kCaptures + "accad_female1/Female1_B12_WalkTurnRight90.bvh");
  EXPECT_FALSE(fs::exists(folder_ / "in/one-skeleton-2.bvh"));  // that one is its own
  EXPECT_EQ(read("in/one.bvh"), shared);
}

TEST_F(Library, NeverWritesOverTheCaptureThatItNamesAsItsSkeleton) {
  copy(kWalk, "in/mine.bvh");
  add("in/mine.yaml in/mine.bvh");
  // As DESIGN.md's example has it: the hierarchy of a capture.
  std::string text = read("in/mine.yaml");
  text.replace(text.find("mine-skeleton.bvh"), 17, "capture.bvh");
  write("in/mine.yaml", text);
  std::string capture = read("in/mine-skeleton.bvh");
  const size_t motion = capture.find("MOTION");
  const std::string frame = capture.substr(capture.find('\n', capture.find("Frame Time")) + 1);
  capture = capture.substr(0, motion) + "MOTION\nFrames: 2\nFrame Time: 0.033333\n" + frame + frame;
  write("in/capture.bvh", capture);
  add("in/mine.yaml in/mine.bvh --name again --no-mirror");
  EXPECT_EQ(read("in/capture.bvh"), capture);
  // Its feet stand otherwise now, beside a walk that is there on one side only.
  EXPECT_NE(read("in/mine.yaml").find("skeleton: mine-skeleton.bvh"), std::string::npos);
  // Another rig's skeleton does not replace it either.
  write("in/other.recipe.yaml",
        "skeleton: capture.bvh\ncaptures: " + kCaptures +
            "\nlicence: none\ncredit: none\nmotions:\n"
            "  - {name: walk, kind: walk, clip: accad_male1/Male1_B3_Walk.bvh}\n");
  expectRefused("library build in/other.recipe.yaml", {"capture.bvh: is a capture"});
  EXPECT_EQ(read("in/capture.bvh"), capture);
}

TEST_F(Library, IsNotWrittenOverWhatIsNoLibrary) {
  write("in/it.recipe.yaml",
        "skeleton: it.bvh\ncaptures: " + kCaptures +
            "\nlicence: none\ncredit: none\nmotions:\n"
            "  - {name: walk, kind: walk, clip: accad_male1/Male1_B3_Walk.bvh}\n");
  expectRefused("library build in/it.recipe.yaml -o in/it.recipe.yaml",
                {"it.recipe.yaml: is read too, as in/it.recipe.yaml"});
  fs::copy_file(folder_ / "in/it.recipe.yaml", folder_ / "in/other.yaml");
  expectRefused("library build in/it.recipe.yaml -o in/other.yaml",
                {"other.yaml: is no motion library"});
  EXPECT_EQ(run("library build in/it.recipe.yaml").status, 0);
  EXPECT_EQ(run("library build in/it.recipe.yaml").status, 0);  // over itself
}

TEST_F(Library, LegsAreNoChainsOfMovements) {
  expectRefused("library add mine.yaml " + kWalk + " --kind movement --joints left_leg",
                {"--joints", "left_leg"});
  write("in/it.recipe.yaml", "skeleton: it.bvh\ncaptures: " + kCaptures +
                                 "\nlicence: none\ncredit: none\nmotions:\n"
                                 "  - {name: kick, kind: movement, joints: [right_leg], clip: "
                                 "accad_male1/Male1_B3_Walk.bvh}\n");
  expectRefused("library build in/it.recipe.yaml", {"it.recipe.yaml:6: ", "leg"});
}

TEST_F(Library, TurnsOnTheSpotAreAddedToBothSidesShownCheckedAndTurnedBy) {
  const std::string about = kCaptures + "accad_female1/Female1_B15_WalkTurnAround180.bvh";
  add("in/mine.yaml " + kWalk);
  const Ran formula = run("library show in/mine.yaml");
  EXPECT_NE(formula.out.find("turns on the spot to the left, turns on the spot to the right"),
            std::string::npos)
      << formula.out;
  const Ran added =
      run("library add in/mine.yaml '" + about + "' --kind turn_on_spot --name about");
  ASSERT_EQ(added.status, 0) << added.err;
  EXPECT_NE(added.err.find("about: turn_on_spot, +17"), std::string::npos) << added.err;
  EXPECT_NE(added.err.find("about-mirrored: turn_on_spot, -17"), std::string::npos) << added.err;
  const json shown = json::parse(run("library show --json in/mine.yaml").out)[0];
  for (const json& motion : shown["motions"]) {
    if (motion["kind"] != "turn_on_spot") continue;
    const bool mirrored = motion["source"]["mirrored"];
    EXPECT_NEAR(motion["angle"].get<double>(), mirrored ? -171.0 : 171.0, 3.0);
    EXPECT_EQ(motion["foot"], mirrored ? "left" : "right");
    EXPECT_GT(motion["twist"], 30.0);
  }
  for (const json& formula_only : shown["by_formula"])
    EXPECT_EQ(formula_only.get<std::string>().find("turns"), std::string::npos) << formula_only;
  const std::string folder = fs::path(about).parent_path().string();
  const Ran checked = run("library check in/mine.yaml --captures '" + folder + "'");
  EXPECT_EQ(checked.status, 0) << checked.out;
  write("in/turn.yaml",
        "scene: floor.yaml\ncharacter: {library: mine.yaml}\n"
        "start: {at: [2, 2], heading: 0}\ngoal: {at: [2, 2], heading: 180}\n");
  EXPECT_EQ(run("plan in/turn.yaml -o out --formats bvh,json").status, 0);
}

// Each file is read, and written with fewer digits, once a motion.
TEST_F(Library, IsRightByItsCapturesInWhateverOrderTheyWereAdded) {
  const auto of = [](const std::string& clip) { return kCaptures + clip + "' --name "; };
  const std::map<std::string, std::string> motions = {
      {"stand", of("accad_female1/Female1_A01_Stand.bvh") + "stand --kind posture"},
      {"walk", of("accad_female1/Female1_B03_Walk1.bvh") + "walk"},
      {"turn", of("accad_female1/Female1_B09_WalkTurnLeft90.bvh") + "turn"},
      {"other", of("cmu_mb2/07_01.bvh") + "other --no-mirror"},
      {"start", of("accad_female1/Female1_B01_StandToWalk.bvh") + "start --kind start"},
      {"carry", of("accad_female1/Female1_B20_WalkWithBox.bvh") + "carry --kind movement"},
      {"about",
       of("accad_female1/Female1_B15_WalkTurnAround180.bvh") + "about --kind turn_on_spot"}};
  for (const auto& [name, arguments] : motions) {
    const std::string clip = arguments.substr(0, arguments.find('\''));
    fs::create_directories(folder_ / "captures");
    fs::copy_file(clip, folder_ / "captures" / fs::path(clip).filename());
  }
  for (const std::vector<std::string>& order :
       {std::vector<std::string>{"stand", "other", "start", "about", "turn", "walk"},
        {"start", "carry", "walk", "turn"}}) {
    fs::remove(folder_ / "mine.yaml");
    for (const std::string& name : order) add("mine.yaml '" + motions.at(name));
    const Ran checked = run("library check mine.yaml --captures captures");
    EXPECT_EQ(checked.status, 0) << order[1] << ": " << checked.out;
  }
}

// One's own stand is taken whenever it comes, and all else is made again with it.
TEST_F(Library, AStandOfOnesOwnTakesThePlaceOfABorrowedOne) {
  const std::string folder = kCaptures + "accad_female1";
  const std::string stand = kStand + "' --kind posture --name stand";
  copy(kStand, "elsewhere/stand.bvh");
  add("late.yaml '" + kWalk + "' --frames 30 110");
  const std::string before = read("late.yaml");
  const Ran apart = run("library add late.yaml elsewhere/stand.bvh --kind posture --name stand");
  EXPECT_EQ(apart.status, 2);
  EXPECT_NE(apart.err.find("elsewhere/Female1_B03_Walk1.bvh: is not there"), std::string::npos)
      << apart.err;
  EXPECT_NE(apart.err.find("--captures DIR"), std::string::npos) << apart.err;
  EXPECT_EQ(read("late.yaml"), before);
  add("late.yaml elsewhere/stand.bvh --kind posture --name stand --captures '" + folder + "'");
  const Ran checked =
      run("library check late.yaml --captures elsewhere --captures '" + folder + "'");
  EXPECT_EQ(checked.status, 0) << checked.out;
  EXPECT_EQ(checked.out.find("WRONG"), std::string::npos) << checked.out;
  const json motions = json::parse(run("library show --json late.yaml").out)[0]["motions"];
  EXPECT_EQ(motions[0]["source"]["clip"], "stand.bvh");
  const Ran twice = run("library add late.yaml '" + stand);
  EXPECT_EQ(twice.status, 2);
  EXPECT_NE(twice.err.find("the library has a motion stand"), std::string::npos) << twice.err;
  const Ran of_walk = run("library add late.yaml '" + kTurn + "' --captures .");
  EXPECT_EQ(of_walk.status, 2);
  EXPECT_NE(of_walk.err.find("--captures: is of a posture called stand"), std::string::npos)
      << of_walk.err;
}

TEST_F(Library, ATurnOnTheSpotIsAddedToOneSideWhereThatIsAsked) {
  const std::string about = kCaptures + "accad_female1/Female1_B15_WalkTurnAround180.bvh";
  const auto countWith = [&](const std::string& options) {
    fs::remove(folder_ / "mine.yaml");
    add("mine.yaml '" + about + "' --kind turn_on_spot " + options);
    return json::parse(run("library show --json mine.yaml").out)[0]["motions"].size();
  };
  EXPECT_EQ(countWith(""), 3u);  // with a `stand`
  EXPECT_EQ(countWith("--no-mirror"), 2u);
  EXPECT_EQ(countWith("--style old-man"), 2u);
  EXPECT_EQ(countWith("--style old-man --mirror"), 3u);
}

TEST_F(Library, WhereNobodyTurnsOnTheSpotThatIsSaid) {
  expectRefused("library add mine.yaml " + kWalk + " --kind turn_on_spot",
                {"B03_Walk1.bvh: nobody in it turns on the spot", "30 degrees"});
  expectRefused("library add mine.yaml " + kWalk + " --kind turn_on_spot --frames 50 60",
                {"B03_Walk1.bvh: in these frames nobody turns on the spot"});
  expectRefused("library add mine.yaml '" + kCaptures +
                    "accad_female1/Female1_C17_RunTurnAround.bvh' --kind turn_on_spot",
                {"C17_RunTurnAround.bvh: nobody in it turns on the spot", "nobody runs"});
  write("in/it.recipe.yaml",
        "skeleton: it.bvh\ncaptures: " + kCaptures +
            "\nlicence: none\ncredit: none\nmotions:\n"
            "  - {name: about, kind: turn_on_spot, mirror: both, clip: "
            "accad_female1/Female1_B15_WalkTurnAround180.bvh, frames: [130, 230]}\n");
  EXPECT_EQ(run("library build in/it.recipe.yaml -o it.yaml").status, 0);
  EXPECT_EQ(json::parse(run("library show --json it.yaml").out)[0]["motions"].size(), 3u);
}

TEST_F(Library, OptionsOfOtherKindsAreRefusedByName) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"--kind turn_on_spot --joints left_arm", "--joints: is of no turn_on_spot; expected --kind"},
      {"--joints left_arm", "--joints: is of no walk; expected --kind movement"},
      {"--kind turn_on_spot --turning turn",
       "--turning: is of no turn_on_spot; expected --kind walk"},
      {"--kind posture --turning straight", "--turning: is of no posture"},
      {"--kind start --style x --mirror", "--mirror: is of no start"},
      {"--kind posture --style x", "--style: is of no posture"},
      {"--style x --mirror --no-mirror", "--no-mirror"},
  };
  for (const auto& [options, why] : cases)
    expectRefused("library add mine.yaml " + kWalk + " " + options, {why});
}

TEST_F(Library, FramesThatAClipDoesNotHaveAreNamedWhateverIsMadeOfThem) {
  for (const char* kind : {"walk", "movement", "posture", "start", "stop", "turn_on_spot"}) {
    SCOPED_TRACE(kind);
    const std::string add = "library add mine.yaml " + kWalk + " --kind " + kind + " --frames ";
    expectRefused(add + "20 10", {"frames 20 to 10 end before they begin; expected the first"});
    expectRefused(add + "10 99999", {"frames 10 to 99999 are not all of its motion"});
    expectRefused(add + "-5 10", {"frames -5 to 10 are not all of its motion"});
  }
}

// As of a clip that holds no others.
TEST_F(Library, AStartIsLookedForInTheFramesThatAreAskedFor) {
  const std::string clip = kCaptures + "accad_female1/Female1_B01_StandToWalk.bvh";
  ASSERT_EQ(run("convert '" + clip + "' -o cut.bvh --trim 9:81").status, 0);
  const auto startOf = [&](const std::string& of) {
    fs::remove(folder_ / "mine.yaml");
    add("mine.yaml " + of + " --name go --kind start");
    const json shown = json::parse(run("library show --json mine.yaml").out)[0];
    return shown["motions"].back();
  };
  const json within = startOf("'" + clip + "' --frames 9 81"), cut = startOf("cut.bvh");
  ASSERT_EQ(within["kind"], "start");
  for (const int end : {0, 1}) {
    EXPECT_EQ(within["source"]["frames"][end].get<int>(),
              9 + cut["source"]["frames"][end].get<int>());
  }
  EXPECT_NEAR(within["speed"].get<double>(), cut["speed"].get<double>(), 0.005);
  // There he walks already.
  expectRefused("library add other.yaml '" + clip + "' --kind start --frames 60 90",
                {"does not stand and then walk"});
}

TEST_F(Library, APostureIsOfFramesInWhichItIsHeld) {
  expectRefused("library add mine.yaml " + kWalk + " --kind posture --name freeze",
                {"does not hold still", "degrees"});
  add("mine.yaml " + kStand + " --kind posture --name wait");
  // What the refusal names can be taken.
  const std::string clip = kCaptures + "accad_female1/Female1_B24_WalkToCrouch.bvh";
  const Ran refused = run("library add mine.yaml " + clip + " --kind posture --name crouch");
  ASSERT_EQ(refused.status, 2);
  std::smatch frames;
  ASSERT_TRUE(std::regex_search(refused.err, frames, std::regex("such as ([0-9]+) to ([0-9]+)")))
      << refused.err;
  add("mine.yaml " + clip + " --kind posture --name crouch --frames " + frames[1].str() + " " +
      frames[2].str());
}

TEST_F(Library, TheMirrorImageOfAClipIsThatOfItsCycle) {
  for (const std::string& clip : {kWalk, kTurn, kCaptures + "cmu_mb2/08_03.bvh"}) {
    SCOPED_TRACE(clip);
    fs::remove(folder_ / "mine.yaml");
    add("mine.yaml '" + clip + "'");
    const json motions = json::parse(run("library show --json mine.yaml").out)[0]["motions"];
    ASSERT_EQ(motions.size(), 3u);
    EXPECT_EQ(motions[2]["speed"], motions[1]["speed"]);
    EXPECT_EQ(motions[2]["period"], motions[1]["period"]);
    EXPECT_EQ(motions[2]["turn_rate"].get<double>(), -motions[1]["turn_rate"].get<double>());
  }
}

}  // namespace
}  // namespace amble
