/// A walk picture after picture, as a film shows it: the room from one corner, the figure that
/// walks; either the whole walk in view, or the eye goes along with the walker.
///
/// Where the eye stands still the room is drawn once; of each picture only what the body and its
/// shadow change is drawn anew, as drawing all of it would give it, up to the rounding of where
/// triangles' edges lie.
#pragma once

#include "viz/figure/figure.h"
#include "viz/pictures/render.h"

namespace amble {

struct FilmSettings {
  int width = 1280;     ///< [pixels, even, 16 to 8192]
  int height = 720;     ///< [pixels, even, 16 to 8192]
  double rate = 30.0;   ///< pictures a second [1/s, > 0]
  bool follow = false;  ///< the eye goes along, near; else it stands and sees the whole walk
  int threads = 1;      ///< change no byte [>= 1]
};

class WalkFilm {
 public:
  /// Of the shadow map: finer than a pixel, over a room [samples a side].
  static constexpr int kShadowSize = 1536;

  /// @param view, figure  of its body; must outlive the film. @pre view.hasBody()
  WalkFilm(const WalkView& view, const Figure& figure, const FilmSettings& settings = {});

  int pictures() const;  ///< [>= 1]
  /// With the time in a corner. @pre 0 <= i < pictures(). Costs 10 to 50 ms in a room, some 200
  /// where the eye goes along
  Image picture(int i) const;

 private:
  struct Window {  // of a picture [pixels]
    int x0, y0, x1, y1;
    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
  };
  int frameOf(int picture) const;
  Camera cameraAlong(int frame) const;
  void drawChanged(const std::vector<DrawTriangle>& body, Image& image) const;
  Image drawnAlong(int frame, const std::vector<DrawTriangle>& body) const;
  Window changedBy(const std::vector<DrawTriangle>& body) const;
  Window grown(const Window& window, int margin) const;
  SampleBuffer samplesOf(const std::vector<DrawTriangle>& body, const Camera& camera,
                         const Window& window) const;

  const WalkView& view_;
  const Figure& figure_;
  FilmSettings settings_;
  WalkShot shot_;
  Camera large_;  // of samples
  SampleBuffer room_;
  StillLight light_;
  Image still_;   // the room without a body
  int reach_;     // how far away a sample may darken a pixel [pixels]
  float lowest_;  // of what a shadow falls on [m]
};

}  // namespace amble
