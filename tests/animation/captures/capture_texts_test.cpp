// Captures as they were exported, written again in other ways: what says the same is read the same,
// and what is broken is refused at its very line.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <functional>
#include <set>
#include <sstream>

#include "animation/captures/bvh.h"
#include "base/error.h"
#include "tests/animation/captures.h"
#include "tests/animation/random_clip.h"
#include "tests/environments/test_files.h"

namespace amble {
namespace {

constexpr int kKept = 12;  // frames of each capture

/// A capture's text, line by line: those up to the frame time, and its first frames.
struct CaptureText {
  std::string path;
  std::vector<std::string> head, frames;

  std::string text(const std::string& end = "\n") const {
    std::string all;
    for (const std::string& line : head) all += line + end;
    for (const std::string& line : frames) all += line + end;
    return all;
  }
};

/// One capture of each folder, which are each of another exporter.
const std::vector<CaptureText>& texts() {
  static const std::vector<CaptureText> kTexts = [] {
    std::vector<CaptureText> all;
    std::set<std::string> seen;
    for (const Capture& capture : captures()) {
      if (!seen.insert(capture.path.substr(0, capture.path.find('/'))).second) continue;
      std::ifstream in(capture.file);
      CaptureText one{capture.path, {}, {}};
      for (std::string line; one.frames.size() < kKept && std::getline(in, line);) {
        while (!line.empty() && (line.back() == '\r' || line.back() == ' ')) line.pop_back();
        const bool motion = !one.head.empty() && one.head.back().starts_with("Frame Time");
        if (line.starts_with("Frames:")) line = "Frames: " + std::to_string(kKept);
        (motion ? one.frames : one.head).push_back(line);
      }
      all.push_back(one);
    }
    return all;
  }();
  return kTexts;
}

Clip parsed(const std::string& text) { return parseBvh(text, "it.bvh"); }

std::string refusedWith(const std::string& text) {
  return errorOf([&] { parsed(text); });
}

void expectSameBits(const Clip& a, const Clip& b, const std::string& what) {
  ASSERT_EQ(a.frames(), b.frames()) << what;
  ASSERT_EQ(a.skeleton.size(), b.skeleton.size()) << what;
  EXPECT_EQ(a.frame_time, b.frame_time) << what;
  for (int j = 0; j < a.skeleton.size(); ++j) {
    EXPECT_EQ(a.skeleton.joint(j).name, b.skeleton.joint(j).name) << what;
    EXPECT_EQ(a.skeleton.joint(j).offset, b.skeleton.joint(j).offset) << what;
  }
  for (int i = 0; i < a.frames(); ++i) {
    EXPECT_EQ(a.poses.p_WR(i), b.poses.p_WR(i)) << what;
    for (int j = 0; j < a.skeleton.size(); ++j) {
      EXPECT_EQ(a.poses.rotations(i)[j].coeffs(), b.poses.rotations(i)[j].coeffs()) << what;
    }
  }
}

/// Every word of a line that is a number, written by `change`.
std::string withNumbers(const std::string& line,
                        const std::function<std::string(const std::string&)>& change) {
  std::istringstream in(line);
  std::string out, word;
  while (in >> word) out += (out.empty() ? "" : " ") + change(word);
  return out;
}

class CaptureTexts : public testing::Test {
 protected:
  void SetUp() override { AMBLE_NEEDS_CAPTURES(); }
};

TEST_F(CaptureTexts, OfSeveralExportersAreThere) {
  EXPECT_GT(texts().size(), 4u);
  for (const CaptureText& one : texts()) {
    EXPECT_EQ(one.frames.size(), static_cast<size_t>(kKept)) << one.path;
    EXPECT_EQ(parsed(one.text()).frames(), kKept) << one.path;
  }
}

TEST_F(CaptureTexts, LineEndsBlanksAndEmptyLinesSayNothing) {
  for (const CaptureText& one : texts()) {
    const Clip wanted = parsed(one.text());
    expectSameBits(parsed(one.text("\r\n")), wanted, one.path + " CRLF");
    expectSameBits(parsed(one.text("\r")), wanted, one.path + " CR");
    expectSameBits(parsed(one.text("  \t\n")), wanted, one.path + " trailing blanks");
    expectSameBits(parsed(one.text("\n\n \n")), wanted, one.path + " empty lines");
    expectSameBits(parsed("\xEF\xBB\xBF" + one.text()), wanted, one.path + " mark");
    CaptureText tabs = one;
    for (std::string& line : tabs.frames) {
      line = withNumbers(line, [](const std::string& word) { return "\t " + word; });
    }
    expectSameBits(parsed(tabs.text()), wanted, one.path + " tabs");
  }
}

TEST_F(CaptureTexts, ANumberIsTheSameWithASignAnExponentOrMoreDigits) {
  for (const CaptureText& one : texts()) {
    const Clip wanted = parsed(one.text());
    const std::vector<std::function<std::string(const std::string&)>> ways = {
        [](const std::string& word) { return word[0] == '-' ? word : "+" + word; },
        [](const std::string& word) { return fmt::format("{:.17e}", std::stod(word)); },
        [](const std::string& word) { return fmt::format("{:.16E}", std::stod(word)); },
        [](const std::string& word) {
          return word + (word.find('.') == word.npos ? ".000" : "000");
        }};
    for (size_t k = 0; k < ways.size(); ++k) {
      CaptureText other = one;
      for (std::string& line : other.frames) {
        if (line.find_first_of("eE") != line.npos) continue;  // has exponents of its own
        line = withNumbers(line, ways[k]);
      }
      expectSameBits(parsed(other.text()), wanted, one.path + " way " + std::to_string(k));
    }
  }
}

TEST_F(CaptureTexts, FramesStandForThemselves) {
  for (const CaptureText& one : texts()) {
    const Clip wanted = parsed(one.text());
    CaptureText back = one;
    std::reverse(back.frames.begin(), back.frames.end());
    const Clip clip = parsed(back.text());
    ASSERT_EQ(clip.frames(), kKept);
    for (int i = 0; i < kKept; ++i) {
      EXPECT_EQ(clip.poses.p_WR(i), wanted.poses.p_WR(kKept - 1 - i)) << one.path;
      for (int j = 0; j < wanted.skeleton.size(); ++j) {
        EXPECT_EQ(clip.poses.rotations(i)[j].coeffs(),
                  wanted.poses.rotations(kKept - 1 - i)[j].coeffs())
            << one.path;
      }
    }
  }
}

TEST_F(CaptureTexts, AUnitMakesEveryLengthLongerAndNoTurn) {
  for (const CaptureText& one : texts()) {
    const Clip own = parsed(one.text());
    const Clip small = parseBvh(one.text(), "it.bvh", {.metres_per_unit = 0.01});
    for (int i = 0; i < kKept; ++i) {
      EXPECT_LT((own.poses.p_WR(i) - 100.0 * small.poses.p_WR(i)).norm(), 1e-9) << one.path;
      for (int j = 0; j < own.skeleton.size(); ++j) {
        EXPECT_EQ(own.poses.rotations(i)[j].coeffs(), small.poses.rotations(i)[j].coeffs());
      }
    }
    for (int j = 0; j < own.skeleton.size(); ++j) {
      EXPECT_LT((own.skeleton.joint(j).offset - 100.0 * small.skeleton.joint(j).offset).norm(),
                1e-9)
          << one.path;
    }
  }
}

TEST_F(CaptureTexts, CutAfterSoManyFramesItIsRefusedByHowManyThereAre) {
  for (const CaptureText& one : texts()) {
    for (const int left : {0, 1, 7}) {
      CaptureText cut = one;
      cut.frames.resize(left);
      const std::string error = refusedWith(cut.text());
      EXPECT_NE(error.find("expected " + std::to_string(kKept) + " as line "), std::string::npos)
          << error;
      if (left > 0) {
        EXPECT_NE(error.find("the file ends after frame " + std::to_string(left)),
                  std::string::npos)
            << error;
      }
    }
  }
}

TEST_F(CaptureTexts, ANumberLessOrMoreOrNoneIsRefusedAtItsLine) {
  Generator generator(811);
  for (const CaptureText& one : texts()) {
    for (int round = 0; round < 6; ++round) {
      const int frame = std::uniform_int_distribution<int>(0, kKept - 1)(generator);
      const std::string at = "it.bvh:" + std::to_string(one.head.size() + frame + 1) + ": ";
      CaptureText less = one, more = one, none = one;
      less.frames[frame].erase(less.frames[frame].find_last_of(" \t"));
      more.frames[frame] += " 0.5";
      int count = 0;
      const int bad = std::uniform_int_distribution<int>(0, 40)(generator);
      none.frames[frame] = withNumbers(one.frames[frame], [&](const std::string& word) {
        return count++ == bad ? "1.5.2" : word;
      });
      const std::string few = refusedWith(less.text()), many = refusedWith(more.text()),
                        word = refusedWith(none.text());
      EXPECT_TRUE(few.starts_with(at)) << few;
      EXPECT_NE(few.find("numbers in a frame; expected "), std::string::npos) << few;
      EXPECT_TRUE(many.starts_with(at)) << many;
      EXPECT_NE(many.find("too many numbers in a frame"), std::string::npos) << many;
      EXPECT_EQ(word, at + "'1.5.2'; expected a finite number") << one.path;
    }
  }
}

// Any line of a hierarchy, left out, makes another file or none; it is never read beyond.
TEST_F(CaptureTexts, WithoutALineOfItsHierarchyItIsReadOrRefusedWithALine) {
  for (const CaptureText& one : texts()) {
    int refused = 0;
    for (size_t k = 0; k + 1 < one.head.size(); ++k) {
      CaptureText without = one;
      without.head.erase(without.head.begin() + static_cast<std::ptrdiff_t>(k));
      try {
        const Clip clip = parsed(without.text());
        EXPECT_EQ(clip.frames(), kKept) << one.path << ": " << one.head[k];
      } catch (const InputError& error) {
        EXPECT_GT(error.line(), 0) << error.what();
        EXPECT_NE(std::string(error.what()).find("; expected "), std::string::npos);
        ++refused;
      }
    }
    EXPECT_GT(refused, static_cast<int>(one.head.size()) / 4) << one.path;
  }
}

TEST_F(CaptureTexts, WrittenByUsTheyAreReadByUsAsTheSameMotion) {
  for (const CaptureText& one : texts()) {
    const Clip clip = parsed(one.text());
    if (!clip.joint_positions.empty()) continue;
    for (const double unit : {1.0, 0.01, 0.0254}) {
      std::ostringstream out;
      writeBvh(out, clip, {.metres_per_unit = unit});
      const Clip again = parseBvh(out.str(), "again.bvh", {.metres_per_unit = unit});
      ASSERT_EQ(again.frames(), clip.frames()) << one.path;
      for (int i = 0; i < clip.frames(); ++i) {
        const std::vector<JointFrame> a = jointFrames(clip, i), b = jointFrames(again, i);
        for (size_t j = 0; j < a.size(); ++j) {
          EXPECT_LT((a[j].p_WJ - b[j].p_WJ).norm(), 1e-4 * (1.0 + a[j].p_WJ.norm())) << one.path;
        }
      }
    }
  }
}

}  // namespace
}  // namespace amble
