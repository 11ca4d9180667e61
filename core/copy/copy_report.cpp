#include "core/copy/copy_report.h"

#include <fmt/format.h>

#include "core/base/duration_text.h"
#include "core/base/figure_text.h"
#include "core/base/plain_text.h"
#include "core/report/json_text.h"

namespace rocinante {
namespace {

void addCounts(Json& out, const PieceCounts& counts) {
  out["messages"] = counts.messages;
  out["start_ns"] = counts.messages > 0 ? Json(nanosecondsOf(counts.start)) : Json(nullptr);
  out["end_ns"] = counts.messages > 0 ? Json(nanosecondsOf(counts.end)) : Json(nullptr);
  out["channels"] = counts.channels;
  out["restated"] = counts.restated;
  if (counts.decoded > 0) out["decoded"] = counts.decoded;
  out["keyframes"] = counts.keyframes;
  out["losses"] = counts.losses;
  out["marks"] = counts.marks;
  out["attachments"] = counts.attachments;
  out["bytes"] = counts.bytes;
}

void addSession(Json& out, const CopyReport& report) {
  out["session_id"] = report.session_id;
  out["origin_ns"] = report.origin ? Json(nanosecondsOf(*report.origin)) : Json(nullptr);
}

Json gapJson(const CopyGap& gap, bool with_input) {
  Json out;
  if (with_input) out["log"] = gap.input;
  out["from"] = gap.span.from;
  out["to"] = gap.span.to;
  out["cause"] = gap.span.cause;
  out["messages_lost"] = orNull(gap.span.messages_lost);
  return out;
}

Json damageJson(const CopyReport& report) {
  Json damage = Json::array();
  for (const CopyGap& gap : report.gaps) damage.push_back(gapJson(gap, true));
  return damage;
}

}  // namespace

std::string copyReportJson(const std::string& output, const CopyReport& report) {
  Json out{{"format", 1}, {"output", output}};
  addSession(out, report);
  addCounts(out, report.counts);
  out["repeated"] = report.repeated;
  out["damage"] = damageJson(report);
  out["notes"] = report.notes;
  return jsonText(out);
}

std::string splitReportJson(const SplitReport& report) {
  Json pieces = Json::array();
  for (const SplitPiece& piece : report.pieces) {
    Json each{{"output", piece.path.string()}};
    addCounts(each, piece.counts);
    pieces.push_back(std::move(each));
  }
  Json out{{"format", 1}, {"outputs", std::move(pieces)}};
  addSession(out, report.whole);
  out["messages"] = report.whole.counts.messages;
  out["damage"] = damageJson(report.whole);
  out["notes"] = report.whole.notes;
  return jsonText(out);
}

std::string recoverReportJson(const std::string& output, const CopyReport& report) {
  Json out{{"format", 1}, {"output", output}, {"recovered", report.counts.messages}};
  Json lost = Json::array();
  Json repaired = Json::array();
  for (const CopyGap& gap : report.gaps) {
    (gap.costs ? lost : repaired).push_back(gapJson(gap, false));
  }
  out["lost"] = std::move(lost);
  out["repaired"] = std::move(repaired);
  addSession(out, report);
  addCounts(out, report.counts);
  out["notes"] = report.notes;
  return jsonText(out);
}

std::string copyReportText(const std::string& output, const PieceCounts& counts) {
  if (counts.messages == 0) return fmt::format("{}: no messages\n", plainText(output));
  return fmt::format("{}: {} of {}, {} s\n", plainText(output),
                     countText(counts.messages, "message"), countText(counts.channels, "channel"),
                     secondsText(counts.end - counts.start, 3));
}

std::string gapText(const CopyGap& gap) {
  const std::uint64_t lost = gap.span.messages_lost.value_or(0);
  const std::string cost = lost > 0 ? "; " + countText(lost, "message") + " lost" : "";
  if (gap.span.to == 0) return gap.span.cause;
  const std::string place = gap.span.to > gap.span.from
                                ? fmt::format("bytes {} to {}", gap.span.from, gap.span.to)
                                : fmt::format("byte {}", gap.span.from);
  return fmt::format("{}{} ({}, {})", gap.span.cause, cost, gap.input, place);
}

}  // namespace rocinante
