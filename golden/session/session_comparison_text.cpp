#include <fmt/format.h>

#include <algorithm>

#include "core/base/duration_text.h"
#include "core/base/figure_text.h"
#include "core/base/plain_text.h"
#include "core/report/json_text.h"
#include "golden/report/report_runs.h"
#include "golden/session/session_comparison.h"
#include "golden/why/frame_why.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxLines = 20;

/// The smallest and largest ratio of b's duration to a's between two events.
std::pair<double, double> paceOf(const EventAlignment& events) {
  double least = 1;
  double most = 1;
  bool is_first = true;
  for (std::size_t i = 1; i < events.matched.size(); ++i) {
    const Nanoseconds span_a = events.matched[i].a - events.matched[i - 1].a;
    const Nanoseconds span_b = events.matched[i].b - events.matched[i - 1].b;
    if (span_a <= Nanoseconds(0)) continue;
    const double pace = static_cast<double>(span_b.count()) / static_cast<double>(span_a.count());
    least = is_first ? pace : std::min(least, pace);
    most = is_first ? pace : std::max(most, pace);
    is_first = false;
  }
  return {least, most};
}

void addEvents(const SessionComparison& comparison, std::string& out) {
  const EventAlignment& events = comparison.events;
  out += fmt::format("events    {} in both, {} only in a, {} only in b\n", events.matched.size(),
                     events.only_a.size(), events.only_b.size());
  if (events.matched.empty()) {
    out += "time      no event is in both; aligned at the first packets\n";
  } else if (events.matched.size() > 1) {
    const auto [least, most] = paceOf(events);
    out += fmt::format("time      between events b takes {:.4f} to {:.4f} times as long as a\n",
                       least, most);
  }
}

void addBehaviour(const JudgedRun& run, std::string& out) {
  const RunJudgement& judged = run.judgement;
  if (!judged.comparable) {
    out += fmt::format("behaviour not judged: {}\n", plainText(run.rule));
    return;
  }
  out += fmt::format("behaviour {}, {}, from {} to {} s\n", countText(judged.items, "item"),
                     countText(judged.values, "value"), secondsText(judged.from, 3),
                     secondsText(judged.until, 3));
  if (judged.findings.empty()) out += "  all within the limits\n";
  for (const std::string& line : runReasons(run, kMaxLines)) out += "  " + line + "\n";
  for (const std::string& note : judged.notes) out += "  note: " + plainText(note) + "\n";
}

}  // namespace

std::string sessionText(const SessionComparison& comparison) {
  std::string out;
  const std::size_t accepted = comparison.run().accepted.size();
  if (accepted > 1) out += fmt::format("accepted  {} recordings, a the first\n", accepted);
  addEvents(comparison, out);
  addBehaviour(comparison.run(), out);
  const SuiteReport& pictures = comparison.report;
  if (!pictures.frames.empty()) {
    const std::size_t unjudged = pictures.count(FrameVerdict::incomparable);
    out += fmt::format("pictures  {} of {} differ{}\n", pictures.count(FrameVerdict::different),
                       pictures.frames.size(),
                       unjudged == 0 ? "" : fmt::format(", {} incomparable", unjudged));
  }
  for (const std::string& note : pictures.notes) out += "  note: " + note + "\n";
  for (std::size_t i = 0; i < pictures.frames.size(); ++i) {
    const JudgedFrame& judged = pictures.frames[i];
    if (judged.verdict == FrameVerdict::same) continue;
    out += fmt::format("  {} at {} s, b at {} s: {}\n", judged.frame.name,
                       secondsText(*judged.frame.time - comparison.origin_a, 3),
                       secondsText(comparison.times_b[i] - comparison.origin_b, 3), judged.rule);
    if (!judged.why) continue;
    for (const std::string& line : whyLines(*judged.why, 3)) out += "    " + line + "\n";
  }
  if (!comparison.damage.empty()) out += comparison.damage.text() + "\n";
  out += std::string(nameOf(comparison.verdict())) + "\n";
  return out;
}

std::string sessionJson(const SessionComparison& comparison) {
  Json root;
  root["format"] = 1;
  root["verdict"] = nameOf(comparison.verdict());
  const auto nanoseconds = [](LogTime time) { return time.time_since_epoch().count(); };
  const auto eventsJson = [&](const std::vector<Event>& events) {
    Json list = Json::array();
    for (const Event& event : events) {
      list.push_back({{"text", event.text},
                      {"source", event.source},
                      {"log_time_ns", nanoseconds(event.time)}});
    }
    return list;
  };
  Json matched = Json::array();
  for (const MatchedEvent& event : comparison.events.matched) {
    matched.push_back({{"text", event.text},
                       {"a_log_time_ns", nanoseconds(event.a)},
                       {"b_log_time_ns", nanoseconds(event.b)}});
  }
  root["events"] = {{"matched", matched},
                    {"only_a", eventsJson(comparison.events.only_a)},
                    {"only_b", eventsJson(comparison.events.only_b)}};
  root["run"] = runsJson(comparison.report.runs)[0];
  root["pictures"] = Json::parse(reportJson(comparison.report))["frames"];
  for (std::size_t i = 0; i < comparison.times_b.size(); ++i) {
    root["pictures"][i]["b_log_time_ns"] = nanoseconds(comparison.times_b[i]);
  }
  if (!comparison.damage.empty()) root["damage"] = comparison.damage.text();
  root["notes"] = comparison.report.notes;
  return jsonText(root);
}

}  // namespace rocinante
