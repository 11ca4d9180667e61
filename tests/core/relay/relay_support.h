#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "core/relay/relay.h"
#include "tests/core/packet/fold_text.h"

namespace rocinante::test {

/// A relay whose outputs are listeners that fold what they are sent.
class RelayedListeners {
 public:
  struct Listener {
    TextFold fold;
    std::vector<std::string> heard;
    std::function<bool()> loses = [] { return false; };
  };

  explicit RelayedListeners(std::string name = "site")
      : relay({std::move(name), "run", kRestate}) {}

  static constexpr Nanoseconds kRestate = std::chrono::seconds(2);

  Relay::OutputId open(RelayOutputOptions options = {}) {
    const Relay::OutputId id = relay.open(std::move(options), atSeconds(now_));
    listeners[id];
    return id;
  }
  void receive(double seconds, std::string_view text) {
    passTime(seconds);
    relay.receive(bytesOf(text), atSeconds(now_));
    deliver();
  }
  /// Does everything that is due until then, when it is due.
  void passTime(double until) {
    while (relay.due() <= atSeconds(until)) {
      now_ = std::max(now_, static_cast<double>(nanosecondsOf(relay.due())) * 1e-9 + 1e-6);
      relay.advance(atSeconds(now_));
      deliver();
    }
    now_ = std::max(now_, until);
  }
  double now() const { return now_; }

  Relay relay;
  std::map<Relay::OutputId, Listener> listeners;

 private:
  void deliver() {
    for (const Relay::Outgoing& each : relay.outgoing()) {
      for (auto& [id, listener] : listeners) {
        const bool is_its =
            each.output == id || (each.output == Relay::kEveryWhole && relay.isWhole(id));
        if (!is_its || listener.loses()) continue;
        listener.heard.emplace_back(textOf(each.payload));
        listener.fold.fold(now_, listener.heard.back());
      }
    }
    relay.clearOutgoing();
  }

  double now_ = 1;
};

/// The lines of a state's identity that `wanted` selects.
inline std::string identityLines(const SessionState& state,
                                 const std::function<bool(const std::string&)>& wanted) {
  std::istringstream lines(state.identityText());
  std::string text;
  for (std::string line; std::getline(lines, line);) {
    if (wanted(line)) text += line + '\n';
  }
  return text;
}

/// Items and sources, without the times of last writes, which are the listener's own.
inline std::string itemsAndSources(const SessionState& state) {
  return identityLines(state, [](const std::string& line) { return !line.starts_with("device "); });
}

}  // namespace rocinante::test
