#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/behaviour/run_judgement.h"
#include "core/cell/cell.h"
#include "core/session/event_alignment.h"
#include "viewer/ui/study/worker.h"

namespace rocinante {

/// A time during which two sessions are apart, in the shown session's time.
struct Parting {
  LogTime from{}, until{};         ///< the first and the last moment; they may be the same
  std::vector<std::string> items;  ///< what is apart in it, sorted: see apartItem()
  bool operator==(const Parting&) const = default;
};

/// How far two sessions are apart in one thing at most.
struct PartingPeak {
  LogTime at{};      ///< where it is largest, in the shown session's time
  std::string item;  ///< "arm/elbow", "signal arm current", "event/picked"
  std::string size;  ///< "30.0°", "3.1 mm"; empty: it has no figure, such as a missing event
  std::string what;  ///< one sentence, with the times of both
  bool operator==(const PartingPeak&) const = default;
};

/// What a finding is about: a device by its name, else as it is named there ("drawing/plan/path",
/// "event/picked", "session").
std::string apartItem(const RunFinding& finding);

/// Where a session leaves the one beside it: the findings of `golden session BESIDE SHOWN` with its
/// own limits, in the alignment of the two. In a thread of its own with a low priority. For one
/// calling thread.
class PartingStudy {
 public:
  /// `cell` is borrowed, and read by the thread. `alignment`: from the shown session to the other.
  PartingStudy(const Cell& cell, std::filesystem::path shown, std::filesystem::path beside,
               EventAlignment alignment);

  /// By time, without gaps between two in which nothing is apart; empty until it is finished.
  std::vector<Parting> found() const;
  /// What is apart at a moment, sorted.
  std::vector<std::string> apartAt(LogTime moment) const;
  /// The largest of all by severityOf(). Empty: the two are not apart, or it is not finished.
  std::optional<PartingPeak> largest() const;
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
    std::vector<Parting> by_item;  ///< by time, each of one item
    std::optional<PartingPeak> largest;
    std::string fault;
  };
  static Answer look(const Cell& cell, const Question& question, const std::stop_token& stop);

  Worker<Question, Answer> worker_;
};

}  // namespace rocinante
