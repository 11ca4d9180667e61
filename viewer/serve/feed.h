#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/base/result.h"
#include "core/foreign/live/received_decoder.h"
#include "core/transport/open_source.h"

namespace rocinante {

/// Listens in a thread of its own, so that a busy server loses no packets, and hands them over.
class Feed {
 public:
  struct Options {
    std::vector<Endpoint> endpoints;
    std::shared_ptr<TrustJudge> trust;                   ///< null: nothing need be signed
    std::shared_ptr<const decode::DecoderSet> decoders;  ///< null: packet text alone
    std::function<void(std::string_view)> notify;        ///< from the thread: news of a source
  };
  /// Datagrams one behind the other.
  struct Batch {
    Bytes bytes;
    std::vector<std::size_t> ends;
  };
  /// Waiting for the server at most; what finds no room is dropped and counted.
  static constexpr std::size_t kMostBytes = std::size_t{32} << 20U;

  /// `wake` is called by the thread when there is something to take and there was nothing before.
  static Result<std::unique_ptr<Feed>> start(Options options, std::function<void()> wake);
  ~Feed();
  Feed(const Feed&) = delete;
  Feed& operator=(const Feed&) = delete;

  /// Replaces `batch` by what has arrived, in its order; false when that is nothing. Its memory is
  /// used again.
  bool take(Batch& batch);

  /// Datagrams that the kernel or this feed dropped.
  std::uint64_t dropped() const { return dropped_here_.load() + dropped_before_.load(); }
  std::uint64_t received() const { return received_.load(); }
  /// With the ports that were bound.
  const std::vector<std::string>& listening() const { return listening_; }

 private:
  Feed(Options options, Sources sources, std::function<void()> wake);
  void run();
  void drain(std::size_t source);
  void add(ByteView datagram);

  Options options_;
  Sources sources_;
  std::function<void()> wake_;
  std::vector<std::string> listening_;
  std::optional<ReceivedDecoder> decoder_;
  std::mutex mutex_;
  Batch waiting_;  ///< guarded by mutex_
  std::atomic<std::uint64_t> received_{0}, dropped_here_{0}, dropped_before_{0};
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace rocinante
