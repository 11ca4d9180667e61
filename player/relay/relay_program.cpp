#include "player/relay/relay_program.h"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <utility>

#include "core/cli/status_line.h"
#include "core/foreign/live/received_decoder.h"
#include "core/net/hears.h"
#include "core/signing/signed_datagram.h"
#include "core/transport/open_sink.h"
#include "core/transport/open_source.h"
#include "player/relay/relay_ports.h"

namespace rocinante {
namespace {

/// Of one input in a turn: one under a flood must not keep the others waiting.
constexpr int kBatchesATurn = 16;
constexpr Nanoseconds kLongestSleep = std::chrono::milliseconds(50);
constexpr Nanoseconds kProgress = std::chrono::milliseconds(200);
/// A real-time thread that has not slept for so long takes a core from the machine.
constexpr Nanoseconds kAwake = std::chrono::milliseconds(500);

SteadyTime steadyNow() { return std::chrono::steady_clock::now(); }

/// The fold's time: the wall clock of the start, continued by the steady one, so that it never goes
/// back.
class FoldClock {
 public:
  LogTime at(SteadyTime now) const { return began_ + (now - steady_); }
  SteadyTime steadyAt(LogTime time) const { return steady_ + (time - began_); }

 private:
  SteadyTime steady_ = steadyNow();
  LogTime began_{
      std::chrono::duration_cast<Nanoseconds>(std::chrono::system_clock::now().time_since_epoch())};
};

/// Empty without a signer.
std::function<ByteView(ByteView)> signingWith(DatagramSigner* signer) {
  if (signer == nullptr) return {};
  return [signer](ByteView datagram) { return signer->sign(datagram); };
}

/// Of what one endpoint receives from one sender.
ArrivalWay wayOf(std::size_t input, const ReceivedDatagram& datagram) {
  // A server does not tell who sends.
  if (!datagram.subject.empty()) return kUnknownWay;
  std::string_view address(reinterpret_cast<const char*>(datagram.sender.address.data()),
                           datagram.sender.address.size());
  const std::uint64_t place = (std::uint64_t{input} << 16U | datagram.sender.port) + 1;
  const std::uint64_t way = std::hash<std::string_view>()(address) ^ place * 0x9E3779B97F4A7C15U;
  return way == kUnknownWay ? 1 : way;
}

class RunningRelay {
 public:
  /// `signer` may be null, and must outlive the relay.
  RunningRelay(const RelayProgramOptions& options, const SendSurroundings& surroundings,
               DatagramSigner* signer)
      : options_(options),
        surroundings_(surroundings),
        sign_(signingWith(signer)),
        signature_bytes_(signer == nullptr ? 0 : kSignatureBytes),
        relay_({options.name, options.run, options.restate, sign_, signature_bytes_}),
        line_(options.progress) {}

  Status open();
  Status run();
  RelayReport report() const;

 private:
  Status receive(std::size_t input);
  void pass(std::size_t input, const ReceivedDatagram& datagram, LogTime now);
  void sendOutgoing();
  void sleep();
  void showProgress();
  Status checkLoop(const DatagramSink& sink) const;
  Status checkSubscriptions() const;

  const RelayProgramOptions& options_;
  const SendSurroundings& surroundings_;
  std::function<ByteView(ByteView)> sign_;  ///< empty: nothing is signed
  std::size_t signature_bytes_;
  Relay relay_;
  FoldClock clock_;
  Sources sources_;
  std::vector<std::uint64_t> received_;  ///< by source
  std::optional<ReceivedDecoder> decoder_;
  std::vector<ToPort> to_;
  std::vector<std::unique_ptr<ServePort>> serve_;
  std::optional<PacingThread> thread_;
  bool was_realtime_ = false;
  std::vector<pollfd> waiting_;
  SteadyTime began_{}, slept_{}, shown_{};
  cli::StatusLine line_;
  bool loop_reported_ = false;
  std::uint64_t most_subscribers_ = 0;
};

/// A relay that sends to an address where it listens itself would hear every datagram again.
Status RunningRelay::checkLoop(const DatagramSink& sink) const {
  const Endpoint& to = sink.endpoint();
  bool loops = std::any_of(sources_.begin(), sources_.end(),
                           [&](const auto& each) { return hears(*each, to, sink.serverId()); });
  for (const auto& each : serve_) {
    const UdpReceiver& served = each->socket();
    loops = loops || hears(served.endpoint(), served.boundAddress(), to);
  }
  if (!loops) return {};
  return Error{ErrorKind::bad_argument, "--to names an address where this relay itself listens",
               to.text()};
}

/// Nor does it ask itself for what it sends.
Status RunningRelay::checkSubscriptions() const {
  for (const auto& source : sources_) {
    const Endpoint& from = source->endpoint();
    if (!from.isSubscription()) continue;
    Endpoint relay;
    relay.address = from.address;
    for (const auto& each : serve_) {
      if (!hears(each->socket().endpoint(), each->socket().boundAddress(), relay)) continue;
      return Error{ErrorKind::bad_argument, "--from subscribes at what this relay itself serves",
                   from.text()};
    }
  }
  return {};
}

Status RunningRelay::open() {
  InputOptions input;
  input.allow = options_.allow;
  auto trust = TrustJudge::open(options_.trust);
  if (!trust) return trust.error();
  input.trust = std::move(*trust);
  Result<Sources> sources = openSources(options_.from, input);
  if (!sources) return sources.error();
  sources_ = std::move(*sources);
  received_.resize(sources_.size());
  if (options_.decoders) decoder_.emplace(options_.decoders, listenedEndpoints(sources_));
  for (const Endpoint& each : options_.serve) {
    SubscriptionDesk::Options desk;
    desk.relay = options_.name;
    desk.run = options_.run;
    desk.restate_s = secondsOf(options_.restate);
    desk.allow = options_.allow;
    desk.sign = sign_;
    auto port = ServePort::open(each, std::move(desk), signature_bytes_);
    if (!port) return port.error();
    serve_.push_back(std::move(*port));
  }
  if (Status checked = checkSubscriptions(); !checked) return checked;
  const LogTime now = clock_.at(steadyNow());
  for (const Endpoint& each : options_.to) {
    auto sink = openSink(each);
    if (!sink) return sink.error();
    if (Status checked = checkLoop(**sink); !checked) return checked;
    ToPort port;
    port.sink = std::move(*sink);
    RelayOutputOptions how = options_.outputs;
    how.signature_bytes = signature_bytes_;
    how.head_bytes = (each.address.is_ipv6 ? 48 : 28) + signature_bytes_;
    port.output = relay_.open(std::move(how), now);
    port.whole = relay_.isWhole(port.output);
    to_.push_back(std::move(port));
  }
  Result<PacingThread> thread = PacingThread::begin(options_.realtime);
  if (!thread) return thread.error();
  thread_.emplace(std::move(*thread));
  was_realtime_ = thread_->isRealtime();

  for (const auto& each : sources_) surroundings_.notify("listening on " + boundText(*each));
  for (const ToPort& each : to_) {
    surroundings_.notify("sending to " + each.sink->endpoint().text());
  }
  for (const auto& each : serve_) surroundings_.notify("serving at " + boundText(each->socket()));
  return {};
}

Status RunningRelay::receive(std::size_t input) {
  for (int turn = 0; turn < kBatchesATurn; ++turn) {
    const auto batch = sources_[input]->receive();
    if (!batch) return batch.error();
    if (batch->empty()) break;
    const LogTime now = clock_.at(steadyNow());
    for (const ReceivedDatagram& each : *batch) {
      ++received_[input];
      pass(input, each, now);
    }
    // The payloads are the source's until it receives again.
    sendOutgoing();
  }
  return {};
}

void RunningRelay::pass(std::size_t input, const ReceivedDatagram& datagram, LogTime now) {
  if (datagram.truncated) return relay_.receive({}, now);
  const ArrivalWay way = wayOf(input, datagram);
  const MadePacket* const made =
      decoder_ ? decoder_->decode(input, datagram, LogTime(datagram.kernel_time.time_since_epoch()))
               : nullptr;
  if (made == nullptr) return relay_.receive(datagram.payload, now, way);
  relay_.receive(bytesOf(made->text), now, way);
  // The decoder's text is good until the next.
  sendOutgoing();
}

void RunningRelay::sendOutgoing() {
  if (relay_.outgoing().empty()) return;
  for (ToPort& each : to_) each.send(relay_.outgoing());
  for (const auto& each : serve_) each->send(relay_.outgoing());
  relay_.clearOutgoing();
}

void RunningRelay::sleep() {
  const SteadyTime now = steadyNow();
  Nanoseconds longest = kLongestSleep;
  if (relay_.due() != LogTime::max()) {
    const LogTime log_now = clock_.at(now);
    longest = relay_.due() <= log_now ? Nanoseconds(0) : std::min(longest, relay_.due() - log_now);
  }
  waiting_.clear();
  for (const auto& each : sources_) {
    if (each->fileDescriptor() < 0) longest = std::min<Nanoseconds>(longest, kProgress / 100);
    waiting_.push_back({each->fileDescriptor(), POLLIN, 0});
  }
  for (const auto& each : serve_) waiting_.push_back({each->socket().fileDescriptor(), POLLIN, 0});
  const timespec timeout{0, longest.count()};
  const int ready = ::ppoll(waiting_.data(), waiting_.size(), &timeout, nullptr);
  if (ready == 0 && longest.count() > 0) slept_ = steadyNow();
  if (ready > 0 && steadyNow() - now > std::chrono::microseconds(20)) slept_ = steadyNow();
  if (thread_->isRealtime() && steadyNow() - slept_ > kAwake) {
    thread_->leaveRealtime();
    was_realtime_ = false;
  }
}

void RunningRelay::showProgress() {
  if (!line_.isVisible() || steadyNow() - shown_ < kProgress) return;
  shown_ = steadyNow();
  std::size_t subscribers = 0;
  for (const auto& each : serve_) subscribers += each->desk().subscribers();
  const RelayReport so_far = report();
  line_.show(fmt::format("{:.0f} s: {} received, {} applied, {} subscribers, {} lost",
                         so_far.seconds, so_far.counts.received, so_far.counts.applied, subscribers,
                         so_far.lost()));
}

Status RunningRelay::run() {
  began_ = slept_ = steadyNow();
  while (!surroundings_.stop()) {
    for (std::size_t i = 0; i < sources_.size(); ++i) {
      if (Status received = receive(i); !received) return received;
      if (const auto note = sources_[i]->maintain()) surroundings_.notify(*note);
    }
    for (const ToPort& each : to_) {
      const auto news = each.sink->news();
      if (!news) continue;
      surroundings_.notify(*news);
      // Only a server that answers has an identity.
      if (Status checked = checkLoop(*each.sink); !checked) return checked;
    }
    if (relay_.loop() && !std::exchange(loop_reported_, true)) {
      surroundings_.notify(relay_.loop()->text());
    }
    std::uint64_t subscribers = 0;
    for (const auto& each : serve_) {
      const SteadyTime now = steadyNow();
      Status handled = each->handleRequests(relay_, options_.outputs, now, clock_.at(now));
      if (!handled) return handled;
      subscribers += each->desk().subscribers();
    }
    most_subscribers_ = std::max(most_subscribers_, subscribers);
    relay_.advance(clock_.at(steadyNow()));
    sendOutgoing();
    showProgress();
    sleep();
  }
  line_.clear();
  for (const auto& each : sources_) {
    if (const auto text = neverAcceptedText(*each)) surroundings_.notify(*text);
  }
  return {};
}

RelayReport RunningRelay::report() const {
  RelayReport report;
  report.name = options_.name;
  report.run = options_.run;
  report.counts = relay_.counts();
  report.loop = relay_.loop();
  report.seconds = secondsOf(steadyNow() - began_);
  report.scheduling = was_realtime_ ? "fifo" : "other";
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const DatagramSource& source = *sources_[i];
    const Result<std::uint64_t> dropped = sources_[i]->droppedByNow();
    report.inputs.push_back(
        {boundText(source), received_[i], dropped ? *dropped : source.dropped(), source.counts()});
  }
  for (const ToPort& each : to_) {
    report.outputs.push_back({each.sink->endpoint().text(), std::to_string(each.output), each.whole,
                              each.forwarded, each.dropped, relay_.conflated(each.output),
                              relay_.filteredOut(each.output), relay_.paced(each.output),
                              each.trouble ? each.trouble->text() : std::string()});
  }
  for (const auto& each : serve_) {
    report.subscribers += each->desk().subscribers();
    report.served += each->forwarded();
    report.served_dropped += each->dropped();
    report.served_conflated += each->conflated(relay_);
    report.served_filtered_out += each->filteredOut(relay_);
    report.served_paced += each->paced(relay_);
    const SubscriptionDesk::Counts& counts = each->desk().counts();
    report.requests.requests += counts.requests;
    report.requests.challenged += counts.challenged;
    report.requests.refused += counts.refused;
    report.requests.ignored += counts.ignored;
    report.requests.malformed += counts.malformed;
    report.requests.bytes_in += counts.bytes_in;
    report.requests.bytes_out += counts.bytes_out;
  }
  report.most_subscribers = most_subscribers_;
  if (decoder_) report.decoded = decoder_->decoder().account();
  return report;
}

}  // namespace

Result<RelayReport> relayUntilStopped(const RelayProgramOptions& options,
                                      const SendSurroundings& surroundings) {
  std::optional<DatagramSigner> signer;
  if (!options.key.empty()) {
    Result<SigningKey> key = SigningKey::read(options.key);
    if (!key) return key.error();
    signer.emplace(std::move(*key), [] { return WallTime(std::chrono::system_clock::now()); });
  }
  RunningRelay relay(options, surroundings, signer ? &*signer : nullptr);
  if (Status opened = relay.open(); !opened) return opened.error();
  if (Status ran = relay.run(); !ran) return ran.error();
  return relay.report();
}

}  // namespace rocinante
