#include "player/send/play_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/base/duration_text.h"
#include "core/base/figure_text.h"

namespace rocinante {
namespace {

// An endless loop must not grow the report forever: only the first spans are kept, and counting
// continues.
constexpr std::size_t kMaxSpans = 10'000;

double microseconds(Nanoseconds duration) { return static_cast<double>(duration.count()) / 1e3; }
double seconds(Nanoseconds duration) { return static_cast<double>(duration.count()) / 1e9; }

}  // namespace

double PlayReport::achievedRateHz() const {
  return sent > 1 && duration.count() > 0 ? static_cast<double>(sent - 1) / seconds(duration) : 0;
}

void PlayJournal::sent(const Due& due, ByteView payload, SteadyTime deadline, SteadyTime sent_at) {
  if (due.restated) {
    ++restatements_;
    return;
  }
  if (span_ < due.span && (span_sent_ > 0 || !has_bounds_)) {
    closeSpan(due.after_turn && span_ + 1 == due.span);
  }
  span_ = due.span;
  has_bounds_ = due.bounds != PlayedSpan{};
  if (has_bounds_) bounds_ = due.bounds;
  last_sent_ = due.place.time;
  if (sent_ == 0) first_ = sent_at;
  last_ = sent_at;
  ++sent_;
  ++span_sent_;
  bytes_ += payload.size();
  stream_hash_.add(payload);
  span_hash_.add(payload);
  late_.add(sent_at - deadline);
  drift_.add(sent_at - deadline);
}

void PlayJournal::tooLong(const Due& due) {
  LeftOut left_out;
  left_out.kind = "datagram";
  left_out.reason = "longer than UDP carries, 65,507 bytes";
  left_out.first = rfc3339Text(WallTime(due.place.time.time_since_epoch()));
  left_out.severity = Severity::warning;
  left_out_.leaveOut(std::move(left_out));
}

void PlayJournal::closeSpan(bool whole) {
  const std::string sha256 = hexOf(span_hash_.finish());
  PlayedSpan span = bounds_;
  // An unfinished span is as long as it was played.
  if (has_bounds_ && !whole) span.until = last_sent_ + Nanoseconds(1);
  if (spans_.size() < kMaxSpans) spans_.push_back({span.from, span.until, span_sent_, sha256});
  span_sent_ = 0;
}

void PlayJournal::writeTo(PlayReport& report, bool whole) {
  closeSpan(whole);
  report.sent = sent_;
  report.bytes = bytes_;
  report.restatements = restatements_;
  report.late_p50_us = late_.percentile(0.5);
  report.late_p90_us = late_.percentile(0.9);
  report.late_p99_us = late_.percentile(0.99);
  report.late_p999_us = late_.percentile(0.999);
  report.late_max_us = late_.max();
  report.late_bins = late_.bins();
  report.drift = drift_.drift();
  report.duration = last_ - first_;
  report.stream_sha256 = hexOf(stream_hash_.finish());
  report.spans = std::move(spans_);
  report.left_out = std::move(left_out_);
}

std::string jsonText(const PlayReport& report) {
  Json json;
  json["format"] = 1;
  json["inputs"] = report.inputs;
  if (!report.source.empty()) json["source"] = report.source;
  if (!report.run.empty()) json["run"] = report.run;
  json["to"] = report.to;
  json["speed"] = report.speed ? Json(report.speed->ratio()) : Json(nullptr);
  json["sent"] = report.sent;
  json["bytes"] = report.bytes;
  json["restatements"] = report.restatements;
  json["duration_s"] = seconds(report.duration);
  json["achieved_rate_hz"] = report.achievedRateHz();
  // Nothing is late without a schedule.
  Json late = nullptr;
  Json bins = nullptr;
  Json drift = nullptr;
  if (report.speed) {
    late = Json::object();
    late["p50"] = report.late_p50_us;
    late["p90"] = report.late_p90_us;
    late["p99"] = report.late_p99_us;
    late["p999"] = report.late_p999_us;
    late["max"] = report.late_max_us;
    bins = Json::object();
    for (const LateHistogram::Bin& bin : report.late_bins) {
      bins[std::to_string(bin.up_to_us)] = bin.count;
    }
    drift = microseconds(report.drift);
  }
  json["late_us"] = late;
  json["late_histogram_us"] = bins;
  json["drift_us"] = drift;
  json["timing_source"] = report.timing_source;
  json["scheduling"] = report.scheduling;
  json["stream_sha256"] = report.stream_sha256;
  Json spans = Json::array();
  for (const PlayedSpanReport& span : report.spans) {
    Json one;
    one["from_ns"] = span.from.time_since_epoch().count();
    one["until_ns"] = span.until.time_since_epoch().count();
    one["sent"] = span.sent;
    one["sha256"] = span.sha256;
    spans.push_back(one);
  }
  json["spans"] = spans;
  json["interrupted"] = report.interrupted;
  json["damage"] = report.damage;
  if (!report.left_out.empty()) json["left_out"] = leftOutJson(report.left_out);
  json["failure"] = report.failure ? Json(report.failure->text()) : Json(nullptr);
  // A file name need not be UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string summaryText(const PlayReport& report) {
  std::string text = fmt::format("sent {} ({} bytes) to {} in {} s, {:.1f}/s",
                                 countText(report.sent, "datagram"), report.bytes, report.to,
                                 secondsText(report.duration, 3), report.achievedRateHz());
  if (report.restatements > 0) {
    text += ", and " + countText(report.restatements, "restatement");
  }
  text += "\n";
  if (report.speed && report.sent > 0) {
    text += fmt::format("late by p50 {}, p99 {}, at most {} us; drift {:.1f} us ({}, {})\n",
                        report.late_p50_us, report.late_p99_us, report.late_max_us,
                        microseconds(report.drift), report.timing_source, report.scheduling);
  }
  if (!report.left_out.empty()) text += accountSentence(report.left_out) + "\n";
  text += "stream sha256 " + report.stream_sha256 + "\n";
  return text;
}

std::string behindText(const PlayReport& report) {
  return fmt::format("could not keep up: sent {:.0f} datagrams a second and ended {} s late",
                     report.achievedRateHz(), secondsText(report.drift, 3));
}

}  // namespace rocinante
