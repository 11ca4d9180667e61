#include "player/play_stream.h"

#include <utility>

#include "core/packet/restatement.h"

namespace rocinante {

Result<PlayStream> PlayStream::open(LogMerge& logs, const Options& options) {
  PlayStream stream(logs, options);
  if (options.restate) {
    Result<StateBefore> before = stateBefore(logs, options.span.from);
    if (!before) return before.error();
    stream.before_ = std::move(*before);
  }
  if (const Status begun = stream.beginTurn(0); !begun) return begun.error();
  return stream;
}

Status PlayStream::beginTurn(std::uint32_t turn) {
  turn_ = turn;
  restatement_.clear();
  restated_ = 0;
  if (options_.restate) {
    // A part ID of its own: a part lost in one turn must not be made up for by the next one's.
    const std::string part_id = "play" + std::to_string(turn + 1);
    RestatementOptions how;
    how.by = "play";
    how.reset = true;
    how.part_id = part_id;
    restatement_ = restateAll(before_.state, how);
    // A source that speaks only later must be forgotten too by who listened before.
    for (const std::string& source : before_.silent_sources) {
      std::vector<std::string> parts = restate(before_.state, source, how);
      std::move(parts.begin(), parts.end(), std::back_inserter(restatement_));
    }
  }
  head_taken_ = true;
  return logs_->seek(options_.span.from, LogMerge::Which::captured);
}

LogTime PlayStream::shifted(LogTime time) const {
  return time + (options_.span.until - options_.span.from) * turn_;
}

Result<std::optional<Due>> PlayStream::due() {
  while (!over_) {
    if (restated_ < restatement_.size()) {
      const Nanoseconds ahead = turn_ == 0 ? options_.restate_ahead : Nanoseconds(0);
      return std::optional(Due{shifted(options_.span.from) - ahead, turn_, true});
    }
    if (head_taken_) {
      Result<std::optional<LogMessage>> message = logs_->next();
      if (!message) return message.error();
      head_ = *message;
      head_taken_ = false;
    }
    if (head_ && head_->log_time < options_.span.until) {
      return std::optional(Due{shifted(head_->log_time), turn_, false});
    }
    over_ = turn_ + 1 == options_.turns;
    if (over_) break;
    if (const Status begun = beginTurn(turn_ + 1); !begun) return begun.error();
  }
  return std::optional<Due>();
}

ByteView PlayStream::take() {
  if (restated_ < restatement_.size()) return bytesOf(restatement_[restated_++]);
  head_taken_ = true;
  return head_->payload;
}

}  // namespace rocinante
