#include "viewer/serve/foxglove_desk.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include "core/packet/packet_text.h"
#include "viewer/serve/client_queue.h"
#include "viewer/serve/foxglove_client.h"

namespace rocinante {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// A desk, and the state that it shows.
struct Session {
  Cell cell;
  FoxgloveDesk desk{cell, "x"};
  SessionState state;
  PacketTextDecoder decoder;
  LogTime now{std::chrono::seconds(100)};
  int sequence = 0;

  void receive(const std::string& statements) {
    const std::string text = "RK1 s " + std::to_string(sequence++) + " -\n" + statements;
    const Packet* const packet = decoder.decode(bytesOf(text));
    ASSERT_NE(packet, nullptr);
    ASSERT_EQ(state.apply(now, *packet), Applied::yes);
    desk.applied(*packet, {});
    desk.moment(now, state);
    now += std::chrono::milliseconds(10);
  }
};

/// All that a client is to be sent: texts, and of messages what is behind their heads.
std::vector<std::string> sentTo(FoxgloveClient& client) {
  constexpr std::size_t kHead = 1 + 4 + 8;
  std::vector<std::string> all;
  while (const auto out = client.next()) {
    const ByteView bytes = ByteView(out->bytes).subspan(SharedMessage::kRoom);
    all.emplace_back(textOf(out->is_text ? bytes : bytes.subspan(kHead)));
  }
  return all;
}

TEST(FoxgloveDesk, SignalsThatAppearGiveTheirChannelAnotherSchema) {
  Session session;
  FoxgloveClient client(session.desk);
  session.receive("signal arm load 1 kg\n");
  const auto hasFirst =
      AllOf(HasSubstr(R"("op":"advertise")"), HasSubstr(R"("topic":"/signals/arm")"),
            HasSubstr(R"("encoding":"json")"), HasSubstr(R"(\"description\":\"kg\")"));
  EXPECT_THAT(sentTo(client), ElementsAre(HasSubstr("serverInfo"), hasFirst));
  client.receive(R"({"op":"subscribe","subscriptions":[{"id":7,"channelId":0}]})", false);
  EXPECT_THAT(sentTo(client), ElementsAre(R"({"load":1.0})"));

  session.receive("signals arm current=2\n");
  const auto hasSecond = AllOf(HasSubstr(R"("op":"advertise")"), HasSubstr(R"("id":1)"),
                               HasSubstr(R"(\"current\")"), HasSubstr(R"(\"load\")"));
  EXPECT_THAT(sentTo(client), ElementsAre(R"({"op":"unadvertise","channelIds":[0]})", hasSecond));
  client.receive(R"({"op":"subscribe","subscriptions":[{"id":8,"channelId":1}]})", false);
  client.receive(R"({"op":"unsubscribe","subscriptionIds":[7]})", false);
  EXPECT_THAT(sentTo(client), ElementsAre(R"({"current":2.0,"load":1.0})"));

  // Whole, as it may be the only one that a client sees.
  session.receive("signals arm current=3\n");
  EXPECT_THAT(sentTo(client), ElementsAre(R"({"current":3.0,"load":1.0})"));
  // Who comes later hears of the last channel alone.
  FoxgloveClient late(session.desk);
  EXPECT_THAT(sentTo(late),
              ElementsAre(HasSubstr("serverInfo"), AllOf(hasSecond, Not(HasSubstr(R"("id":0)")))));
}

TEST(FoxgloveDesk, AChannelIsNotReplacedWithoutEnd) {
  Session session;
  for (int i = 0; i < 100; ++i) session.receive("signals - n" + std::to_string(i) + "=1\n");
  const auto& channels = session.desk.channels();
  ASSERT_EQ(channels.size(), FoxgloveDesk::kMostSchemas);
  EXPECT_EQ(session.desk.replaced().size(), FoxgloveDesk::kMostSchemas - 1);
  EXPECT_THAT(channels.front().messages, IsEmpty());
  ASSERT_EQ(channels.back().messages.size(), 1U);
  EXPECT_THAT(textOf(channels.back().messages.back().bytes), HasSubstr(R"("n99":1.0)"));
}

TEST(FoxgloveDesk, SignalsBeyondTheirBoundAreLeftOut) {
  Session session;
  std::string all = "signals -";
  for (std::size_t i = 0; i < FoxgloveDesk::kMostSignals; ++i) {
    if (i == FoxgloveDesk::kMostSignals / 2) all += "\nsignals -";
    all += " n" + std::to_string(i) + "=1";
  }
  session.receive(all + "\n");
  session.receive("signals - n7=2 more=1\nsignals other more=1\n");
  ASSERT_EQ(session.desk.channels().size(), 1U);
  const auto text = textOf(session.desk.channels()[0].messages.back().bytes);
  EXPECT_THAT(text, AllOf(HasSubstr(R"("n7":2.0)"), Not(HasSubstr("more"))));
}

}  // namespace
}  // namespace rocinante
