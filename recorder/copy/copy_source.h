#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/log/log_reader.h"
#include "core/packet/session_state.h"
#include "core/session/state_damage.h"
#include "recorder/copy/log_selection.h"

namespace rocinante {

/// Told now and then which part of the work is done, 0 to 1. An error ends the work.
using CopyProgress = std::function<Status(double)>;

/// What stood in a log before a moment, so that a piece that begins there stands alone.
struct Preceding {
  SessionState state;
  LogTime moment{};  ///< of the keyframe that says it
  /// A restatement that began behind this place is not complete at the moment asked for. No
  /// keyframe can say that: `state` is that of this place, and the messages from here to the
  /// moment are said again on /rocinante/restated/..., so that the fold goes on as it did.
  std::optional<LogPosition> lead;
  /// The restatements overlap without an end: one of them is taken as abandoned.
  bool restatement_cut = false;
  /// What the state lacks because the log is damaged before the moment.
  StateDamage damage;
};

/// The next thing that goes from a log to the output. Times are those of the output.
struct CopyItem {
  enum class Kind : std::uint8_t {
    opening,  ///< the keyframe that the log, or the chosen range, begins with: `preceding`
    lead,     ///< a message from before the range; see Preceding::lead
    message,
    loss,
    mark,
  };
  Kind kind = Kind::message;
  LogTime time{};
  std::int64_t publish_time_ns = 0;
  LogMessage message;  ///< lead, message; as it was read, borrowed until the source moves on
  const Preceding* preceding = nullptr;
  const LossSpan* loss = nullptr;
  const Event* mark = nullptr;
};

/// One log that is copied from: what is chosen of it, one thing after another in the order in which
/// it belongs into the output: by time; at one time first a loss, then messages in the file's
/// order, then marks. Keyframes are left out but for an opening one. A loss counts at the end of
/// its span, and belongs to a range [from, until) when that lies in (from, until].
/// What peek() gives points into the source, which must not be moved from then on.
class CopySource {
 public:
  struct Options {
    SelectionOptions selection;
    TimeRange range;
    std::vector<Event> marks;  ///< oldest first; those that the log holds already are left out
    Nanoseconds shift{0};      ///< added to every log time
    bool shift_publish = false;
  };

  /// Finds what the copy opens with, which reads what stands before the range unless `preceding`
  /// is given.
  static Result<CopySource> of(LogReader reader, Options options,
                               std::optional<Preceding> preceding, const CopyProgress& progress);

  /// The next thing, or null at the end. The same until pop().
  Result<const CopyItem*> peek();
  void pop();

  LogReader& reader() { return reader_; }
  const LogReader& reader() const { return reader_; }
  const Options& options() const { return options_; }
  LogTime shifted(LogTime time) const { return time + options_.shift; }
  /// Empty when the log knows none.
  std::optional<LogTime> origin() const;
  /// What could not be used beside what reader().damage() tells.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  CopySource(LogReader reader, Options options);

  Status findOpening();
  Status findPreceding(const CopyProgress& progress);
  Status start();
  Status takeMessage();
  void chooseItem();

  LogReader reader_;
  Options options_;
  Selection selection_;
  std::vector<LossSpan> losses_;  ///< in order of their ends, shifted
  std::size_t next_loss_ = 0;
  std::size_t next_mark_ = 0;
  std::optional<Preceding> preceding_;
  bool opening_given_ = false;
  std::optional<LogMessage> message_;  ///< looked at, not given yet
  bool message_is_lead_ = false;
  bool at_end_ = false;
  Event baked_mark_;
  std::string moved_payload_;  ///< of a clock step whose time is shifted
  /// Texts of marks given at the time of the last: one that stands in the log and beside it is one.
  std::vector<std::string> given_marks_;
  LogTime given_marks_time_{};
  bool has_item_ = false;
  CopyItem item_;
  std::vector<std::string> notes_;
};

}  // namespace rocinante
