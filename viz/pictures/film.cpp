#include "viz/pictures/film.h"

#include <algorithm>
#include <cmath>

#include "base/text.h"
#include "viz/pictures/draw_mesh.h"
#include "viz/pictures/tiny_text.h"

namespace amble {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

RenderSettings pictureOf(const FilmSettings& settings) {
  RenderSettings picture;
  picture.width = settings.width;
  picture.height = settings.height;
  picture.threads = settings.threads;
  return picture;
}

WalkShot shotOf(const WalkView& view, const FilmSettings& settings) {
  WalkShot shot = takeShot(view, pictureOf(settings).shot(bodyFrames(view, pictureOf(settings))));
  shot.light.shadow_size = WalkFilm::kShadowSize;
  return shot;
}

// "3.2 s" in the lower left corner.
void drawTime(Image& image, double time) {
  constexpr int kDot = 2, kIndent = 26, kHigh = 14;
  const std::string text = fixedNumber(time, 1) + " s";
  const int y = image.height - kIndent - kHigh;
  fillRect(image, kIndent - 10, y - 8, textWidth("000.0 s", kDot) + 20, kHigh + 16,
           rgb(246, 247, 249));
  drawText(image, kIndent, y, text, kDot, rgb(70, 74, 82));
}

}  // namespace

WalkFilm::WalkFilm(const WalkView& view, const Figure& figure, const FilmSettings& settings)
    : view_(view),
      figure_(figure),
      settings_(settings),
      shot_(shotOf(view, settings)),
      large_(shot_.camera.enlarged(kSupersampling)),
      room_(rasterize(shot_.triangles, large_, settings.width * kSupersampling,
                      settings.height * kSupersampling, settings.threads)),
      light_(shot_.triangles, shot_.light),
      still_(light_.light(room_, large_, {})) {
  constexpr float kTall = 2.5f;  // no body reaches nearer to the eye from where it walks [m]
  constexpr double kDeep = 3.0;  // how far below the walk shadows are looked for [m]
  constexpr int kSmoothing = 4;  // of what darkens, and what is lost by rounding [pixels]
  float nearest = 1e9f;
  for (const float depth : room_.depth) nearest = depth > 0 ? std::min(nearest, depth) : nearest;
  double low = view.floor;
  for (int frame = 0; frame < view.animation->size(); ++frame) {
    const Eigen::Vector3d& p_WR = view.animation->poses.p_WR(frame);
    nearest = std::min(nearest, shot_.camera.toView(p_WR.cast<float>()).z() - kTall);
    low = std::min(low, view.animation->states[frame].position.z());
  }
  const float reach = shot_.camera.scale * shot_.light.corner_reach / std::max(0.5f, nearest);
  reach_ = static_cast<int>(std::ceil(reach)) + kSmoothing;
  lowest_ = static_cast<float>(std::max(low - kDeep, view.scene->bounds().min().z()));
}

int WalkFilm::pictures() const {
  const double duration = (view_.animation->size() - 1) * view_.animation->frame_time;
  return 1 + static_cast<int>(std::floor(duration * settings_.rate + 1e-6));
}

// Where the body is seen, its shadow, and the corners that it darkens.
WalkFilm::Window WalkFilm::changedBy(const std::vector<DrawTriangle>& body) const {
  constexpr float kSoft = 0.1f;  // a shadow's edge, and more [m]
  const Vector3f to_sun = shot_.light.to_sun / shot_.light.to_sun.z();
  Vector2f low = Vector2f::Constant(1e9f), high = -low;
  for (const DrawTriangle& triangle : body) {
    for (const Vector3f& p : triangle.p) {
      for (const Vector3f& at : {p, Vector3f(p - std::max(0.0f, p.z() - lowest_) * to_sun)}) {
        Vector3f seen = shot_.camera.toView(at);
        seen.z() = std::max(kNearest, seen.z());
        const Vector2f pixel = shot_.camera.toPixel(seen);
        const Vector2f soft = Vector2f::Constant(shot_.camera.scale * kSoft / seen.z());
        low = low.cwiseMin(pixel - soft);
        high = high.cwiseMax(pixel + soft);
      }
    }
  }
  const auto within = [](float at, int most) {
    return static_cast<int>(std::clamp(at, 0.0f, static_cast<float>(most)));
  };
  const Window window = {within(low.x(), settings_.width), within(low.y(), settings_.height),
                         within(std::ceil(high.x()), settings_.width),
                         within(std::ceil(high.y()), settings_.height)};
  return grown(window, reach_);
}

// By a margin, within the picture; from a multiple of what the noise of corners repeats after.
WalkFilm::Window WalkFilm::grown(const Window& window, int margin) const {
  constexpr int kGrid = 4;  // [pixels]
  return {std::max(0, window.x0 - margin) / kGrid * kGrid,
          std::max(0, window.y0 - margin) / kGrid * kGrid,
          std::min(settings_.width, window.x1 + margin),
          std::min(settings_.height, window.y1 + margin)};
}

// The nearer of room and body.
SampleBuffer WalkFilm::samplesOf(const std::vector<DrawTriangle>& body, const Camera& camera,
                                 const Window& window) const {
  SampleBuffer samples = rasterize(body, camera, window.width() * kSupersampling,
                                   window.height() * kSupersampling, settings_.threads);
  for (int y = 0; y < samples.height; ++y) {
    const size_t first = room_.index(window.x0 * kSupersampling, y + window.y0 * kSupersampling);
    for (int x = 0; x < samples.width; ++x) {
      const size_t own = samples.index(x, y), behind = first + static_cast<size_t>(x);
      const float depth = room_.depth[behind];
      if (depth == 0 || (samples.depth[own] > 0 && samples.depth[own] < depth)) continue;
      samples.depth[own] = depth;
      samples.look[own] = room_.look[behind];
    }
  }
  return samples;
}

int WalkFilm::frameOf(int picture) const {
  const double time = picture / settings_.rate;
  return std::min(view_.animation->size() - 1,
                  static_cast<int>(std::lround(time / view_.animation->frame_time)));
}

// From where the corner's eye looks, but near; steady: by the mean of the walker's way about then.
Camera WalkFilm::cameraAlong(int frame) const {
  constexpr double kSteady = 0.4;  // before and after, of the mean [s]
  constexpr float kAway = 5.0f;    // of the eye [m]
  constexpr float kShown = 3.2f;   // height of what is shown where the walker is [m]
  constexpr float kAim = 0.9f;     // over the ground [m]
  const int reach = static_cast<int>(std::lround(kSteady / view_.animation->frame_time));
  const int first = std::max(0, frame - reach);
  const int last = std::min(view_.animation->size() - 1, frame + reach);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int i = first; i <= last; ++i) {
    const Eigen::Vector3d& p_WR = view_.animation->poses.p_WR(i);
    sum += Eigen::Vector3d(p_WR.x(), p_WR.y(), view_.animation->states[i].position.z());
  }
  const Vector3f aim = (sum / (last - first + 1)).cast<float>() + kAim * Vector3f::UnitZ();
  Camera camera = shot_.camera;
  camera.eye = aim - kAway * camera.axes.row(2).transpose();
  camera.centre =
      Vector2f(static_cast<float>(settings_.width), static_cast<float>(settings_.height)) / 2;
  camera.scale = static_cast<float>(settings_.height) * kAway / kShown;
  return camera;
}

Image WalkFilm::drawnAlong(int frame, const std::vector<DrawTriangle>& body) const {
  const Camera camera = cameraAlong(frame).enlarged(kSupersampling);
  std::vector<DrawTriangle> all = shot_.triangles;
  all.insert(all.end(), body.begin(), body.end());
  const SampleBuffer samples = rasterize(all, camera, settings_.width * kSupersampling,
                                         settings_.height * kSupersampling, settings_.threads);
  return light_.light(samples, camera, body);
}

// What changes is told from as much again around it.
void WalkFilm::drawChanged(const std::vector<DrawTriangle>& body, Image& image) const {
  const Window inner = changedBy(body), outer = grown(inner, reach_);
  if (inner.width() <= 0 || inner.height() <= 0) return;
  Camera camera = large_;
  camera.centre -=
      kSupersampling * Vector2f(static_cast<float>(outer.x0), static_cast<float>(outer.y0));
  const Image changed = light_.light(samplesOf(body, camera, outer), camera, body);
  for (int y = inner.y0; y < inner.y1; ++y) {
    std::copy_n(changed.pixel(inner.x0 - outer.x0, y - outer.y0), 3 * inner.width(),
                image.pixel(inner.x0, y));
  }
}

Image WalkFilm::picture(int i) const {
  std::vector<DrawTriangle> body;
  addFigure(view_, frameOf(i), figure_, body);
  Image image = settings_.follow ? drawnAlong(frameOf(i), body) : still_;
  if (!settings_.follow) drawChanged(body, image);
  drawTime(image, i / settings_.rate);
  return image;
}

}  // namespace amble
