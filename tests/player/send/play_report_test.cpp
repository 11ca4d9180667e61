#include "player/send/play_report.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

using namespace std::chrono_literals;

void send(PlayJournal& journal, std::string_view payload, Nanoseconds late, std::uint32_t span = 0,
          bool restated = false) {
  static SteadyTime deadline{};
  deadline += 1ms;
  journal.sent(Due{LogTime{}, span, restated}, bytesOf(payload), deadline, deadline + late);
}

TEST(PlayJournal, HashesThePayloadsInOrderWithNothingBetween) {
  PlayJournal journal(LogTime(5s), LogTime(7s));
  send(journal, "a", 10us);
  send(journal, "bc", 20us);
  PlayReport report;
  journal.writeTo(report);
  EXPECT_EQ(report.sent, 2U);
  EXPECT_EQ(report.bytes, 3U);
  // SHA-256 of "abc", FIPS 180-4.
  EXPECT_EQ(report.stream_sha256,
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  ASSERT_EQ(report.spans.size(), 1U);
  EXPECT_EQ(report.spans[0].sha256, report.stream_sha256);
  EXPECT_EQ(report.spans[0].from, LogTime(5s));
  EXPECT_EQ(report.spans[0].until, LogTime(7s));
  EXPECT_EQ(report.late_max_us, 20U);
  EXPECT_EQ(report.duration, 1ms + 10us);
}

TEST(PlayJournal, ARestatementIsInNoCountAndNoHash) {
  PlayJournal plain(LogTime{}, LogTime(1s));
  PlayJournal restating(LogTime{}, LogTime(1s));
  send(restating, "state", 9s, 0, true);
  for (PlayJournal* journal : {&plain, &restating}) {
    send(*journal, "a", 10us);
    send(*journal, "b", 10us);
  }
  PlayReport a;
  PlayReport b;
  plain.writeTo(a);
  restating.writeTo(b);
  EXPECT_EQ(b.restatements, 1U);
  EXPECT_EQ(b.sent, 2U);
  EXPECT_EQ(b.stream_sha256, a.stream_sha256);
  EXPECT_EQ(b.late_max_us, 10U);
  EXPECT_EQ(b.bytes, a.bytes);
}

TEST(PlayJournal, EachTurnIsASpanOfItsOwn) {
  PlayJournal journal(LogTime{}, LogTime(1s));
  for (std::uint32_t turn = 0; turn < 3; ++turn) {
    send(journal, "state", 0us, turn, true);
    send(journal, "abc", 0us, turn);
  }
  PlayReport report;
  journal.writeTo(report);
  ASSERT_EQ(report.spans.size(), 3U);
  for (const auto& span : report.spans) {
    EXPECT_EQ(span.sent, 1U);
    EXPECT_EQ(span.sha256, "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  }
  EXPECT_EQ(report.sent, 3U);
  EXPECT_EQ(report.restatements, 3U);
}

TEST(PlayReport, JsonHasEveryKeyInItsOrder) {
  PlayReport report;
  report.inputs = {"s.mcap"};
  report.to = "udp://127.0.0.1:5000";
  report.speed = PlaybackSpeed::parse("2.5").value();
  report.sent = 3;
  report.bytes = 30;
  report.restatements = 1;
  report.late_p50_us = 1;
  report.late_p90_us = 2;
  report.late_p99_us = 3;
  report.late_p999_us = 4;
  report.late_max_us = 5;
  report.late_bins = {{1, 2}, {5, 1}};
  report.drift = 1500ns;
  report.duration = 2s;
  report.stream_sha256 = "aa";
  report.spans = {{LogTime(1s), LogTime(2s), 3, "aa"}};
  report.timing_source = "kernel";
  report.scheduling = "fifo";
  EXPECT_EQ(jsonText(report), R"({
  "format": 1,
  "inputs": [
    "s.mcap"
  ],
  "to": "udp://127.0.0.1:5000",
  "speed": 2.5,
  "sent": 3,
  "bytes": 30,
  "restatements": 1,
  "duration_s": 2.0,
  "achieved_rate_hz": 1.0,
  "late_us": {
    "p50": 1,
    "p90": 2,
    "p99": 3,
    "p999": 4,
    "max": 5
  },
  "late_histogram_us": {
    "1": 2,
    "5": 1
  },
  "drift_us": 1.5,
  "timing_source": "kernel",
  "scheduling": "fifo",
  "stream_sha256": "aa",
  "spans": [
    {
      "from_ns": 1000000000,
      "until_ns": 2000000000,
      "sent": 3,
      "sha256": "aa"
    }
  ],
  "interrupted": false,
  "damage": [],
  "failure": null
}
)");
}

TEST(PlayReport, WithoutAScheduleNothingIsLate) {
  const std::string json = jsonText(PlayReport());
  EXPECT_NE(json.find("\"speed\": null"), json.npos);
  EXPECT_NE(json.find("\"late_us\": null"), json.npos);
  EXPECT_NE(json.find("\"drift_us\": null"), json.npos);
}

TEST(PlayReport, SaysWhenItFellBehindForGood) {
  PlayReport report;
  report.sent = 101;
  report.duration = 1s;
  EXPECT_TRUE(report.keptUp());
  report.drift = 2s;
  EXPECT_FALSE(report.keptUp());
  EXPECT_EQ(behindText(report),
            "could not keep up: sent 100 datagrams a second and ended 2.000 s late");
}

}  // namespace
}  // namespace rocinante
