#include "core/foreign/live/received_decoder.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

using std::chrono::seconds;

constexpr LogTime kReceived{seconds(1'700'000'000)};

std::shared_ptr<const decode::DecoderSet> declared(const std::string& which) {
  const std::string text = "[[decoder]]\nname = \"byte\"\nkind = \"struct\"\n" + which +
                           "\n[[decoder.field]]\nname = \"q\"\nat = 0\ntype = \"u8\"\n"
                           "[[decoder.joint]]\ndevice = \"arm\"\njoint = \"j\"\nfield = \"q\"\n";
  auto set = decode::parseDecoders(text, "test");
  EXPECT_TRUE(set) << set.error().text();
  return *set;
}

std::vector<ListenedEndpoint> endpoints() {
  std::vector<ListenedEndpoint> listened;
  for (const char* const text : {"127.0.0.1:8", "127.0.0.1:9"}) {
    const Endpoint endpoint = Endpoint::parse(text).value();
    listened.push_back({endpoint, endpoint.address});
  }
  return listened;
}

/// The text made of a datagram; "" for none.
std::string madeOf(ReceivedDecoder& decoder, std::size_t endpoint, std::string_view payload,
                   const char* sender = "10.0.0.1") {
  ReceivedDatagram datagram;
  datagram.payload = bytesOf(payload);
  datagram.sender = SocketAddress::parse(sender, 4000).value();
  const MadePacket* const made = decoder.decode(endpoint, datagram, kReceived);
  if (made == nullptr) return "";
  EXPECT_NE(made->packet, nullptr);
  EXPECT_EQ(made->metadata->at("source"), "decoded:byte");
  EXPECT_EQ(made->metadata->at("decoder"), decoder.decoder().decoders().set().hash);
  return std::string(made->text);
}

TEST(ReceivedDecoder, MakesAPacketWithTheTimeOfArrival) {
  ReceivedDecoder decoder(declared(""), endpoints());
  EXPECT_EQ(madeOf(decoder, 0, "\x07"), "RK1 decoded:byte - 1700000000\njoint arm j=7");
}

TEST(ReceivedDecoder, LeavesPacketTextAloneWhateverItIsWorth) {
  ReceivedDecoder decoder(declared(""), endpoints());
  EXPECT_EQ(madeOf(decoder, 0, "RK1 arm 0 -\njoints arm 1"), "");
  EXPECT_EQ(madeOf(decoder, 0, "RK1 "), "");
  EXPECT_EQ(decoder.decoder().account().octets, 0U);
}

TEST(ReceivedDecoder, ChoosesByPortSenderAndTheTopicThatALogWouldHave) {
  ReceivedDecoder by_port(declared("port = 9"), endpoints());
  EXPECT_EQ(madeOf(by_port, 0, "\x07"), "");
  EXPECT_NE(madeOf(by_port, 1, "\x07"), "");
  ReceivedDecoder by_sender(declared("from = \"10.0.0.2\""), endpoints());
  EXPECT_EQ(madeOf(by_sender, 0, "\x07"), "");
  EXPECT_NE(madeOf(by_sender, 0, "\x07", "10.0.0.2"), "");
  ReceivedDecoder by_topic(declared("topic = \"/udp/9/*\""), endpoints());
  EXPECT_EQ(madeOf(by_topic, 0, "\x07"), "");
  EXPECT_NE(madeOf(by_topic, 1, "\x07"), "");
}

TEST(ReceivedDecoder, CountsWhatBecameOfTheOctets) {
  ReceivedDecoder decoder(declared(""), endpoints());
  EXPECT_NE(madeOf(decoder, 0, "\x07"), "");
  EXPECT_EQ(madeOf(decoder, 0, ""), "");
  const decode::DecodeAccount account = decoder.decoder().account();
  EXPECT_EQ(decode::accountText(account),
            "  byte: 1 packet, 1 refused: it ends before a field\n  not decoded: 1 datagram\n");
}

}  // namespace
}  // namespace rocinante
