#include "core/check/judges/sender_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/base/plain_text.h"
#include "core/packet/name_cache.h"

namespace rocinante {
namespace {

std::string runText(std::string_view run, std::string_view sender) {
  std::string text = run.empty() ? "no RUN" : "RUN " + plainText(run);
  if (!sender.empty()) text += " from " + plainText(sender);
  return text;
}

}  // namespace

void TwoSources::note(std::uint32_t& writer, const PacketPlace& place) {
  if (writer == place.source) return;
  if (writer != kNobody && tally.hit(place)) {
    before = writer;
    now = place.source;
  }
  writer = place.source;
}

void TwoSources::report(const std::string& subject, std::string_view what,
                        const std::vector<std::string>& sources, Findings& findings) const {
  if (tally.count == 0) return;
  findings.push_back(tally.finding("packet.two-sources", subject,
                                   fmt::format("{} written by {} and by {}; the last to write wins",
                                               what, sources[before], sources[now])));
  findings.back().hint =
      fmt::format("to take one of a log: rocinante log filter LOG --source {} -o OUT",
                  shellWord(sources[before]));
  if (sources[before].starts_with("decoded:")) {
    findings.back().hint +=
        "; of a bag or table, LOG is made by: rocinante log import FILE --cell CELL -o LOG";
  }
}

void SenderJudge::take(const PacketHeader& header, const PacketPlace& place) {
  if (header.reset) {
    for (Run& each : earlier_) each.is_set = false;
    now_.is_set = now_.is_set && header.by.empty();
  }
  if (!header.by.empty()) return;
  if (now_.is_set && sameName(now_.run, header.run)) {
    now_.last = place.time;
    return;
  }
  const auto known = std::find_if(earlier_.begin(), earlier_.end(), [&](const Run& each) {
    return each.is_set && each.run == header.run;
  });
  const bool is_back = known != earlier_.end() && place.time - known->last <= kSoon;
  if (is_back) {
    ++all_returns_;
    if (returns_.hit(place)) {
      runs_ = runText(now_.run, now_.sender) + "; " + runText(header.run, place.sender);
    }
  }
  // The run that ends comes first, in the place of the one that begins, or of the oldest.
  const auto place_of_old = known != earlier_.end() ? known : earlier_.end() - 1;
  std::swap(now_, *place_of_old);
  std::rotate(earlier_.begin(), place_of_old, place_of_old + 1);
  now_.run.assign(header.run);
  now_.sender.assign(place.sender);
  now_.last = place.time;
  now_.is_set = true;
}

void SenderJudge::dropFindings() {
  if (returns_.count == 0) all_returns_ = 0;
  returns_ = {};
}

void SenderJudge::report(const std::string& source, Findings& findings) const {
  if (!found()) return;
  findings.push_back(
      returns_.finding("source.two-senders", source,
                       fmt::format("two processes send as source {} and take turns: a receiver "
                                   "shows now the one, now the other",
                                   source)));
  findings.back().example = runs_;
  findings.back().hint = "stop one of them, or give it a SOURCE of its own";
}

}  // namespace rocinante
