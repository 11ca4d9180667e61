#include "golden/check/live_input.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <poll.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/cli/program.h"
#include "core/packet/decoder.h"

namespace rocinante {
namespace {

// One endpoint under a flood must not keep the others waiting.
constexpr int kBatchesATurn = 64;

ClockReading readBothClocks() {
  ClockReading reading;
  reading.before = std::chrono::steady_clock::now();
  reading.wall = std::chrono::system_clock::now();
  reading.after = std::chrono::steady_clock::now();
  return reading;
}

}  // namespace

Result<LiveInput> LiveInput::open(const std::vector<std::string>& endpoints,
                                  const std::string& trust_file,
                                  std::shared_ptr<const decode::DecoderSet> decoders, LiveTime time,
                                  Take take) {
  std::vector<Endpoint> parsed;
  for (const std::string& text : endpoints) {
    const Result<Endpoint> endpoint = Endpoint::parse(text);
    if (!endpoint) return endpoint.error();
    parsed.push_back(*endpoint);
  }
  auto trust = TrustJudge::open(trust_file);
  if (!trust) return trust.error();
  InputOptions listening;
  listening.trust = std::move(*trust);
  Result<Sources> sources = openSources(parsed, listening);
  if (!sources) return sources.error();
  return LiveInput(std::move(*sources), std::move(decoders), time, std::move(take));
}

LiveInput::LiveInput(Sources sources, std::shared_ptr<const decode::DecoderSet> decoders,
                     LiveTime time, Take take)
    : sources_(std::move(sources)),
      take_(std::move(take)),
      received_(sources_.size()),
      dropped_(sources_.size()) {
  if (decoders) {
    decoder_ = std::make_unique<ReceivedDecoder>(std::move(decoders), listenedEndpoints(sources_));
  }
  for (const auto& each : sources_) names_.push_back(boundText(*each));
  const bool has_own_times = sources_[0]->endpoint().hasOwnTimes();
  if (time == LiveTime::steady && !has_own_times) clock_.emplace(readBothClocks());
}

std::string LiveInput::names() const { return fmt::format("{}", fmt::join(names_, " ")); }

Status LiveInput::pass(std::int64_t wait_ms) {
  std::vector<pollfd> waiting;
  for (const auto& each : sources_) {
    if (const auto news = each->maintain()) cli::warn(*news);
    waiting.push_back({each->fileDescriptor(), POLLIN, 0});
  }
  ::poll(waiting.data(), waiting.size(), static_cast<int>(wait_ms));
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    if (Status drained = drain(i); !drained) return drained;
  }
  return {};
}

Status LiveInput::drain(std::size_t index) {
  for (int turn = 0; turn < kBatchesATurn; ++turn) {
    const auto datagrams = sources_[index]->receive();
    if (!datagrams) return datagrams.error();
    if (datagrams->empty()) break;
    if (clock_) (void)clock_->observe(readBothClocks());
    received_[index] += datagrams->size();
    for (const ReceivedDatagram& datagram : *datagrams) {
      const LogTime arrived = clock_ ? clock_->at(datagram.kernel_time)
                                     : LogTime(datagram.kernel_time.time_since_epoch());
      // The kernel's clock may be set back, and the times of several sockets are only nearly in
      // order.
      last_ = std::max(last_.value_or(LogTime{}), arrived);
      if (!first_) first_ = last_;
      take(index, datagram);
    }
  }
  return {};
}

void LiveInput::take(std::size_t index, const ReceivedDatagram& datagram) {
  if (sender_text_.empty() || sender_ != datagram.sender) {
    sender_ = datagram.sender;
    sender_text_ = sender_.text();
  }
  LiveDatagram taken{encodingOf(datagram.payload),
                     datagram.payload,
                     datagram.subject.empty() ? std::string_view(sender_text_) : "",
                     std::nullopt,
                     {}};
  if (decoder_ && taken.encoding != "rk1") {
    const MadePacket* const made = decoder_->decode(index, datagram, *last_);
    if (made != nullptr) taken.decoded = made->text;
    taken.not_finite = decoder_->decoder().decoders().notFinite();
  }
  take_(*last_, taken);
}

std::optional<LogTime> LiveInput::now() {
  if (!clock_) return last_;
  (void)clock_->observe(readBothClocks());
  return std::max(last_.value_or(LogTime{}), clock_->now());
}

std::vector<LossSpan> LiveInput::takeLosses() {
  std::vector<LossSpan> losses;
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    const auto dropped = sources_[i]->droppedByNow();
    if (!dropped || *dropped <= dropped_[i]) continue;
    LossSpan loss;
    loss.endpoint = names_[i];
    loss.from = losses_until_.value_or(first_.value_or(LogTime{}));
    loss.until = std::max(loss.from, last_.value_or(LogTime{}));
    loss.counts.kernel = *dropped - dropped_[i];
    dropped_[i] = *dropped;
    losses.push_back(loss);
  }
  losses_until_ = last_;
  return losses;
}

void LiveInput::warnOfSilence() const {
  for (const auto& each : sources_) {
    if (const auto text = neverAcceptedText(*each)) cli::warn(*text);
  }
  if (!first_ || sources_.size() < 2) return;
  for (std::size_t i = 0; i < sources_.size(); ++i) {
    if (received_[i] == 0) cli::warn(fmt::format("nothing arrived at {}", names_[i]));
  }
}

std::optional<UntrustedCounts> LiveInput::untrusted() const {
  std::optional<UntrustedCounts> all;
  for (const auto& each : sources_) {
    if (const auto one = each->counts().untrusted) {
      if (!all) all.emplace();
      *all += *one;
    }
  }
  return all;
}

std::optional<decode::DecodeAccount> LiveInput::decoded() const {
  if (!decoder_) return std::nullopt;
  return decoder_->decoder().account();
}

}  // namespace rocinante
