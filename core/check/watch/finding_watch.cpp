#include "core/check/watch/finding_watch.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

#include "core/base/duration_text.h"
#include "core/base/figure_text.h"
#include "core/base/plain_text.h"
#include "core/check/check.h"
#include "core/check/rules/rule_list.h"
#include "core/report/account.h"
#include "core/report/json_text.h"

namespace rocinante {
namespace {

/// A finding that begins again within this many holds of its end flickers.
constexpr int kSoonHolds = 4;
/// Of one reach().
constexpr int kMaxSteps = 512;

/// Judged once for each use, or not at a time: it stands until the use is right.
bool isStanding(const Finding& finding) {
  return !finding.last || finding.rule == "device.unadded";
}

WallTime wallTimeOf(LogTime time) { return WallTime(time.time_since_epoch()); }

Json momentJson(const std::optional<LogTime>& time) {
  return time ? Json(rfc3339Text(wallTimeOf(*time))) : Json(nullptr);
}

}  // namespace

FindingWatch::FindingWatch(const Cell& cell, const WatchOptions& options)
    : cell_(cell), options_(options), rules_(cell.rules), session_(cell) {
  names_.cell = cell.file;
}

std::vector<FindingChange> FindingWatch::reach(LogTime now) {
  if (!updated_) return update(now);
  std::vector<FindingChange> all;
  const Nanoseconds step = std::max<Nanoseconds>(kPeriod, (now - *updated_) / kMaxSteps);
  while (now - *updated_ >= step) {
    for (FindingChange& each : update(*updated_ + step)) all.push_back(std::move(each));
  }
  return all;
}

std::vector<FindingChange> FindingWatch::update(LogTime now) {
  std::vector<FindingChange> changes;
  updated_ = now;
  session_.advance(now);
  session_.settle();
  ++round_;
  if (!window_began_) {
    window_began_ = now;
    tellCell(changes, now);
  }
  for (Finding& finding : findingsNow().findings) take(std::move(finding), now, changes);
  std::ranges::stable_sort(changes, std::ranges::greater(),
                           [](const FindingChange& each) { return each.finding.severity; });
  endOld(now, changes);
  if (now - *window_began_ >= kWindow) beginWindow(now);
  return changes;
}

CheckReport FindingWatch::findingsNow() {
  CheckReport report;
  session_.finish(report);
  rules_.apply(report.findings);
  std::erase_if(report.findings,
                [&](const Finding& finding) { return finding.severity < options_.least; });
  return report;
}

void FindingWatch::tellCell(std::vector<FindingChange>& changes, LogTime now) {
  for (Finding& finding : checkCell(cell_).findings) {
    if (finding.severity < options_.least) continue;
    const BaselineKey key = baselineKeyOf(names_, finding);
    if (options_.baseline != nullptr && options_.baseline->accepts(key, finding)) continue;
    if (known_.size() >= kMax) {
      is_full_ = true;
      continue;
    }
    const auto [found, is_new] = known_.try_emplace(key);
    if (!is_new) continue;
    found->second.finding = std::move(finding);
    found->second.is_static = true;
    begin(found->second, now, now, changes);
  }
}

void FindingWatch::take(Finding finding, LogTime now, std::vector<FindingChange>& changes) {
  BaselineKey key = baselineKeyOf(names_, finding);
  if (options_.baseline != nullptr && options_.baseline->accepts(key, finding)) return;
  auto found = known_.find(key);
  if (found == known_.end()) {
    if (known_.size() >= kMax) {
      is_full_ = true;
      return;
    }
    found = known_.emplace(std::move(key), Lasting()).first;
    found->second.hold = options_.hold;
  }
  Lasting& it = found->second;
  if (it.is_static || it.round == round_) return;
  it.round = round_;
  const bool is_standing = isStanding(finding);
  const LogTime last = is_standing ? now : std::min(*finding.last, now);
  if (!it.stood) it.stands_since = now;
  it.stood = true;
  // Counts start again with the window.
  const std::uint64_t more = finding.count - std::min(it.counted, finding.count);
  it.counted = finding.count;
  it.finding = std::move(finding);
  if (it.lasts) {
    it.last = std::max(it.last, last);
    it.count += more;
    return;
  }
  if (is_standing) {
    if (now - it.stands_since < it.hold) return;
    it.last = now;
    it.count = it.finding.count;
    begin(it, it.stands_since, now, changes);
    return;
  }
  // What happened before it ended was told.
  if (last <= it.last && it.last != LogTime{}) return;
  it.count = std::max<std::uint64_t>(more, 1);
  const LogTime first = it.finding.first.value_or(last);
  const LogTime began = it.last == LogTime{} || first > it.last ? first : last;
  it.last = last;
  begin(it, began, now, changes);
}

void FindingWatch::begin(Lasting& it, LogTime at, LogTime now,
                         std::vector<FindingChange>& changes) {
  const bool is_soon = it.ended != LogTime{} && now - it.ended < kSoonHolds * it.hold;
  if (is_soon) it.hold = std::min(2 * it.hold, std::max(kLongestHold, options_.hold));
  it.lasts = true;
  it.began = at;
  ++begun_;
  FindingChange change;
  change.begins = true;
  change.at = at;
  change.finding = it.finding;
  if (!it.is_static) {
    change.finding.count = it.count;
    change.finding.first = at;
    change.finding.last = it.last;
  }
  change.fails = it.finding.severity >= options_.fail_on;
  failed_ = failed_ || change.fails;
  changes.push_back(std::move(change));
}

void FindingWatch::endOld(LogTime now, std::vector<FindingChange>& changes) {
  for (auto each = known_.begin(); each != known_.end();) {
    Lasting& it = each->second;
    it.stood = it.stood && it.round == round_;
    if (it.lasts && !it.is_static && now - it.last > it.hold) {
      it.lasts = false;
      it.ended = now;
      FindingChange change;
      change.at = it.last;
      change.finding = it.finding;
      change.finding.count = it.count;
      change.finding.first = it.began;
      change.finding.last = it.last;
      change.fails = it.finding.severity >= options_.fail_on;
      changes.push_back(std::move(change));
    }
    // One that ended is known for as long as it may flicker, and while its window lists it.
    const bool is_over = !it.lasts && it.round != round_ &&
                         (it.ended == LogTime{} || now - it.ended > kSoonHolds * it.hold);
    each = is_over ? known_.erase(each) : std::next(each);
  }
}

void FindingWatch::beginWindow(LogTime now) {
  window_began_ = now;
  session_.dropFindings();
  for (auto& [key, it] : known_) it.counted = 0;
  // Some counts fade instead of ending: what is left of them was told.
  for (const Finding& finding : findingsNow().findings) {
    const auto found = known_.find(baselineKeyOf(names_, finding));
    if (found != known_.end()) found->second.counted = finding.count;
  }
}

std::size_t FindingWatch::lasting(Severity severity) const {
  return static_cast<std::size_t>(std::ranges::count_if(known_, [&](const auto& each) {
    return each.second.lasts && each.second.finding.severity == severity;
  }));
}

std::string momentText(LogTime time) {
  const auto rounded = std::chrono::floor<std::chrono::milliseconds>(time.time_since_epoch());
  std::string text = rfc3339Text(WallTime(Nanoseconds(rounded)));
  // Nine decimals and Z.
  text.replace(text.size() - 7, 7, "Z");
  return text;
}

std::string findingChangeText(const FindingChange& change) {
  const Finding& finding = change.finding;
  const std::string place = finding.place();
  std::string text =
      fmt::format("{} {}: {}{}{}: {} [{}]", momentText(change.at),
                  change.begins ? "begins" : "ends", place, place.empty() ? "" : ": ",
                  nameOf(finding.severity), plainText(sentenceOf(finding)), finding.rule);
  if (change.begins || !finding.first) return text;
  const auto lasted = std::chrono::floor<std::chrono::milliseconds>(*finding.last - *finding.first);
  return text +
         fmt::format(" ({} in {} s)", countText(finding.count, "time"), secondsText(lasted, 1));
}

std::string findingChangeJson(const FindingChange& change) {
  const Finding& finding = change.finding;
  Json json;
  json["format"] = 1;
  json["event"] = change.begins ? "begins" : "ends";
  json["at"] = momentJson(change.at);
  json["fails"] = change.fails;
  json["rule"] = finding.rule;
  json["severity"] = std::string(nameOf(finding.severity));
  json["count"] = finding.count;
  json["first"] = momentJson(finding.first);
  json["last"] = momentJson(finding.last);
  json["packet"] = orNull(finding.packet);
  json["subject"] = finding.subject;
  json["text"] = sentenceOf(finding);
  json["example"] = finding.example;
  json["hint"] = finding.hint;
  if (const Rule* const rule = findRule(finding.rule)) json["title"] = std::string(rule->title);
  if (!finding.file.empty()) {
    json["file"] = finding.file;
    json["line"] = finding.line;
    json["column"] = finding.column;
  }
  return jsonText(json, -1);
}

}  // namespace rocinante
