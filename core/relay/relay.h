#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/packet/packet_text.h"
#include "core/packet/session_state.h"
#include "core/relay/echo_memory.h"
#include "core/relay/filtered_output.h"

namespace rocinante {

/// Received datagrams, by what became of them.
struct RelayInputCounts {
  std::uint64_t received = 0;
  std::uint64_t applied = 0;  ///< by the fold: these pass
  std::uint64_t late = 0;     ///< not above the highest SEQUENCE of their source
  std::uint64_t refused = 0;  ///< of a source for which the fold has no room
  std::uint64_t other = 0;    ///< not packet text
  std::uint64_t looped = 0;   ///< passed this relay before, or more than eight others
};

/// The first sign that a relay receives what it passed on.
struct RelayLoop {
  std::string source;
  /// Since it was passed on. Empty: the datagram named this relay, so that no other way but a loop
  /// can have brought it.
  std::optional<Nanoseconds> after;

  /// As a sentence for the user.
  std::string text() const;
};

/// A relay without sockets and threads (docs/decisions/014): folds what it is given and writes what
/// goes to each output. Memory is bounded by the limits of the fold, and for each output by the
/// number of its items. One thread; reads no clock.
class Relay {
 public:
  using OutputId = std::uint32_t;
  static constexpr OutputId kEveryWhole = 0;  ///< all whole outputs
  /// How many restatements and greetings are sent at a time; the others wait. Those of slow
  /// links are counted apart, since they take long.
  static constexpr std::size_t kRestating = 4;
  static constexpr std::size_t kSlowRestating = 64;

  struct Options {
    std::string name;  ///< NAME: unique among the relays of a site
    std::string run;   ///< part of the IDs of restatements; chosen anew at each start
    Nanoseconds restate = std::chrono::seconds(2);  ///< between those of a filtered output
    /// Signs what the relay writes itself: the same bytes with at most `signature_bytes` more,
    /// valid until its next call. Empty: nothing is signed.
    std::function<ByteView(ByteView)> sign{};
    std::size_t signature_bytes = 0;
    /// Sees each packet that the fold has just applied, with its new events. Empty: nobody looks.
    std::function<void(const Packet&, const std::vector<Event>&)> applied{};
  };
  struct Outgoing {
    OutputId output;
    ByteView payload;  ///< valid until clearOutgoing(), and while the datagram that was received is
  };

  explicit Relay(Options options);

  /// The output's number, above 0, also OUTPUT of its via=NAME:OUTPUT:N.
  OutputId open(RelayOutputOptions options, LogTime now);
  void close(OutputId output);
  bool isWhole(OutputId output) const { return outputs_.at(output).filtered == nullptr; }
  /// Values that this output folded into newer ones instead of sending them; 0 of a whole one.
  std::uint64_t conflated(OutputId output) const;
  /// What this output has no words for; nothing of a whole one.
  FilteredOutCounts filteredOut(OutputId output) const;
  /// Statements of this output that wait for its link; none of a whole one.
  PacedCounts paced(OutputId output) const;
  /// Sends the output everything that it passes, soon.
  void greet(OutputId output);

  /// Folds the datagram, and passes it on if it was applied. `now` must not go back.
  void receive(ByteView datagram, LogTime now, ArrivalWay way = kUnknownWay);
  /// What has become due: conflated values, restatements, greetings.
  void advance(LogTime now);
  /// When advance() has something to do; LogTime::max(): never.
  LogTime due() const { return due_; }

  /// In the order in which they must be sent to each output.
  std::span<const Outgoing> outgoing() const { return outgoing_; }
  void clearOutgoing();

  const RelayInputCounts& counts() const { return counts_; }
  const std::optional<RelayLoop>& loop() const { return loop_; }
  const SessionState& state() const { return state_; }

 private:
  struct Output {
    std::unique_ptr<FilteredOutput> filtered;  ///< null: whole
    bool is_slow = false;
    // Of whole outputs: the greeting. Filtered ones restate themselves.
    std::optional<OutputHeader> header;
    std::optional<Restating> greeting;
    RestatingPace pace;
    LogTime next_restatement = LogTime::max();
    LogTime restated{};       ///< when the last one began
    bool is_waiting = false;  ///< for its turn to restate
  };

  bool namesThis(const PacketHeader& header, std::string_view through) const;
  bool isLooped(const EchoMemory::Arrival& arrival, std::string_view through);
  void noteThrough(std::string_view source, std::string_view through);
  void passOn(ByteView datagram, const Packet& packet, LogTime now);
  void restateSoon(LogTime now);
  void beginRestatements(LogTime now);
  void begin(OutputId id, Output& output, LogTime now);
  void sendGreeting(OutputId id, Output& output, LogTime now);
  void send(OutputId output, std::vector<std::string>& texts);
  static bool isRestating(const Output& output);
  static LogTime dueOf(const Output& output);
  LogTime dueOfAll() const;

  Options options_;
  std::string encoded_name_;
  PacketTextDecoder decoder_;
  SessionState state_;
  ThroughBySource through_;
  EchoMemory echoes_;
  std::optional<RelayLoop> loop_;
  std::map<OutputId, Output> outputs_;
  std::size_t whole_ = 0;  ///< outputs
  OutputId last_output_ = 0;
  std::uint64_t restatements_ = 0;
  LogTime due_ = LogTime::max();
  std::vector<Outgoing> outgoing_;
  std::deque<std::string> texts_;     ///< of `outgoing_`
  std::vector<std::string> written_;  ///< scratch
  RelayInputCounts counts_;
};

}  // namespace rocinante
