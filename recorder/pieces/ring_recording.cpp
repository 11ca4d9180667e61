#include "recorder/pieces/ring_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "core/base/duration_text.h"
#include "core/base/figure_text.h"
#include "core/log/loss_message.h"
#include "core/session/message_folder.h"

namespace rocinante {
namespace {

/// Kept beyond the span, so that a file can begin where no restatement is unfinished: one is
/// abandoned after a second.
constexpr Nanoseconds kMargin = std::chrono::seconds(1);
/// Items written at a time: a few milliseconds, during which the queue buffers datagrams.
constexpr std::uint64_t kItemsATime = 8'192;
constexpr const char* kRingReason = "ring";

}  // namespace

RingRecording::RingRecording(Options options, NoteBox& notes)
    : options_(std::move(options)),
      notes_(notes),
      triggers_(options_.triggers),
      ring_(options_.ring.max_bytes),
      shelf_(options_.limits, notes) {}

Status RingRecording::begin(const SessionState& preceding, LogTime) {
  tail_ = preceding;
  return {};
}

void RingRecording::fold(const RingBuffer::Item& item, SessionState& state) {
  if (item.kind != RingBuffer::Kind::datagram) return;
  const bool is_packet_text = channels_[item.flow]->encoding == decoder_.encoding();
  if (!is_packet_text && item.made.empty()) return;
  if (const Packet* const packet = decoder_.decode(is_packet_text ? item.payload : item.made)) {
    foldPacket(state, item.time, *packet);
  }
}

void RingRecording::dropFront() {
  fold(ring_.front(), tail_);
  ring_.popFront();
}

void RingRecording::dropOld(LogTime now) {
  const LogTime oldest = now - options_.ring.span - kMargin;
  while (!ring_.empty() && ring_.front().time < oldest && !(file_ && next_ == ring_.begin())) {
    dropFront();
  }
}

void RingRecording::add(const RingBuffer::Item& item) {
  last_ = item.time;
  dropOld(item.time);
  while (!ring_.add(item)) {
    // The file takes precedence: write its items before the ring drops them.
    while (file_ && next_ == ring_.begin()) writeSome(kItemsATime);
    dropped_early_ = ring_.front().time;
    dropFront();
  }
}

Status RingRecording::write(const CapturedDatagram& datagram) {
  if (!origin_ && datagram.captured()) origin_ = datagram.time;
  if (channels_.size() <= datagram.flow) channels_.resize(datagram.flow + 1);
  if (!channels_[datagram.flow]) channels_[datagram.flow] = *datagram.channel;
  triggerBySilence(datagram.time);
  RingBuffer::Item item{RingBuffer::Kind::datagram, datagram.time,
                        datagram.publish_time_ns,   static_cast<std::uint32_t>(datagram.flow),
                        datagram.sequence,          datagram.payload};
  if (const MadePacket* const made = datagram.made) {
    item.made = bytesOf(made->text);
    item.decoder = static_cast<std::uint8_t>(made->decoder);
    if (decoders_.size() <= made->decoder) decoders_.resize(made->decoder + 1);
    decoders_[made->decoder] = made->metadata;
  }
  add(item);
  if (const Condition* const met = triggers_.metBy(datagram.time, datagram.packet)) {
    trigger(datagram.time, met->text());
  }
  if (options_.watch) {
    if (datagram.made != nullptr) {
      options_.watch->addMade(datagram.time, datagram.channel->encoding,
                              bytesOf(datagram.made->text));
    } else {
      options_.watch->add(datagram.time, datagram.channel->encoding, datagram.captured(),
                          datagram.payload);
    }
    triggerByFinding();
  }
  return {};
}

void RingRecording::triggerByFinding() {
  for (const FindingTrigger::Begun& each : options_.watch->take()) {
    if (file_) notes_.say("found: " + each.text);
    trigger(std::min(each.at, last_), each.text);
  }
}

/// Called before anything of the span is dropped.
void RingRecording::triggerBySilence(LogTime reached) {
  if (const Condition* const met = triggers_.metBySilence(reached)) {
    trigger(triggers_.moment(), met->text());
  }
}

Status RingRecording::writeLoss(const LossSpan& span) {
  const std::string text = lossText(span);
  if (options_.watch) options_.watch->addLoss(span);
  add({RingBuffer::Kind::loss, std::max(last_, span.until), 0, 0, 0, bytesOf(text)});
  return {};
}

Status RingRecording::writeStep(const ClockStep& step) {
  const ByteView bytes(reinterpret_cast<const std::byte*>(&step), sizeof step);
  add({RingBuffer::Kind::step, std::max(last_, step.at), 0, 0, 0, bytes});
  return {};
}

void RingRecording::trigger(LogTime moment, const std::string& why) {
  if (file_) {
    until_ = std::max(until_, moment + options_.ring.after);
    ++about_file_.triggers;
    return;
  }
  startFile(moment, why);
}

/// The last place up to `from` where no restatement is unfinished, or else the first one within
/// kMargin after it; `state` becomes the fold of everything before.
RingBuffer::Place RingRecording::placeToBegin(LogTime from, SessionState& state) {
  state = tail_;
  std::optional<RingBuffer::Place> closed;
  RingBuffer::Place place = ring_.begin();
  for (; !(place == ring_.end()); place = ring_.after(place)) {
    const RingBuffer::Item item = ring_.at(place);
    const bool is_closed = !state.restatementOpen(item.time);
    if (item.time >= from && (is_closed || closed || item.time - from > kMargin)) {
      if (is_closed || !closed) return place;
      break;
    }
    if (is_closed) closed = place;
    fold(item, state);
  }
  if (place == ring_.end()) return place;
  state = tail_;
  for (place = ring_.begin(); !(place == *closed); place = ring_.after(place)) {
    fold(ring_.at(place), state);
  }
  return place;
}

void RingRecording::startFile(LogTime moment, const std::string& why) {
  const auto ours = [&](const std::filesystem::path& path) { return shelf_.holds(path); };
  Result<MadePiece> made = options_.make(moment, ours);
  if (!made) {
    notes_.warn(fmt::format("{}: cannot write the ring: {}", why, made.error().text()));
    return;
  }
  file_ = std::make_unique<PieceLog>(std::move(*made), options_.keyframes);
  const LogTime from = moment - options_.ring.span;
  SessionState state;
  next_ = placeToBegin(from, state);
  const bool is_empty = next_ == ring_.end();
  const LogTime opening = is_empty ? std::max(last_, from) : ring_.at(next_).time;
  until_ = moment + options_.ring.after;
  about_file_ = {};
  about_file_.triggers = 1;
  about_file_.why = why;
  about_file_.triggered = moment;
  about_file_.cut_short = dropped_early_ && *dropped_early_ >= from;
  std::string text =
      fmt::format("{}: {:.1f} s to {}", why, secondsOf(moment - std::max(from, opening)),
                  file_->file().path.string());
  if (about_file_.cut_short) {
    text += fmt::format(", not {} s: --ring-size {} was full", secondsText(options_.ring.span),
                        sizeText(ring_.maxBytes()));
  }
  notes_.say(std::move(text));
  if (Status begun = file_->begin(state, opening, origin_); !begun) {
    notes_.warn(begun.error().text());
    closeFile("refused");
  }
}

Status RingRecording::writeItem(const RingBuffer::Item& item) {
  switch (item.kind) {
    case RingBuffer::Kind::loss: {
      const std::optional<LossSpan> loss = parseLoss(item.payload);
      return loss ? file_->writeLoss(*loss) : Status();
    }
    case RingBuffer::Kind::step: {
      ClockStep step{};
      std::memcpy(&step, item.payload.data(), sizeof step);
      return file_->writeStep(step);
    }
    case RingBuffer::Kind::datagram:
      break;
  }
  CapturedDatagram datagram;
  datagram.flow = item.flow;
  datagram.channel = &*channels_[item.flow];
  datagram.sequence = item.sequence;
  datagram.time = item.time;
  datagram.publish_time_ns = item.publish_time_ns;
  datagram.payload = item.payload;
  MadePacket made;
  if (!item.made.empty()) {
    made.decoder = item.decoder;
    made.metadata = decoders_[item.decoder];
    made.text = textOf(item.made);
    datagram.made = &made;
  }
  return file_->write(datagram, /*decoded=*/false);
}

/// Writes the file's next items, at most `most`, and closes it when it is complete.
void RingRecording::writeSome(std::uint64_t most) {
  for (; file_ && !(next_ == ring_.end()) && most > 0; --most) {
    const RingBuffer::Item item = ring_.at(next_);
    if (item.time > until_) {
      closeFile(kRingReason);
      return;
    }
    next_ = ring_.after(next_);
    if (Status written = writeItem(item); !written) {
      notes_.warn(written.error().text());
      closeFile("refused");
    }
  }
}

void RingRecording::closeFile(const std::string& reason) {
  if (Status flushed = file_->flushAll(); !flushed && reason == kRingReason) {
    notes_.warn(flushed.error().text());
  }
  shelf_.put(std::move(file_), reason, about_file_);
  shelf_.keepLimits(std::nullopt);
}

Status RingRecording::flush(LogTime reached, SteadyTime now) {
  triggerBySilence(reached);
  if (options_.watch) {
    options_.watch->reach(reached);
    triggerByFinding();
  }
  dropOld(reached);
  writeSome(kItemsATime);
  if (file_ && next_ == ring_.end() && reached > until_) closeFile(kRingReason);
  if (file_) {
    if (Status flushed = file_->flush(now); !flushed) {
      notes_.warn(flushed.error().text());
      closeFile("refused");
    }
  }
  if (file_) {
    if (const auto disturbed = file_->newDisturbance()) notes_.warn(disturbed->text());
  }
  if (file_) shelf_.keepLimits(file_->bytes());
  if (Status settled = shelf_.settle(); !settled) notes_.warn(settled.error().text());
  return {};
}

Status RingRecording::close(const std::string& reason) {
  if (options_.watch) {
    options_.watch->finish();
    triggerByFinding();
    if (const std::uint64_t dropped = options_.watch->dropped(); dropped > 0) {
      notes_.warn(fmt::format("--watch fell behind: {} not judged, all were kept",
                              countText(dropped, "datagram")));
    }
  }
  while (file_ && !(next_ == ring_.end())) writeSome(kItemsATime);
  if (file_) closeFile(reason);
  if (Status settled = shelf_.finish(); !settled) notes_.warn(settled.error().text());
  return {};
}

Nanoseconds RingRecording::held() const {
  if (ring_.empty()) return Nanoseconds(0);
  return std::min<Nanoseconds>(last_ - ring_.front().time, options_.ring.span);
}

}  // namespace rocinante
