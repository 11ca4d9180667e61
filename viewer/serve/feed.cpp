#include "viewer/serve/feed.h"

#include <poll.h>
#include <sys/prctl.h>

#include <chrono>
#include <utility>

namespace rocinante {
namespace {

/// How late a loss or the end of a wait is seen; a datagram ends the wait at once.
constexpr int kPollMs = 50;
/// The same where a source has nothing to wait for.
constexpr int kAskMs = 5;
/// One endpoint under a flood must not keep the others waiting.
constexpr int kBatchesATurn = 64;

LogTime wallNow() {
  return LogTime(
      std::chrono::duration_cast<Nanoseconds>(std::chrono::system_clock::now().time_since_epoch()));
}

}  // namespace

Feed::Feed(Options options, Sources sources, std::function<void()> wake)
    : options_(std::move(options)), sources_(std::move(sources)), wake_(std::move(wake)) {
  for (const auto& each : sources_) listening_.push_back(boundText(*each));
  if (options_.decoders) decoder_.emplace(options_.decoders, listenedEndpoints(sources_));
}

Feed::~Feed() {
  stop_.store(true);
  if (thread_.joinable()) thread_.join();
}

Result<std::unique_ptr<Feed>> Feed::start(Options options, std::function<void()> wake) {
  for (const Endpoint& endpoint : options.endpoints) {
    if (endpoint.file.empty()) continue;
    return Error{ErrorKind::bad_argument,
                 "a capture file is not live: record makes a log of it, which can be served",
                 endpoint.text()};
  }
  InputOptions listening;
  listening.trust = options.trust;
  auto sources = openSources(options.endpoints, listening);
  if (!sources) return sources.error();
  std::unique_ptr<Feed> feed(new Feed(std::move(options), std::move(*sources), std::move(wake)));
  feed->thread_ = std::thread([raw = feed.get()] {
    ::prctl(PR_SET_NAME, "rocinante-feed");
    raw->run();
  });
  return feed;
}

bool Feed::take(Batch& batch) {
  batch.bytes.clear();
  batch.ends.clear();
  const std::lock_guard lock(mutex_);
  std::swap(batch, waiting_);
  return !batch.ends.empty();
}

void Feed::add(ByteView datagram) {
  bool is_first = false;
  {
    const std::lock_guard lock(mutex_);
    if (waiting_.bytes.size() + datagram.size() > kMostBytes) {
      ++dropped_here_;
      return;
    }
    is_first = waiting_.ends.empty();
    waiting_.bytes.insert(waiting_.bytes.end(), datagram.begin(), datagram.end());
    waiting_.ends.push_back(waiting_.bytes.size());
  }
  if (is_first) wake_();
}

void Feed::drain(std::size_t source) {
  for (int turn = 0; turn < kBatchesATurn && !stop_.load(std::memory_order_relaxed); ++turn) {
    const auto batch = sources_[source]->receive();
    // A source that fails for a while (an interface goes down) is polled again.
    if (!batch.ok() || batch->empty()) return;
    received_ += batch->size();
    for (const ReceivedDatagram& datagram : *batch) {
      const MadePacket* const made =
          decoder_ ? decoder_->decode(source, datagram, wallNow()) : nullptr;
      add(made != nullptr ? bytesOf(made->text) : datagram.payload);
    }
  }
}

void Feed::run() {
  std::vector<pollfd> polls(sources_.size());
  while (!stop_.load(std::memory_order_relaxed)) {
    std::uint64_t dropped = 0;
    int wait_ms = kPollMs;
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      if (const auto news = sources_[i]->maintain(); news && options_.notify)
        options_.notify(*news);
      polls[i] = {sources_[i]->fileDescriptor(), POLLIN, 0};
      if (polls[i].fd < 0) wait_ms = kAskMs;
      dropped += sources_[i]->dropped();
    }
    dropped_before_.store(dropped);
    ::poll(polls.data(), polls.size(), wait_ms);
    for (std::size_t i = 0; i < sources_.size(); ++i) drain(i);
  }
}

}  // namespace rocinante
