#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/cell/cell.h"
#include "core/check/judges/cadence_judge.h"
#include "core/check/judges/clock_judge.h"
#include "core/check/judges/sender_judge.h"
#include "core/check/judges/static_items.h"
#include "core/check/judges/tally.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// The clocks of one source. A program has one; a topic of a bag may have several publishers, each
/// with stamps of its own, and each writes things of its own: PacketPlace::publisher tells them
/// apart. What is beyond the bound shares one.
class SourceClocks {
 public:
  explicit SourceClocks(const ClockThresholds& thresholds)
      : thresholds_(thresholds), own_(thresholds) {}

  void take(const PacketPlace& place) { clockOf(place.publisher).take(place); }
  void ignore() {
    is_ignored_ = true;
    own_.ignore();
    for (auto& [name, clock] : others_) clock.ignore();
  }
  void dropFindings() {
    own_.dropFindings();
    for (auto& [name, clock] : others_) clock.dropFindings();
  }
  /// Steps of each publisher by itself; a skew or a drift, which all may share, once.
  void report(const std::string& source, Findings& findings) const;

 private:
  static constexpr std::size_t kMaxPublishers = 32;

  ClockJudge& clockOf(std::string_view publisher);

  ClockThresholds thresholds_;
  bool is_ignored_ = false;
  ClockJudge own_;
  std::map<std::string, ClockJudge, std::less<>> others_;
};

class RuleSettings;

/// Thresholds for one source.
struct SourceThresholds {
  ClockThresholds clock;
  CadenceThresholds cadence;
  double restate_s = 10;

  /// Those of the rules, overridden by the cell's limits for this source; null: the cell has none.
  static SourceThresholds of(const RuleSettings& rules, const CellSource* source);
};

/// Judges the stream of one source: sequence numbers, clock, cadence and restatements.
class SourceJudge {
 public:
  SourceJudge(std::string name, std::uint32_t number, const SourceThresholds& thresholds);

  const std::string& name() const { return name_; }
  std::uint32_t number() const { return number_; }

  /// The next packet, after the fold has counted it. Fills in the sender's fields of `place`.
  void take(const PacketHeader& header, Applied applied, const SourceCounts& counts,
            PacketPlace& place);
  /// A statement of the packet.
  void takeStatement(const Statement& statement, const PacketPlace& place);

  /// `end`: of the session.
  void report(LogTime end, Findings& findings) const;
  /// Forgets what was found; the stream is followed on.
  void dropFindings();

 private:
  void watchPath(const PacketHeader& header, const SourceCounts& counts, const PacketPlace& place);
  void watchNumbers(const SourceCounts& counts, const PacketPlace& place);
  void judgeRestatement(const PacketPlace& place);
  /// When all of its static state had last been said again.
  LogTime lastRestated() const;

  std::string name_;
  std::uint32_t number_;
  double restate_s_;
  std::uint32_t stretch_ = 0;
  /// Of SourceCounts, after the last packet.
  struct Seen {
    std::uint64_t gap = 0, late = 0, duplicates = 0, restarts = 0;
  };
  Seen seen_;
  Seen dropped_;            ///< of those, the ones that dropFindings() forgot
  std::uint64_t lost_ = 0;  ///< directly before the packet that is being judged
  Tally gap_, late_, duplicate_, restart_, mixed_;
  std::string relay_;  ///< NAME:OUTPUT of the first packet of a mixed source that was filtered
  SenderJudge senders_;
  SourceClocks clocks_;
  CadenceJudge cadence_;
  StaticItems statics_;
  bool has_statics_ = false;
  LogTime restated_at_{};  ///< when static state was last restated, or first sent
  Tally unrestated_;
  double longest_unrestated_s_ = 0;
};

}  // namespace rocinante
