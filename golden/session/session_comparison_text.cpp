#include "golden/session/session_comparison_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/count_text.h"
#include "core/base/duration_text.h"
#include "core/base/plain_text.h"
#include "core/report/json_text.h"
#include "golden/why/frame_why.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxLines = 20;
constexpr double kDegreesInRadian = 57.29577951308232;

std::string amountText(const Deviation& item) {
  if (!item.largest) return "not the same";
  if (item.unit == "rad") return fmt::format("up to {:.4f}°", *item.largest * kDegreesInRadian);
  return fmt::format("up to {:.6f}{}{}", *item.largest, item.unit.empty() ? "" : " ", item.unit);
}

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
  const auto list = [&](const char* side, const std::vector<Event>& missing, LogTime origin) {
    for (std::size_t i = 0; i < std::min(missing.size(), kMaxLines); ++i) {
      out += fmt::format("  only in {}: \"{}\" of {} at {} s\n", side, plainText(missing[i].text),
                         plainText(missing[i].source), secondsText(missing[i].time - origin, 3));
    }
  };
  list("a", events.only_a, comparison.origin_a);
  list("b", events.only_b, comparison.origin_b);
  if (events.matched.empty()) {
    out += "time      no event is in both; aligned at the first packets\n";
  } else if (events.matched.size() > 1) {
    const auto [least, most] = paceOf(events);
    out += fmt::format("time      between events b takes {:.4f} to {:.4f} times as long as a\n",
                       least, most);
  }
}

void addState(const SessionComparison& comparison, std::string& out) {
  const SessionDeviation& state = comparison.state;
  const auto at = [&](LogTime moment) { return secondsText(moment - comparison.origin_a, 3); };
  out += fmt::format("state     {} at {}, from {} to {} s, every {} s\n",
                     countText(state.items, "item"), countText(state.samples, "moment"),
                     at(state.from), at(state.until), secondsText(state.step));
  if (state.beyond.empty()) {
    out += "  all within limits";
    if (state.largest_within && state.largest_within->largest.value_or(0) > 0) {
      out += fmt::format("; the nearest to its limit: {}, {}", state.largest_within->item,
                         amountText(*state.largest_within));
    }
    out += "\n";
    return;
  }
  out += fmt::format("  they first differ at {} s: {} beyond {}\n",
                     at(state.beyond.front().first_at), countText(state.beyond.size(), "item"),
                     state.beyond.size() == 1 ? "its limit" : "their limits");
  for (std::size_t i = 0; i < std::min(state.beyond.size(), kMaxLines); ++i) {
    const Deviation& item = state.beyond[i];
    out += fmt::format("  {}: {}, from {} s on", plainText(item.item), amountText(item),
                       at(item.first_at));
    out += item.largest ? fmt::format(", most at {} s\n", at(item.largest_at)) : "\n";
  }
  if (state.beyond.size() > kMaxLines) {
    out += fmt::format("  and {} more\n", state.beyond.size() - kMaxLines);
  }
}

}  // namespace

std::string sessionText(const SessionComparison& comparison) {
  std::string out;
  addEvents(comparison, out);
  addState(comparison, out);
  const SuiteReport& pictures = comparison.pictures;
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
  const SessionDeviation& state = comparison.state;
  Json beyond = Json::array();
  for (const Deviation& item : state.beyond) {
    beyond.push_back({{"item", item.item},
                      {"unit", item.unit},
                      {"largest", orNull(item.largest)},
                      {"largest_at_ns", nanoseconds(item.largest_at)},
                      {"first_at_ns", nanoseconds(item.first_at)}});
  }
  root["state"] = {
      {"items", state.items},
      {"samples", state.samples},
      {"step_ns", state.step.count()},
      {"from_ns", nanoseconds(state.from)},
      {"until_ns", nanoseconds(state.until)},
      {"parts_at_ns",
       state.beyond.empty() ? Json(nullptr) : Json(nanoseconds(state.beyond.front().first_at))},
      {"beyond", beyond}};
  root["pictures"] = Json::parse(reportJson(comparison.pictures))["frames"];
  for (std::size_t i = 0; i < comparison.times_b.size(); ++i) {
    root["pictures"][i]["b_log_time_ns"] = nanoseconds(comparison.times_b[i]);
  }
  if (!comparison.damage.empty()) root["damage"] = comparison.damage.text();
  root["notes"] = comparison.pictures.notes;
  return jsonText(root);
}

}  // namespace rocinante
