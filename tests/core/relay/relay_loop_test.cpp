// Relays that form a loop, by a clock of the test: whatever header a source writes, at whatever
// rate and delay, nothing goes round, nobody shows an older state, and a restart passes.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/relay/relay.h"
#include "tests/core/packet/fold_text.h"

namespace rocinante {
namespace {

using namespace std::chrono_literals;

constexpr LogTime kLoopBegin(1'700'000'000s);

/// Relays, the links between their outputs and inputs, and a listener at each.
class RelayNet {
 public:
  struct Node {
    explicit Node(const std::string& name) : relay({name, "run"}) {}
    Relay relay;
    test::TextFold listener;
    Relay::OutputId listened = 0;
    double shown = -1;
    int went_back = 0;
    std::vector<std::string> heard;  ///< by the listener
  };

  std::size_t add(const std::string& name) {
    nodes.push_back(std::make_unique<Node>(name));
    names_.push_back(name);
    nodes.back()->listened = nodes.back()->relay.open({}, now);
    return nodes.size() - 1;
  }
  /// Without `is_known` nobody learns who sent it, as with NATS.
  void link(std::size_t from, std::size_t to, Nanoseconds delay, RelayOutputOptions options = {},
            bool is_known = true) {
    const auto output = nodes[from]->relay.open(std::move(options), now);
    links_.push_back({from, to, output, delay, is_known ? links_.size() + 100 : kUnknownWay});
  }
  /// The relay forgets everything, and has the same outputs.
  void restart(std::size_t at) {
    auto node = std::make_unique<Node>(names_[at]);
    node->listened = node->relay.open({}, now);
    for (Link& link : links_) {
      if (link.from == at) link.output = node->relay.open({}, now);
    }
    nodes[at] = std::move(node);
  }
  void send(std::size_t to, const std::string& text, ArrivalWay way = 1) {
    under_way_.emplace(now, Datagram{to, text, way});
    passTime(Nanoseconds(0));
  }
  /// Lets everything happen that is due in this time.
  void passTime(Nanoseconds time) {
    const LogTime until = now + time;
    for (;;) {
      LogTime next = LogTime::max();
      for (const auto& node : nodes) next = std::min(next, node->relay.due());
      if (!under_way_.empty()) next = std::min(next, under_way_.begin()->first);
      if (next > until) break;
      now = std::max(now, next);
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (nodes[i]->relay.due() > now) continue;
        nodes[i]->relay.advance(now);
        deliver(i);
      }
      while (!under_way_.empty() && under_way_.begin()->first <= now) {
        const Datagram datagram = std::move(under_way_.begin()->second);
        under_way_.erase(under_way_.begin());
        nodes[datagram.to]->relay.receive(bytesOf(datagram.text), now, datagram.way);
        deliver(datagram.to);
      }
      if (on_links > kStorm) return;
    }
    now = until;
  }
  bool isStorm() const { return on_links > kStorm; }

  std::vector<std::unique_ptr<Node>> nodes;
  LogTime now = kLoopBegin;
  std::size_t on_links = 0;  ///< datagrams that entered one
  LogTime last{};            ///< when

 private:
  static constexpr std::size_t kStorm = 200'000;
  struct Link {
    std::size_t from, to;
    Relay::OutputId output;
    Nanoseconds delay;
    ArrivalWay way;
  };
  struct Datagram {
    std::size_t to;
    std::string text;
    ArrivalWay way;
  };

  void deliver(std::size_t from) {
    Node& node = *nodes[from];
    for (const Relay::Outgoing& each : node.relay.outgoing()) {
      const std::string text(textOf(each.payload));
      const auto is_its = [&](Relay::OutputId id) {
        return each.output == id || (each.output == Relay::kEveryWhole && node.relay.isWhole(id));
      };
      if (is_its(node.listened)) hear(node, text);
      for (const Link& link : links_) {
        if (link.from != from || !is_its(link.output)) continue;
        under_way_.emplace(now + link.delay, Datagram{link.to, text, link.way});
        ++on_links;
        last = now + link.delay;
      }
    }
    node.relay.clearOutgoing();
  }
  void hear(Node& node, const std::string& text) {
    node.heard.push_back(text);
    node.listener.fold(secondsOf(now - kLoopBegin), text);
    const auto& joints = node.listener.device("arm").joints;
    if (!joints) return;
    if (joints->value[0] < node.shown) ++node.went_back;
    node.shown = joints->value[0];
  }

  std::vector<std::string> names_;
  std::vector<Link> links_;
  std::multimap<LogTime, Datagram> under_way_;
};

/// Header forms of docs/packet-format.md: {n} is the SEQUENCE, {t} the TIME in seconds.
const std::vector<std::string>& headerForms() {
  static const std::vector<std::string> kForms = [] {
    std::vector<std::string> forms;
    for (const char* source : {"arm", "arm@r%201"}) {
      for (const char* sequence : {"{n}", "-"}) {
        for (const char* time : {"-", "{t}"}) {
          for (const char* words :
               {"", " restated", " restated part=r{n}:1/1", " part=r{n}:1/1", " shiny colour=red",
                " by=player restated", " by=player restated part=p{n}:1/1 reset", " reset",
                " via=plant:3:{n}", " through=x,y", " at=17{n}"}) {
            forms.push_back(fmt::format("RK1 {} {} {}{}", source, sequence, time, words));
          }
        }
      }
    }
    return forms;
  }();
  return kForms;
}

std::string written(std::string form, int n, double seconds) {
  const auto put = [&](std::string_view word, const std::string& value) {
    for (std::size_t at = form.find(word); at != form.npos; at = form.find(word)) {
      form.replace(at, word.size(), value);
    }
  };
  put("{n}", std::to_string(n));
  put("{t}", fmt::format("{:.6f}", 1000 + seconds));
  std::string text = form + fmt::format("\njoints arm {}\n", n);
  if (form.find(" at=") != form.npos) text += "sig 9d24e2eeaf27c2a0 bm90IGEgc2lnbmF0dXJl\n";
  return text;
}

struct Pace {
  double hz;
  Nanoseconds delay;
};

/// Enough that more than 64 datagrams are under way where the delay has room for them.
int datagramsOf(const Pace& pace) {
  return std::clamp(static_cast<int>(pace.hz * secondsOf(pace.delay) * 1.5) + 80, 3, 2000);
}

const std::vector<Pace> kPaces = {{1, 0ms},      {1, 500ms},  {10, 250ms},
                                  {60, 20ms},    {1000, 0ms}, {1000, 100ms},
                                  {1000, 500ms}, {6000, 5ms}, {6000, 100ms}};

/// A source speaks to node 0, ends, and the net falls silent.
void speakAndEnd(RelayNet& net, const std::string& form, const Pace& pace) {
  const int count = pace.hz < 5 ? 4 : datagramsOf(pace);
  const Nanoseconds period(static_cast<std::int64_t>(1e9 / pace.hz));
  for (int n = 0; n < count && !net.isStorm(); ++n) {
    net.send(0, written(form, n, secondsOf(net.now - kLoopBegin)));
    net.passTime(period);
  }
  ASSERT_FALSE(net.isStorm()) << "it goes round";
  for (const auto& node : net.nodes) EXPECT_EQ(node->went_back, 0) << "an older state is shown";
}

TEST(RelayLoop, TwoRelaysFallSilentWithTheirSource) {
  for (const std::string& form : headerForms()) {
    for (const Pace& pace : kPaces) {
      SCOPED_TRACE(fmt::format("{} at {}/s, {} s each way", form, pace.hz, secondsOf(pace.delay)));
      RelayNet net;
      net.add("a");
      net.add("b");
      net.link(0, 1, pace.delay);
      net.link(1, 0, pace.delay);
      speakAndEnd(net, form, pace);
      const LogTime ended = net.now;
      net.passTime(60s);
      EXPECT_LE(net.last, ended + 2 * pace.delay);
      for (const auto& node : net.nodes) {
        EXPECT_EQ(node->went_back, 0);
        EXPECT_EQ(node->shown, net.nodes[0]->shown);
      }
      const std::size_t passed = net.nodes[0]->heard.size();
      EXPECT_EQ(net.on_links, 2 * passed) << "each once by each link";
      if (::testing::Test::HasFailure()) return;
    }
  }
}

TEST(RelayLoop, ARingAndAMeshOfThreeToo) {
  for (const std::string& form : headerForms()) {
    for (const bool is_mesh : {false, true}) {
      for (const Pace& pace : {Pace{1, 100ms}, Pace{60, 30ms}, Pace{2000, 100ms}}) {
        SCOPED_TRACE(fmt::format("{} at {}/s, mesh: {}", form, pace.hz, is_mesh));
        RelayNet net;
        for (const char* name : {"a", "b", "c"}) net.add(name);
        for (std::size_t i = 0; i < 3; ++i) {
          // One way is much longer than the others.
          const Nanoseconds delay = i == 2 ? 5 * pace.delay : pace.delay;
          net.link(i, (i + 1) % 3, delay);
          if (is_mesh) net.link((i + 1) % 3, i, delay);
        }
        speakAndEnd(net, form, pace);
        const LogTime ended = net.now;
        net.passTime(60s);
        EXPECT_LE(net.last, ended + 8 * pace.delay);
        for (const auto& node : net.nodes) {
          EXPECT_EQ(node->went_back, 0);
          EXPECT_EQ(node->shown, net.nodes[0]->shown);
        }
        if (::testing::Test::HasFailure()) return;
      }
    }
  }
}

// What a filtering relay sends back has bytes of its own.
TEST(RelayLoop, FilteredOutputsAreRecognised) {
  RelayOutputOptions rated, slow, some;
  rated.pacing.interval = 50ms;
  slow.bytes_per_second = 20'000;
  some.filters.push_back({{"*"}, {}, ~0U});
  const std::vector<RelayOutputOptions> kinds = {{}, rated, slow, some};
  for (const char* form :
       {"RK1 arm {n} -", "RK1 arm@r {n} {t}", "RK1 arm - -", "RK1 arm {n} {t}"}) {
    for (std::size_t there = 0; there < kinds.size(); ++there) {
      for (std::size_t back = 1; back < kinds.size(); ++back) {
        for (const Pace& pace : {Pace{1, 100ms}, Pace{60, 100ms}, Pace{2000, 100ms}}) {
          SCOPED_TRACE(fmt::format("{} at {}/s, outputs {} and {}", form, pace.hz, there, back));
          RelayNet net;
          net.add("a");
          net.add("b");
          net.link(0, 1, pace.delay, kinds[there]);
          net.link(1, 0, pace.delay, kinds[back]);
          speakAndEnd(net, form, pace);
          net.passTime(10s);
          EXPECT_EQ(net.nodes[0]->shown, net.nodes[1]->shown);
          // What passes now are restatements: one every two seconds by each output.
          const std::size_t before = net.on_links;
          net.passTime(60s);
          EXPECT_LE(net.on_links, before + 2 * 31U * 2);
          for (const auto& node : net.nodes) EXPECT_EQ(node->went_back, 0);
          if (::testing::Test::HasFailure()) return;
        }
      }
    }
  }
}

TEST(RelayLoop, CountsAndReportsWhatComesBack) {
  RelayNet net;
  net.add("a");
  net.add("b");
  net.link(0, 1, 100ms);
  net.link(1, 0, 3ms);
  net.send(0, "RK1 arm 0 -\njoints arm 1\n");
  net.passTime(1s);
  const Relay& relay = net.nodes[0]->relay;
  EXPECT_EQ(relay.counts().looped, 1U);
  ASSERT_TRUE(relay.loop().has_value());
  EXPECT_EQ(relay.loop()->source, "arm");
  EXPECT_EQ(relay.loop()->after, 103ms);
  EXPECT_EQ(
      relay.loop()->text(),
      "datagrams of arm that this relay passed on come back after 0.103 s: relays form a loop, "
      "or the source is heard by two ways; what comes back is dropped and counted as looped");
  EXPECT_FALSE(net.nodes[1]->relay.loop().has_value());

  RelayNet named;
  named.add("a");
  named.add("b");
  named.link(0, 1, 1ms);
  named.link(1, 0, 1ms);
  named.send(0, "RK1 arm - -\njoints arm 1\n");
  named.passTime(1s);
  ASSERT_TRUE(named.nodes[0]->relay.loop().has_value());
  EXPECT_EQ(named.nodes[0]->relay.loop()->text(),
            "this relay hears itself: its own datagrams about arm come back; what comes back is "
            "dropped and counted as looped");
}

// A source without RUN and TIME says the same bytes after it was switched off and on.
TEST(RelayLoop, TheSameBytesByTheSameWayAreARestart) {
  for (const bool in_loop : {false, true}) {
    RelayNet net;
    net.add("a");
    net.add("b");
    net.link(0, 1, 20ms);
    if (in_loop) net.link(1, 0, 20ms);
    for (int run = 0; run < 3; ++run) {
      for (int n = 0; n < 100; ++n) {
        net.nodes[0]->shown = net.nodes[1]->shown = -1;
        net.send(0, written("RK1 arm {n} -", n, 0));
        net.passTime(1ms);
      }
    }
    net.passTime(1s);
    EXPECT_EQ(net.nodes[0]->heard.size(), 300U);
    EXPECT_EQ(net.nodes[1]->heard.size(), 300U) << in_loop;
    EXPECT_EQ(net.nodes[0]->relay.state().counts().at("arm").restarts, 2U);
  }
}

// A program that writes SEQUENCE 0 always.
TEST(RelayLoop, AlwaysTheSameNumberPassesAsOften) {
  RelayNet net;
  net.add("a");
  net.add("b");
  net.link(0, 1, 20ms);
  net.link(1, 0, 20ms);
  for (int i = 0; i < 200; ++i) {
    net.nodes[0]->shown = net.nodes[1]->shown = -1;
    net.send(0, fmt::format("RK1 arm 0 -\njoints arm {}\n", i % 2));
    net.passTime(10ms);
  }
  net.passTime(1s);
  EXPECT_EQ(net.nodes[1]->heard.size(), 200U);
  EXPECT_EQ(net.on_links, 400U);
  EXPECT_EQ(net.nodes[1]->listener.device("arm").joints->value[0], 1);
}

TEST(RelayLoop, TheSameBytesFromAnotherPortPassAfterTwoSeconds) {
  RelayNet net;
  net.add("a");
  net.send(0, "RK1 arm 0 -\njoints arm 1\n", 1);
  net.passTime(100ms);
  net.send(0, "RK1 arm 1 -\njoints arm 2\n", 1);
  net.passTime(100ms);
  net.send(0, "RK1 arm 0 -\njoints arm 1\n", 2);
  EXPECT_EQ(net.nodes[0]->heard.size(), 2U);
  EXPECT_EQ(net.nodes[0]->relay.counts().looped, 1U);
  // Other bytes are a restart at once.
  net.send(0, "RK1 arm 0 -\njoints arm 3\n", 2);
  EXPECT_EQ(net.nodes[0]->heard.size(), 3U);
  net.passTime(2200ms);
  net.send(0, "RK1 arm 0 -\njoints arm 1\n", 3);
  EXPECT_EQ(net.nodes[0]->heard.size(), 4U);
}

// Restarts of a source with RUN, in a loop where what it said before is still under way.
TEST(RelayLoop, ARestartPassesWhileTheRunBeforeComesBack) {
  for (const char* form : {"RK1 arm@{r} {n} {t}", "RK1 arm@{r} {n} -", "RK1 arm {n} {t}"}) {
    RelayNet net;
    net.add("a");
    net.add("b");
    net.link(0, 1, 200ms);
    net.link(1, 0, 200ms);
    int value = 0;
    for (int run = 0; run < 4; ++run) {
      for (int n = 0; n < 500; ++n, ++value) {
        std::string text = written(form, n, secondsOf(net.now - kLoopBegin));
        if (const auto at = text.find("{r}"); at != text.npos) {
          text.replace(at, 3, "r" + std::to_string(run));
        }
        text = text.substr(0, text.find('\n')) + fmt::format("\njoints arm {}\n", value);
        net.send(0, text);
        net.passTime(1ms);
      }
    }
    net.passTime(10s);
    EXPECT_FALSE(net.isStorm());
    for (const auto& node : net.nodes) {
      EXPECT_EQ(node->went_back, 0) << form;
      EXPECT_EQ(node->shown, 1999) << form;
      EXPECT_EQ(node->heard.size(), 2000U) << form;
    }
  }
}

// A player at the end of its log goes back, in a loop that still brings the lap before.
TEST(RelayLoop, APlayersLapsPassOnce) {
  for (const bool is_known : {true, false}) {
    RelayNet net;
    net.add("a");
    net.add("b");
    net.link(0, 1, 100ms, {}, is_known);
    net.link(1, 0, 100ms, {}, is_known);
    for (int lap = 0; lap < 4; ++lap) {
      for (auto& node : net.nodes) node->shown = -1;
      net.send(0, fmt::format("RK1 arm@r 0 1 restated part=l{}:1/1 by=player reset\njoints arm 0\n",
                              lap));
      for (int n = 1; n < 1500; ++n) {
        net.send(0, written("RK1 arm@r {n} {t}", n, n));
        net.passTime(1ms);
        EXPECT_TRUE(!is_known || net.nodes[0]->shown == n) << lap;
        if (n == 110) net.nodes[1]->shown = -1;
      }
    }
    net.passTime(10s);
    EXPECT_FALSE(net.isStorm());
    EXPECT_LE(net.last, net.now - 9s);
    for (const auto& node : net.nodes) EXPECT_EQ(node->shown, 1499);
  }
}

// Nobody knows who sends: the same bytes that come again within two seconds are an echo.
TEST(RelayLoop, LoopsWithoutSendersEndToo) {
  for (const std::string& form : headerForms()) {
    if (form.find("through=") != form.npos) continue;
    for (const Pace& pace : {Pace{1, 100ms}, Pace{2000, 100ms}}) {
      SCOPED_TRACE(form);
      RelayNet net;
      net.add("a");
      net.add("b");
      net.link(0, 1, pace.delay, {}, false);
      net.link(1, 0, pace.delay, {}, false);
      speakAndEnd(net, form, pace);
      const LogTime ended = net.now;
      net.passTime(60s);
      EXPECT_LE(net.last, ended + 2 * pace.delay);
      if (::testing::Test::HasFailure()) return;
    }
  }
}

// A relay that has just started is brought by the long way what the short way brought before.
TEST(RelayLoop, ARelayThatStartsAnewShowsNothingOlder) {
  for (const char* form : {"RK1 arm@r {n} -", "RK1 arm {n} {t}"}) {
    SCOPED_TRACE(form);
    RelayNet net;
    for (const char* name : {"a", "b", "c"}) net.add(name);
    net.link(0, 1, 1ms);
    net.link(0, 2, 400ms);
    net.link(1, 2, 1ms);
    net.link(2, 0, 1ms);
    for (int n = 0; n < 3000; ++n) {
      if (n % 1000 == 999) net.restart(2);
      net.send(0, written(form, n, secondsOf(net.now - kLoopBegin)));
      net.passTime(1ms);
    }
    net.passTime(10s);
    EXPECT_FALSE(net.isStorm());
    for (const auto& node : net.nodes) {
      EXPECT_EQ(node->went_back, 0);
      EXPECT_EQ(node->shown, 2999);
    }
  }
}

}  // namespace
}  // namespace rocinante
