#include "core/check/judges/source_judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/check/rules/rule_settings.h"

namespace rocinante {

ClockJudge& SourceClocks::clockOf(std::string_view publisher) {
  if (publisher.empty()) return own_;
  auto found = others_.find(publisher);
  if (found == others_.end()) {
    if (others_.size() == kMaxPublishers) return own_;
    found = others_.emplace(std::string(publisher), ClockJudge(thresholds_)).first;
    if (is_ignored_) found->second.ignore();
  }
  return found->second;
}

void SourceClocks::report(const std::string& source, Findings& findings) const {
  Findings found;
  own_.report(source, found);
  for (const auto& [publisher, clock] : others_) {
    Findings its;
    clock.report(source, its);
    for (Finding& finding : its) {
      if (finding.rule == "source.clock-step") {
        finding.text += ", in what is sent of " + publisher;
      } else if (std::ranges::find(found, finding.rule, &Finding::rule) != found.end()) {
        continue;
      }
      found.push_back(std::move(finding));
    }
  }
  std::ranges::move(found, std::back_inserter(findings));
}

SourceThresholds SourceThresholds::of(const RuleSettings& rules, const CellSource* source) {
  const SourceLimits limits = source != nullptr ? source->limits : SourceLimits{};
  SourceThresholds all;
  all.clock.skew_s = limits.clock_skew_s.value_or(rules.threshold("source.clock-skew"));
  all.clock.drift_ppm = rules.threshold("source.clock-drift");
  all.clock.step_s = rules.threshold("source.clock-step") * 1e-3;
  all.cadence.silence_s = limits.silence_s.value_or(rules.threshold("source.silence"));
  all.cadence.is_silence_own =
      limits.silence_s.has_value() || rules.hasOwnThreshold("source.silence");
  all.cadence.is_silence_given = limits.silence_s.has_value();
  all.restate_s = limits.restate_s.value_or(rules.threshold("source.unrestated"));
  if (source != nullptr) all.cadence.rate_hz = source->rate_hz;
  // A source without a declared rate has no period to deviate from.
  if (limits.jitter_ms || all.cadence.rate_hz || rules.hasOwnThreshold("source.jitter")) {
    all.cadence.jitter_s = limits.jitter_ms.value_or(rules.threshold("source.jitter")) * 1e-3;
  }
  return all;
}

SourceJudge::SourceJudge(std::string name, std::uint32_t number, const SourceThresholds& thresholds)
    : name_(std::move(name)),
      number_(number),
      restate_s_(thresholds.restate_s),
      clocks_(thresholds.clock),
      cadence_(thresholds.cadence) {}

void SourceJudge::take(const PacketHeader& header, Applied applied, const SourceCounts& counts,
                       PacketPlace& place) {
  const bool own = header.by.empty();
  if (header.reset || counts.restarts != seen_.restarts) ++stretch_;
  if (header.reset && !own) clocks_.ignore();
  senders_.take(header, place);
  watchNumbers(counts, place);
  place.sent_ns = header.time_ns;
  place.source = number_;
  place.stretch = stretch_;
  place.is_restated = header.restated || !own;
  watchPath(header, counts, place);
  if (applied != Applied::yes) return;
  if (place.is_restated) {
    restated_at_ = place.time;
    if (own) cadence_.takeRestatement(place);
    return;
  }
  clocks_.take(place);
  cadence_.take(place, lost_);
  judgeRestatement(place);
}

void SourceJudge::watchPath(const PacketHeader& header, const SourceCounts& counts,
                            const PacketPlace& place) {
  if (!header.by.empty()) return;
  if (header.via && relay_.empty()) relay_ = header.via->relay;
  if (counts.isMixed()) mixed_.hit(place);
}

void SourceJudge::watchNumbers(const SourceCounts& counts, const PacketPlace& place) {
  lost_ = counts.gap > seen_.gap ? counts.gap - seen_.gap : 0;
  if (lost_ > 0) gap_.hit(place);
  if (counts.duplicates > seen_.duplicates) {
    duplicate_.hit(place);
  } else if (counts.late > seen_.late) {
    late_.hit(place);
  }
  if (counts.restarts > seen_.restarts) restart_.hit(place);
  seen_ = {counts.gap, counts.late, counts.duplicates, counts.restarts};
}

void SourceJudge::takeStatement(const Statement& statement, const PacketPlace& place) {
  statics_.take(statement, place.time);
  if (!StaticItems::isStatic(statement)) return;
  if (!has_statics_ && !place.is_restated) restated_at_ = place.time;
  has_statics_ = true;
}

LogTime SourceJudge::lastRestated() const {
  return std::max(restated_at_, statics_.oldest().value_or(restated_at_));
}

void SourceJudge::judgeRestatement(const PacketPlace& place) {
  if (!has_statics_ || secondsOf(place.time - restated_at_) <= restate_s_) return;
  restated_at_ = lastRestated();
  const double since_s = secondsOf(place.time - restated_at_);
  if (since_s <= restate_s_) return;
  unrestated_.hit(place);
  longest_unrestated_s_ = std::max(longest_unrestated_s_, since_s);
  restated_at_ = place.time;
}

void SourceJudge::dropFindings() {
  dropped_ = seen_;
  gap_ = late_ = duplicate_ = restart_ = mixed_ = unrestated_ = {};
  longest_unrestated_s_ = 0;
  senders_.dropFindings();
  clocks_.dropFindings();
  cadence_.dropFindings();
}

void SourceJudge::report(LogTime end, Findings& findings) const {
  const auto add = [&](const Tally& tally, std::uint64_t count, const char* rule,
                       std::string text) {
    if (count == 0) return;
    findings.push_back(tally.finding(rule, name_, std::move(text)));
    findings.back().count = count;
  };
  // A count may fall: a gap that a late packet closes.
  const auto since = [](std::uint64_t now, std::uint64_t before) {
    return now > before ? now - before : 0;
  };
  const std::uint64_t duplicates = since(seen_.duplicates, dropped_.duplicates);
  add(gap_, since(seen_.gap, dropped_.gap), "source.gap",
      fmt::format("packets of source {} that never arrived", name_));
  add(late_, since(since(seen_.late, dropped_.late), duplicates), "source.late",
      fmt::format("packets of source {} that arrived late and were dropped", name_));
  add(duplicate_, duplicates, "source.duplicate",
      fmt::format("packets of source {} that arrived twice; the second was dropped", name_));
  senders_.report(name_, findings);
  const bool take_turns = senders_.found();
  add(restart_, take_turns ? 0 : since(seen_.restarts, dropped_.restarts), "source.restart",
      fmt::format("restarts of source {}", name_));
  add(mixed_, mixed_.count, "source.mixed",
      fmt::format("source {} is heard whole and also filtered by relay {}", name_, relay_));
  if (mixed_.count > 0) {
    findings.back().hint = "listen to the source or to one output of the relay, not to both";
  }
  clocks_.report(name_, findings);
  cadence_.report(name_, end, findings);

  Tally unrestated = unrestated_;
  double longest_s = longest_unrestated_s_;
  const double at_end_s = secondsOf(end - lastRestated());
  if (has_statics_ && at_end_s > restate_s_) {
    PacketPlace place;
    place.time = end;
    unrestated.hit(place);
    longest_s = std::max(longest_s, at_end_s);
  }
  add(unrestated, unrestated.count, "source.unrestated",
      fmt::format("source {} did not send its static state (add, order, colours, drawings) again "
                  "for {:.4g} s; {:.6g} s are expected at most",
                  name_, longest_s, restate_s_));
  if (unrestated.count > 0) {
    findings.back().hint =
        "a receiver that joins late misses what it sent once: restate it every two seconds";
  }
}

}  // namespace rocinante
