// Whatever a session says, and whatever is lost: listeners come to the relay's state.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>
#include <tuple>

#include "tests/core/packet/random_session.h"
#include "tests/core/relay/relay_support.h"

namespace rocinante {
namespace {

using test::identityLines;
using test::itemsAndSources;
using test::RandomSession;
using test::RelayedListeners;

struct RelayCase {
  RelayOutputOptions options;
  std::function<bool(const std::string&)> passes;  ///< a line of the identity
};

bool isItemOrSource(const std::string& line) { return !line.starts_with("device "); }

std::vector<RelayCase> cases() {
  std::vector<RelayCase> all(6);
  for (RelayCase& each : all) each.passes = isItemOrSource;
  all[1].options.pacing.interval = std::chrono::milliseconds(100);
  all[2].options.pacing.min_change = {400, 400, 1, {{"*", 400}}};
  all[2].options.pacing.interval = std::chrono::milliseconds(50);
  all[3].options.filters.push_back({{"a"}, {}, ~0U});
  all[3].passes = [](const std::string& line) {
    return line.starts_with("item a ") || line.starts_with("source a");
  };
  all[4].options.filters.push_back({{}, {}, statementKindsOf("pose").value()});
  all[4].passes = [](const std::string& line) {
    return line.starts_with("source ") || line.find(" pose ") != std::string::npos;
  };
  all[5].options.filters.push_back({{}, {"tank"}, ~0U});
  all[5].options.pacing.interval = std::chrono::milliseconds(30);
  all[5].passes = [](const std::string& line) {
    std::istringstream words(line);
    std::string what, owner, kind, name;
    words >> what >> owner >> kind >> name;
    const bool of_path = kind == "show" || kind == "hide" || kind == "color" || kind == "signal";
    const bool of_device = kind == "add" || kind == "remove" || kind == "joints" ||
                           kind == "joint" || kind == "order" || kind == "pose";
    if (what != "item" || of_device) return what == "source" || name == "tank";
    if (!of_path || name.starts_with("layer/") || name == "-") return true;
    return name.substr(0, name.find('/')) == "tank";
  };
  return all;
}

RC_GTEST_PROP(RelayProperty, ListenersHaveTheStateTwoRestatementsAfterTheLossEnds,
              (std::uint64_t seed)) {
  RandomSession session(seed);
  std::mt19937_64 random(seed);
  RelayedListeners net;
  const std::vector<RelayCase> all = cases();
  bool is_lossy = true;
  std::vector<Relay::OutputId> ids;
  for (const RelayCase& each : all) {
    ids.push_back(net.open(each.options));
    net.listeners[ids.back()].loses = [&] { return is_lossy && random() % 5 == 0; };
  }
  for (int i = 0; i < 300; ++i) {
    const auto datagram = session.next();
    net.receive(datagram.seconds, datagram.text);
  }
  is_lossy = false;
  net.relay.greet(ids[0]);
  net.passTime(net.now() + 4.5);
  for (std::size_t i = 0; i < all.size(); ++i) {
    // A whole listener hears no `reset` of the relay: it may wait for a source's next number.
    if (i == 0) continue;
    const std::string expected = identityLines(net.relay.state(), all[i].passes);
    const std::string came = identityLines(net.listeners[ids[i]].fold.state, isItemOrSource);
    if (came != expected) RC_LOG() << "output " << i;
    RC_ASSERT(came == expected);
  }
}

// What a filter does not let through changes its count: whatever is inserted into a packet, an
// output sends more, or has left out more.
RC_GTEST_PROP(RelayProperty, WhatIsInsertedIsSentOrCounted, (std::uint64_t seed)) {
  std::mt19937_64 random(seed);
  const std::vector<std::string> inserts = {
      "joints inserted 1",
      "joint inserted a=1",
      "pose inserted 0 0 0 0 0 0 1",
      "add inserted m",
      "remove inserted",
      "show inserted",
      "hide layer/inserted",
      "color inserted #ff0000",
      "line inserted #ff0000 0 0 0",
      "points inserted #ff0000 0 0 0",
      "label inserted 0 0 0 \"x\"",
      "erase inserted",
      "event \"inserted\"",
      "view inserted 0 0 1 0 0 0 45",
      "order inserted a b",
      "signal inserted load 1 kg",
      "signals inserted load=1 busy=true",
      "signal - mode \"inserted\"",
      "signal inserted mode default",
      "wobble inserted",
      "joints inserted nan",
      "pose inserted 0 0 0 0 0 0 0",
  };
  const std::string insert = inserts[random() % inserts.size()];
  const bool is_slow = seed % 3 == 0;
  // A slow output tells an order with the values that need it.
  const bool needs_values = is_slow && insert.starts_with("order");
  RelayFilter filter;
  if (random() % 2 == 0) filter.devices = {random() % 2 == 0 ? "other" : "inserted"};
  if (random() % 2 == 0) filter.sources = {random() % 2 == 0 ? "a" : "z"};
  if (random() % 2 == 0) filter.kinds = statementKindsOf("pose").value();
  if (random() % 2 == 0) filter.signals = {"inserted load"};
  const auto outcome = [&](bool is_inserted) {
    RelayedListeners net;
    RelayOutputOptions options;
    options.filters.push_back(filter);
    if (is_slow) options.bytes_per_second = 1e6;
    const auto id = net.open(std::move(options));
    RandomSession session(seed);
    for (int i = 0; i < 20; ++i) net.receive(1 + i * 0.01, session.next().text);
    net.receive(2, "RK1 a@inserting 0 -\npose arm 0 0 1 0 0 0 1\n" +
                       (is_inserted ? insert + "\n" : std::string()) +
                       (needs_values ? "joints inserted 1 2\n" : ""));
    net.passTime(2.1);
    std::string all;
    for (const std::string& each : net.listeners[id].heard) all += each;
    const FilteredOutCounts counts = net.relay.filteredOut(id);
    return std::tuple(all, counts.stopped, counts.signals, counts.unreadable);
  };
  RC_ASSERT(outcome(true) != outcome(false));
}

RC_GTEST_PROP(RelayProperty, AWholeListenerThatLosesNothingHasTheIdentity, (std::uint64_t seed)) {
  RandomSession session(seed);
  RelayedListeners net;
  const auto id = net.open();
  for (int i = 0; i < 300; ++i) {
    const auto datagram = session.next();
    net.receive(datagram.seconds, datagram.text);
    RC_ASSERT(net.listeners[id].fold.state.sameAs(net.relay.state()));
  }
}

RC_GTEST_PROP(RelayProperty, ConflationNeverGoesBack, (std::uint64_t seed)) {
  std::mt19937_64 random(seed);
  RelayedListeners net;
  RelayOutputOptions options;
  options.pacing.interval = std::chrono::milliseconds(1 + random() % 200);
  if (random() % 2 == 0) options.bytes_per_second = 2000 + random() % 20'000;
  const auto id = net.open(options);
  std::map<std::string, double> last;
  std::size_t read = 0;
  for (int i = 1; i < 300; ++i) {
    const std::string device = "d" + std::to_string(random() % 4);
    net.receive(1 + i * 0.005, "RK1 s " + std::to_string(i) + " -\njoints " + device + ' ' +
                                   std::to_string(i) + "\n");
    const auto& heard = net.listeners[id].heard;
    for (; read < heard.size(); ++read) {
      for (const char* name : {"d0", "d1", "d2", "d3"}) {
        const auto at = heard[read].find(std::string("joints ") + name);
        if (at == std::string::npos) continue;
        const double value = std::stod(heard[read].substr(at + 10));
        RC_ASSERT(value >= last[name]);
        last[name] = value;
      }
    }
    RC_ASSERT(net.listeners[id].fold.state.counts().count("s") == 0 ||
              net.listeners[id].fold.counts("s").late == 0);
  }
}

}  // namespace
}  // namespace rocinante
