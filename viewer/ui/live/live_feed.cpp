#include "viewer/ui/live/live_feed.h"

#include <poll.h>
#include <sys/prctl.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>
#include <utility>

#include "core/base/plain_text.h"
#include "core/foreign/live/received_decoder.h"
#include "core/packet/decoder.h"
#include "core/recording/session_clock.h"
#include "core/transport/open_source.h"
#include "viewer/ui/live/state_hand_over.h"

namespace rocinante {
namespace {

/// Shown by `top -H`.
constexpr char kThreadName[] = "rocinante-feed";
/// A datagram ends the wait at once: this is how late a rate, a loss or a lease is looked at, while
/// something comes and when nothing has come for a second.
constexpr int kPollMs = 10, kSilentPollMs = 100;
constexpr std::size_t kSampleBytes = 24;
/// One endpoint under a flood must not keep the others waiting.
constexpr int kBatchesATurn = 64;

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
  /// What the window takes in one call.
  struct Inbox {
    LiveFigures figures;
    StateChanges changes;
    std::optional<std::vector<LiveSource>> sources;  ///< if they changed
  };
  /// Where the reading of a source stands.
  struct Listening {
    LogTime last{};           ///< of its latest datagram; does not go back
    LogTime drained_until{};  ///< everything that arrived before this was received
    LogTime checked{};        ///< when drops were last read
    std::uint64_t dropped = 0;
  };

  std::vector<Endpoint> endpoints;
  Sources sources;
  std::unique_ptr<LiveKeeper> keeper;
  std::string keeping_fault;
  std::atomic<Inbox*> ready{nullptr};
  std::atomic<Inbox*> returned{nullptr};  ///< taken, and empty again
  std::atomic<bool> stop{false};
  std::mutex wake_mutex;
  std::function<void()> wake;  ///< guarded by wake_mutex
  std::thread thread;
  std::unique_ptr<Decoder> window_decoder = makeDecoder("rk1");

  // Only the network thread touches these.
  SessionState state;
  LiveFigures figures;
  std::unique_ptr<Inbox> inbox = std::make_unique<Inbox>();  ///< being filled
  bool whole = false;  ///< too much has changed: the state is handed over as a copy
  std::optional<SessionClock> clock;
  std::optional<ReceivedDecoder> octets;  ///< empty: without decoders
  std::vector<Listening> listening;

  ~Impl() {
    stop.store(true);
    if (thread.joinable()) thread.join();
    delete ready.exchange(nullptr);
    delete returned.exchange(nullptr);
  }

  void run();
  void observeClock();
  /// Reads all waiting datagrams; returns their number.
  std::uint64_t drain(Decoder& decoder);
  void take(std::uint32_t endpoint, const ReceivedDatagram& datagram, Decoder& decoder);
  void tellKeeper();
  bool handOver();
};

void LiveFeed::Impl::observeClock() {
  const std::optional<ClockStep> step = clock->observe(readClocks());
  if (step && keeper) keeper->addStep(*step);
}

std::uint64_t LiveFeed::Impl::drain(Decoder& decoder) {
  std::uint64_t count = 0;
  for (std::uint32_t i = 0; i < sources.size(); ++i) {
    for (int turn = 0; turn < kBatchesATurn && !stop.load(std::memory_order_relaxed); ++turn) {
      const LogTime asked = clock->now();
      const auto batch = sources[i]->receive();
      // A source that fails temporarily (an interface goes down) is polled again.
      if (!batch.ok() || batch->empty()) {
        listening[i].drained_until = asked - sources[i]->deliveryDelay();
        break;
      }
      // So that no stamp of the batch is later than the last reading.
      observeClock();
      for (const ReceivedDatagram& datagram : *batch) take(i, datagram, decoder);
      count += batch->size();
      listening[i].drained_until = listening[i].last;
    }
  }
  return count;
}

void LiveFeed::Impl::take(std::uint32_t endpoint, const ReceivedDatagram& datagram,
                          Decoder& decoder) {
  Listening& from = listening[endpoint];
  from.last = std::max(from.last, clock->at(datagram.kernel_time));
  if (keeper) keeper->add(endpoint, from.last, datagram);
  // The fold's time must not decrease from one source to the next.
  figures.time = std::max(figures.time, from.last);
  const Packet* packet = decoder.decode(datagram.payload);
  ByteView packet_text = datagram.payload;
  if (packet == nullptr && octets) {
    if (const MadePacket* const made = octets->decode(endpoint, datagram, from.last)) {
      packet = made->packet;
      packet_text = bytesOf(made->text);
    }
  }
  if (packet == nullptr) {
    if (figures.undecoded++ == 0) {
      figures.undecoded_sample = plainText(textOf(
          datagram.payload.first(std::min<std::size_t>(datagram.payload.size(), kSampleBytes))));
    }
    return;
  }
  state.apply(figures.time, *packet);
  whole = whole || !inbox->changes.add(figures.time, packet_text, state);
}

/// Tells the keeper what was lost, and up to when everything was received.
void LiveFeed::Impl::tellKeeper() {
  LogTime drained_until = clock->now();
  for (std::uint32_t i = 0; i < sources.size(); ++i) {
    Listening& each = listening[i];
    drained_until = std::min(drained_until, each.drained_until);
    const std::uint64_t dropped = sources[i]->dropped();
    if (dropped > each.dropped) {
      keeper->addDropped(i, each.checked, clock->now(), dropped - each.dropped);
      each.dropped = dropped;
    }
    each.checked = clock->now();
  }
  keeper->pass(drained_until);
}

/// Fails when the window has not taken the last one.
bool LiveFeed::Impl::handOver() {
  if (ready.load(std::memory_order_acquire) != nullptr) return false;
  inbox->figures = figures;
  if (std::exchange(whole, false)) inbox->changes.replaceBy(state);
  ready.store(inbox.release(), std::memory_order_release);
  inbox.reset(returned.exchange(nullptr, std::memory_order_acq_rel));
  if (!inbox) inbox = std::make_unique<Inbox>();
  const std::lock_guard lock(wake_mutex);
  if (wake) wake();
  return true;
}

void LiveFeed::Impl::run() {
  const auto decoder = makeDecoder("rk1");
  RateMeter meter;
  SourceWatch watch;
  std::vector<pollfd> polls(sources.size());
  bool news = true;
  double reported_rate = 0;
  while (!stop.load(std::memory_order_relaxed)) {
    for (std::size_t i = 0; i < sources.size(); ++i) {
      // A group is joined again when its interface returns; the descriptor may then change.
      if (auto note = sources[i]->maintain()) {
        figures.news = *std::move(note);
        news = true;
      }
      polls[i] = {sources[i]->fileDescriptor(), POLLIN, 0};
    }
    const bool is_silent = !news && figures.rate_hz == 0;
    ::poll(polls.data(), polls.size(), is_silent ? kSilentPollMs : kPollMs);
    observeClock();
    const std::uint64_t count = drain(*decoder);
    state.takeEvents();
    figures.datagrams += count;
    const SteadyTime now = steadyNow();
    meter.add(now, count);
    if (watch.look(now, state.counts())) {
      inbox->sources = watch.sources();
      figures.gaps = 0;
      for (const auto& [source, counts] : state.counts()) figures.gaps += counts.gap;
      news = true;
    }
    figures.rate_hz = meter.perSecond();
    figures.dropped = 0;
    const UntrustedCounts reported = std::exchange(figures.untrusted, UntrustedCounts{});
    for (const auto& source : sources) {
      figures.dropped += source->dropped();
      if (const auto untrusted = source->counts().untrusted) figures.untrusted += *untrusted;
    }
    if (keeper) tellKeeper();
    figures.taken = now;
    news = news || figures.untrusted != reported || count > 0 || figures.rate_hz != reported_rate;
    if (news && handOver()) {
      reported_rate = figures.rate_hz;
      news = false;
    }
  }
}

LiveFeed::LiveFeed(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
LiveFeed::~LiveFeed() = default;
LiveFeed::LiveFeed(LiveFeed&&) noexcept = default;
LiveFeed& LiveFeed::operator=(LiveFeed&&) noexcept = default;

Result<LiveFeed> LiveFeed::start(const std::vector<Endpoint>& endpoints,
                                 std::shared_ptr<TrustJudge> trust,
                                 const std::optional<KeepLimits>& keep,
                                 LiveKeeper::Decoders decoders) {
  auto impl = std::make_unique<Impl>();
  impl->endpoints = endpoints;
  for (const Endpoint& endpoint : endpoints) {
    if (!endpoint.file.empty()) {
      return Error{ErrorKind::bad_argument,
                   "a capture file is not live: record makes a log of it, which can be viewed",
                   endpoint.text()};
    }
  }
  InputOptions listening;
  listening.trust = std::move(trust);
  auto sources = openSources(endpoints, listening);
  if (!sources) return sources.error();
  impl->sources = std::move(*sources);
  impl->clock.emplace(readClocks());
  impl->listening.resize(impl->sources.size());
  for (Impl::Listening& each : impl->listening) each.checked = impl->clock->now();
  std::vector<ListenedEndpoint> listened = listenedEndpoints(impl->sources);
  if (decoders) impl->octets.emplace(decoders, listened);
  if (keep && !keep->none()) {
    auto keeper =
        LiveKeeper::start(KeptFolder::ofUser(), *keep, std::move(listened), std::move(decoders));
    if (keeper.ok()) {
      impl->keeper = std::move(*keeper);
    } else {
      impl->keeping_fault = keeper.error().text();
    }
  }
  Impl* feed = impl.get();
  impl->thread = std::thread([feed] {
    ::prctl(PR_SET_NAME, kThreadName);
    feed->run();
  });
  return LiveFeed(std::move(impl));
}

bool LiveFeed::update(LiveSnapshot& live) {
  std::unique_ptr<Impl::Inbox> inbox(impl_->ready.exchange(nullptr, std::memory_order_acq_rel));
  if (!inbox) return false;
  static_cast<LiveFigures&>(live) = std::move(inbox->figures);
  std::move(inbox->changes).applyTo(live.state, *impl_->window_decoder);
  if (inbox->sources) live.sources = *std::exchange(inbox->sources, std::nullopt);
  delete impl_->returned.exchange(inbox.release(), std::memory_order_acq_rel);
  return true;
}

void LiveFeed::onNews(std::function<void()> wake) {
  const std::lock_guard lock(impl_->wake_mutex);
  impl_->wake = std::move(wake);
}

LiveKeeper* LiveFeed::keeper() const { return impl_->keeper.get(); }
const std::string& LiveFeed::keepingFault() const { return impl_->keeping_fault; }

const std::vector<Endpoint>& LiveFeed::endpoints() const { return impl_->endpoints; }

}  // namespace rocinante
