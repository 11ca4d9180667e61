#pragma once

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <vector>

#include "core/net/datagram_source.h"
#include "core/net/udp_socket.h"
#include "core/recording/datagram_block.h"

namespace rocinante {

/// Sends on what is received, verbatim and in order, from a thread of its own behind a bounded
/// queue: a network that is slow costs the tee datagrams, counted, and the recording none.
class Tee {
 public:
  struct Options {
    std::size_t queue_blocks = 64;  ///< of DatagramBlock: 57 MB at most
    /// At the end, for what still waits.
    Nanoseconds patience = std::chrono::milliseconds(500);
  };
  struct Account {
    Endpoint to;
    std::uint64_t sent = 0;
    std::uint64_t dropped = 0;     ///< the queue was full, or the system refused to send them
    std::optional<Error> trouble;  ///< the first refusal
  };

  /// bad_argument or refused as UdpSender::open says.
  static Result<std::unique_ptr<Tee>> open(const Endpoint& to, const Options& options);
  static Result<std::unique_ptr<Tee>> open(const Endpoint& to) { return open(to, Options()); }
  ~Tee();
  Tee(const Tee&) = delete;
  Tee& operator=(const Tee&) = delete;

  /// For one receiving thread: copies the datagrams, never waits for the network.
  void forward(std::span<const ReceivedDatagram> batch);

  /// Sends what still waits, within Options::patience, and ends the thread.
  void close();
  /// Exact after close().
  Account account() const;

  /// Where the datagrams come from, as a receiver on this machine sees it.
  const SocketAddress& localAddress() const { return sender_.localAddress(); }

 private:
  Tee(UdpSender sender, const Options& options);
  void run();
  bool take(std::vector<std::unique_ptr<DatagramBlock>>& blocks);
  void send(const DatagramBlock& block);
  bool mayWait();

  UdpSender sender_;
  Options options_;
  mutable std::mutex mutex_;
  std::condition_variable news_;
  std::vector<std::unique_ptr<DatagramBlock>> waiting_;  ///< the last is being filled
  std::vector<std::unique_ptr<DatagramBlock>> free_;
  std::size_t made_ = 0;
  std::optional<SteadyTime> closed_;
  Account account_;
  std::vector<ByteView> payloads_;  ///< of the thread
  std::thread thread_;
};

/// Says why `to` cannot be a tee of a recording that listens at `sources`: it would hear itself.
Status checkTee(const Endpoint& to, const std::vector<DatagramSource*>& sources);

}  // namespace rocinante
