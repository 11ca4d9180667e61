#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/cell/cell.h"
#include "core/session/event_alignment.h"
#include "viewer/ui/study/worker.h"

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

  /// What was found so far, by time.
  std::vector<Parting> found() const;
  /// Why it cannot be told; one sentence, or empty.
  std::string fault() const;
  /// The beginning of the first one after a moment, or of the last one that begins before it.
  std::optional<LogTime> beside(LogTime moment, bool after) const;
  /// True when there is more since the last call.
  bool takeNews() { return worker_.takeNews(); }
  bool isFinished() const { return !worker_.isBusy(); }
  void wait() const { worker_.wait(); }

 private:
  struct Question {
    std::filesystem::path shown, beside;
    EventAlignment alignment;
  };
  struct Answer {
    std::vector<Parting> partings;
    std::string fault;
  };
  Status look(const Cell& cell, const Question& question, const std::stop_token& stop,
              std::vector<Parting>& partings);

  Worker<Question, Answer> worker_;
};

}  // namespace rocinante
