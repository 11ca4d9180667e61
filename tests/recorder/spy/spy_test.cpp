#include "recorder/spy/spy.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "recorder/spy/spy_json.h"
#include "recorder/spy/spy_text.h"

namespace rocinante {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

class SpyTest : public testing::Test {
 protected:
  static constexpr LogTime kBegan{seconds(1'700'000'000)};

  static std::vector<ListenedEndpoint> endpoints() {
    ListenedEndpoint one;
    one.endpoint = Endpoint::parse("127.0.0.1:19960").value();
    one.bound = one.endpoint.address;
    return {one};
  }

  void hear(std::string_view payload, Nanoseconds at, std::uint16_t port = 40'000) {
    ReceivedDatagram datagram;
    datagram.payload = bytesOf(payload);
    datagram.sender = SocketAddress::parse("127.0.0.1", port).value();
    spy.add(0, datagram, kBegan + at);
  }

  SpyReport after(Nanoseconds time) { return spy.report(kBegan + time); }

  static auto reason(std::string rule) { return Field("rule", &Finding::rule, rule); }

  Spy spy{endpoints(), kBegan};
};

TEST_F(SpyTest, SilenceIsToldAfterTwoSeconds) {
  EXPECT_THAT(after(seconds(1)).reasons, IsEmpty());
  const SpyReport report = after(seconds(3));
  ASSERT_THAT(report.reasons, ElementsAre(reason("live.nothing-received")));
  EXPECT_THAT(report.reasons[0].text, HasSubstr("udp://127.0.0.1:19960"));
}

TEST_F(SpyTest, DrawingsAndEventsAreListed) {
  hear("RK1 planner 0 -\nline goal #ff0000 0 0 0 1 0 0\nevent \"pick\"\n", milliseconds(10));
  hear("RK1 planner 1 -\nevent \"pick\"\nevent \"a long way\"\n", milliseconds(20));
  const SpyReport report = after(milliseconds(520));
  ASSERT_THAT(report.drawings, SizeIs(1));
  EXPECT_EQ(report.drawings[0].name, "goal");
  EXPECT_EQ(report.drawings[0].source, "planner");
  EXPECT_EQ(report.drawings[0].parts, 1U);
  EXPECT_THAT(report.drawings[0].text, testing::StartsWith("line goal "));
  ASSERT_THAT(report.events, SizeIs(2));
  EXPECT_EQ(report.events[1].text, "pick");
  EXPECT_EQ(report.events[1].count, 2U);
  EXPECT_EQ(report.events[1].silent, milliseconds(500));
  EXPECT_THAT(spyText(report, 0, 0),
              AllOf(HasSubstr("drawing  source   parts  statement"), HasSubstr("line goal"),
                    HasSubstr("times  silent  source   event"), HasSubstr("pick")));
  EXPECT_THAT(spyJson(report, false),
              AllOf(HasSubstr("\"drawing\":\"goal\""), HasSubstr("\"event\":\"pick\"")));
  hear("RK1 planner 2 -\nerase goal\n", milliseconds(30));
  EXPECT_THAT(after(milliseconds(600)).drawings, IsEmpty());
}

TEST_F(SpyTest, EventsOfAFloodAreCountedAndNotKept) {
  std::string packet = "RK1 flood 0 -\n";
  for (int i = 0; i < 250; ++i) packet += fmt::format("event \"e{}\"\n", i);
  hear(packet, milliseconds(10));
  const SpyReport report = after(milliseconds(20));
  EXPECT_THAT(report.events, SizeIs(200));
  EXPECT_EQ(report.more_events, 50U);
}

TEST_F(SpyTest, WhoSendsWhatIsNoPacketIsShownItsFirstBytes) {
  hear("RK2 me - -\n", milliseconds(10));
  hear({"\0\xff", 2}, milliseconds(20), 40'001);
  const SpyReport report = after(milliseconds(30));
  EXPECT_EQ(report.datagrams, 2U);
  EXPECT_EQ(report.packets, 0U);
  ASSERT_THAT(report.senders, SizeIs(2));
  EXPECT_EQ(report.senders[0].first_bytes, "\"RK2 me - -\\x0a\"");
  EXPECT_EQ(report.senders[1].first_bytes, "00ff");
  EXPECT_THAT(report.reasons, Contains(reason("live.nothing-decoded")));
}

TEST_F(SpyTest, RatesAreOfTheLastTwoSeconds) {
  for (int i = 0; i < 400; ++i) {
    hear(fmt::format("RK1 arm@r {} -\njoints a {}\n", i, i), milliseconds(10 * i));
  }
  const SpyReport report = after(seconds(4));
  ASSERT_THAT(report.sources, SizeIs(1));
  EXPECT_NEAR(report.sources[0].rate_hz, 100, 7);
  EXPECT_NEAR(report.devices[0].rate_hz, 100, 7);
  EXPECT_NEAR(after(seconds(20)).sources[0].rate_hz, 0, 1e-9);
}

TEST_F(SpyTest, AFirstPacketAloneIsNoRate) {
  hear("RK1 arm - -\njoints a 1\n", milliseconds(10));
  EXPECT_EQ(after(milliseconds(20)).sources[0].rate_hz, 0);
}

TEST_F(SpyTest, DevicesShowTheirLastValuesAndWhetherTheyMove) {
  hear("RK1 arm@r 0 -\njoints a 1 2\njoint g left=0.5\npose t 1 2 3 0 0 0 1 in a/tool\n",
       milliseconds(10));
  hear("RK1 arm@r 1 -\njoints a 1 2\njoint g left=0.6\n", milliseconds(20));
  const SpyReport report = after(seconds(3));
  ASSERT_THAT(report.devices, SizeIs(3));
  EXPECT_THAT(report.devices[0].joints, ElementsAre(1, 2));
  EXPECT_EQ(report.devices[0].changes, 0U);
  EXPECT_EQ(report.devices[1].named_joints.at("left"), 0.6);
  EXPECT_EQ(report.devices[1].changes, 1U);
  EXPECT_EQ(report.devices[2].pose->position.z, 3);
  EXPECT_EQ(report.devices[2].carrier, "a/tool");
  EXPECT_THAT(report.reasons, Contains(AllOf(reason("live.constant"),
                                             Field(&Finding::text, HasSubstr("a received")))));
}

TEST_F(SpyTest, EachKindOfFaultKeepsItsFirstLineWithItsColumn) {
  hear("RK1 arm@r 0 -\njoints a 1,0 2\n", milliseconds(10));
  hear("RK1 arm@r 1 -\njoints a nan\n", milliseconds(20));
  hear("RK1 arm@r 2 -\norder b x y\njoints b 1 2 3\n", milliseconds(30));
  const SpyReport report = after(milliseconds(40));
  ASSERT_THAT(report.faults, SizeIs(2));
  EXPECT_EQ(report.faults[0].kind, PacketFault::bad_number);
  EXPECT_EQ(report.faults[0].count, 2U);
  EXPECT_EQ(report.faults[0].line, "joints a 1,0 2");
  EXPECT_EQ(report.faults[0].line_number, 2U);
  EXPECT_EQ(report.faults[0].column, 10U);
  EXPECT_THAT(report.faults[0].hint, HasSubstr("no comma"));
  EXPECT_EQ(report.faults[1].kind, PacketFault::order_mismatch);
  EXPECT_EQ(report.faults[1].line, "joints b 1 2 3");
}

TEST_F(SpyTest, TwoSendersOfOneNameAreFoundOut) {
  for (int i = 0; i < 5; ++i) {
    hear(fmt::format("RK1 arm@r {} -\n", 10 + i), milliseconds(20 * i), 40'000);
    hear(fmt::format("RK1 arm@s {} -\n", 20 + i), milliseconds(20 * i + 10), 40'001);
  }
  const SpyReport report = after(seconds(1));
  EXPECT_THAT(report.reasons, Contains(reason("source.two-senders")));
  EXPECT_THAT(report.reasons, Not(Contains(reason("live.two-senders"))));
  for (const Finding& each : report.reasons) {
    if (each.rule != "source.two-senders") continue;
    EXPECT_EQ(each.example, "RUN s from 127.0.0.1:40001; RUN r from 127.0.0.1:40000");
  }
}

TEST_F(SpyTest, TwoSendersOfOneNameWithoutARunAreFoundOut) {
  for (int i = 0; i < 5; ++i) {
    hear(fmt::format("RK1 arm {} -\n", 10 + i), milliseconds(20 * i), 40'000);
    hear(fmt::format("RK1 arm {} -\n", 20 + i), milliseconds(20 * i + 10), 40'001);
  }
  EXPECT_THAT(after(seconds(1)).reasons, Contains(reason("live.two-senders")));
}

TEST_F(SpyTest, TwoPathsOfOneSourceAreNotTwoSenders) {
  for (int i = 0; i < 5; ++i) {
    hear(fmt::format("RK1 arm@r {} -\n", 10 + i), milliseconds(20 * i), 40'000);
    hear(fmt::format("RK1 arm@r {} -\n", 10 + i), milliseconds(20 * i + 10), 40'001);
  }
  const SpyReport report = after(seconds(1));
  EXPECT_THAT(report.reasons, Contains(reason("live.two-paths")));
  EXPECT_THAT(report.reasons, Not(Contains(reason("live.two-senders"))));
  EXPECT_THAT(report.reasons, Not(Contains(reason("source.gap"))));
}

TEST_F(SpyTest, ASourceHeardWholeAndFilteredIsReported) {
  hear("RK1 arm@r 7 - via=hub:slow:0\n", milliseconds(10));
  hear("RK1 arm@r 7 - by=hub restated part=g:1/1\n", milliseconds(15));
  hear("RK1 arm@r 9 - via=hub:slow:1\n", milliseconds(20));
  EXPECT_THAT(after(milliseconds(30)).reasons, Not(Contains(reason("source.mixed"))));
  // Late, and heard all the same.
  hear("RK1 arm@r 8 -\n", milliseconds(30), 40'001);
  EXPECT_THAT(after(milliseconds(40)).reasons, Contains(reason("source.mixed")));
}

TEST_F(SpyTest, RequestsAndStrangersAreReported) {
  InputCounts counts;
  counts.requests = 3;
  counts.strangers = 1;
  spy.setDropped(0, 0, counts);
  const SpyReport report = after(milliseconds(40));
  EXPECT_THAT(report.reasons, ElementsAre(reason("live.strangers"), reason("live.requests")));
  EXPECT_THAT(spyJson(report, false), AllOf(HasSubstr("\"strangers\""), HasSubstr("\"requests\"")));
}

TEST_F(SpyTest, ASourceThatStartsAnewIsNoSecondSender) {
  hear("RK1 arm@r 7 -\n", milliseconds(10), 40'000);
  hear("RK1 arm@s 0 -\n", milliseconds(20), 40'001);
  hear("RK1 arm@s 1 -\n", milliseconds(30), 40'001);
  const SpyReport report = after(milliseconds(40));
  EXPECT_THAT(report.reasons, Not(Contains(reason("live.two-senders"))));
  EXPECT_EQ(report.sources[0].restarts, 1U);
  EXPECT_EQ(report.sources[0].run, "s");
}

TEST_F(SpyTest, ClocksApartAndLossesAreTold) {
  hear("RK1 arm@r 0 1700000060.5\n", milliseconds(500));
  hear("RK1 arm@r 9 1700000060.6\n", milliseconds(600));
  spy.setDropped(0, 4);
  const SpyReport report = after(milliseconds(700));
  EXPECT_EQ(report.sources[0].gap, 8U);
  EXPECT_THAT(report.reasons,
              AllOf(Contains(reason("source.gap")), Contains(reason("source.clock-skew")),
                    Contains(reason("log.loss"))));
  EXPECT_EQ(report.sources[0].clock_offset, Nanoseconds(seconds(60)));
}

TEST_F(SpyTest, JudgesSourcesAsCheckDoes) {
  hear("RK1 arm@r 0 -\njoints a 1\n", milliseconds(10));
  hear("RK1 arm@r 5 -\njoints a 2\n", milliseconds(20));
  hear("RK1 arm@r 3 -\njoints a 3\n", milliseconds(30));
  const SpyReport report = after(milliseconds(40));
  ASSERT_THAT(report.reasons, ElementsAre(reason("source.gap"), reason("source.late")));
  EXPECT_EQ(report.reasons[1].text, "packets of source arm that arrived late and were dropped");
  EXPECT_EQ(report.reasons[1].count, 1U);
  EXPECT_THAT(spyJson(report, false), HasSubstr("\"id\":\"source.late\""));
}

TEST_F(SpyTest, EveryFaultHasARuleWithItsFirstLineAndSender) {
  hear("RK1 arm@r 0 -\njoints a nan\njoints a 1,0\n", milliseconds(10));
  hear("RK1 arm@r 1 -\norder b x y\njoints b 1 2 3\n", milliseconds(20));
  hear("RK2 arm\n", milliseconds(30), 40'001);
  const SpyReport report = after(milliseconds(40));
  EXPECT_THAT(report.reasons,
              ElementsAre(reason("packet.bad-number"), reason("packet.joint-count"),
                          reason("packet.not-finite"), reason("packet.unknown-protocol")));
  const auto example = [&](std::size_t number) { return report.reasons[number].example; };
  EXPECT_EQ(example(1), "127.0.0.1:40000, line 3: joints b 1 2 3");
  EXPECT_EQ(example(2), "127.0.0.1:40000, line 2: joints a nan");
  EXPECT_EQ(example(3), "127.0.0.1:40001, line 1: RK2 arm");
  EXPECT_THAT(report.reasons[0].hint, HasSubstr("no comma"));
}

TEST_F(SpyTest, RemovedDevicesAreFoundOnlyWhenTheyAreUsedAgain) {
  hear("RK1 arm@r 0 -\npose a 0 0 0 0 0 0 1\nremove a\n", milliseconds(10));
  EXPECT_THAT(after(milliseconds(20)).reasons, IsEmpty());
  hear("RK1 arm@r 1 -\npose a 0 0 0 0 0 0 1\n", milliseconds(30));
  EXPECT_THAT(after(milliseconds(40)).reasons, ElementsAre(reason("packet.after-remove")));
}

TEST_F(SpyTest, TwoSourcesOfOneDeviceAreFound) {
  hear("RK1 arm@r 0 -\njoints a 1\n", milliseconds(10));
  hear("RK1 cam@r 0 -\njoints a 2\n", milliseconds(20));
  EXPECT_THAT(after(milliseconds(40)).reasons, ElementsAre(reason("packet.two-sources")));
}

TEST_F(SpyTest, StrangersWithoutNumberFillNoMemory) {
  for (std::uint16_t port = 1; port < 10'000; ++port) hear("x", milliseconds(port), port);
  const SpyReport report = after(seconds(11));
  EXPECT_EQ(report.senders.size(), 4'096U);
  EXPECT_EQ(report.more_senders, 9'999U - 4'096U);
}

TEST_F(SpyTest, TimesThatGoBackAreHeldUp) {
  hear("RK1 arm@r 0 -\njoints a 1\n", seconds(2));
  hear("RK1 arm@r 1 -\njoints a 2\n", seconds(1));
  EXPECT_THAT(spy.report(kBegan).devices[0].joints, ElementsAre(2));
}

TEST_F(SpyTest, ShowsWhatDecodersMakeAndTheFieldsThatNobodyUses) {
  auto set = decode::parseDecoders(R"(
[[decoder]]
name = "cell"
kind = "json"
begins_with = "{"
[[decoder.field]]
name = "q"
at = "/q"
[[decoder.field]]
name = "speed"
at = "/v"
[[decoder.joint]]
device = "arm"
joint = "j"
field = "q"
)",
                                   "test");
  ASSERT_TRUE(set.ok()) << set.error().text();
  Spy decoding(endpoints(), kBegan, *set);
  const auto say = [&](std::string_view payload, Nanoseconds at) {
    ReceivedDatagram datagram;
    datagram.payload = bytesOf(payload);
    datagram.sender = SocketAddress::parse("127.0.0.1", 40'000).value();
    decoding.add(0, datagram, kBegan + at);
  };
  say(R"({"q":0.5,"v":2,"mode":"run"})", milliseconds(10));
  say(R"({"q":0.75,"v":3,"mode":"\u001b[2J"})", milliseconds(20));
  say("{", milliseconds(30));
  say("RK1 lamp 0 -\njoints lamp 1", milliseconds(40));
  say("others", milliseconds(50));
  const SpyReport report = decoding.report(kBegan + seconds(3));
  EXPECT_EQ(report.datagrams, 5U);
  EXPECT_EQ(report.packets, 3U);
  EXPECT_EQ(report.decoded, 2U);
  ASSERT_THAT(report.decoders, SizeIs(1));
  const SpyDecoder& cell = report.decoders[0];
  EXPECT_EQ(cell.packets, 2U);
  EXPECT_EQ(cell.refused, 1U);
  EXPECT_EQ(cell.reason, "it is not JSON");
  // Of the last datagram that gave a packet.
  ASSERT_THAT(cell.fields, SizeIs(3));
  EXPECT_EQ(cell.fields[0].number, 0.75);
  EXPECT_TRUE(cell.fields[0].used);
  EXPECT_EQ(cell.fields[1].name, "speed");
  EXPECT_EQ(cell.fields[1].value, "3");
  EXPECT_FALSE(cell.fields[1].used);
  EXPECT_EQ(cell.fields[2].name, "/mode");
  EXPECT_FALSE(cell.fields[2].declared);
  ASSERT_THAT(report.devices, SizeIs(2));
  EXPECT_EQ(report.devices[0].name, "arm");
  EXPECT_EQ(report.devices[0].changes, 1U);
  const std::string text = spyText(report, 0, 0);
  EXPECT_THAT(text, HasSubstr("5 datagrams, 1 in packet text, 2 decoded\n"));
  EXPECT_THAT(text, HasSubstr("no line uses it"));
  EXPECT_THAT(text, HasSubstr("not declared"));
  EXPECT_THAT(text, Not(HasSubstr("\x1b")));
  EXPECT_THAT(spyJson(report, true), HasSubstr("\"field\": \"/mode\""));
}

TEST_F(SpyTest, NoLineOfATableObeysAStranger) {
  hear("RK1 a%1Bb - -\njoints d%0Ae 1\n", milliseconds(10));
  hear("RK1 a - -\nlabel x 0 0 0 \"\x1b[2J\"\n", milliseconds(20));
  const std::string text = spyText(after(seconds(1)), 0, 0);
  EXPECT_THAT(text, Not(HasSubstr("\x1b")));
}

TEST_F(SpyTest, TablesFitTheScreen) {
  for (int i = 0; i < 50; ++i) hear(fmt::format("RK1 s{} - -\n", i), milliseconds(i));
  const std::string text = spyText(after(seconds(1)), 5, 40);
  EXPECT_THAT(text, HasSubstr("... and 45 more sources"));
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    EXPECT_LE(end - at, 40U);
    at = end + 1;
  }
}

TEST_F(SpyTest, OnATerminalTheReasonsComeFirstAndAreBroken) {
  const SpyReport report = after(seconds(3));
  const std::string piped = spyText(report, 0, 0), shown = spyText(report, 0, 60);
  EXPECT_GT(piped.find("[live.nothing-received]"), piped.find("endpoint"));
  EXPECT_LT(shown.find("[live.nothing-received]"), shown.find("endpoint"));
  EXPECT_THAT(shown, HasSubstr("\n    "));
  EXPECT_EQ(std::ranges::count(piped, '-'), std::ranges::count(shown, '-')) << "nothing is cut";
}

}  // namespace
}  // namespace rocinante
