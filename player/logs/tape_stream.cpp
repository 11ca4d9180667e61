#include "player/logs/tape_stream.h"

#include <algorithm>
#include <utility>

namespace rocinante {
namespace {

// An empty turn would be repeated as fast as the machine can.
constexpr Nanoseconds kLeastTurn = std::chrono::milliseconds(1);
// Sources whose restatements overlap without end would make us restate endlessly.
constexpr std::uint32_t kMaxSettled = 64;

}  // namespace

Result<TapeStream> TapeStream::open(MultiLogReader& logs, const PlayRoutes& routes, TapeRun run) {
  TapeStream stream(logs, routes, std::move(run));
  if (const Status put = logs.seek(stream.run_.from, MultiLogReader::Which::received); !put) {
    return put.error();
  }
  return stream;
}

TapeStream::TapeStream(MultiLogReader& logs, const PlayRoutes& routes, TapeRun run)
    : logs_(&logs), routes_(&routes), run_(std::move(run)) {
  last_on_line_ = last_block_ = run_.start;
  settling_ = run_.state && run_.state->restatementOpen(run_.start);
}

Status TapeStream::beginTurn() {
  ++run_.span;
  after_turn_ = true;
  if (!run_.endless) --run_.turns_left;
  // The turn begins where the previous span ended; a first span may be shorter.
  const LogTime end_on_line = run_.bounds.until + shift_;
  const Nanoseconds played = run_.bounds.until - run_.start;
  shift_ = end_on_line - run_.turn.from + std::max(Nanoseconds(0), kLeastTurn - played);
  run_.bounds = run_.turn;
  run_.start = run_.turn.from;
  head_taken_ = true;
  settling_ = has_unplayed_ = any_in_turn_ = false;
  settled_ = 0;
  if (run_.turn_state) {
    run_.state = run_.turn_state;
    makeBlock(TapePosition::at(run_.turn.from), run_.turn.from);
  }
  return logs_->seek(TapePosition::at(run_.turn.from), MultiLogReader::Which::received);
}

bool TapeStream::isBlockWanted(LogTime moment) const {
  if (!run_.state) return false;
  if (has_unplayed_) return true;
  return run_.repeat && moment - last_block_ >= *run_.repeat &&
         !run_.state->restatementOpen(moment);
}

void TapeStream::makeBlock(TapePosition place, LogTime moment) {
  for (const auto& [source, memory] : run_.state->sources()) run_.sources.insert(source);
  block_ = restatedBlock(*run_.state, run_.sources, *routes_,
                         run_.part_id + "." + std::to_string(++blocks_), run_.restated_bytes);
  block_taken_ = 0;
  block_due_ = {moment + shift_, run_.span, true, after_turn_, 0, run_.bounds, place};
  last_block_ = moment;
  has_unplayed_ = false;
  settling_ = run_.state->restatementOpen(moment);
}

/// Reads the next message to play, folding others on the way. Empty at the end of the span.
Status TapeStream::readHead() {
  while (true) {
    Result<std::optional<LogMessage>> message = logs_->next();
    if (!message) return message.error();
    head_ = *message;
    if (!head_ || head_->log_time >= run_.bounds.until) {
      head_.reset();
      break;
    }
    if (head_->channel->captured()) break;
    if (run_.state && folder_.fold(*run_.state, *head_).applied) has_unplayed_ = true;
  }
  head_taken_ = false;
  if (!head_ || !run_.gap_limit) return {};
  const LogTime latest = last_on_line_ + *run_.gap_limit;
  if (head_->log_time + shift_ > latest) shift_ = latest - head_->log_time;
  return {};
}

Due TapeStream::headDue() const {
  return {head_->log_time + shift_,
          run_.span,
          false,
          after_turn_,
          routes_->played[logs_->place().log][head_->channel->id],
          run_.bounds,
          logs_->place()};
}

Result<std::optional<Due>> TapeStream::due() {
  while (!over_) {
    if (block_taken_ < block_.size()) {
      block_due_.route = block_[block_taken_].route;
      block_due_.continues = block_taken_ + 1 < block_.size();
      return std::optional(block_due_);
    }
    if (head_taken_) {
      if (const Status read = readHead(); !read) return read.error();
    }
    if (head_) {
      if (!isBlockWanted(head_->log_time)) return std::optional(headDue());
      makeBlock(logs_->place(), head_->log_time);
      continue;
    }
    // A turn without a message would loop forever.
    over_ = (!run_.endless && run_.turns_left == 0) || (after_turn_ && !any_in_turn_);
    if (over_) break;
    if (const Status begun = beginTurn(); !begun) return begun.error();
  }
  return std::optional<Due>();
}

ByteView TapeStream::take() {
  if (block_taken_ < block_.size()) return bytesOf(block_[block_taken_++].text);
  head_taken_ = any_in_turn_ = true;
  last_on_line_ = head_->log_time + shift_;
  if (run_.state) {
    const MessageFolder::Folded folded = folder_.fold(*run_.state, *head_);
    if (settling_ && folded.applied && folded.packet->header.part && settled_ < kMaxSettled) {
      ++settled_;
      makeBlock(logs_->place(), head_->log_time);
    }
    settling_ = settling_ && run_.state->restatementOpen(head_->log_time);
  }
  return head_->payload;
}

}  // namespace rocinante
