#include "viewer/ui/study/endpoint_survey.h"

#include <gtest/gtest.h>

#include <chrono>

#include "core/net/udp_socket.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;

/// A port of 127.0.0.1 that was free a moment ago.
Endpoint quietEndpoint() {
  auto probe = UdpReceiver::open(Endpoint::parse("127.0.0.1:0").value());
  Endpoint endpoint = Endpoint::parse("127.0.0.1:1").value();
  endpoint.address.port = probe->boundAddress().port;
  return endpoint;
}

/// Sends until the survey has heard 20 datagrams, or is over.
void sendUntilHeard(EndpointSurvey& survey, const Endpoint& to,
                    const std::vector<std::string>& texts) {
  auto sender = UdpSender::open(to);
  ASSERT_TRUE(sender.ok());
  while (survey.isListening() && (survey.heard().empty() || survey.heard()[0].datagrams < 20)) {
    for (const std::string& text : texts) static_cast<void>(sender->send(bytesOf(text)));
    std::this_thread::sleep_for(5ms);
  }
  survey.wait();
}

TEST(EndpointSurvey, NamesTheSourcesThatItHears) {
  const Endpoint endpoint = quietEndpoint();
  EndpointSurvey survey({{endpoint, 700ms}});
  sendUntilHeard(survey, endpoint,
                 {"RK1 gripper 1 -\n", "RK1 arm@a 1 -\njoints arm 1\n", "not a packet"});
  const auto heard = survey.heard();
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_EQ(heard[0].endpoint, endpoint.text());
  EXPECT_EQ(heard[0].sources, (std::vector<std::string>{"arm", "gripper"}));
  EXPECT_GT(heard[0].undecoded, 0U);
  EXPECT_FALSE(heard[0].listening);
  EXPECT_EQ(heard[0].fault, "");
  EXPECT_TRUE(heard[0].text().starts_with("arm, gripper: ")) << heard[0].text();
  EXPECT_TRUE(survey.takeNews());
  EXPECT_FALSE(survey.takeNews());
  // It is closed again.
  EXPECT_TRUE(UdpReceiver::open(endpoint).ok());
}

TEST(EndpointSurvey, SilenceIsSaidAndItListensOnceMore) {
  const Endpoint endpoint = quietEndpoint();
  EndpointSurvey survey({{endpoint, 30ms}});
  survey.wait();
  ASSERT_EQ(survey.heard().size(), 1U);
  EXPECT_EQ(survey.heard()[0].text(), "nothing heard");
  survey.listen();
  EXPECT_TRUE(survey.isListening());
  survey.wait();
  EXPECT_FALSE(survey.isListening());
}

TEST(EndpointSurvey, ATakenPortIsASentenceAndTheOthersAreHeard) {
  auto held = UdpReceiver::open(Endpoint::parse("127.0.0.1:0").value());
  ASSERT_TRUE(held.ok());
  Endpoint taken = Endpoint::parse("127.0.0.1:1").value();
  taken.address.port = held->boundAddress().port;
  const Endpoint endpoint = quietEndpoint();
  EndpointSurvey survey({{endpoint, 700ms}, {taken, 700ms}});
  sendUntilHeard(survey, endpoint, {"RK1 arm 1 -\n"});
  const auto heard = survey.heard();
  ASSERT_EQ(heard.size(), 2U);
  EXPECT_EQ(heard[0].sources, std::vector<std::string>{"arm"});
  EXPECT_NE(heard[1].text().find(" is held by "), std::string::npos) << heard[1].text();
  EXPECT_TRUE(heard[1].text().ends_with(
      "; `connect` to a group, to a relay (subscribe://HOST:PORT) or to pcap://INTERFACE"))
      << heard[1].text();
}

TEST(EndpointSurvey, HostileNamesAreShownPlainAndNotEndlesslyMany) {
  const Endpoint endpoint = quietEndpoint();
  EndpointSurvey survey({{endpoint, 700ms}});
  std::vector<std::string> texts{"RK1 %1B[31m 1 -\n"};
  for (int i = 0; i < 60; ++i) texts.push_back("RK1 a" + std::to_string(i) + " 1 -\n");
  sendUntilHeard(survey, endpoint, texts);
  const auto heard = survey.heard();
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_LE(heard[0].sources.size(), HeardEndpoint::kMostSources);
  for (const std::string& name : heard[0].sources) {
    EXPECT_EQ(name.find('\x1B'), std::string::npos);
  }
}

TEST(EndpointSurvey, EndsAtOnceWithItsOwner) {
  const SteadyTime began = std::chrono::steady_clock::now();
  { const EndpointSurvey survey({{quietEndpoint(), 1h}}); }
  EXPECT_LT(SteadyTime(std::chrono::steady_clock::now()) - began, 10s);
}

TEST(EndpointSurvey, TheUsualOnesAreTheStandardGroupAndItsPort) {
  const auto usual = usualEndpoints();
  ASSERT_EQ(usual.size(), 2U);
  EXPECT_EQ(usual[0].endpoint, Endpoint::standard());
  EXPECT_EQ(usual[1].endpoint, Endpoint::parse(":19960").value());
  EXPECT_LT(usual[1].length, usual[0].length);
}

TEST(HeardEndpoint, SaysItInOneLine) {
  HeardEndpoint heard;
  EXPECT_EQ(heard.text(), "listening ...");
  heard.datagrams = heard.undecoded = 2;
  EXPECT_EQ(heard.text(), "2 datagrams that are no packets");
  heard.datagrams = 5;
  heard.sources = {"a", "b", "c", "d", "e"};
  EXPECT_EQ(heard.text(), "a, b, c and 2 more: 3 packets");
  heard.fault = "why";
  EXPECT_EQ(heard.text(), "why");
}

}  // namespace
}  // namespace rocinante
