#include "environments/scene/obj_import.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <random>

#include "environments/scene/mesh_import.h"
#include "test_paths.h"
#include "tests/environments/test_files.h"

namespace amble {
namespace {

using Generator = std::mt19937_64;

int below(Generator& generator, int end) {
  return std::uniform_int_distribution<int>(0, end - 1)(generator);
}

std::string contentOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

MeshFile parsed(const std::string& text) { return parseObj(text, "drawn.obj"); }

/// Bit by bit.
void expectSame(const MeshFile& is, const MeshFile& wanted) {
  EXPECT_EQ(is.has_axes, wanted.has_axes);
  ASSERT_EQ(is.parts.size(), wanted.parts.size());
  for (size_t i = 0; i < is.parts.size(); ++i) {
    EXPECT_EQ(is.parts[i].names, wanted.parts[i].names);
    EXPECT_EQ(is.parts[i].mesh.vertices, wanted.parts[i].mesh.vertices);
    EXPECT_EQ(is.parts[i].mesh.triangles, wanted.parts[i].mesh.triangles);
  }
}

int compareWithAssimp(const std::filesystem::path& folder) {
  int compared = 0;
  if (!std::filesystem::exists(folder)) return compared;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".obj") continue;
    SCOPED_TRACE(entry.path());
    expectSame(parsed(contentOf(entry.path())), importMesh(entry.path()));
    ++compared;
  }
  return compared;
}

TEST(ParseObj, OurOwnScenesAreWhatAssimpReads) {
  EXPECT_GE(compareWithAssimp(std::filesystem::path(AMBLE_SOURCE_DIR) / "environments/scenes"), 14);
}

TEST(ParseObj, OtherPeoplesScenesAreWhatAssimpReads) {
  const std::filesystem::path shared = AMBLE_SHARED;
  if (!std::filesystem::exists(shared)) GTEST_SKIP() << "they are not there";
  EXPECT_GE(compareWithAssimp(shared / "scenes") + compareWithAssimp(shared / "cases"), 5);
}

// Without an exponent: then Assimp rounds twice.
std::string randomNumber(Generator& generator) {
  constexpr const char* kForms[] = {"%.5f", "%.12f", "%+.2f", "%.0f"};
  char text[64];
  std::snprintf(text, sizeof text, kForms[below(generator, 4)],
                std::uniform_real_distribution<double>(-20.0, 20.0)(generator));
  return text;
}

std::string randomLine(Generator& generator, const char* key, int numbers) {
  std::string line = key;
  for (int i = 0; i < numbers; ++i)
    line += (below(generator, 9) ? " " : " \t ") + randomNumber(generator);
  return line + (below(generator, 20) ? "" : " ");
}

// One of three forms, or back from the vertices so far.
std::string randomCorner(Generator& generator, int vertices, int given) {
  const int vertex = 1 + below(generator, vertices);
  std::string corner =
      std::to_string(vertex <= given && !below(generator, 6) ? vertex - given - 1 : vertex);
  constexpr const char* kAfter[] = {"", "/1", "//1", "/1/1"};
  return corner + kAfter[below(generator, 4)];
}

/// Objects and groups of triangles, some without, with vertices that repeat, are named before they
/// are given, or back from where they are named.
std::string randomObj(Generator& generator) {
  const std::string end = below(generator, 2) ? "\n" : "\r\n";
  const int vertices = 3 + below(generator, 12);
  int given = 0;
  std::string text = "# drawn" + end + "vt 0 1" + end + "vn 0 0 1" + end;
  const auto giveVertices = [&](int last) {
    for (; given < last; ++given) {
      const int form = below(generator, 12);
      text += randomLine(generator, "v", form == 0 ? 4 : 3);
      text += (form == 1 ? " 0.5 0.25 1" : "") + end;
    }
  };
  giveVertices(vertices / 2);
  for (int object = below(generator, 4); object >= 0; --object) {
    const std::string number = std::to_string(object);
    if (below(generator, 5)) text += (below(generator, 2) ? "o part_" : "g group_") + number + end;
    if (below(generator, 5) == 0) text += "usemtl material_" + number + end;
    if (object == 0) giveVertices(vertices);
    for (int face = 1 + below(generator, 8); face > 0; --face) {
      text += "f";
      for (int k = 0; k < 3; ++k) text += " " + randomCorner(generator, vertices, given);
      text += end + (below(generator, 5) ? "" : "s 1" + end + "# between" + end);
    }
  }
  return text;
}

TEST(ParseObj, DrawnFilesAreWhatAssimpReads) {
  Generator generator(1);
  const TestFolder folder;
  int compared = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const std::string text = randomObj(generator);
    SCOPED_TRACE(text);
    const auto file = folder.write("drawn.obj", text);
    const std::string refused = errorOf([&] { importMesh(file); });
    EXPECT_EQ(errorOf([&] { parsed(text); }).empty(), refused.empty()) << refused;
    if (!refused.empty()) continue;
    expectSame(parsed(text), importMesh(file));
    ++compared;
    if (testing::Test::HasFailure()) break;
  }
  EXPECT_GE(compared, 100);
}

// Numbers are rounded twice on their way to floats; the same way in every format.
TEST(ParseObj, AMeshHasTheSameVerticesAsInPly) {
  Generator generator(2);
  const TestFolder folder;
  std::string obj, ply, faces;
  for (int i = 0; i < 600; ++i) {
    const std::string vertex = randomLine(generator, "", 3);
    obj += "v" + vertex + "\n";
    ply += vertex.substr(vertex.find_first_not_of(" \t")) + "\n";
    if (i % 3 != 2) continue;
    obj += "f -3 -2 -1\n";
    faces +=
        "3 " + std::to_string(i - 2) + " " + std::to_string(i - 1) + " " + std::to_string(i) + "\n";
  }
  const MeshFile wanted = importMesh(folder.write(
      "drawn.ply",
      "ply\nformat ascii 1.0\nelement vertex 600\nproperty float x\nproperty float y\nproperty "
      "float z\nelement face 200\nproperty list uchar int vertex_indices\nend_header\n" +
          ply + faces));
  const MeshFile is = parsed(obj);
  ASSERT_EQ(wanted.parts.size(), 1u);
  EXPECT_EQ(is.parts.at(0).mesh.vertices, wanted.parts[0].mesh.vertices);
  EXPECT_EQ(is.parts[0].mesh.triangles, wanted.parts[0].mesh.triangles);
}

const std::string kCorners = "v 0 0 0\nv 2 0 0\nv 0 1 0\n", kStart = "o a\n" + kCorners;
const std::string kFace = "f 1 2 3\n";

TEST(ParseObj, LinesMayEndAndGoOnAndBeginAsPeopleWriteThem) {
  const MeshFile wanted = parsed(kStart + kFace);
  std::string returns = kStart + kFace, both = returns, indented = returns;
  std::replace(returns.begin(), returns.end(), '\n', '\r');
  for (size_t at = 0; (at = both.find('\n', at)) != std::string::npos; at += 2)
    both.insert(at, 1, '\r');
  for (size_t at = 0; (at = indented.find('\n', at)) != std::string::npos; at += 3)
    indented.insert(at + 1, " \t");
  for (const std::string& text :
       {returns, both, indented, "\xEF\xBB\xBF" + kStart + kFace, kStart + "f 1 2 3",
        "# from C:\\models\\\n" + kStart + kFace, kStart + "f 1 \\\n2\\\n 3\n",
        kStart + "f 1 \\\r\n2 3\r\n", kStart + "f 1 2 3 # f 3 2 1 # f 2 1 3\n",
        "o a\nv 0 0 0 # v 1 1 1\nv 2,0 0 0\nv 0 1,00 0\n" + kFace, kStart + "f 1/7 2/7 3/7\n",
        kStart + "f 1//7 2//7 3//7\n", kStart + "f 1/ 2/ 3/\n", kStart + "f -3 -2 -1\n",
        "o a\n" + kFace + kCorners,
        kStart + "l 1 2\np 3\nf 1 2\nf 3\nf\ncurv 0 1 1 2\nvp 1 2\nunknown words\n" + kFace}) {
    SCOPED_TRACE(text);
    ASSERT_EQ(errorOf([&] { parsed(text); }), "");
    expectSame(parsed(text), wanted);
  }
}

TEST(ParseObj, FacesOfFewerThanThreeCornersArePassedOverWithAWarning) {
  const std::string passed = ": a face of fewer than 3 corners is passed over";
  for (const char* few : {"f 1 2", "f 3", "f", " f \t", "f # 1 2 3", "f 1/2/3 2//1"}) {
    SCOPED_TRACE(few);
    const std::string text = kStart + kFace + few + "\n" + kFace;
    EXPECT_EQ(parsed(text).warnings, std::vector<std::string>{"drawn.obj:6" + passed});
  }
  EXPECT_EQ(parsed(kStart + kFace + "f 1 2\nl 1 2\nf\n" + kFace).warnings,
            std::vector<std::string>{"drawn.obj:6" + passed + ", one of 2 such"});
  EXPECT_TRUE(parsed(kStart + "l 1 2\np 3\n" + kFace + "f 1 2 2\n# f 1 2\n").warnings.empty());
}

TEST(ParseObj, AWeightDividesAndAColourDoesNot) {
  const auto last = [](const std::string& numbers) {
    return parsed("v 0 0 0\nv 2 0 0\nv " + numbers + "\n" + kFace).parts[0].mesh.vertices[2];
  };
  EXPECT_EQ(last("1 2 3 0.5"), Eigen::Vector3d(2, 4, 6));
  EXPECT_EQ(last("1 2 3 0.5 0.5 0.5"), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(last("1 2 3 0.5 0.5 0.5 1"), Eigen::Vector3d(1, 2, 3));
}

std::vector<std::vector<std::string>> namesOf(const MeshFile& file) {
  std::vector<std::vector<std::string>> names;
  for (const MeshPart& part : file.parts) names.push_back(part.names);
  return names;
}

TEST(ParseObj, PartsAreObjectsAndGroupsAndTheirLaterMaterials) {
  using Names = std::vector<std::vector<std::string>>;
  EXPECT_EQ(namesOf(parsed(kCorners + kFace)), Names{{"defaultobject"}});
  EXPECT_EQ(namesOf(parsed(kStart + kFace + "g legs of it\n" + kFace)),
            (Names{{"a"}, {"legs of it"}}));
  // What is named again goes on; a group does where no other was between.
  const MeshFile again = parsed(kStart + kFace + "o b\n" + kFace + "o a\nf 1 3 2\n");
  EXPECT_EQ(namesOf(again), (Names{{"a"}, {"b"}}));
  EXPECT_EQ(again.parts[0].mesh.triangles.size(), 2u);
  EXPECT_EQ(namesOf(parsed(kCorners + "g a\n" + kFace + "g a\n" + kFace)), Names{{"a"}});
  EXPECT_EQ(namesOf(parsed(kCorners + "g a\n" + kFace + "g \n" + kFace)), (Names{{"a"}, {}}));
  // Of materials the first has no name in Assimp.
  EXPECT_EQ(namesOf(parsed(kStart + "usemtl m\n" + kFace + "usemtl n\n" + kFace)),
            (Names{{"a", "n"}}));
  EXPECT_EQ(namesOf(parsed(kStart + "usemtl m\n" + kFace + "o b\nusemtl n\n" + kFace)),
            (Names{{"a"}, {"b"}}));
}

// The reader itself takes 0 for what is no number, and half a number for its half.
TEST(ParseObj, WhatIsWrongIsSaidWithItsLine) {
  struct Wrong {
    const char* line;
    const char* problem;
  };
  for (const Wrong& wrong : std::vector<Wrong>{
           {"v 1 nan 0",
            "is no vertex: 'v 1 nan 0'; expected `v` and three finite numbers or more"},
           {"v 1 inf 0", "is no vertex"},
           {"v 1e400 0 0", "is no vertex"},
           {"v 1 2", "is no vertex"},
           {"v 1 2 x", "is no vertex"},
           {"v 1 2 3x", "is no vertex"},
           {"v 1,2,3 4 5", "is no vertex"},
           {"v 1e39 0 0", "a vertex that is not finite"},
           {"v 1 2 3 0",
            "a vertex that is not finite; expected finite numbers below 3e38, a weight"},
           {"f 1 2 x",
            "is no face: 'f 1 2 x'; expected `f` and corners such as 1, 1/2, 1/2/3 or -1"},
           {"f 1 2 3.5", "is no face"},
           {"f 1 2-3", "is no face"},
           {"f 1 2 --3", "is no face"},
           {"f 1 2 4294967297", "is no face"},
           {"f 1 2 -", "a face has vertex 0"},
           {"f 0 1 2",
            "a face has vertex 0; expected vertices from 1 on, or from -1 back to the first"},
           {"f -4 1 2", "a face has vertex -4"},
           {"f 1 2 4", "a face has vertex 4; expected vertices from 1 to 3"},
           {"f 1 2 999999999", "a face has vertex 999999999; expected vertices from 1 to 3"}}) {
    // A line that goes on counts as the two that it is.
    const std::string text = kStart + "# goes \\\non\n" + wrong.line + "\n" + kFace;
    const std::string error = errorOf([&] { parsed(text); });
    EXPECT_TRUE(error.starts_with(std::string("drawn.obj:7: ") + wrong.problem)) << error;
  }
}

TEST(ParseObj, WithoutFacesOrTrianglesThereIsNoMesh) {
  EXPECT_EQ(errorOf([] { parsed(""); }), "drawn.obj: holds no faces; expected a mesh of faces");
  EXPECT_EQ(errorOf([] { parsed(kStart + "p 1 2 3\nl 1 2 3\nf 1 2\n"); }),
            "drawn.obj: holds no faces; expected a mesh of faces");
  EXPECT_EQ(errorOf([] { parsed(kStart + "f 1 2 2\n"); }),
            "drawn.obj: holds no triangles; expected at least one with an area");
}

}  // namespace
}  // namespace amble
