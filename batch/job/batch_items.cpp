#include "batch/job/batch_items.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "base/error.h"
#include "base/sample_stream.h"
#include "base/sha256.h"
#include "base/text.h"
#include "base/version.h"
#include "batch/job/source_digest.h"

namespace amble {
namespace {

constexpr size_t kKeyDigits = 16;  // of a SHA-256: two of a million items are the same once in 10^7
constexpr long long kMostItems = 100'000'000;
constexpr int kDigits = 17;  // of a number: all that it has

int waysOf(const BatchJob& job, int scene) {
  return static_cast<int>(job.scenes[static_cast<size_t>(scene)].ways.size()) + job.draw.count;
}

auto orderOf(const BatchItem& item) {
  return std::tuple(item.scene, item.library, item.height, item.speed, item.style, item.actions,
                    item.way, item.seed);
}

template <typename Visit>
void eachWalker(const BatchJob& job, int scene, Visit visit) {
  BatchItem item;
  item.scene = scene;
  for (item.library = 0; item.library < static_cast<int>(job.libraries.size()); ++item.library)
    for (const double height : job.heights.values)
      for (const double speed : job.speeds.values)
        for (item.style = 0; item.style < static_cast<int>(job.styles.size()); ++item.style)
          for (item.actions = 0; item.actions < static_cast<int>(job.actions.size());
               ++item.actions) {
            item.height = height;
            item.speed = speed;
            visit(item);
          }
}

long long countProduct(const BatchJob& job) {
  long long walks = 0;
  for (size_t scene = 0; scene < job.scenes.size(); ++scene)
    walks += waysOf(job, static_cast<int>(scene));
  const double all =
      static_cast<double>(walks) * static_cast<double>(job.libraries.size()) *
      static_cast<double>(job.heights.values.size()) *
      static_cast<double>(job.speeds.values.size()) * static_cast<double>(job.styles.size()) *
      static_cast<double>(job.actions.size()) * static_cast<double>(job.seeds.size());
  return all > static_cast<double>(kMostItems) ? kMostItems + 1 : static_cast<long long>(all);
}

std::vector<BatchItem> productOf(const BatchJob& job) {
  std::vector<BatchItem> items;
  for (int scene = 0; scene < static_cast<int>(job.scenes.size()); ++scene) {
    eachWalker(job, scene, [&](BatchItem item) {
      for (item.way = 0; item.way < waysOf(job, scene); ++item.way) {
        for (const std::uint64_t seed : job.seeds) {
          item.seed = seed;
          items.push_back(item);
        }
      }
    });
  }
  return items;
}

template <typename T>
int drawIndex(const std::vector<T>& values, SampleStream& stream) {
  return stream.below(static_cast<int>(values.size()));
}

// Rounded, so that who reads a label has the number that was walked with.
double drawNumber(const BatchNumbers& numbers, SampleStream& stream) {
  constexpr double kParts = 1000.0;
  if (!numbers.range) return numbers.values[static_cast<size_t>(drawIndex(numbers.values, stream))];
  const auto [from, to] = *numbers.range;
  return std::clamp(std::round(stream.uniform(from, to) * kParts) / kParts, from, to);
}

BatchItem drawItem(const BatchJob& job, SampleStream& stream) {
  BatchItem item;
  item.scene = drawIndex(job.scenes, stream);
  item.library = drawIndex(job.libraries, stream);
  item.height = drawNumber(job.heights, stream);
  item.speed = drawNumber(job.speeds, stream);
  item.style = drawIndex(job.styles, stream);
  item.actions = drawIndex(job.actions, stream);
  item.way = stream.below(waysOf(job, item.scene));
  item.seed = job.seeds[static_cast<size_t>(drawIndex(job.seeds, stream))];
  return item;
}

// No two are the same: a draw that was there already is drawn again.
std::vector<BatchItem> sampleOf(const BatchJob& job) {
  constexpr int kTries = 1000;
  std::set<decltype(orderOf(BatchItem()))> seen;
  std::vector<BatchItem> items;
  for (int i = 0; i < job.sample; ++i) {
    SampleStream stream(job.seed, static_cast<std::uint64_t>(i));
    BatchItem item = drawItem(job, stream);
    int tries = 1;
    while (!seen.insert(orderOf(item)).second && ++tries <= kTries) item = drawItem(job, stream);
    if (tries > kTries) break;
    items.push_back(item);
  }
  return items;
}

std::string numberText(double value) { return shortNumber(value, kDigits); }

std::string placeText(const Place& place) {
  std::string text = numberText(place.at.x()) + " " + numberText(place.at.y());
  text += place.z ? " " + numberText(*place.z) : " -";
  return text + (place.heading ? " " + numberText(*place.heading) : " -");
}

}  // namespace

std::vector<BatchItem> listItems(const BatchJob& job) {
  const bool ranges = job.heights.range || job.speeds.range;
  const long long count = ranges ? kMostItems : countProduct(job);
  const auto fail = [&](const std::string& problem, const std::string& expected) {
    const auto line = job.lines.find("sample");
    throw InputError(job.file.string(), line == job.lines.end() ? 0 : line->second, problem,
                     expected);
  };
  if (job.sample == 0 && count > kMostItems)
    fail("the job has more than " + std::to_string(kMostItems) + " walks", "fewer, or `sample: N`");
  if (job.sample > count)
    fail("a sample of " + std::to_string(job.sample) + " of " + std::to_string(count) + " walks",
         "at most as many as there are");
  std::vector<BatchItem> items =
      job.sample == 0 || job.sample == count ? productOf(job) : sampleOf(job);
  std::stable_sort(items.begin(), items.end(),
                   [](const BatchItem& a, const BatchItem& b) { return orderOf(a) < orderOf(b); });
  for (size_t i = 0; i < items.size(); ++i) items[i].number = static_cast<int>(i);
  return items;
}

std::span<const BatchItem> itemsOf(const std::vector<BatchItem>& items, const Shard& shard) {
  const auto at = [&](int part) {
    return items.size() * static_cast<size_t>(part) / static_cast<size_t>(shard.count);
  };
  return {items.begin() + static_cast<std::ptrdiff_t>(at(shard.index - 1)),
          items.begin() + static_cast<std::ptrdiff_t>(at(shard.index))};
}

bool sameWalker(const BatchItem& a, const BatchItem& b) {
  const auto walker = [](const BatchItem& item) {
    return std::tuple(item.scene, item.library, item.height, item.speed, item.style, item.actions);
  };
  return walker(a) == walker(b);
}

int drawnWay(const BatchJob& job, const BatchItem& item) {
  const int own = static_cast<int>(job.scenes[static_cast<size_t>(item.scene)].ways.size());
  return item.way < own ? -1 : item.way - own;
}

std::string wayName(const BatchJob& job, const BatchItem& item) {
  const int drawn = drawnWay(job, item);
  if (drawn >= 0) return "drawn-" + std::to_string(drawn + 1);
  return job.scenes[static_cast<size_t>(item.scene)].ways[static_cast<size_t>(item.way)].name;
}

Scenario scenarioOf(const BatchJob& job, const BatchItem& item) {
  const BatchScene& scene = job.scenes[static_cast<size_t>(item.scene)];
  Scenario scenario;
  scenario.source.file = job.file;
  scenario.source.lines = {{"scene", scene.line}};
  const auto line = [&](const char* key, const char* axis) {
    const auto found = job.lines.find(axis);
    if (found != job.lines.end()) scenario.source.lines[key] = found->second;
  };
  line("character.library", "libraries");
  line("walk.style", "styles");
  scenario.scene = scene.file;
  scenario.character.library = job.libraries[static_cast<size_t>(item.library)];
  scenario.character.height = item.height;
  scenario.character.limits = job.limits;
  scenario.bounds = scene.bounds;
  scenario.walk = job.walk;
  scenario.walk.style = job.styles[static_cast<size_t>(item.style)];
  scenario.walk.actions = job.actions[static_cast<size_t>(item.actions)];
  for (size_t i = 0; i < scenario.walk.actions.size(); ++i)
    line(("walk.actions[" + std::to_string(i) + "]").c_str(), "actions");
  if (item.speed > 0.0) scenario.walk.speed = item.speed;
  scenario.walk.own_speed = item.speed == 0.0 && !scenario.walk.style.empty();
  scenario.planner = job.planner;
  scenario.planner.seed = item.seed;
  if (drawnWay(job, item) >= 0) {
    scenario.has_ends = false;
    return scenario;
  }
  const BatchWay& way = scene.ways[static_cast<size_t>(item.way)];
  scenario.start = way.start;
  scenario.goal = way.goal;
  scenario.via = way.via;
  for (const char* key : {"start.at", "goal.at"}) scenario.source.lines[key] = way.line;
  for (size_t i = 0; i < way.via.size(); ++i)
    scenario.source.lines["via[" + std::to_string(i) + "].at"] = way.line;
  return scenario;
}

std::string describeItem(const BatchJob& job, const BatchItem& item, const std::string& scene,
                         const std::string& library) {
  const Scenario scenario = scenarioOf(job, item);
  std::string text = "amble " + version() + " " + sourceDigest() + "\n";
  const auto add = [&](const std::string& name, const std::string& value) {
    text += name + " " + withoutControls(value) + "\n";
  };
  add("scene", scene);
  add("library", library);
  add("height", numberText(item.height));
  add("speed", numberText(item.speed));
  add("style", scenario.walk.style);
  add("actions", joined(scenario.walk.actions));
  const GroundLimits& limits = scenario.character.limits;
  add("limits", numberText(limits.max_slope) + " " + numberText(limits.max_climb) + " " +
                    numberText(limits.max_drop));
  if (scenario.bounds) {
    add("bounds", placeText({scenario.bounds->min, {}, {}}) + " " +
                      placeText({scenario.bounds->max, {}, {}}));
  }
  if (const int drawn = drawnWay(job, item); drawn >= 0) {
    add("drawn", std::to_string(job.seed) + " " + std::to_string(drawn) + " " +
                     numberText(job.draw.least) + " " + numberText(job.draw.most) + " " +
                     numberText(job.tallest()));
  } else {
    add("way", wayName(job, item));
    add("start", placeText(scenario.start));
    add("goal", placeText(scenario.goal));
    for (const Place& via : scenario.via) add("via", placeText(via));
  }
  add("ends", std::to_string(job.walk.from_standing) + " " + std::to_string(job.walk.to_standing));
  add("comfort", numberText(job.walk.comfort));
  const bool shared = job.roadmap == BatchRoadmap::kShared;
  add("planner", job.planner.name + " " + std::to_string(job.planner.max_failures) + " " +
                     numberText(job.planner.time_limit) + " " +
                     (shared ? "shared " + std::to_string(job.seed) : "each"));
  add("seed", std::to_string(item.seed));
  add("fps", numberText(job.fps));
  add("formats", joined(job.formats));
  return text;
}

std::string itemKey(const std::string& description) {
  return sha256(description).substr(0, kKeyDigits);
}

}  // namespace amble
