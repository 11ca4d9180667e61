#include "viewer/ui/live/live_feed.h"

#include <poll.h>
#include <sys/prctl.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <thread>
#include <utility>

#include "core/base/plain_text.h"
#include "core/packet/decoder.h"
#include "core/pcap/open_source.h"

namespace rocinante {
namespace {

/// Shown by `top -H`.
constexpr char kThreadName[] = "rocinante-feed";
constexpr int kPollMs = 10;
constexpr std::size_t kSampleBytes = 24;

/// Datagrams of the last second, in tenths.
class RateMeter {
 public:
  void add(SteadyTime now, std::uint64_t count) {
    const std::int64_t tenth = now.time_since_epoch() / std::chrono::milliseconds(100);
    for (std::int64_t passed = 0; newest_ < tenth && passed < kTenths; ++passed, ++newest_) {
      counts_[static_cast<std::size_t>((newest_ + 1) % kTenths)] = 0;
    }
    newest_ = tenth;
    counts_[static_cast<std::size_t>(tenth % kTenths)] += count;
  }

  /// Rate over the nine completed tenths.
  double perSecond() const {
    std::uint64_t sum = 0;
    for (std::int64_t back = 1; back < kTenths; ++back) {
      sum += counts_[static_cast<std::size_t>((newest_ + kTenths - back) % kTenths)];
    }
    return static_cast<double>(sum) / (static_cast<double>(kTenths - 1) * 0.1);
  }

 private:
  static constexpr std::int64_t kTenths = 10;
  std::array<std::uint64_t, kTenths> counts_{};
  std::int64_t newest_ = 0;
};

SteadyTime steadyNow() { return std::chrono::steady_clock::now(); }

}  // namespace

struct LiveFeed::Impl {
  std::vector<Endpoint> endpoints;
  Sources sources;
  std::atomic<LiveSnapshot*> mailbox{nullptr};
  std::atomic<bool> stop{false};
  std::thread thread;

  ~Impl() {
    stop.store(true);
    if (thread.joinable()) thread.join();
    delete mailbox.exchange(nullptr);
  }

  void run();
  /// Reads all waiting datagrams; returns their number.
  std::uint64_t drain(Decoder& decoder, LiveSnapshot& current);
};

std::uint64_t LiveFeed::Impl::drain(Decoder& decoder, LiveSnapshot& current) {
  std::uint64_t count = 0;
  for (const auto& source : sources) {
    while (!stop.load(std::memory_order_relaxed)) {
      const auto batch = source->receive();
      // A source that fails temporarily (an interface goes down) is polled again.
      if (!batch.ok() || batch->empty()) break;
      for (const ReceivedDatagram& datagram : *batch) {
        ++count;
        const LogTime arrived{datagram.kernel_time.time_since_epoch()};
        // The fold's time must not decrease, even if the wall clock does.
        current.time = std::max(current.time, arrived);
        const Packet* packet = decoder.decode(datagram.payload);
        if (packet == nullptr) {
          if (current.undecoded++ == 0) {
            current.undecoded_sample = plainText(textOf(datagram.payload.first(
                std::min<std::size_t>(datagram.payload.size(), kSampleBytes))));
          }
        } else {
          current.state.apply(current.time, *packet);
        }
      }
    }
  }
  current.state.takeEvents();
  return count;
}

void LiveFeed::Impl::run() {
  const auto decoder = makeDecoder("rk1");
  LiveSnapshot current;
  RateMeter meter;
  SourceWatch watch;
  std::vector<pollfd> polls(sources.size());
  bool news = true;
  double told_rate = 0;
  while (!stop.load(std::memory_order_relaxed)) {
    for (std::size_t i = 0; i < sources.size(); ++i) {
      // A group is joined again when its interface returns; the descriptor may then change.
      (void)sources[i]->maintain();
      polls[i] = {sources[i]->fileDescriptor(), POLLIN, 0};
    }
    ::poll(polls.data(), polls.size(), kPollMs);
    const std::uint64_t count = drain(*decoder, current);
    current.datagrams += count;
    const SteadyTime now = steadyNow();
    meter.add(now, count);
    news = watch.look(now, current.state.counts()) || news;
    current.rate_hz = meter.perSecond();
    current.dropped = 0;
    for (const auto& source : sources) current.dropped += source->dropped();
    news = news || count > 0 || current.rate_hz != told_rate;
    if (!news || mailbox.load(std::memory_order_acquire) != nullptr) continue;
    current.gaps = 0;
    for (const auto& [source, counts] : current.state.counts()) current.gaps += counts.gap;
    auto copy = std::make_unique<LiveSnapshot>(current);
    copy->sources = watch.sources();
    copy->taken = now;
    LiveSnapshot* expected = nullptr;
    if (mailbox.compare_exchange_strong(expected, copy.get(), std::memory_order_acq_rel)) {
      static_cast<void>(copy.release());
      told_rate = current.rate_hz;
      news = false;
    }
  }
}

LiveFeed::LiveFeed(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
LiveFeed::~LiveFeed() = default;
LiveFeed::LiveFeed(LiveFeed&&) noexcept = default;
LiveFeed& LiveFeed::operator=(LiveFeed&&) noexcept = default;

Result<LiveFeed> LiveFeed::start(const std::vector<Endpoint>& endpoints) {
  auto impl = std::make_unique<Impl>();
  impl->endpoints = endpoints;
  for (const Endpoint& endpoint : endpoints) {
    if (!endpoint.file.empty()) {
      return Error{ErrorKind::bad_argument,
                   "a capture file is not live: record makes a log of it, which can be viewed",
                   endpoint.text()};
    }
  }
  auto sources = openSources(endpoints, InputOptions());
  if (!sources) return sources.error();
  impl->sources = std::move(*sources);
  Impl* feed = impl.get();
  impl->thread = std::thread([feed] {
    ::prctl(PR_SET_NAME, kThreadName);
    feed->run();
  });
  return LiveFeed(std::move(impl));
}

std::unique_ptr<LiveSnapshot> LiveFeed::take() {
  return std::unique_ptr<LiveSnapshot>(impl_->mailbox.exchange(nullptr, std::memory_order_acq_rel));
}

const std::vector<Endpoint>& LiveFeed::endpoints() const { return impl_->endpoints; }

}  // namespace rocinante
