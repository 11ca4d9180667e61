#include "viewer/ui/live/live_keeper.h"

#include <pthread.h>

#include <chrono>
#include <utility>

#include "core/foreign/live/received_decoder.h"

namespace rocinante {
namespace {

/// 32 MB: a disk that stops for five seconds costs nothing at 60,000 datagrams a second.
constexpr std::size_t kMaxBlocks = 64;
constexpr double kBusyQueue = 0.5;
/// Few wake-ups for the writing thread, and well within the reordering window.
constexpr Nanoseconds kBlockAge = std::chrono::milliseconds(5);
constexpr Nanoseconds kWait = std::chrono::milliseconds(10);
/// Shown by `top -H`.
constexpr char kKeeperThreadName[] = "rocinante-keep";

}  // namespace

Result<std::unique_ptr<LiveKeeper>> LiveKeeper::start(const std::filesystem::path& parent,
                                                      const KeepLimits& limits,
                                                      std::vector<ListenedEndpoint> endpoints,
                                                      Decoders decoders) {
  Result<KeptFolder> folder = KeptFolder::make(parent);
  if (!folder) return folder.error();
  return std::unique_ptr<LiveKeeper>(
      new LiveKeeper(std::move(*folder), limits, std::move(endpoints), decoders));
}

LiveKeeper::LiveKeeper(KeptFolder folder, const KeepLimits& limits,
                       std::vector<ListenedEndpoint> endpoints, const Decoders& decoders)
    : folder_(std::move(folder)),
      queue_(kMaxBlocks),
      pieces_(new KeptPieces(folder_.path(), limits, decoders)),
      writer_(std::unique_ptr<CaptureSink>(pieces_), std::move(endpoints), CaptureLimits(),
              decoders ? std::make_shared<LiveDecoder>(decoders) : nullptr),
      thread_([this] { write(); }) {
  ::pthread_setname_np(thread_.native_handle(), kKeeperThreadName);
}

LiveKeeper::~LiveKeeper() {
  queue_.finish();
  thread_.join();
}

void LiveKeeper::add(std::uint32_t endpoint, LogTime time, const ReceivedDatagram& datagram) {
  const auto put = [&] {
    return block_ && block_->add(endpoint, time, datagram.sender, datagram.payload,
                                 datagram.destination, datagram.subject);
  };
  bool kept = put();
  if (!kept) {
    if (block_) handOver(std::nullopt);
    block_ = queue_.freeBlock();
    kept = put();
  }
  if (kept && !datagram.truncated) return;
  EndpointLoss loss{endpoint, time, time, {}};
  (kept ? loss.counts.truncated : loss.counts.queue) = 1;
  addLoss(losses_, loss);
}

void LiveKeeper::addDropped(std::uint32_t endpoint, LogTime from, LogTime until,
                            std::uint64_t count) {
  EndpointLoss loss{endpoint, from, until, {}};
  loss.counts.kernel = count;
  addLoss(losses_, loss);
}

void LiveKeeper::pass(LogTime drained_until) {
  if (!block_) return handOver(drained_until);
  // `drained_until` must not overtake a block that is still being filled. When the writer is slow
  // blocks are filled to the end, so that the queue holds the most.
  const bool is_old = drained_until - block_->arrivals().front().time >= kBlockAge;
  if (is_old && queue_.fill() < kBusyQueue) handOver(drained_until);
}

void LiveKeeper::handOver(std::optional<LogTime> drained_until) {
  queue_.give(std::move(block_), losses_, steps_, drained_until);
}

void LiveKeeper::write() {
  for (bool finished = false; !finished;) {
    TakenOver taken = queue_.take(kWait);
    finished = taken.finished;
    {
      const std::lock_guard lock(mutex_);
      // A moment's last datagrams may wait for earlier ones of another socket.
      if (finish_) pieces_->finishBefore(*std::exchange(finish_, std::nullopt) + Nanoseconds(1));
      pieces_->hold(held_);
    }
    writer_.write(std::move(taken), queue_);
    writer_.flush(std::chrono::steady_clock::now());
    KeptProgress now;
    now.first = pieces_->first();
    now.finished = pieces_->finished();
    now.finished_until = pieces_->finishedUntil();
    now.datagrams = writer_.packets();
    now.lost = writer_.lost();
    now.bytes = pieces_->bytes();
    if (writer_.trouble()) now.trouble = writer_.trouble()->text();
    const std::optional<std::string> disturbed = pieces_->takeDisturbance();
    const std::lock_guard lock(mutex_);
    if (now.trouble.empty()) now.trouble = disturbed.value_or(progress_.trouble);
    progress_ = std::move(now);
  }
  writer_.close("closed", queue_);
}

KeptProgress LiveKeeper::progress() const {
  const std::lock_guard lock(mutex_);
  return progress_;
}

void LiveKeeper::finishUpTo(LogTime moment) {
  const std::lock_guard lock(mutex_);
  finish_ = moment;
}

void LiveKeeper::hold(bool held) {
  const std::lock_guard lock(mutex_);
  held_ = held;
}

}  // namespace rocinante
