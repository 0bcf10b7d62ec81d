#include "app/write_formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <sstream>
#include <utility>

#include "app/view_of.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/stopwatch.h"
#include "scenarios/problem.h"
#include "scenarios/write_results.h"

namespace amble {
namespace {

WalkView viewIfAny(const RunResult& result) {
  return result.problem != nullptr ? viewOf(result) : WalkView{};
}

ResultSubject subjectOf(const RunResult& result, const WalkView& view, const ResultWishes& wishes) {
  return {.result = result,
          .view = view,
          .threads = wishes.threads,
          .command = wishes.command,
          .views = wishes.views.empty() ? viewNames() : wishes.views,
          .scene_in_glb = wishes.scene_in_glb,
          .film_follows = wishes.film_follows};
}

/// Of the format itself, not of what goes with it: "walk.dae" has the skin of "walk.sdf".
const ResultFormat* formatOf(const std::filesystem::path& file) {
  for (const ResultFormat& format : resultFormats()) {
    const bool alone = format.files.size() == 1 && format.with == nullptr;
    if (alone && std::filesystem::path(format.files.front()).extension() == file.extension())
      return &format;
  }
  return nullptr;
}

std::string endings() {
  std::vector<std::string> all;
  for (const ResultFormat& format : resultFormats()) {
    const std::filesystem::path ending = std::filesystem::path(format.files.front()).extension();
    if (formatOf(ending.string().insert(0, "walk")) == nullptr) continue;
    if (std::find(all.begin(), all.end(), ending) == all.end()) all.push_back(ending);
  }
  return fmt::format("{}", fmt::join(all, ", "));
}

// The same files, whose bytes are made already, on all threads: before the first is written, so
// that a format that cannot be made leaves none.
std::vector<ResultFile> madeTogether(const std::vector<ResultFile>& files, int threads) {
  std::vector<std::string> held(files.size());
  parallelFor(static_cast<int>(files.size()), threads, [&](int i, int) {
    std::ostringstream out;
    files[i].write(out);
    held[i] = std::move(out).str();
  });
  std::vector<ResultFile> made;
  for (size_t i = 0; i < files.size(); ++i) {
    const auto bytes = std::make_shared<const std::string>(std::move(held[i]));
    made.push_back({files[i].file, [bytes](std::ostream& out) { out << *bytes; }});
  }
  return made;
}

}  // namespace

bool isWanted(const ResultWishes& wishes, const std::string& format) {
  if (format == "views" && !wishes.views.empty()) return true;
  const auto named = [&](std::string_view name) {
    return std::find(wishes.formats.begin(), wishes.formats.end(), name) != wishes.formats.end();
  };
  const auto brings = [&](const ResultFormat& other) {
    return other.with != nullptr && other.with == format && named(other.name);
  };
  return named(format) || std::any_of(resultFormats().begin(), resultFormats().end(), brings);
}

void writeFormats(RunResult& result, const std::filesystem::path& folder,
                  const ResultWishes& wishes) {
  const Stopwatch watch;
  const bool loaded = result.problem != nullptr;
  const WalkView view = viewIfAny(result);
  WriteOptions write;
  write.bvh = isWanted(wishes, "bvh");
  write.json = isWanted(wishes, "json");
  write.names = resultFileNames();
  const ResultSubject subject = subjectOf(result, view, wishes);
  for (const ResultFormat& format : resultFormats()) {
    const bool there = format.of_walk ? view.hasBody() : loaded;
    if (format.add && there && isWanted(wishes, format.name)) format.add(subject, write.more);
  }
  write.more = madeTogether(write.more, wishes.threads);
  write.spent = watch.seconds();
  writeResults(result, folder, write);
}

void writeFormat(const RunResult& result, const std::filesystem::path& file,
                 const ResultWishes& wishes) {
  const ResultFormat* const format = formatOf(file);
  if (format == nullptr) {
    throw InputError(file.string(), 0, "no format that is written as one file",
                     "a name that ends in " + endings());
  }
  if (result.problem == nullptr || (format->of_walk && result.bvh.empty())) {
    throw InputError(file.string(), 0, "cannot be written: there is no walk", "a walk");
  }
  checkPrograms({format->name});
  const WalkView view = viewOf(result);
  std::vector<ResultFile> files;
  if (format->add) format->add(subjectOf(result, view, wishes), files);
  const std::string name = format->name;
  writeFile(file, [&](std::ostream& out) {
    if (name == "bvh") {
      out << result.bvh;
    } else if (name == "json") {
      writeJson(out, result.report);
    } else {
      files.front().write(out);
    }
  });
}

}  // namespace amble
