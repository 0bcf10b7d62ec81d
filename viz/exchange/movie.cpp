#include "viz/exchange/movie.h"

#include <string>
#include <vector>

#include "base/child_program.h"
#include "base/error.h"
#include "base/text.h"

namespace amble {
namespace {

// Raw pictures in, H.264 out, as players and browsers take it: half the colour resolution, the
// index at the begin, the colours of HDTV (BT.709). Threads are counted and nothing is said of
// times and versions, so that the film is the same everywhere.
std::vector<std::string> filmArguments(const FilmSettings& settings) {
  const std::string size = std::to_string(settings.width) + "x" + std::to_string(settings.height);
  std::string text = "-nostdin -loglevel error -f rawvideo -pix_fmt rgb24 -video_size " + size +
                     " -framerate " + shortNumber(settings.rate, 12) +
                     " -i pipe:0 -vf scale=out_color_matrix=bt709:out_range=tv,format=yuv420p"
                     " -c:v libx264 -preset veryfast -crf 20 -threads 4 -colorspace bt709"
                     " -color_primaries bt709 -color_trc bt709 -map_metadata -1"
                     " -fflags +bitexact -flags:v +bitexact -movflags +faststart -f mp4 -y";
  std::vector<std::string> arguments;
  std::string_view left = text;
  while (const auto split = splitAt(left, " ")) {
    arguments.emplace_back(split->first);
    left = split->second;
  }
  arguments.emplace_back(left);
  arguments.emplace_back(ChildProgram::kResult);
  return arguments;
}

}  // namespace

std::filesystem::path findFilmMaker() { return findProgram("ffmpeg"); }

void writeMp4(std::ostream& out, const WalkView& view, const Figure& figure,
              const FilmSettings& settings, const StopRequest& stop) {
  const std::filesystem::path program = findFilmMaker();
  if (program.empty()) throw InputError("ffmpeg", 0, "is not installed", "it, for MP4");
  const WalkFilm film(view, figure, settings);
  ChildProgram ffmpeg(program, filmArguments(settings));
  for (int i = 0; i < film.pictures() && !stop.asked(); ++i) {
    const Image image = film.picture(i);
    if (!ffmpeg.feed({reinterpret_cast<const char*>(image.rgb.data()), image.rgb.size()})) break;
  }
  if (stop.asked()) throw FilmStopped();
  if (const int status = ffmpeg.finish(); status != 0) {
    const std::string said = ffmpeg.complaint();
    throw InputError(
        program.string(), 0,
        "ended with status " + std::to_string(status) + (said.empty() ? "" : ": ") + said,
        "an ffmpeg that writes H.264 (libx264)");
  }
  ffmpeg.writeResult(out);
}

}  // namespace amble
