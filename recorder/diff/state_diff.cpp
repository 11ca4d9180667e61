#include <algorithm>
#include <cstdlib>

#include "core/base/hash.h"
#include "core/packet/state_items.h"
#include "core/session/message_folder.h"
#include "recorder/diff/log_diff.h"

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

  /// Folds every message of this moment; `encoded` collects their payloads, in order.
  Status fold(LogTime moment, Bytes& encoded) {
    encoded.clear();
    while (message_ && message_->log_time == moment) {
      const auto digest = xxh3(message_->payload);
      encoded.insert(encoded.end(), digest.begin(), digest.end());
      const auto encoding = xxh3(bytesOf(message_->channel->encoding));
      encoded.insert(encoded.end(), encoding.begin(), encoding.end());
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

/// True for the same pose: a quaternion and its negative turn alike.
bool isSamePose(const PoseValue& a, const PoseValue& b) {
  const Quat& q = b.pose.orientation;
  return a.carrier == b.carrier && a.pose.position == b.pose.position &&
         (a.pose.orientation == q || a.pose.orientation == Quat(-q.w, -q.x, -q.y, -q.z));
}

bool isSameDevice(const DeviceState& a, const DeviceState& b) {
  if (a == b) return true;
  if (!a.pose || !b.pose || !isSamePose(a.pose->value, b.pose->value)) return false;
  DeviceState turned = b;
  turned.pose->value = a.pose->value;
  return a == turned;
}

/// SessionState::sameAs(), but for the sign of quaternions.
bool isSameState(const SessionState& a, const SessionState& b) {
  if (a.sameAs(b)) return true;
  return sameItems(a, b, isSameDevice) && a.sources() == b.sources();
}

/// A line of SessionState::identityText(); of a pose's two quaternions the one whose last number
/// that is not zero is positive.
std::string withSignOfPose(std::string line) {
  const std::size_t pose = line.find(" pose ");
  if (pose == std::string::npos) return line;
  std::vector<std::size_t> words;  // where DEVICE and its numbers begin
  for (std::size_t at = pose + 5; at != std::string::npos; at = line.find(' ', at + 1)) {
    words.push_back(at + 1);
  }
  constexpr std::size_t kNumbers = 8, kFirst = 4;
  if (words.size() < kNumbers) return line;
  const auto isZero = [&](std::size_t word) {
    return std::strtod(line.c_str() + words[word], nullptr) == 0;
  };
  std::size_t last = kNumbers;
  while (--last > kFirst && isZero(last)) {
  }
  if (line[words[last]] != '-') return line;
  for (std::size_t word = kNumbers; word-- > kFirst;) {
    if (line[words[word]] == '-') {
      line.erase(words[word], 1);
    } else if (!isZero(word)) {
      line.insert(words[word], "-");
    }
  }
  return line;
}

std::vector<std::string> sortedLines(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    lines.push_back(withSignOfPose(text.substr(at, end - at)));
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
  Bytes folded_a;
  Bytes folded_b;
  while (fold_a.next() || fold_b.next()) {
    const LogTime never{Nanoseconds::max()};
    const LogTime moment = std::min(fold_a.next().value_or(never), fold_b.next().value_or(never));
    if (Status folded = fold_a.fold(moment, folded_a); !folded) return folded.error();
    if (Status folded = fold_b.fold(moment, folded_b); !folded) return folded.error();
    // Equal states that fold equal messages stay equal.
    if (!diff.differs && folded_a != folded_b && !isSameState(fold_a.state(), fold_b.state())) {
      diff.differs = true;
      diff.first = moment;
      describe(fold_a.state(), fold_b.state(), diff);
    }
    if (progress) progress(moment);
  }
  diff.ends_differ = !isSameState(fold_a.state(), fold_b.state());
  return diff;
}

}  // namespace rocinante
