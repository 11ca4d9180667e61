#include "recorder/record_report.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

using namespace std::chrono_literals;

TEST(RecordReport, StatusShowsTheRateSinceLastTime) {
  const RecordProgress before{2s, 10'000, 0, 500'000};
  EXPECT_EQ(statusText({4s, 22'000, 3, 1'200'000}, before),
            "4.0 s   6000 packets/s   22000 packets   3 lost   1.2 MB");
  EXPECT_EQ(statusText(before, before), "2.0 s   0 packets/s   10000 packets   0 lost   500.0 kB");
}

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
  summary.payload_bytes = 42;
  summary.reason = "interrupted";
  return summary;
}

TEST(RecordReport, SaysWhatWasRecorded) {
  EXPECT_EQ(summaryText(summary()), "recorded 1 packet on 1 channel in 1.5 s: a.mcap (600 B)");
}

TEST(RecordReport, SaysWhatWasLostWhere) {
  RecordSummary lossy = summary();
  lossy.endpoints[0].losses = {1, 2, 3, 4};
  EXPECT_EQ(summaryText(lossy),
            "recorded 1 packet on 1 channel in 1.5 s: a.mcap (600 B)\n"
            "lost at udp://239.1.2.3:7?interface=lo: 1 in the kernel, 2 in the queue, 3 on the "
            "disk; 4 cut");
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
  ]
})");
}

TEST(RecordReport, AFileNameThatIsNoUtf8StillPrints) {
  RecordSummary odd = summary();
  odd.log = "a\xff.mcap";
  EXPECT_NE(summaryJson(odd).find("\"log\": \"a\xEF\xBF\xBD.mcap\""), std::string::npos);
}

}  // namespace
}  // namespace rocinante
