#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/cell/cell.h"
#include "core/session/event_alignment.h"

namespace rocinante {

/// A time during which devices of two sessions are apart, in the shown session's time.
struct Parting {
  LogTime from{}, until{};           ///< the first and the last moment; they may be the same
  std::vector<std::string> devices;  ///< those that are apart somewhere in it, sorted
  bool operator==(const Parting&) const = default;
};

/// Where a session and the one beside it are apart (BesideSession): both are posed at moments
/// kPartingStep apart, farther apart in very long sessions, from the beginning to the end of the
/// time that both have. In a thread of its own with a low priority. For one calling thread.
class PartingStudy {
 public:
  static constexpr Nanoseconds kPartingStep{20'000'000};

  /// `cell` is borrowed, and read by the thread.
  PartingStudy(const Cell& cell, std::filesystem::path shown, std::filesystem::path beside,
               EventAlignment alignment);
  ~PartingStudy();
  PartingStudy(const PartingStudy&) = delete;
  PartingStudy& operator=(const PartingStudy&) = delete;

  /// What was found so far, by time.
  std::vector<Parting> found() const;
  /// Why it cannot be told; one sentence, or empty.
  std::string fault() const;
  /// The beginning of the first one after a moment, or of the last one that begins before it.
  std::optional<LogTime> beside(LogTime moment, bool after) const;
  /// True when there is more since the last call.
  bool takeNews() const;
  bool isFinished() const;
  void wait() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante
