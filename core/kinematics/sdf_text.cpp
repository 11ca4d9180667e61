#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/document/xml_tags.h"
#include "core/kinematics/sdf_reader.h"

namespace rocinante {
namespace {

constexpr std::size_t kDeepestSdf = 100;
// libsdformat 12 is slow to make an element with all its defaults: 45 kB of small models took 7 s.
// Larger files are refused before that.
constexpr std::pair<std::string_view, int> kSdfMicroseconds[] = {
    {"world", 14'000}, {"model", 4'000}, {"population", 3'100},
    {"state", 3'100},  {"actor", 2'900}, {"link", 2'000},
    {"sensor", 1'400}, {"visual", 400},  {"collision", 400}};
constexpr std::int64_t kOtherSdfMicroseconds = 50;
constexpr std::int64_t kMaxSdfMicroseconds = 30'000'000;

std::int64_t sdfMicroseconds(std::string_view element) {
  const auto* const known =
      std::ranges::find(kSdfMicroseconds, element, [](const auto& one) { return one.first; });
  return known == std::end(kSdfMicroseconds) ? kOtherSdfMicroseconds : known->second;
}

}  // namespace

std::optional<std::string> sdfWithoutIncludes(std::string text, FaultList& faults) {
  XmlTags tags(text);
  std::vector<std::pair<const char*, const char*>> cut;
  std::size_t depth = 0, include_depth = 0;
  std::int64_t microseconds = 0;
  const char* from = nullptr;
  for (XmlTag tag; tags.next(tag);) {
    if (tag.starts && ++depth > kDeepestSdf) {
      faults.error("sdf.invalid", {},
                   fmt::format("the XML is nested deeper than {} elements", kDeepestSdf));
      return std::nullopt;
    }
    if (tag.starts && from == nullptr &&
        (microseconds += sdfMicroseconds(tag.name)) > kMaxSdfMicroseconds) {
      faults.error("sdf.invalid", {},
                   "the file is too large: libsdformat would take more than half a minute for its "
                   "elements",
                   "one file per model reads much faster");
      return std::nullopt;
    }
    if (tag.starts && from == nullptr && tag.name == "include") {
      from = tag.name.data() - 1;
      include_depth = depth;
    }
    if (!tag.ends) continue;
    if (from != nullptr && depth == include_depth) {
      const char* end = tag.inner.data() + tag.inner.size();
      while (*end != '>') ++end;
      cut.emplace_back(from, end + 1);
      from = nullptr;
    }
    if (depth > 0) --depth;
  }
  const char* counted = text.data();
  int line = 1;
  for (const auto& [begin, end] : cut) {
    line += static_cast<int>(std::count(counted, begin, '\n'));
    counted = begin;
    faults.leaveOut("element", "include", {line}, "a model in another file is not read",
                    Severity::warning, "sdf.passed-over",
                    "name the included model in a cell of its own");
  }
  for (const auto& [begin, end] : cut) {
    for (std::size_t i = static_cast<std::size_t>(begin - text.data());
         i < static_cast<std::size_t>(end - text.data()); ++i) {
      if (text[i] != '\n') text[i] = ' ';
    }
  }
  return text;
}

std::vector<std::string> sdfMeshes(std::string_view text) {
  std::vector<std::string> meshes;
  XmlTags tags(text);
  bool in_mesh = false;
  for (XmlTag tag; tags.next(tag);) {
    if (tag.name == "mesh") in_mesh = tag.starts && !tag.ends;
    if (!in_mesh || tag.name != "uri" || !tag.starts || tag.ends) continue;
    const char* from = tag.inner.data() + tag.inner.size() + 1;
    const auto offset = static_cast<std::size_t>(from - text.data());
    std::string_view uri = text.substr(offset, text.find('<', offset) - offset);
    uri.remove_prefix(std::min(uri.find_first_not_of(kXmlBlanks), uri.size()));
    uri = uri.substr(0, uri.find_last_not_of(kXmlBlanks) + 1);
    if (!uri.empty()) meshes.emplace_back(uri);
  }
  return meshes;
}

}  // namespace rocinante
