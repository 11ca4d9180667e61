#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/log/log_types.h"
#include "core/report/account.h"
#include "core/report/finding.h"

namespace rocinante {

/// Judges the recording itself: losses, steps of the wall clock, damage.
class LogJudge {
 public:
  void takeLoss(const LossSpan& span) { losses_[span.endpoint].push_back(span); }
  void takeDamage(const DamageSpan& span) { damage_.push_back(span); }
  /// A message on /rocinante/clock.
  void takeClockStep(LogTime time, ByteView payload);
  /// What an import could not keep or translate: a sentence.
  void takeImportWarning(std::string text) { import_warnings_.push_back(std::move(text)); }
  /// What an import made no packets of, as notes.
  void takeLeftOut(const Account& account) { left_out_.add(account); }
  /// Of each datagram, in order.
  void takeTime(LogTime time) {
    if (latest_ && time - *latest_ > kLongestSilence) noteJump(*latest_, time);
    latest_ = std::max(latest_.value_or(time), time);
  }
  void noteIncomplete() { is_incomplete_ = true; }

  void report(Findings& findings) const;
  /// Forgets what was found.
  void dropFindings() { *this = {}; }

 private:
  /// Nobody records so long a silence: the clock was set.
  static constexpr Nanoseconds kLongestSilence = std::chrono::hours(30 * 24);

  void noteJump(LogTime from, LogTime to);
  void reportLoss(const std::string& endpoint, const std::vector<LossSpan>& spans,
                  Findings& findings) const;

  std::map<std::string, std::vector<LossSpan>, std::less<>> losses_;  ///< by endpoint
  std::vector<DamageSpan> damage_;
  std::vector<std::string> import_warnings_;
  Account left_out_;
  Finding clock_steps_, jumps_;
  std::optional<LogTime> latest_;
  double worst_step_s_ = 0;
  bool is_incomplete_ = false;
};

}  // namespace rocinante
