#include "core/recording/capture_writer.h"

#include <algorithm>
#include <utility>

#include "core/net/datagram_source.h"
#include "core/session/message_folder.h"

namespace rocinante {

CaptureWriter::CaptureWriter(std::unique_ptr<CaptureSink> sink,
                             std::vector<ListenedEndpoint> endpoints, CaptureLimits limits,
                             std::shared_ptr<OctetDecoder> octets)
    : sink_(std::move(sink)),
      endpoints_(std::move(endpoints)),
      limits_(std::move(limits)),
      flows_(endpoints_),
      octets_(std::move(octets)),
      window_(endpoints_.size()),
      ledger_(endpoints_.size()),
      taken_(endpoints_.size()),
      started_(limits_.start_on.empty()),
      start_(limits_.start_on),
      stop_(limits_.stop_on),
      saved_bytes_(logBytes()) {
  if (octets_ && !started_) flows_before_.emplace(endpoints_);
}

void CaptureWriter::write(TakenOver taken, HandOver& blocks) {
  for (std::unique_ptr<DatagramBlock>& block : taken.blocks) {
    DatagramBlock* key = block.get();
    const std::size_t count = block->arrivals().size();
    blocks_.emplace(key, BlockInUse{std::move(block), count});
    window_.add(*key);
  }
  for (const EndpointLoss& loss : taken.losses) {
    if (!end_ || loss.from < *end_) new_losses_.push_back(loss);
  }
  steps_.insert(steps_.end(), taken.steps.begin(), taken.steps.end());
  drained_until_ = taken.drained_until;

  while (const auto held = window_.next(taken.drained_until)) writeHeld(*held, blocks);
  const LogTime reached = taken.drained_until - ReorderWindow::kWidth;
  if (!started_) {
    // Losses and clock steps before the recording are not part of it.
    new_losses_.clear();
    steps_.clear();
    return;
  }
  enterLosses(LogTime::max());
  // A loss is written after what is already there; a step has its own time.
  writeSteps(reached);
  writeLosses(ledger_.due(reached));
  if (!end_ && stop_.metBySilence(reached) != nullptr) endAt(stop_.moment(), "condition");
}

void CaptureWriter::flush(SteadyTime now) {
  keep(sink_->flush(drained_until_ - ReorderWindow::kWidth, now));
}

std::optional<std::uint64_t> CaptureWriter::save() {
  if (trouble_ || !keep(sink_->flushAll())) return std::nullopt;
  return packets_ + packets_before_;
}

void CaptureWriter::close(const std::string& reason, HandOver& blocks) {
  while (const auto held = window_.nextOfAll()) writeHeld(*held, blocks);
  writeSteps(LogTime::max());
  writeLosses(ledger_.rest());
  keep(sink_->flushAll());
  writeLosses(newDiskLosses());
  const std::string cause = trouble_ ? "refused" : reason;
  // Losses caused by closing can no longer be written to the file, but are in the account.
  if (!keep(sink_->close(cause))) (void)newDiskLosses();
}

void CaptureWriter::writeHeld(const ReorderWindow::Held& held, HandOver& blocks) {
  if (!end_ && limits_.until && held.time >= *limits_.until) endAt(*limits_.until, "duration");
  if (!end_ && stop_.metBySilence(held.time) != nullptr) endAt(stop_.moment(), "condition");
  if (!end_) takeDatagram(*held.arrival, held.time, held.block->payload(*held.arrival));
  release(held.block, blocks);
}

void CaptureWriter::takeDatagram(const Arrival& arrival, LogTime time, ByteView payload) {
  // Decoded once: for its flow, for the conditions and for the fold.
  const Packet* const packet = decoder_.decode(payload);
  if (packet == nullptr && octets_) return takeOctets(arrival, time, payload);
  if (!started_ && !begins(time, packet)) return;
  writeDatagram(arrival, time, payload, flowOf(flows_, arrival, payload, packet), packet, nullptr);
  endWith(time, packet);
}

void CaptureWriter::takeOctets(const Arrival& arrival, LogTime time, ByteView payload) {
  FlowTable& flows = started_ ? flows_ : *flows_before_;
  std::size_t flow = flowOf(flows, arrival, payload, nullptr);
  const FlowChannel& channel = flows.channels()[flow];
  const MadePacket* made = nullptr;
  // Damaged packet text is nobody's octets.
  if (channel.encoding != "rk1") {
    made = octets_->decode(channel, time.time_since_epoch().count(), payload);
  }
  const Packet* const packet = made == nullptr ? nullptr : made->packet;
  if (!started_) {
    if (!begins(time, packet)) return;
    flow = flowOf(flows_, arrival, payload, nullptr);
  }
  writeDatagram(arrival, time, payload, flow, packet, made);
  endWith(time, packet);
}

void CaptureWriter::endWith(LogTime time, const Packet* packet) {
  if (limits_.max_packets && packets_ == *limits_.max_packets) endAt(time, "packets");
  if (stop_.any() && stop_.metBy(time, packet) != nullptr && !end_) endAt(time, "condition");
}

bool CaptureWriter::begins(LogTime time, const Packet* packet) {
  if (start_.metBy(time, packet) == nullptr) {
    ++packets_before_;
    if (packet != nullptr) foldPacket(before_, time, *packet);
    return false;
  }
  started_ = true;
  flows_before_.reset();
  if (limits_.duration) limits_.until = time + *limits_.duration;
  std::erase_if(new_losses_, [&](const EndpointLoss& loss) { return loss.until < time; });
  std::erase_if(steps_, [&](const ClockStep& step) { return step.at < time; });
  keep(sink_->begin(std::exchange(before_, {}), time));
  return true;
}

void CaptureWriter::writeDatagram(const Arrival& arrival, LogTime time, ByteView payload,
                                  std::size_t flow, const Packet* packet, const MadePacket* made) {
  if (sink_->seamDue(time)) {
    enterLosses(time);
    writeSteps(time - Nanoseconds(1));
    writeLosses(ledger_.upTo(time));
    keep(sink_->seam(time));
  }
  if (flow == sequences_.size()) sequences_.push_back(0);
  if (logBytes() != saved_bytes_) {
    saved_bytes_ = logBytes();
    unsaved_since_ = time;
  } else if (unsaved_since_ == LogTime{}) {
    unsaved_since_ = time;
  }
  if (!first_time_) first_time_ = time;
  last_time_ = time;
  ++packets_;
  ++taken_[arrival.endpoint];
  if (packet != nullptr && !packet->header.by.empty()) ++restated_;
  payload_bytes_ += payload.size();
  CapturedDatagram datagram;
  datagram.flow = flow;
  datagram.channel = &flows_.channels()[flow];
  datagram.sequence = sequences_[flow]++;
  datagram.time = time;
  datagram.publish_time_ns = time.time_since_epoch().count();
  // A log has no times before 1970.
  if (packet != nullptr && packet->header.time_ns && *packet->header.time_ns >= 0) {
    datagram.publish_time_ns = *packet->header.time_ns;
  }
  datagram.payload = payload;
  datagram.packet = packet;
  datagram.made = made;
  keep(sink_->write(datagram));
}

std::size_t CaptureWriter::flowOf(FlowTable& flows, const Arrival& arrival, ByteView payload,
                                  const Packet* packet) {
  Flow flow{arrival.endpoint, arrival.sender, {}, false, false};
  const auto destination = DatagramBlock::destinationOf(arrival, payload);
  if (destination) flow.destination = &*destination;
  flow.subject = DatagramBlock::subjectOf(arrival, payload);
  if (packet != nullptr) {
    flow.source = packet->header.source;
    flow.is_packet_text = true;
    flow.is_restated = !packet->header.by.empty();
  } else {
    flow.is_packet_text = encodingOf(payload) == "rk1";
  }
  return flows.channelOf(flow);
}

void CaptureWriter::enterLosses(LogTime time) {
  std::erase_if(new_losses_, [&](const EndpointLoss& loss) {
    if (loss.until > time) return false;
    ledger_.add(loss);
    return true;
  });
}

void CaptureWriter::writeLosses(const std::vector<EndpointLoss>& losses) {
  for (const EndpointLoss& loss : losses) {
    const ListenedEndpoint& listened = endpoints_[loss.endpoint];
    const std::string endpoint = boundText(listened.endpoint, listened.bound);
    keep(sink_->writeLoss({endpoint, loss.from, loss.until, loss.counts}));
  }
}

void CaptureWriter::writeSteps(LogTime reached) {
  const auto later = std::stable_partition(
      steps_.begin(), steps_.end(), [&](const ClockStep& step) { return step.at <= reached; });
  for (auto step = steps_.begin(); step != later; ++step) keep(sink_->writeStep(*step));
  steps_.erase(steps_.begin(), later);
}

void CaptureWriter::endAt(LogTime time, const char* reason) {
  end_ = time;
  end_reason_ = reason;
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
  const std::vector<std::uint64_t> refused = sink_->refusedByFlow();
  std::vector<EndpointLoss> losses;
  for (std::size_t flow = 0; flow < refused.size(); ++flow) {
    if (refused[flow] == 0) continue;
    EndpointLoss loss{flows_.channels()[flow].endpoint, unsaved_since_, last_time_, {}};
    loss.counts.disk = refused[flow];
    addLoss(losses, loss);
  }
  // The sink counts from its beginning; counts added before are not new.
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
