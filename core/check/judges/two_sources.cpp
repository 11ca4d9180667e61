#include "core/check/judges/two_sources.h"

#include <fmt/format.h>

#include "core/base/shell_word.h"

namespace rocinante {

void TwoSources::note(std::uint32_t& writer, const PacketPlace& place) {
  if (writer == place.source) return;
  if (writer != kNobody && tally.hit(place)) {
    before = writer;
    now = place.source;
  }
  writer = place.source;
}

void TwoSources::report(const std::string& device, std::string_view what,
                        const std::vector<std::string>& sources, Findings& findings) const {
  if (tally.count == 0) return;
  findings.push_back(tally.finding(
      "packet.two-sources", device,
      fmt::format("the {} of device {} are written by {} and by {}; the last to write wins", what,
                  device, sources[before], sources[now])));
  findings.back().hint =
      fmt::format("to take one of a log: rocinante log filter LOG --source {} -o OUT",
                  shellWord(sources[before]));
  if (sources[before].starts_with("decoded:")) {
    findings.back().hint +=
        "; of a bag or table, LOG is made by: rocinante log import FILE --cell CELL -o LOG";
  }
}

}  // namespace rocinante
