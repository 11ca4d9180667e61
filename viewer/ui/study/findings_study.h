#pragma once

#include <atomic>
#include <filesystem>
#include <string>

#include "core/cell/cell.h"
#include "core/check/rules/check_report.h"
#include "viewer/ui/study/worker.h"

namespace rocinante {

/// Judges a log against its cell as `rocinante check` does, in a thread of its own with a low
/// priority. For one calling thread.
class FindingsStudy {
 public:
  /// `cell` is borrowed, and read by the thread.
  FindingsStudy(const Cell& cell, std::filesystem::path log);

  /// The finished part, 0 to 1.
  double progress() const { return done_; }
  /// Null until it is finished. Findings of the session alone come with their first time.
  const CheckReport* report() const;
  /// Why it could not judge; one sentence, or empty.
  std::string fault() const;
  /// Returns when it is finished.
  void wait() const { worker_.wait(); }
  bool isFinished() const { return !worker_.isBusy(); }

 private:
  std::atomic<double> done_{0};
  Worker<std::filesystem::path, Result<CheckReport>> worker_;
};

}  // namespace rocinante
