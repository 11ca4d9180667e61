// Figure 2 of the system of 1996: two sources are combined, and retransmitted to two viewers and a
// recorder, over links of different speed. The links lose, repeat, reorder and delay.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "core/log/log_reader.h"
#include "core/net/udp_socket.h"
#include "core/packet/packet_text.h"
#include "core/session/timeline.h"
#include "core/source/source.h"
#include "core/transport/open_sink.h"
#include "core/transport/open_source.h"
#include "tests/support/fault_link.h"
#include "tests/support/programs.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;
using test::FaultLink;
using test::LinkFaults;
using test::Program;

Endpoint endpointOf(const std::string& text) {
  auto endpoint = Endpoint::parse(text);
  EXPECT_TRUE(endpoint.ok()) << text;
  return *endpoint;
}

LogTime logNow() {
  const auto now = std::chrono::system_clock::now().time_since_epoch();
  return LogTime(std::chrono::duration_cast<Nanoseconds>(now));
}

/// Items with their owners, and each source's RUN, SEQUENCE and TIME: the identity without the
/// times of arrival, which are a listener's own.
std::set<std::string> saidOf(const SessionState& state) {
  std::set<std::string> said;
  std::istringstream lines(state.identityText());
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("device ")) said.insert(line);
  }
  return said;
}

/// Joint values as a slow link has them: with four decimals.
std::set<std::string> coarse(const std::set<std::string>& said) {
  std::set<std::string> rounded;
  for (const std::string& line : said) {
    if (line.find(" joints ") == line.npos) {
      rounded.insert(line);
      continue;
    }
    std::istringstream words(line);
    std::string text;
    for (std::string word; words >> word;) {
      const bool is_number = word.find_first_not_of("0123456789.-") == word.npos;
      text += is_number ? fmt::format(" {:.4f}", std::stod(word)) : " " + word;
    }
    rounded.insert(text);
  }
  return rounded;
}

std::set<std::string> exactly(const std::set<std::string>& said) { return said; }

/// Whoever listens at an endpoint: folds what comes, in a thread.
class Listener {
 public:
  explicit Listener(const std::string& endpoint) {
    auto opened = openSource(endpointOf(endpoint));
    EXPECT_TRUE(opened.ok()) << (opened.ok() ? "" : opened.error().text());
    source_ = std::move(*opened);
    port_ = source_->boundAddress().port;
    thread_ = std::thread([this] { run(); });
  }
  ~Listener() {
    stop_ = true;
    thread_.join();
  }

  std::uint16_t port() const { return port_; }
  std::set<std::string> said() const {
    const std::lock_guard lock(mutex_);
    return saidOf(state_);
  }
  std::uint64_t heard() const { return heard_; }

 private:
  void run() {
    PacketTextDecoder decoder;
    while (!stop_) {
      pollfd waiting{source_->fileDescriptor(), POLLIN, 0};
      ::poll(&waiting, 1, 5);
      const auto received = source_->receive();
      if (received.ok()) {
        const std::lock_guard lock(mutex_);
        for (const ReceivedDatagram& datagram : *received) {
          const Packet* packet = decoder.decode(datagram.payload);
          ++heard_;
          if (packet != nullptr) state_.apply(logNow(), *packet);
        }
        (void)state_.takeEvents();
      }
      (void)source_->maintain();
    }
  }

  std::unique_ptr<DatagramSource> source_;
  std::uint16_t port_ = 0;
  mutable std::mutex mutex_;
  SessionState state_;
  std::atomic<std::uint64_t> heard_{0};
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

/// A six-joint arm and what belongs to it, at 60 Hz until it rests; then it only says again what
/// it said. Keeps the fold of what it sent: what a listener must arrive at.
class Speaker {
 public:
  Speaker(std::string name, const std::string& to, int number = 1)
      : name_(std::move(name)), run_(fmt::format("r{}", number)) {
    auto sink = openSink(endpointOf(to));
    EXPECT_TRUE(sink.ok());
    sink_ = std::move(*sink);
    thread_ = std::thread([this] { run(); });
  }
  ~Speaker() { silence(); }

  void rest() { resting_ = true; }
  void silence() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
  }
  std::set<std::string> said() const {
    const std::lock_guard lock(mutex_);
    return saidOf(state_);
  }

 private:
  bool send(std::span<std::byte> datagram) {
    const ByteView payload = datagram;
    {
      const std::lock_guard lock(mutex_);
      if (const Packet* packet = decoder_.decode(payload)) state_.apply(logNow(), *packet);
    }
    return sink_->send(std::span(&payload, 1)).ok();
  }

  void run() {
    SourceSettings settings;
    settings.source = name_;
    settings.run = run_;
    settings.restate = 1s;
    auto opened =
        Source::open(settings, [this](std::span<std::byte> bytes) { return send(bytes); });
    ASSERT_TRUE(opened.ok());
    Source& source = *opened;
    const SourceDevice arm = source.device(name_);
    const SourceDevice tray = source.device(name_ + "_tray");
    EXPECT_EQ(source.add(tray, "tray"), SourceResult::done);
    EXPECT_EQ(source.setColor({name_, "", false}, 0xFF8000FF), SourceResult::done);
    const auto began = std::chrono::steady_clock::now();
    for (std::uint64_t cycle = 0; !stop_; ++cycle) {
      if (!resting_) {
        std::vector<double> joints;
        for (int joint = 0; joint < 6; ++joint) {
          joints.push_back(std::sin(0.02 * static_cast<double>(cycle) + joint));
        }
        EXPECT_EQ(source.setJoints(arm, joints), SourceResult::done);
        // Comes and goes: whoever misses an `erase` must lose the line all the same.
        const std::string line = fmt::format("path{}", cycle / 30);
        if (cycle % 30 == 0) {
          const std::vector<Vec3> points{{0, 0, 0}, {1, 0, joints[0]}};
          EXPECT_EQ(source.drawLine(line, 0x00FF00FF, points), SourceResult::done);
        } else if (cycle % 30 == 20) {
          EXPECT_EQ(source.erase(line), SourceResult::done);
        }
      }
      (void)source.flush(
          std::chrono::time_point_cast<Nanoseconds>(std::chrono::system_clock::now()));
      std::this_thread::sleep_until(began + (cycle + 1) * 16667us);
    }
  }

  std::string name_, run_;
  std::unique_ptr<DatagramSink> sink_;
  PacketTextDecoder decoder_;
  mutable std::mutex mutex_;
  SessionState state_;
  std::atomic<bool> resting_{false}, stop_{false};
  std::thread thread_;
};

std::set<std::string> saidBy(const Speaker& a, const Speaker& b) {
  std::set<std::string> said = a.said();
  said.merge(b.said());
  return said;
}

/// Waits until the listener has what the speakers said last.
testing::AssertionResult arrives(
    const Listener& listener, const Speaker& a, const Speaker& b,
    std::set<std::string> (*as)(const std::set<std::string>&) = exactly) {
  const auto give_up = std::chrono::steady_clock::now() + 60s;
  std::set<std::string> wanted, had;
  while (std::chrono::steady_clock::now() < give_up) {
    had = as(listener.said());
    wanted = as(saidBy(a, b));
    if (had == wanted) return testing::AssertionSuccess();
    std::this_thread::sleep_for(2ms);
  }
  auto failure = testing::AssertionFailure() << "after " << listener.heard() << " datagrams\n";
  for (const std::string& line : wanted) {
    if (!had.contains(line)) failure << "- " << line << "\n";
  }
  for (const std::string& line : had) {
    if (!wanted.contains(line)) failure << "+ " << line << "\n";
  }
  return failure;
}

/// The address that a relay serves, from its first lines.
std::string servedBy(Program& relay) {
  const std::string line = relay.waitForLine("serving at");
  const std::size_t at = line.find("127.0.0.1:");
  EXPECT_NE(at, line.npos) << line;
  return at == line.npos ? std::string() : line.substr(at, line.find_first_of(" ,;", at) - at);
}

std::uint16_t portOf(const std::string& address) {
  return static_cast<std::uint16_t>(std::stoi(address.substr(address.rfind(':') + 1)));
}

/// A port of loopback that is free now.
std::uint16_t freeRelayPort() {
  const auto receiver = UdpReceiver::open(endpointOf("127.0.0.1:0"));
  return receiver->boundAddress().port;
}

TEST(Figure2, EveryoneArrivesAtWhatTheSourcesSaid) {
  const test::TemporaryFolder folder;
  const std::string arm_at = fmt::format("127.0.0.1:{}", freeRelayPort());
  const std::string gantry_at = fmt::format("127.0.0.1:{}", freeRelayPort());
  const LinkFaults bad{.loss = 0.2, .duplicate = 0.05, .delay = 10ms, .jitter = 30ms};
  const LinkFaults slow{.loss = 0.05, .delay = 50ms, .bits_per_second = 28'800};

  // The second viewer is at the end of a telephone line.
  const Listener far_viewer("127.0.0.1:0");
  FaultLink telephone(far_viewer.port(), slow);
  Program first =
      Program::start("rocinante-relay", {"--from", arm_at, "--from", gantry_at, "--serve",
                                         "127.0.0.1:0", "--restate", "1s", "--name", "plant"});
  const std::string plant = servedBy(first);
  Program modem = Program::start(
      "rocinante-relay",
      {"--from", "subscribe://" + plant, "--to", fmt::format("127.0.0.1:{}", telephone.port()),
       "--bandwidth", "28.8k", "--restate", "1s", "--name", "modem"});
  FaultLink link(portOf(plant), bad);
  Program second = Program::start(
      "rocinante-relay", {"--from", fmt::format("subscribe://127.0.0.1:{}", link.port()), "--serve",
                          "127.0.0.1:0", "--restate", "1s", "--name", "office"});
  const std::string served = servedBy(second);
  const Listener near_viewer("subscribe://" + served);
  const std::string log = (folder / "session.mcap").string();
  Program recorder = Program::start("rocinante-record", {"subscribe://" + served, "-o", log});

  Speaker arm("arm", arm_at);
  Speaker gantry("gantry", gantry_at);
  std::this_thread::sleep_for(5s);
  arm.rest();
  gantry.rest();
  link.setFaults({});
  telephone.setFaults({.bits_per_second = 28'800});
  EXPECT_TRUE(arrives(near_viewer, arm, gantry));
  EXPECT_TRUE(arrives(far_viewer, arm, gantry, coarse));
  EXPECT_GT(link.counts().lost, 0U);
  EXPECT_EQ(telephone.counts().overflowed, 0U) << "the relay sends more than the line takes";
  // Somebody who comes now is greeted with everything.
  const Listener late_viewer("subscribe://" + served);
  EXPECT_TRUE(arrives(late_viewer, arm, gantry));

  arm.silence();
  gantry.silence();
  const std::set<std::string> last = saidBy(arm, gantry);
  EXPECT_TRUE(arrives(near_viewer, arm, gantry));
  EXPECT_TRUE(arrives(far_viewer, arm, gantry, coarse));
  EXPECT_EQ(recorder.stop().exit_code, 0);
  EXPECT_EQ(second.stop().exit_code, 0);
  EXPECT_EQ(modem.stop().exit_code, 0);
  EXPECT_EQ(first.stop().exit_code, 0);
  auto reader = LogReader::open(log);
  ASSERT_TRUE(reader.ok()) << reader.error().text();
  auto session = Timeline::of(std::move(*reader));
  const auto end = session.stateAt(session.end());
  ASSERT_TRUE(end.ok());
  EXPECT_EQ(saidOf(**end), last);
}

/// Seconds of coming and going: short in CI, a minute in scripts/nightly.
std::chrono::seconds longEnough() {
  return std::chrono::seconds(std::getenv("ROCINANTE_LONG") != nullptr ? 60 : 6);
}

TEST(Figure2, ListenersComeAndGoWhileEverythingIsRestarted) {
  std::mt19937 random(2024);
  const std::string arm_at = fmt::format("127.0.0.1:{}", freeRelayPort());
  const std::string gantry_at = fmt::format("127.0.0.1:{}", freeRelayPort());
  const std::string served = fmt::format("127.0.0.1:{}", freeRelayPort());
  const auto startRelay = [&] {
    Program relay =
        Program::start("rocinante-relay", {"--from", arm_at, "--from", gantry_at, "--serve", served,
                                           "--restate", "1s", "--name", "hub"});
    servedBy(relay);
    return relay;
  };
  Program relay = startRelay();
  std::array<int, 2> runs{1, 1};
  std::array<std::unique_ptr<Speaker>, 2> speakers{std::make_unique<Speaker>("arm", arm_at),
                                                   std::make_unique<Speaker>("gantry", gantry_at)};
  std::vector<std::unique_ptr<Listener>> listeners;
  const auto below = [&](std::size_t count) {
    return std::uniform_int_distribution<std::size_t>(0, count - 1)(random);
  };
  const auto end = std::chrono::steady_clock::now() + longEnough();
  while (std::chrono::steady_clock::now() < end) {
    const std::size_t choice = below(20);
    if (choice == 0) {
      relay.signal(SIGKILL);
      relay.finish();
      relay = startRelay();
    } else if (choice == 1) {
      const std::size_t which = below(2);
      speakers[which].reset();
      speakers[which] = std::make_unique<Speaker>(which == 0 ? "arm" : "gantry",
                                                  which == 0 ? arm_at : gantry_at, ++runs[which]);
    } else if (choice < 6 && !listeners.empty()) {
      listeners.erase(listeners.begin() + static_cast<std::ptrdiff_t>(below(listeners.size())));
    } else if (listeners.size() < 50) {
      listeners.push_back(std::make_unique<Listener>("subscribe://" + served));
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(10 + below(60)));
  }
  while (listeners.size() < 50) {
    listeners.push_back(std::make_unique<Listener>("subscribe://" + served));
  }
  for (const auto& speaker : speakers) speaker->rest();
  for (const auto& listener : listeners)
    EXPECT_TRUE(arrives(*listener, *speakers[0], *speakers[1]));
}

std::set<std::string> itemsOf(const std::set<std::string>& said) {
  std::set<std::string> items;
  for (const std::string& line : said) {
    if (line.starts_with("item ")) items.insert(line);
  }
  return items;
}

/// A player jumps back at each turn: what came after the jump must go, also behind a relay.
TEST(Figure2, APlayersTurnsAndJumpsArriveBehindARelay) {
  const std::string log = std::string(ROCINANTE_SOURCE_DIR) + "/examples/demo/session.mcap";
  auto reader = LogReader::open(log);
  ASSERT_TRUE(reader.ok()) << reader.error().text();
  auto session = Timeline::of(std::move(*reader));
  const std::string player_at = fmt::format("127.0.0.1:{}", freeRelayPort());
  Program relay = Program::start("rocinante-relay", {"--from", player_at, "--serve", "127.0.0.1:0",
                                                     "--restate", "500ms", "--name", "hub"});
  const std::string served = servedBy(relay);
  const Listener whole("subscribe://" + served);
  const Listener seldom("subscribe://" + served + "?rate=20");
  // Forwards to the end, then back to the middle in three turns.
  const std::vector<std::pair<std::string, Nanoseconds>> parts = {{"16s", 20s}, {"4s", 7s}};
  for (const auto& [from, until] : parts) {
    Program player = Program::start(
        "rocinante-play", {log, "--to", player_at, "--from", from, "--until",
                           fmt::format("{}s", std::chrono::duration<double>(until).count()),
                           "--loop", "3", "--speed", "10"});
    EXPECT_EQ(player.finish().exit_code, 0);
    const auto state = session.stateAt(session.origin() + until - 1ns);
    ASSERT_TRUE(state.ok());
    const std::set<std::string> wanted = itemsOf(saidOf(**state));
    for (const Listener* listener : {&whole, &seldom}) {
      const auto give_up = std::chrono::steady_clock::now() + 60s;
      while (itemsOf(listener->said()) != wanted && std::chrono::steady_clock::now() < give_up) {
        std::this_thread::sleep_for(5ms);
      }
      EXPECT_EQ(itemsOf(listener->said()), wanted) << (listener == &whole ? "whole" : "filtered");
    }
  }
}

}  // namespace
}  // namespace rocinante
