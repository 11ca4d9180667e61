#include "core/report/traffic_findings.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

using namespace std::chrono_literals;

TEST(TrafficFindings, NameThePlaceTheTimeAndWhatToCheck) {
  const Finding unicast = nothingReceived("udp://:1", Reach::unicast, 2900ms);
  EXPECT_EQ(unicast.text, "nothing received on udp://:1 for 2 s");
  EXPECT_NE(unicast.hint.find("firewall"), std::string::npos);
  EXPECT_NE(nothingReceived("", Reach::multicast, 2s).hint.find("ttl"), std::string::npos);
  EXPECT_NE(nothingReceived("", Reach::watched, 2s).hint.find("filter="), std::string::npos);
  EXPECT_EQ(nothingSince("udp://:1", 4s).text, "nothing received on udp://:1 for the last 4 s");
  EXPECT_EQ(nothingSince("", 4s).text, "nothing received for the last 4 s");
}

TEST(TrafficFindings, ShowHowTheFirstDatagramBegins) {
  EXPECT_EQ(nothingDecoded(1, "", "").text, "1 datagram received, none of them a packet");
  EXPECT_EQ(nothingDecoded(2, "00ff", "").text,
            "2 datagrams received, none of them a packet; the first begins 00ff");
  EXPECT_EQ(nothingDecoded(2, "00ff", "[::1]:5").text,
            "2 datagrams received, none of them a packet; the first, from [::1]:5, begins 00ff");
}

}  // namespace
}  // namespace rocinante
