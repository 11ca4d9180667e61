#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"

namespace rocinante {

/// What is sent of a log, and under which names.
struct LogChoice {
  std::vector<std::string> sources;  ///< patterns of the log's SOURCEs; empty: all
  std::vector<std::string> devices;  ///< patterns (statementLines); empty: every statement
  std::map<std::string, std::string, std::less<>> names;  ///< a SOURCE of the log: its new name

  bool includes(std::string_view source) const;
  /// The name that `source` is sent under.
  std::string_view nameOf(std::string_view source) const;
};

/// One source of the log as it is sent: its own name, its own count.
struct LogSpeaker {
  std::string name;
  std::uint64_t sequence = 0;         ///< of its next datagram; 0: it has not spoken yet
  std::uint64_t restatements = 0;     ///< so far: they name each other's parts
  LogTime restates = LogTime::max();  ///< when it restates itself next
};

/// The sources of a log as they are sent, and when each restates itself: at least once in `period`,
/// and not all at once. Pure: it sees time only through its arguments.
class LogSpeakers {
 public:
  using Speakers = std::map<std::string, LogSpeaker, std::less<>>;  ///< by SOURCE of the log

  /// `period` 0: they never restate themselves.
  explicit LogSpeakers(Nanoseconds period) : period_(period) {}

  /// The speaker for `source` of the log, made when new. bad_argument when another source has its
  /// name already.
  Result<LogSpeaker*> of(std::string_view source, std::string_view name);

  /// The one that restates itself next; null: none ever does.
  const Speakers::value_type* next() const;

  /// Plans those that have spoken anew: within a period from now, at equal distances.
  void spread(LogTime now);
  /// Plans one that has just spoken for the first time, in its place among the others.
  void begin(LogSpeaker& speaker, LogTime now);
  /// It has just restated itself.
  void restated(LogSpeaker& speaker, LogTime now) const;

  const Speakers& all() const { return speakers_; }

 private:
  Speakers speakers_;
  Nanoseconds period_;
};

}  // namespace rocinante
