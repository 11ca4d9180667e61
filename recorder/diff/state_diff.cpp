#include "recorder/diff/state_diff.h"

#include <algorithm>

#include "core/base/hash.h"
#include "core/session/message_folder.h"

namespace rocinante {
namespace {

/// One log, folded moment by moment.
class Fold {
 public:
  explicit Fold(LogReader& reader) : reader_(reader) {}

  Status begin() {
    if (Status rewound = reader_.rewind(); !rewound) return rewound;
    return advance();
  }

  /// The time of the next folded message.
  std::optional<LogTime> next() const {
    if (!message_) return std::nullopt;
    return message_->log_time;
  }

  /// Folds every message of this moment; `told` collects their payloads, in order.
  Status fold(LogTime moment, Bytes& told) {
    told.clear();
    while (message_ && message_->log_time == moment) {
      const auto digest = xxh3(message_->payload);
      told.insert(told.end(), digest.begin(), digest.end());
      const auto encoding = xxh3(bytesOf(message_->channel->encoding));
      told.insert(told.end(), encoding.begin(), encoding.end());
      folder_.fold(state_, *message_);
      if (Status advanced = advance(); !advanced) return advanced;
    }
    return {};
  }

  const SessionState& state() const { return state_; }

 private:
  Status advance() {
    do {
      Result<std::optional<LogMessage>> next = reader_.next();
      if (!next) return next.error();
      message_ = *next;
    } while (message_ && !message_->channel->folded());
    return {};
  }

  LogReader& reader_;
  std::optional<LogMessage> message_;  ///< the next to be folded
  MessageFolder folder_;
  SessionState state_;
};

std::vector<std::string> sortedLines(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  std::ranges::sort(lines);
  return lines;
}

void describe(const SessionState& a, const SessionState& b, StateDiff& diff) {
  const std::vector<std::string> lines_a = sortedLines(a.identityText());
  const std::vector<std::string> lines_b = sortedLines(b.identityText());
  std::ranges::set_difference(lines_a, lines_b, std::back_inserter(diff.only_a));
  std::ranges::set_difference(lines_b, lines_a, std::back_inserter(diff.only_b));
  diff.items_only_a = diff.only_a.size();
  diff.items_only_b = diff.only_b.size();
  for (std::vector<std::string>* items : {&diff.only_a, &diff.only_b}) {
    if (items->size() > LogDiff::kMaxItems) items->resize(LogDiff::kMaxItems);
  }
}

}  // namespace

Result<StateDiff> diffStates(LogReader& a, LogReader& b,
                             const std::function<void(LogTime)>& progress) {
  Fold fold_a(a);
  Fold fold_b(b);
  for (Fold* fold : {&fold_a, &fold_b}) {
    if (Status begun = fold->begin(); !begun) return begun.error();
  }
  StateDiff diff;
  Bytes told_a;
  Bytes told_b;
  while (fold_a.next() || fold_b.next()) {
    const LogTime never{Nanoseconds::max()};
    const LogTime moment = std::min(fold_a.next().value_or(never), fold_b.next().value_or(never));
    if (Status folded = fold_a.fold(moment, told_a); !folded) return folded.error();
    if (Status folded = fold_b.fold(moment, told_b); !folded) return folded.error();
    // Equal states that fold equal messages stay equal.
    if (!diff.differs && told_a != told_b && !fold_a.state().sameAs(fold_b.state())) {
      diff.differs = true;
      diff.first = moment;
      describe(fold_a.state(), fold_b.state(), diff);
    }
    if (progress) progress(moment);
  }
  diff.ends_differ = !fold_a.state().sameAs(fold_b.state());
  return diff;
}

}  // namespace rocinante
