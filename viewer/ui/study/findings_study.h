#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "core/cell/cell.h"
#include "core/check/rules/check_report.h"

namespace rocinante {

/// Judges a log against its cell as `rocinante check` does, in a thread of its own with a low
/// priority. For one calling thread.
class FindingsStudy {
 public:
  /// `cell` is borrowed, and read by the thread.
  FindingsStudy(const Cell& cell, std::filesystem::path log);
  ~FindingsStudy();
  FindingsStudy(const FindingsStudy&) = delete;
  FindingsStudy& operator=(const FindingsStudy&) = delete;

  /// The finished part, 0 to 1.
  double progress() const;
  /// Null until it is finished. Findings of the session alone come with their first time.
  const CheckReport* report() const;
  /// Why it could not judge; one sentence, or empty.
  std::string fault() const;
  /// Returns when it is finished.
  void wait();
  bool isFinished() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante
