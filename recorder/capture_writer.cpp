#include "recorder/capture_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/packet/decoder.h"

namespace rocinante {

CaptureWriter::CaptureWriter(LogWriter log, std::vector<ListenedEndpoint> endpoints,
                             CaptureLimits limits, const KeyframeOptions& keyframes)
    : session_(std::move(log), keyframes),
      endpoints_(std::move(endpoints)),
      limits_(limits),
      flows_(endpoints_),
      window_(endpoints_.size()),
      ledger_(endpoints_.size()),
      taken_(endpoints_.size()),
      saved_bytes_(logBytes()) {}

void CaptureWriter::write(TakenOver taken, HandOver& blocks) {
  for (std::unique_ptr<DatagramBlock>& block : taken.blocks) {
    DatagramBlock* key = block.get();
    const std::size_t count = block->arrivals().size();
    blocks_.emplace(key, BlockInUse{std::move(block), count});
    window_.add(*key);
  }
  for (const EndpointLoss& loss : taken.losses) {
    if (!end_ || loss.from < *end_) ledger_.add(loss);
  }
  steps_.insert(steps_.end(), taken.steps.begin(), taken.steps.end());

  while (const auto held = window_.next(taken.drained_until)) writeHeld(*held, blocks);
  const LogTime reached = taken.drained_until - ReorderWindow::kWidth;
  writeLosses(ledger_.due(reached));
  writeSteps(reached);
}

void CaptureWriter::flush(SteadyTime now) { keep(session_.log().flushIfDue(now)); }

void CaptureWriter::close(const std::string& reason, SteadyTime now, HandOver& blocks) {
  while (const auto held = window_.nextOfAll()) writeHeld(*held, blocks);
  writeLosses(ledger_.rest());
  writeSteps(LogTime::max());
  // The open chunk now, so that what the disk refuses of it can still be told in the file.
  keep(session_.log().flushIfDue(now + std::chrono::hours(24)));
  writeLosses(newDiskLosses());
  const std::string cause = trouble_ ? "refused" : reason;
  // What only the closing refused can no longer be told in the file, but is in the account.
  if (!keep(session_.log().close(cause))) (void)newDiskLosses();
}

void CaptureWriter::writeHeld(const ReorderWindow::Held& held, HandOver& blocks) {
  if (!end_ && limits_.until && held.time >= *limits_.until) end_ = *limits_.until;
  if (!end_) {
    writeDatagram(*held.arrival, held.time, held.block->payload(*held.arrival));
    if (limits_.max_packets && packets_ == *limits_.max_packets) end_ = held.time;
  }
  release(held.block, blocks);
}

void CaptureWriter::writeDatagram(const Arrival& arrival, LogTime time, ByteView payload) {
  // Decoded once, for its flow and for the fold.
  const Packet* const packet = decoder_.decode(payload);
  const std::size_t index = channelOf(arrival, payload, packet);
  if (index == channels_.size()) {
    const FlowChannel& channel = flows_.channels()[index];
    const Result<ChannelId> id =
        session_.addChannel(channel.topic, channel.encoding, channel.metadata);
    // FlowTable stays below what a log can have, so this is for a change of one without the other.
    if (!id && !trouble_) trouble_ = id.error();
    channels_.push_back({id ? *id : ChannelId{0}, 0});
  }
  if (logBytes() != saved_bytes_) {
    saved_bytes_ = logBytes();
    unsaved_since_ = time;
  } else if (unsaved_since_ == LogTime{}) {
    unsaved_since_ = time;
  }
  last_time_ = time;
  ++packets_;
  ++taken_[arrival.endpoint];
  payload_bytes_ += payload.size();
  ChannelState& channel = channels_[index];
  std::int64_t publish_time_ns = time.time_since_epoch().count();
  // A log has no times before 1970.
  if (packet != nullptr && packet->header.time_ns && *packet->header.time_ns >= 0) {
    publish_time_ns = *packet->header.time_ns;
  }
  keep(session_.write(channel.id, channel.sequence++, time, publish_time_ns, payload, packet));
}

std::size_t CaptureWriter::channelOf(const Arrival& arrival, ByteView payload,
                                     const Packet* packet) {
  Flow flow{arrival.endpoint, arrival.sender, {}, false, false};
  if (packet != nullptr) {
    flow.source = packet->header.source;
    flow.is_packet_text = true;
    flow.is_restated = !packet->header.by.empty();
    if (flow.is_restated) ++restated_;
  } else {
    flow.is_packet_text = encodingOf(payload) == "rk1";
  }
  return flows_.channelOf(flow);
}

void CaptureWriter::writeLosses(const std::vector<EndpointLoss>& losses) {
  for (const EndpointLoss& loss : losses) {
    Endpoint endpoint = endpoints_[loss.endpoint].endpoint;
    endpoint.address.port = endpoints_[loss.endpoint].bound.port;
    keep(session_.log().writeLoss({endpoint.text(), loss.from, loss.until, loss.counts}));
  }
}

void CaptureWriter::writeSteps(LogTime reached) {
  const auto later = std::stable_partition(
      steps_.begin(), steps_.end(), [&](const ClockStep& step) { return step.at <= reached; });
  for (auto step = steps_.begin(); step != later; ++step) {
    if (!clock_channel_) {
      const Result<ChannelId> id = session_.addChannel("/rocinante/clock", "json", {});
      if (!id) break;
      clock_channel_ = *id;
    }
    last_time_ = std::max(last_time_, step->at);
    const std::string text = fmt::format(R"({{"noticed_ns":{},"step_ns":{}}})",
                                         step->at.time_since_epoch().count(), step->step.count());
    keep(session_.write(*clock_channel_, clock_sequence_++, last_time_,
                        last_time_.time_since_epoch().count(), bytesOf(text)));
  }
  steps_.erase(steps_.begin(), later);
}

void CaptureWriter::release(DatagramBlock* block, HandOver& blocks) {
  const auto in_use = blocks_.find(block);
  if (--in_use->second.waiting > 0) return;
  blocks.giveBack(std::move(in_use->second.block));
  blocks_.erase(in_use);
}

bool CaptureWriter::keep(const Status& done) {
  if (!done && !trouble_) trouble_ = done.error();
  return done.ok();
}

std::vector<EndpointLoss> CaptureWriter::newDiskLosses() {
  std::vector<EndpointLoss> losses;
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    const auto refused = session_.log().refusedByDisk().find(channels_[i].id);
    if (refused == session_.log().refusedByDisk().end()) continue;
    EndpointLoss loss{flows_.channels()[i].endpoint, unsaved_since_, last_time_, {}};
    loss.counts.disk = refused->second;
    addLoss(losses, loss);
  }
  // The log counts from its beginning; what was added before is not new.
  for (EndpointLoss& loss : losses) loss.counts.disk -= ledger_.totals()[loss.endpoint].disk;
  std::erase_if(losses, [](const EndpointLoss& loss) { return loss.counts.disk == 0; });
  for (const EndpointLoss& loss : losses) ledger_.add(loss);
  (void)ledger_.rest();
  return losses;
}

std::uint64_t CaptureWriter::lost() const {
  std::uint64_t lost = 0;
  for (const LossCounts& each : ledger_.totals()) lost += each.kernel + each.queue + each.disk;
  return lost;
}

std::vector<EndpointAccount> CaptureWriter::accounts() const {
  std::vector<EndpointAccount> accounts;
  for (std::size_t i = 0; i < endpoints_.size(); ++i) {
    const LossCounts& losses = ledger_.totals()[i];
    accounts.push_back({endpoints_[i], taken_[i] - losses.disk, losses});
  }
  return accounts;
}

}  // namespace rocinante
