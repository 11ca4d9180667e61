#pragma once

#include <map>
#include <string>
#include <string_view>

#include "core/check/judges/clock_judge.h"

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

}  // namespace rocinante
