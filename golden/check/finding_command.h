#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/child_process.h"
#include "core/base/result.h"

namespace rocinante {

/// Runs a command for each finding that begins or ends: `check --on-finding`. Its standard input is
/// a file in memory with the finding as JSON, so that neither waits for the other; what it prints
/// goes to standard error. No shell takes part. At most kRunning run at a time and kWaiting wait;
/// what comes beyond is not run, and counted. Commands are reaped by tend(), never waited for. One
/// thread.
class FindingCommand {
 public:
  static constexpr std::size_t kRunning = 8;
  static constexpr std::size_t kWaiting = 64;

  /// `text`: a program and its arguments, with spaces between. bad_argument when it is empty,
  /// not_found when there is no such program.
  static Result<FindingCommand> parse(std::string_view text);

  /// Runs it, now or when another has ended.
  void add(std::string json);
  /// Reaps those that ended, and starts those that wait.
  void tend();
  /// Gives those that run this long to end; the rest continues without us.
  void finish(int at_most_ms);

  bool isIdle() const { return running_.empty() && waiting_.empty(); }
  std::uint64_t failed() const { return failed_; }  ///< not started, or did not exit with 0
  std::uint64_t dropped() const { return dropped_; }
  const std::string& text() const { return text_; }

 private:
  Status start(const std::string& json);
  void noteFailure(const std::string& how);

  std::string text_;
  std::vector<std::string> words_;
  std::vector<ChildProcess> running_;
  std::deque<std::string> waiting_;
  std::uint64_t failed_ = 0, dropped_ = 0;
};

}  // namespace rocinante
