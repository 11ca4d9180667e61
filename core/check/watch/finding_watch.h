#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/bytes.h"
#include "core/cell/cell.h"
#include "core/check/reports/baseline.h"
#include "core/check/rules/check_report.h"
#include "core/check/session_check.h"

namespace rocinante {

struct WatchOptions {
  Severity least = Severity::note;  ///< less severe findings are passed over
  Severity fail_on = Severity::error;
  /// A finding ends when it has not occurred for this long.
  Nanoseconds hold = std::chrono::seconds(5);
  const Baseline* baseline = nullptr;  ///< what it accepts is passed over; borrowed
};

/// A finding that began or ended.
struct FindingChange {
  bool begins = false;
  bool fails = false;  ///< at least as severe as `fail_on`
  /// As it is now; `count`, `first` and `last` are those since it began. Without times for a fault
  /// of the cell.
  Finding finding;
  LogTime at{};  ///< when it began; when it last occurred
};

/// Judges a session without end, and says when each finding begins and when it ends.
///
/// **How.** One SessionCheck follows the session for ever. update() takes its findings as they are
/// now and compares them with those that last. Every kWindow the check forgets what it found
/// (dropFindings()) and nothing of what it follows: worst values, parts and drifts are those of the
/// last minutes, an hour of silence is an hour, and no state has to be built up again. So nothing
/// grows with the session.
///
/// **Which finding is which** is decided as in a baseline: by rule, subject, file and sentence
/// without numbers (BaselineKey).
///
/// **It begins** when it has occurred since the last update() and did not last; one without times
/// (nobody drives a device, a source never spoke) when it has stood for the hold, since sources may
/// be started a moment later; a fault of the cell at once. **It ends** when it has not occurred, or
/// has not stood, for the hold. One that begins again soon after it ended is given twice the hold
/// each time, up to kLongestHold, so that what flickers is reported a few times and not for ever.
///
/// Time is data: it reads no clock. Memory is bounded: kMax findings at a time; what is beyond is
/// not told (isFull()). The cell and the baseline must outlive it. One thread.
class FindingWatch {
 public:
  static constexpr Nanoseconds kPeriod = std::chrono::milliseconds(200);
  static constexpr Nanoseconds kWindow = std::chrono::seconds(60);
  static constexpr Nanoseconds kLongestHold = std::chrono::minutes(10);
  static constexpr std::size_t kMax = 1000;

  FindingWatch(const Cell& cell, const WatchOptions& options);

  /// The next datagram in time order, as SessionCheck takes it.
  void add(LogTime time, std::string_view encoding, bool captured, ByteView datagram,
           std::string_view sender = {}) {
    session_.add(time, encoding, captured, datagram, sender);
  }
  /// What is not packet text, and whether a decoder understood it; its packet is added as another.
  void addOctets(LogTime time, std::string_view encoding, bool decoded) {
    session_.addOctets(time, encoding, decoded);
  }
  /// Of the octets that are added next.
  void addNotFinite(LogTime time, const NotFiniteField& field) {
    session_.addNotFinite(time, field);
  }
  void addLoss(const LossSpan& span) { session_.addLoss(span); }

  /// What began and what ended up to `now`, which never decreases and is not before the latest
  /// datagram; to be called a few times a second. Begun ones first, the most severe of them first.
  std::vector<FindingChange> update(LogTime now);
  /// update() every kPeriod up to `now`, in fewer steps where that is far: for time that jumps, as
  /// in a file. To be called before a datagram of that time is added.
  std::vector<FindingChange> reach(LogTime now);

  std::uint64_t datagrams() const { return session_.datagrams(); }
  std::uint64_t packets() const { return session_.packets(); }
  /// Of a severity, that last now.
  std::size_t lasting(Severity severity) const;
  std::uint64_t begun() const { return begun_; }
  /// One that fails has begun.
  bool failed() const { return failed_; }
  /// There were more than kMax findings at a time: not all were reported.
  bool isFull() const { return is_full_; }

 private:
  struct Lasting {
    Finding finding;
    bool lasts = false;
    bool is_static = false;  ///< a fault of the cell: it lasts for ever
    Nanoseconds hold{};
    LogTime stands_since{};  ///< of one without times
    bool stood = false;      ///< at the last update()
    LogTime began{}, last{};
    LogTime ended{};
    std::uint64_t count = 0;    ///< since it began
    std::uint64_t counted = 0;  ///< of the window, up to the last update()
    std::uint64_t round = 0;    ///< of the update() that met it last
  };
  using Known = std::map<BaselineKey, Lasting>;

  void tellCell(std::vector<FindingChange>& changes, LogTime now);
  CheckReport findingsNow();
  void take(Finding finding, LogTime now, std::vector<FindingChange>& changes);
  void begin(Lasting& it, LogTime at, LogTime now, std::vector<FindingChange>& changes);
  void endOld(LogTime now, std::vector<FindingChange>& changes);
  void beginWindow(LogTime now);

  const Cell& cell_;
  WatchOptions options_;
  RuleSettings rules_;
  SessionCheck session_;
  CheckReport names_;  ///< of the cell, for keys
  Known known_;
  std::optional<LogTime> window_began_, updated_;
  std::uint64_t round_ = 0, begun_ = 0;
  bool failed_ = false, is_full_ = false;
};

/// One line, without its end: "2026-02-03T04:05:06.789Z begins: error: SENTENCE [RULE]"; with the
/// count and the span when it ends.
std::string findingChangeText(const FindingChange& change);
/// One JSON object on one line, with its end (docs/programs/check.md, "A standing watch").
std::string findingChangeJson(const FindingChange& change);

/// "2026-02-03T04:05:06.789Z": to the millisecond, for people.
std::string momentText(LogTime time);

}  // namespace rocinante
