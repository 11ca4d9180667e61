#include <fmt/format.h>

#include <algorithm>

#include "core/base/duration_text.h"
#include "core/base/plain_text.h"
#include "core/cli/text_table.h"
#include "recorder/diff/diff_place_json.h"
#include "recorder/diff/replay_diff.h"

namespace rocinante {
namespace {

using cli::counted;
using cli::grouped;

std::string sourceName(const ReplaySource& source) {
  const std::string name = source.source.empty() ? "(none)" : plainText(source.source);
  return source.to.empty() ? name : name + " to " + plainText(source.to);
}

std::string partingText(const std::optional<DiffPlace>& place, LogTime origin) {
  if (!place) return "it has ended";
  return fmt::format("message {} of the source, {} s, {}", place->number,
                     secondsText(place->time - origin, 9), plainText(place->topic));
}

std::string msText(std::uint64_t us) {
  return fmt::format("{:.3f}", static_cast<double>(us) / 1000);
}

}  // namespace

std::string replayText(const ReplayDiff& diff) {
  std::string out = fmt::format("a  {}\nb  {}\n", plainText(diff.name_a), plainText(diff.name_b));
  cli::TextTable table;
  table.is_number = {false, true, true, true, true, true, true, true};
  table.rows = {
      {"source", "in both", "missing", "extra", "out of order", "off by ms p50", "p99", "max"}};
  for (const ReplaySource& source : diff.sources) {
    const bool any = source.same > 0;
    const auto shown = [&](std::uint64_t us) { return any ? msText(us) : std::string("-"); };
    table.rows.push_back({sourceName(source), grouped(source.same), grouped(source.missing),
                          grouped(source.extra), grouped(source.out_of_order),
                          shown(source.error_p50_us), shown(source.error_p99_us),
                          shown(source.error_max_us)});
  }
  out += table.text();
  for (const ReplaySource& source : diff.sources) {
    if (!source.differs) continue;
    out += fmt::format("{} first differs\n  in a: {}\n  in b: {}\n", sourceName(source),
                       partingText(source.first_a, diff.origin_a),
                       partingText(source.first_b, diff.origin_b));
  }
  if (diff.lost_b > 0) {
    out += fmt::format("losses   the recorder of b reports a loss of {}\n",
                       counted(diff.lost_b, "datagram"));
  }
  out += diff.stream_a == diff.stream_b
             ? "stream   the same payloads in the same order over all sources\n"
             : "stream   different payloads, or a different order over all sources\n";
  if (diff.otherSpeed()) {
    out += fmt::format("speed    --speed is {:g}, but b ran at about {:.3g}\n", diff.speed,
                       *diff.measured_speed);
  }
  const bool late = !diff.same() && std::ranges::none_of(diff.sources, &ReplaySource::differs);
  out += diff.same() ? "replay   the same\n"
         : late      ? fmt::format("replay   the same messages, but not within {} s\n",
                                   secondsText(*diff.within))
                     : std::string("replay   differs\n");
  return out;
}

std::string replayJson(const ReplayDiff& diff) {
  Json sources = Json::array();
  for (const ReplaySource& source : diff.sources) {
    sources.push_back({{"source", source.source},
                       {"to", source.to},
                       {"messages_a", source.messages_a},
                       {"messages_b", source.messages_b},
                       {"in_both", source.same},
                       {"missing", source.missing},
                       {"extra", source.extra},
                       {"out_of_order", source.out_of_order},
                       {"off_us",
                        {{"p50", source.error_p50_us},
                         {"p99", source.error_p99_us},
                         {"max", source.error_max_us}}},
                       {"first_a", placeJson(source.first_a)},
                       {"first_b", placeJson(source.first_b)}});
  }
  Json out;
  out["format"] = 1;
  out["a"] = diff.name_a;
  out["b"] = diff.name_b;
  out["same"] = diff.same();
  out["messages_a"] = diff.messages_a;
  out["messages_b"] = diff.messages_b;
  out["stream_sha256_a"] = diff.stream_a;
  out["stream_sha256_b"] = diff.stream_b;
  out["speed"] = diff.speed;
  out["measured_speed"] = orNull(diff.measured_speed);
  out["lost_b"] = diff.lost_b;
  out["sources"] = std::move(sources);
  return jsonText(out);
}

}  // namespace rocinante
