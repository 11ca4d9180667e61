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
