#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/net/datagram_source.h"
#include "recorder/capture/tee.h"

namespace rocinante {

/// Packets that a recorder's tees forwarded and that come back from another sender: recorders whose
/// tees form a circle would forward them for ever. Only packet text, of which a second copy says
/// nothing new. Memory is bounded. One thread.
class TeeEchoes {
 public:
  static constexpr Nanoseconds kSpan = std::chrono::seconds(2);
  static constexpr std::size_t kPackets = 65'536;

  /// What is to be forwarded of the batch: all of it, or what came the first time. Valid until the
  /// next call.
  std::span<const ReceivedDatagram> firsts(std::span<const ReceivedDatagram> batch, SteadyTime now);

  std::uint64_t count() const { return count_; }
  /// After the first echo, once: a sentence for the user.
  std::optional<std::string> news();

 private:
  struct Forwarded {
    SteadyTime time;
    SocketAddress sender;
  };
  bool isEcho(const ReceivedDatagram& datagram, SteadyTime now);

  std::unordered_map<std::uint64_t, Forwarded> forwarded_;
  std::deque<std::pair<SteadyTime, std::uint64_t>> order_;  ///< of forwarded_, oldest first
  std::vector<ReceivedDatagram> firsts_;
  std::uint64_t count_ = 0;
  std::optional<std::string> news_;
};

/// All tees of a recording, usually none. Each has its own queue and thread, so a slow one does not
/// affect the others.
class TeeSet {
 public:
  /// Opens all or none; fails as Tee::open.
  static Result<TeeSet> open(const std::vector<Endpoint>& endpoints);

  bool empty() const { return tees_.empty(); }
  /// Addresses whose datagrams must not be recorded again (InputOptions::own).
  std::vector<SocketAddress> localAddresses() const;
  /// Fails if a recording that listens on `sources` would receive its own tee.
  Status check(const std::vector<DatagramSource*>& sources) const;

  /// Without what comes back to it.
  void forward(std::span<const ReceivedDatagram> batch);
  /// When something has come back: a sentence for the user, once. For the thread that forwards.
  std::optional<std::string> circleNews() { return echoes_.news(); }
  /// Sends waiting datagrams for a moment. Not while another thread forwards.
  void close() {
    for (const auto& each : tees_) each->close();
  }
  /// What changed at those that send to a server, as sentences for the user.
  std::vector<std::string> news();
  /// Exact after close().
  std::vector<Tee::Account> accounts() const;

 private:
  std::vector<std::unique_ptr<Tee>> tees_;
  TeeEchoes echoes_;
};

}  // namespace rocinante
