#include "viz/pictures/render.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "viz/pictures/draw_mesh.h"
#include "viz/pictures/lighting.h"
#include "viz/pictures/tiny_text.h"

namespace amble {
namespace {

// "0 s [colours] 9.5 s" in the lower left corner.
void drawTimeBar(Image& image, double duration) {
  constexpr int kRamp = 260, kThick = 14, kDot = 2, kIndent = 26;
  const int y = image.height - kIndent - kThick;
  const Color ink = rgb(70, 74, 82);
  const std::string end = fixedNumber(duration, 1) + " s";
  const int plate = textWidth("0 s " + end, kDot) + kRamp + 4 * kDot + 20;
  fillRect(image, kIndent - 10, y - 8, plate, kThick + 16, rgb(246, 247, 249));
  drawText(image, kIndent, y, "0 s", kDot, ink);
  const int x = kIndent + textWidth("0 s ", kDot);
  for (int i = 0; i < kRamp; ++i)
    fillRect(image, x + i, y, 1, kThick, timeColor((i + 0.5) / kRamp));
  drawText(image, x + kRamp + 4 * kDot, y, end, kDot, ink);
}

// What is said of a picture, in its lower left corner, in lines that fit.
void drawWords(Image& image, const std::string& text) {
  constexpr int kDot = 2, kIndent = 16, kLine = 11 * kDot;
  const int letters = (image.width - 2 * kIndent) / textWidth(" ", kDot);
  const std::vector<std::string> lines =
      brokenLines(text, static_cast<size_t>(std::max(1, letters)));
  const int height = static_cast<int>(lines.size()) * kLine + kIndent;
  fillRect(image, 0, image.height - height, image.width, height, rgb(246, 247, 249));
  for (size_t i = 0; i < lines.size(); ++i)
    drawText(image, kIndent, image.height - height + kIndent / 2 + static_cast<int>(i) * kLine,
             lines[i], kDot, rgb(150, 24, 20));
}

// Whether a body is so far before the walker's eyes that more than a back is seen.
bool isAhead(const WalkView& view, int frame, const Camera& camera) {
  constexpr float kNear = 1.5f;  // [m]
  return frame > middleFrame(view) &&
         (view.animation->poses.p_WR(frame).cast<float>() - camera.eye).head<2>().norm() > kNear;
}

}  // namespace

std::vector<int> bodyFrames(const WalkView& view, const RenderSettings& settings) {
  if (!view.hasBody()) return {};
  const PoseArray& poses = view.animation->poses;
  const int last = view.animation->size() - 1;
  const int step =
      std::max(1, static_cast<int>(std::lround(settings.every / view.animation->frame_time)));
  const auto merges = [&](int a, int b) {
    return (poses.p_WR(a) - poses.p_WR(b)).norm() < settings.apart;
  };
  std::vector<int> frames = {0};
  for (int frame = step; frame <= last; ++frame) {
    if (frame - frames.back() >= step && !merges(frame, frames.back())) frames.push_back(frame);
  }
  // The last stands for one that it would merge with.
  if (frames.back() == last) return frames;
  const bool near = last - frames.back() <= step / 2 || merges(last, frames.back());
  if (near && frames.size() > 1) frames.pop_back();
  if (!near || !merges(last, 0)) frames.push_back(last);
  return frames;
}

Image renderWalk(const WalkView& view, const RenderSettings& settings) {
  const std::vector<int> frames = bodyFrames(view, settings);
  WalkShot shot = takeShot(view, settings.shot(frames));
  for (const int frame : frames) {
    if (settings.from == PointOfView::kFirst && !isAhead(view, frame, shot.camera)) continue;
    const double share = static_cast<double>(frame) / std::max(1, view.animation->size() - 1);
    const std::vector<Color> colors(view.body->parts.size(), timeColor(share));
    addBody(view, frame, colors, shot.triangles);
  }
  const Camera large = shot.camera.enlarged(kSupersampling);
  const SampleBuffer samples = rasterize(shot.triangles, large, settings.width * kSupersampling,
                                         settings.height * kSupersampling, settings.threads);
  Image image = lightSamples(samples, large, shot.triangles, shot.light);
  if (!frames.empty())
    drawTimeBar(image, (view.animation->size() - 1) * view.animation->frame_time);
  if (!view.why.empty()) drawWords(image, view.why);
  return image;
}

}  // namespace amble
