/// A walk as a film that every player plays: MP4, H.264. ffmpeg makes it of the pictures; it is
/// not needed otherwise.
#pragma once

#include <filesystem>
#include <ostream>

#include "base/stop_request.h"
#include "viz/pictures/film.h"

namespace amble {

/// The program that makes films; empty where it is not installed.
std::filesystem::path findFilmMaker();

class FilmStopped : public Stopped {
 public:
  FilmStopped() : Stopped(false) {}
  const char* what() const noexcept override {
    return "stopped while the film was made; nothing was written";
  }
};

/// With the same ffmpeg the same walk gives the same bytes. @param figure  of the body
/// @pre view.hasBody()
/// @throws InputError where ffmpeg is not there or cannot do it, FilmStopped where that was asked
void writeMp4(std::ostream& out, const WalkView& view, const Figure& figure,
              const FilmSettings& settings = {}, const StopRequest& stop = {});

}  // namespace amble
