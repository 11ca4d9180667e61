#pragma once

#include <deque>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/copy/log_selection.h"
#include "core/log/log_reader.h"
#include "core/packet/session_state.h"
#include "core/session/state_damage.h"

namespace rocinante {

/// Called with the fraction of the work done, 0 to 1. An error ends the work.
using CopyProgress = std::function<Status(double)>;

/// The state before a moment of a log, which makes a piece that begins there self-contained.
struct Preceding {
  SessionState state;
  LogTime moment{};  ///< of the keyframe that states it
  /// A restatement that began after this place is incomplete at the requested moment, which a
  /// keyframe cannot express: `state` is that of this place, and the messages from here to the
  /// moment are repeated on /rocinante/restated/..., so that the fold continues as it did.
  std::optional<LogPosition> lead;
  /// The restatements overlap without end: one of them is treated as abandoned.
  bool restatement_cut = false;
  /// Damage before the moment, for which the state may be incomplete.
  StateDamage damage;
};

/// The next item copied from a log to the output. Times are those of the output.
struct CopyItem {
  enum class Kind : std::uint8_t {
    opening,  ///< opening keyframe of the log or the chosen range: `preceding`
    lead,     ///< a message from before the range; see Preceding::lead
    message,
    loss,
    mark,
  };
  Kind kind = Kind::message;
  LogTime time{};
  std::int64_t publish_time_ns = 0;
  LogMessage message;  ///< lead, message; as read, borrowed until the source advances
  const Preceding* preceding = nullptr;
  const LossSpan* loss = nullptr;
  const Event* mark = nullptr;
};

/// An input log of a copy: its chosen items in output order, that is by time; at equal times a loss
/// first, then messages in file order, then marks. Keyframes are left out except an opening one. A
/// loss counts at the end of its span, and belongs to a range [from, until) if that end is in
/// (from, until]. Results of peek() point into the source, which must not be moved afterwards.
class CopySource {
 public:
  struct Options {
    SelectionOptions selection;
    TimeRange range;
    std::vector<Event> marks;  ///< oldest first; those already in the log are left out
    Nanoseconds shift{0};      ///< added to every log time
    bool shift_publish = false;
  };

  /// Finds the opening of the copy. Reads the log before the range unless `preceding` is given.
  static Result<CopySource> of(LogReader reader, Options options,
                               std::optional<Preceding> preceding, const CopyProgress& progress);

  /// The next item, or null at the end. The same until pop().
  Result<const CopyItem*> peek();
  void pop();

  LogReader& reader() { return reader_; }
  const LogReader& reader() const { return reader_; }
  const Options& options() const { return options_; }
  LogTime shifted(LogTime time) const { return time + options_.shift; }
  /// Empty when the log has none.
  std::optional<LogTime> origin() const;
  /// Sentences about what could not be used, besides reader().damage().
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  CopySource(LogReader reader, Options options);

  Status findOpening();
  Status findPreceding(const CopyProgress& progress);
  Status start();
  Status takeMessage();
  Status takeOctetsIfWanted(const LogMessage& octets);
  void chooseItem();

  LogReader reader_;
  Options options_;
  Selection selection_;
  std::vector<LossSpan> losses_;  ///< ordered by their ends, shifted
  std::size_t next_loss_ = 0;
  std::size_t next_mark_ = 0;
  std::optional<Preceding> preceding_;
  bool opening_given_ = false;
  std::optional<LogMessage> message_;  ///< read, not returned yet
  bool message_is_lead_ = false;
  /// Read behind message_, to see what it says: comes next. The payload of message_ is then
  /// octets_payload_.
  std::optional<LogMessage> behind_;
  Bytes octets_payload_;
  bool at_end_ = false;
  Event baked_mark_;
  std::string moved_payload_;  ///< of a clock step with shifted time
  /// Texts of the marks at the last mark's time: a mark in the log and beside it counts once.
  std::vector<std::string> given_marks_;
  LogTime given_marks_time_{};
  bool has_item_ = false;
  CopyItem item_;
  std::vector<std::string> notes_;
};

}  // namespace rocinante
