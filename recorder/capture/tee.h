#pragma once

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <vector>

#include "core/net/datagram_sink.h"
#include "core/net/datagram_source.h"
#include "core/recording/datagram_block.h"

namespace rocinante {

/// Forwards received datagrams, verbatim and in order, from its own thread behind a bounded queue:
/// a slow network makes the tee drop datagrams, which are counted, and costs the recording none.
class Tee {
 public:
  struct Options {
    std::size_t queue_blocks = 64;  ///< DatagramBlocks: 57 MB at most
    /// Time for the waiting datagrams at the end.
    Nanoseconds patience = std::chrono::milliseconds(500);
  };
  struct Account {
    Endpoint to;
    std::uint64_t sent = 0;
    std::uint64_t dropped = 0;     ///< queue full, or refused by the system
    std::uint64_t looped = 0;      ///< came back, and were not forwarded again
    std::optional<Error> trouble;  ///< the first refusal
  };

  /// Fails as openSink: bad_argument or refused.
  static Result<std::unique_ptr<Tee>> open(const Endpoint& to, const Options& options);
  static Result<std::unique_ptr<Tee>> open(const Endpoint& to) { return open(to, Options()); }
  ~Tee();
  Tee(const Tee&) = delete;
  Tee& operator=(const Tee&) = delete;

  /// Copies the datagrams; never waits for the network. For one receiving thread.
  void forward(std::span<const ReceivedDatagram> batch);

  /// Sends waiting datagrams within Options::patience, then ends the thread.
  void close();
  /// Exact after close().
  Account account() const;

  std::string serverId() const { return sink_->serverId(); }
  /// What changed since the last call, as a sentence for the user. Any thread.
  std::optional<std::string> news() { return sink_->news(); }

  /// The datagrams' source address, as a receiver on this machine sees it; empty: they go to a
  /// server.
  const std::optional<SocketAddress>& localAddress() const { return local_address_; }

 private:
  Tee(std::unique_ptr<DatagramSink> sink, const Options& options);
  void run();
  bool take(std::vector<std::unique_ptr<DatagramBlock>>& blocks);
  void send(const DatagramBlock& block);
  bool mayWait();

  std::unique_ptr<DatagramSink> sink_;
  std::optional<SocketAddress> local_address_;
  Options options_;
  mutable std::mutex mutex_;
  std::condition_variable news_;
  std::vector<std::unique_ptr<DatagramBlock>> waiting_;  ///< the last is being filled
  std::vector<std::unique_ptr<DatagramBlock>> free_;
  std::size_t made_ = 0;
  std::optional<SteadyTime> closed_;
  Account account_;
  std::vector<ByteView> payloads_;  ///< used by the thread
  std::thread thread_;
};

/// Fails if a recording that listens on `sources` would receive what it sends to `to`, whose
/// DatagramSink::serverId() is `to_server`.
Status checkTee(const Endpoint& to, const std::vector<DatagramSource*>& sources,
                const std::string& to_server = {});

}  // namespace rocinante
