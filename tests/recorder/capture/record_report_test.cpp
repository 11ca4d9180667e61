#include "recorder/capture/record_report.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

using namespace std::chrono_literals;

RecordSummary summary() {
  RecordSummary summary;
  summary.log = "a.mcap";
  const Endpoint endpoint = Endpoint::parse("239.1.2.3:0?interface=lo").value();
  SocketAddress bound = endpoint.address;
  bound.port = 7;
  summary.endpoints.push_back({{endpoint, bound}, 1, {}});
  summary.packets = 1;
  summary.channels = 1;
  summary.duration = 1500ms;
  summary.log_bytes = 600;
  PieceFacts piece;
  piece.file.path = "a.mcap";
  piece.packets = 1;
  piece.bytes = 600;
  piece.start = piece.end = LogTime(1'770'091'506s);
  summary.files.pieces.push_back(piece);
  summary.payload_bytes = 42;
  summary.reason = "interrupted";
  return summary;
}

TEST(RecordReport, SaysWhatWasRecorded) {
  EXPECT_EQ(summaryText(summary()), "recorded 1 packet on 1 channel in 1.5 s: a.mcap (600 B)");
}

/// One subscription, which was accepted after this time, or never.
RecordSummary subscribed(std::optional<Nanoseconds> accepted_after) {
  RecordSummary one = summary();
  one.endpoints[0].listened.endpoint = Endpoint::parse("subscribe://127.0.0.1:9").value();
  InputAccount input;
  input.endpoint = "subscribe://127.0.0.1:9";
  input.subscription = {accepted_after, accepted_after ? "" : "never answered"};
  one.inputs.push_back(input);
  return one;
}

TEST(RecordReport, NamesAFirstDatagramThatCameLate) {
  RecordSummary late = summary();
  late.first_after = 1s;
  EXPECT_EQ(summaryText(late), summaryText(summary()));
  EXPECT_NE(summaryJson(late).find("\"first_after_s\": 1.0,"), std::string::npos);
  late.first_after = 1'300ms;
  EXPECT_EQ(summaryText(late),
            "recorded 1 packet on 1 channel in 1.5 s, the first after 1.3 s: a.mcap (600 B)");
}

TEST(RecordReport, NamesASubscriptionThatWasAcceptedLate) {
  EXPECT_EQ(summaryText(subscribed(1s)), summaryText(summary()));
  EXPECT_EQ(summaryText(subscribed(1'300ms)),
            summaryText(summary()) + "\nsubscribe://127.0.0.1:9: subscribed after 1.3 s");
  const std::string json = summaryJson(subscribed(250ms));
  EXPECT_NE(json.find("\"accepted_after_s\": 0.25,\n        \"trouble\": null"), std::string::npos)
      << json;
}

TEST(RecordReport, ASubscriptionThatWasNeverAcceptedIsInTheJson) {
  RecordSummary never = subscribed(std::nullopt);
  never.endpoints[0].recorded = never.packets = 0;
  EXPECT_EQ(summaryText(never).find('\n'), std::string::npos);
  const std::string json = summaryJson(never);
  EXPECT_NE(json.find("\"accepted_after_s\": null,\n        \"trouble\": \"never answered\""),
            std::string::npos)
      << json;
}

TEST(RecordReport, NamesTheEndpointsThatHeardNothing) {
  RecordSummary silent = summary();
  InputAccount input;
  input.endpoint = "udp://127.0.0.1:7";
  silent.inputs.push_back(input);
  silent.endpoints.push_back({silent.endpoints[0].listened, 0, {}});
  input.endpoint = "udp://127.0.0.1:8";
  silent.inputs.push_back(input);
  EXPECT_EQ(summaryText(silent),
            summaryText(summary()) +
                "\nnothing was heard at udp://127.0.0.1:8 (rocinante spy looks for the reason)");
  silent.inputs[1].counts.untrusted.emplace();
  silent.endpoints[0].recorded = 0;
  EXPECT_NE(summaryText(silent).find("at udp://127.0.0.1:7, udp://127.0.0.1:8 ("),
            std::string::npos);
}

TEST(RecordReport, WhatWasHeardAndNotRecordedIsNoSilence) {
  RecordSummary heard = subscribed(1ms);
  heard.endpoints[0].recorded = 0;
  ASSERT_NE(summaryText(heard).find("nothing was heard"), std::string::npos);
  RecordSummary lossy = heard, refused = heard, before = heard;
  lossy.endpoints[0].losses.queue = 1;
  refused.inputs[0].counts.refused = 1;
  before.packets_before = 1;
  for (const RecordSummary& each : {lossy, refused, before}) {
    EXPECT_EQ(summaryText(each).find("nothing was heard"), std::string::npos) << summaryText(each);
  }
}

TEST(RecordReport, SaysWhatWasLostWhere) {
  RecordSummary lossy = summary();
  lossy.endpoints[0].losses = {1, 2, 3, 4};
  EXPECT_EQ(summaryText(lossy),
            "recorded 1 packet on 1 channel in 1.5 s: a.mcap (600 B)\n"
            "lost at udp://239.1.2.3:7?interface=lo: 1 in the kernel, 2 in the queue, 3 on the "
            "disk; 4 truncated");
}

TEST(RecordReport, JsonHoldsTheWholeAccount) {
  RecordSummary lossy = summary();
  lossy.endpoints[0].losses = lossy.losses = {1, 2, 3, 4};
  EXPECT_EQ(summaryJson(lossy), R"({
  "format": 1,
  "log": "a.mcap",
  "packets": 1,
  "restated": 0,
  "bytes": 600,
  "payload_bytes": 42,
  "channels": 1,
  "duration_s": 1.5,
  "first_after_s": null,
  "losses": {
    "kernel": 1,
    "queue": 2,
    "disk": 3,
    "truncated": 4
  },
  "complete": true,
  "reason": "interrupted",
  "late": 0,
  "endpoints": [
    {
      "endpoint": "udp://239.1.2.3:7?interface=lo",
      "packets": 1,
      "losses": {
        "kernel": 1,
        "queue": 2,
        "disk": 3,
        "truncated": 4
      }
    }
  ],
  "tees": [],
  "pieces": [
    {
      "log": "a.mcap",
      "packets": 1,
      "bytes": 600,
      "start": "2026-02-03T04:05:06.000000000Z",
      "end": "2026-02-03T04:05:06.000000000Z"
    }
  ],
  "deleted": {
    "pieces": 0,
    "packets": 0,
    "bytes": 0
  },
  "packets_before": 0,
  "warnings": []
}
)");
}

TEST(RecordReport, AFileNameThatIsNoUtf8StillPrints) {
  RecordSummary odd = summary();
  odd.log = "a\xff.mcap";
  EXPECT_NE(summaryJson(odd).find("\"log\": \"a\xEF\xBF\xBD.mcap\""), std::string::npos);
}

}  // namespace
}  // namespace rocinante
