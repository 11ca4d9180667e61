#include "core/nats/nats_source.h"

#include <gtest/gtest.h>
#include <poll.h>

#include "core/packet/packet_text.h"
#include "core/packet/session_state.h"
#include "core/transport/open_sink.h"
#include "core/transport/open_source.h"
#include "tests/support/nats_server.h"

namespace rocinante {
namespace {

using test::NatsServer;

struct Heard {
  std::string subject;
  std::string payload;
  WallTime time;
};

Endpoint natsEndpoint(const std::string& text) { return Endpoint::parse(text).value(); }

/// Receives this number; fails the test after 60 s.
std::vector<Heard> hear(DatagramSource& source, std::size_t count) {
  std::vector<Heard> heard;
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (heard.size() < count) {
    if (std::chrono::steady_clock::now() > give_up) {
      ADD_FAILURE() << "only " << heard.size() << " datagrams came";
      return heard;
    }
    pollfd waiting{source.fileDescriptor(), POLLIN, 0};
    ::poll(&waiting, 1, 100);
    const auto batch = source.receive();
    if (!batch) {
      ADD_FAILURE() << batch.error().text();
      return heard;
    }
    for (const ReceivedDatagram& each : *batch) {
      heard.push_back(
          {std::string(each.subject), std::string(textOf(each.payload)), each.kernel_time});
    }
  }
  return heard;
}

std::string packet(const std::string& source, int number) {
  return "RK1 " + source + " " + std::to_string(number) + " -\njoints arm " +
         std::to_string(number) + "\n";
}

Status send(DatagramSink& sink, const std::string& text) {
  const ByteView payload = bytesOf(text);
  return sink.send({&payload, 1});
}

/// Sends packets of another source until one is heard; fails the test after 60 s.
void knock(DatagramSink& sink, DatagramSource& source) {
  for (int number = 0; number < 600; ++number) {
    ASSERT_TRUE(send(sink, packet("knock@run", number)).ok());
    ASSERT_TRUE(sink.flush().ok());
    pollfd waiting{source.fileDescriptor(), POLLIN, 0};
    ::poll(&waiting, 1, 100);
    const auto batch = source.receive();
    ASSERT_TRUE(batch.has_value());
    if (!batch->empty()) return;
  }
  ADD_FAILURE() << "nothing is heard";
}

/// Waits for a sentence of maintain() that holds `text`; empty after 60 s.
std::string waitForNews(DatagramSource& source, std::string_view text) {
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (std::chrono::steady_clock::now() < give_up) {
    const auto said = source.maintain();
    if (said && said->find(text) != said->npos) return *said;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  ADD_FAILURE() << "never said: " << text;
  return {};
}

TEST(NatsSource, HearsTwentyThousandWithoutLossInOrder) {
  ROCINANTE_NEEDS_NATS_SERVER();
  const NatsServer server;
  const auto source = openSource(natsEndpoint(server.at("cell1"))).value();
  const auto sink = openSink(natsEndpoint(server.at("cell1"))).value();
  constexpr int kCount = 20'000;
  const auto before = std::chrono::system_clock::now();
  for (int i = 0; i < kCount; ++i) ASSERT_TRUE(send(*sink, packet("arm", i)).ok());
  ASSERT_TRUE(sink->flush().ok());
  const auto heard = hear(*source, kCount);
  ASSERT_EQ(heard.size(), std::size_t{kCount});
  WallTime last = before;
  for (int i = 0; i < kCount; ++i) {
    const Heard& each = heard[static_cast<std::size_t>(i)];
    ASSERT_EQ(each.payload, packet("arm", i));
    ASSERT_EQ(each.subject, "cell1.arm");
    ASSERT_GE(each.time, last);
    last = each.time;
  }
  EXPECT_EQ(source->droppedByNow().value(), 0U);
}

TEST(NatsSource, WildcardsChooseSubjects) {
  ROCINANTE_NEEDS_NATS_SERVER();
  const NatsServer server;
  const auto arms = openSource(natsEndpoint(server.at("*.arm"))).value();
  const auto second = openSource(natsEndpoint(server.at("cell2"))).value();
  const auto one = openSink(natsEndpoint(server.at("cell1"))).value();
  const auto two = openSink(natsEndpoint(server.at("cell2"))).value();
  for (const std::string source : {"gantry", "arm"}) {
    ASSERT_TRUE(send(*one, packet(source, 1)).ok());
    ASSERT_TRUE(one->flush().ok());
    ASSERT_TRUE(send(*two, packet(source, 2)).ok());
    ASSERT_TRUE(two->flush().ok());
  }
  const auto by_source = hear(*arms, 2);
  ASSERT_EQ(by_source.size(), 2U);
  EXPECT_EQ(by_source[0].subject, "cell1.arm");
  EXPECT_EQ(by_source[1].subject, "cell2.arm");
  const auto by_cell = hear(*second, 2);
  ASSERT_EQ(by_cell.size(), 2U);
  EXPECT_EQ(by_cell[0].subject, "cell2.gantry");
  EXPECT_EQ(by_cell[1].subject, "cell2.arm");
  const auto refused = openSink(natsEndpoint(server.at("cell1.*")));
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().what, "a subject to send to has no wildcards");
}

TEST(NatsSource, CountsWhatItsBufferCannotHold) {
  ROCINANTE_NEEDS_NATS_SERVER();
  const NatsServer server;
  const auto source =
      openNatsSource(natsEndpoint(server.at("a")), {.buffer_bytes = 100'000}).value();
  const auto sink = openSink(natsEndpoint(server.at("a"))).value();
  constexpr std::uint64_t kCount = 1'000;
  for (std::uint64_t i = 0; i < kCount; ++i) {
    ASSERT_TRUE(send(*sink, packet("arm", static_cast<int>(i))).ok());
  }
  ASSERT_TRUE(sink->flush().ok());
  std::uint64_t received = 0;
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  // Nothing is taken until so many were dropped that the rest fits.
  while (source->dropped() < kCount - 200 && std::chrono::steady_clock::now() < give_up) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  while (received + source->dropped() < kCount && std::chrono::steady_clock::now() < give_up) {
    received += source->receive().value().size();
  }
  EXPECT_GT(received, 100U);
  EXPECT_EQ(received + source->droppedByNow().value(), kCount);
}

TEST(NatsSource, SaysWhyAServerRefuses) {
  ROCINANTE_NEEDS_NATS_SERVER();
  test::TemporaryFolder folder;
  {
    std::ofstream file(folder / "server.conf");
    file << "authorization { users = [ { user: ada, password: s3cret },\n"
            "  { user: guest, password: guest, permissions: {\n"
            "    publish: { deny: \">\" }, subscribe: { deny: \"secret.>\" } } } ] }\n";
  }
  const NatsServer server({"-c", (folder / "server.conf").string()});
  const std::string name = "127.0.0.1:" + std::to_string(server.port());
  EXPECT_TRUE(openSource(natsEndpoint(server.at("cell1", "ada:s3cret@"))).ok());
  EXPECT_EQ(openSource(natsEndpoint(server.at("cell1", "ada:wrong@"))).error().text(),
            "the NATS server " + name + " refuses this user, token or these credentials (nats://" +
                name + "/cell1)");
  EXPECT_EQ(openSink(natsEndpoint(server.at("cell1"))).error().what,
            "the NATS server " + name + " refuses a client without user, token or credentials");
  const auto denied = openSource(natsEndpoint(server.at("secret", "guest:guest@")));
  ASSERT_FALSE(denied.ok());
  EXPECT_NE(denied.error().what.find("Permissions Violation for Subscription to \"secret.>\""),
            std::string::npos)
      << denied.error().what;
  const auto sink = openSink(natsEndpoint(server.at("cell1", "guest:guest@"))).value();
  ASSERT_TRUE(send(*sink, packet("arm", 1)).ok());
  const Status flushed = sink->flush();
  ASSERT_FALSE(flushed.ok());
  EXPECT_NE(flushed.error().what.find("Permissions Violation for Publish to \"cell1.arm\""),
            std::string::npos)
      << flushed.error().what;
}

/// As programs without --no-wait read it.
Endpoint waiting(const std::string& text) {
  Endpoint endpoint = natsEndpoint(text);
  endpoint.nats.waits = true;
  return endpoint;
}

TEST(NatsSource, AServerThatIsNotThereYetIsWaitedFor) {
  ROCINANTE_NEEDS_NATS_SERVER();
  NatsServer server;
  server.kill();
  const std::string port = std::to_string(server.port());
  const auto source = openSource(waiting(server.at("cell1"))).value();
  const auto sink = openSink(waiting(server.at("cell1"))).value();
  EXPECT_EQ(waitForNews(*source, "yet"),
            "no NATS server answers at 127.0.0.1:" + port + " yet; waiting for it");
  EXPECT_TRUE(sink->news().has_value());
  EXPECT_FALSE(sink->isReady().value());
  EXPECT_TRUE(source->receive().value().empty());
  server.start();
  EXPECT_EQ(waitForNews(*source, "connected"), "connected to " + server.at("cell1"));
  while (!sink->isReady().value()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  knock(*sink, *source);
}

TEST(NatsSource, AMessageIsTakenWhole) {
  ROCINANTE_NEEDS_NATS_SERVER();
  const NatsServer server;
  const auto source = openSource(natsEndpoint(server.at("cell1"))).value();
  const auto sink = openSink(natsEndpoint(server.at("cell1"))).value();
  const std::string large = "RK1 arm 1 -\nevent \"" + std::string(900'000, 'x') + "\"\n";
  ASSERT_TRUE(send(*sink, large).ok());
  ASSERT_TRUE(sink->flush().ok());
  const auto heard = hear(*source, 1);
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_EQ(heard[0].payload, large);
}

TEST(NatsSource, RefusesWhatItCannotDo) {
  EXPECT_EQ(openSource(natsEndpoint("nats://127.0.0.1:1/a")).error().what,
            "no NATS server answers at 127.0.0.1:1");
  InputOptions options;
  options.allow = AddressFilter::of({"10.0.0.0/8"}).value();
  EXPECT_EQ(openSource(natsEndpoint("nats://127.0.0.1:1/a"), options).error().kind,
            ErrorKind::bad_argument);
  EXPECT_EQ(openSink(natsEndpoint("jetstream://127.0.0.1:1/A")).error().kind,
            ErrorKind::bad_argument);
  EXPECT_EQ(UdpReceiver::open(natsEndpoint("nats://127.0.0.1:1/a")).error().what,
            "this takes udp:// endpoints only");
  EXPECT_EQ(openSource(natsEndpoint("nats://127.0.0.1:1/a?ca=/nowhere/ca.pem")).error().kind,
            ErrorKind::refused);
}

TEST(NatsSource, ConnectsAgainAndTheLossShowsInTheNumbers) {
  ROCINANTE_NEEDS_NATS_SERVER();
  NatsServer server;
  const auto source = openSource(natsEndpoint(server.at("cell1"))).value();
  int number = 0;
  {
    const auto sink = openSink(natsEndpoint(server.at("cell1"))).value();
    for (; number < 10; ++number) ASSERT_TRUE(send(*sink, packet("arm@run", number)).ok());
  }
  SessionState state;
  PacketTextDecoder decoder;
  LogTime now{};
  const auto apply = [&](const std::vector<Heard>& heard) {
    for (const Heard& each : heard) {
      state.apply(now += std::chrono::milliseconds(1), *decoder.decode(bytesOf(each.payload)));
    }
  };
  apply(hear(*source, 10));
  server.kill();
  const std::string name = server.at("cell1");
  EXPECT_EQ(waitForNews(*source, "lost"),
            "the connection of " + name + " is lost; nothing passes until it returns");
  // What a source sends meanwhile reaches nobody.
  number += 7;
  server.start();
  EXPECT_EQ(waitForNews(*source, "again"),
            "connected to " + name + " again; what was sent meanwhile is lost");
  const auto sink = openSink(natsEndpoint(server.at("cell1"))).value();
  // The server may know of the subscription a moment after the connection is there.
  knock(*sink, *source);
  ASSERT_TRUE(send(*sink, packet("arm@run", number)).ok());
  ASSERT_TRUE(sink->flush().ok());
  while (!HasFailure() && state.counts().at("arm").gap == 0) apply(hear(*source, 1));
  EXPECT_EQ(state.counts().at("arm").gap, 7U);
}

TEST(NatsSource, ASinkKeepsALittleForAServerThatIsAway) {
  ROCINANTE_NEEDS_NATS_SERVER();
  NatsServer server;
  const auto sink = openSink(natsEndpoint(server.at("cell1"))).value();
  ASSERT_TRUE(send(*sink, packet("arm", 0)).ok());
  ASSERT_TRUE(sink->flush().ok());
  server.kill();
  const std::string large = packet("arm", 1) + "# " + std::string(1'000, 'x') + "\n";
  Status sent;
  int taken = 0;
  // The library needs a moment to see it, and then keeps 4 MiB.
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (sent.ok() && taken < 100'000 && std::chrono::steady_clock::now() < give_up) {
    sent = send(*sink, large);
    ++taken;
  }
  ASSERT_FALSE(sent.ok());
  EXPECT_EQ(sent.error().what, "the NATS server 127.0.0.1:" + std::to_string(server.port()) +
                                   " is away, and 4 MiB already wait for it");
  EXPECT_GT(taken, 3'000);
  EXPECT_LT(taken, 6'000);
}

}  // namespace
}  // namespace rocinante
