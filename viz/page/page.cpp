#include "viz/page/page.h"

#include <functional>
#include <map>

#include "base/text.h"
#include "base/xml.h"
#include "viz/page/bench.h"
#include "viz/page/page_data.h"
#include "viz/page/page_texts.h"

namespace amble {
namespace {

// A list of what `write` gives of each.
template <typename Items, typename Write>
std::string listOf(const Items& items, Write write) {
  std::string list = "[";
  for (const auto& item : items) {
    if (list.size() > 1) list += ',';
    list += write(item);
  }
  return list + "]";
}

// People of one build share a figure: of many clips there is one.
std::string actorsOf(const std::vector<PageActor>& actors, PageBytes& bytes) {
  std::map<std::string, std::string> figures;  // by body
  return listOf(actors, [&](const PageActor& actor) {
    const std::string body = bodyJson(actor);
    const auto [figure, is_new] = figures.try_emplace(body);
    if (is_new) figure->second = figureJson(actor, bytes);
    return "{\"name\":" + jsonString(actor.name) + ",\"body\":" + body +
           ",\"figure\":" + figure->second + "}";
  });
}

std::string dataOf(const PageSubject& subject, PageBytes& bytes) {
  std::string data = "{\"version\":1,\"title\":" + jsonString(subject.title) +
                     ",\"description\":" + jsonString(subject.description) +
                     ",\"why\":" + jsonString(subject.why) +
                     ",\"floor\":" + plainNumber(subject.floor, 6) +
                     ",\"facts\":" + listOf(subject.facts, [](const auto& fact) {
                       return "[" + jsonString(fact.first) + "," + jsonString(fact.second) + "]";
                     });
  data += ",\"actors\":" + actorsOf(subject.actors, bytes);
  data += ",\"takes\":" +
          listOf(subject.takes, [&](const PageTake& take) { return takeJson(take, bytes); });
  data +=
      ",\"room\":" + (subject.scene == nullptr ? std::string("null")
                                               : roomJson(*subject.scene, subject.floor, bytes));
  data += ",\"walk\":" + (subject.walk == nullptr ? std::string("null") : walkJson(subject, bytes));
  data +=
      ",\"bench\":" + (subject.bench == nullptr ? std::string("null")
                                                : benchJson(*subject.bench, pageNumbers(bytes)));
  data += ",\"notes\":" + listOf(subject.notes, jsonString);
  return data + "}";
}

// JSON as it may stand in a <script> element: `<` is in strings only, and never there as itself.
std::string inScript(const std::string& json) {
  std::string safe;
  safe.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return safe;
}

}  // namespace

void writePage(std::ostream& out, const PageSubject& subject) {
  PageBytes bytes;
  const std::string data = inScript(dataOf(subject, bytes));
  const std::map<std::string_view, std::function<void()>> marks = {
      {"title", [&] { out << xmlText(subject.title); }},
      {"description", [&] { out << xmlText(subject.description); }},
      {"style", [&] { out << pageStyle(); }},
      {"script", [&] { out << pageScript(); }},
      {"data", [&] { out << data; }},
      {"bytes", [&] { bytes.writeBase64(out); }},
  };
  std::string_view rest = pageFrame();
  while (const auto before = splitAt(rest, "{{")) {
    const auto mark = splitAt(before->second, "}}");
    out << before->first;
    marks.at(mark->first)();
    rest = mark->second;
  }
  out << rest;
}

}  // namespace amble
