#pragma once

#include "core/base/time.h"

namespace rocinante {

/// The part of a log's time that the time line and the plots show. Pure.
class TimeView {
 public:
  /// Below this a nanosecond would be wider than a pixel.
  static constexpr Nanoseconds kShortest{1000};

  TimeView() = default;
  TimeView(LogTime start, LogTime end);

  LogTime from() const { return from_; }
  LogTime until() const { return until_; }
  Nanoseconds span() const { return until_ - from_; }
  bool showsAll() const { return from_ == start_ && until_ == end_; }

  /// Shows that part, in either order, moved into the log and at least kShortest long.
  void show(LogTime from, LogTime until);
  void showAll();
  /// `factor` times as long, about `fixed`, which stays where it is.
  void zoom(double factor, LogTime fixed);
  /// Moves by a part of what is shown: 1 is all of it, later.
  void pan(double part);
  /// Moves on so that a moment that leaves one side comes in at the other: for playing.
  void follow(LogTime moment);
  /// The log has become longer, or its beginning is gone. All of it stays all of it; a part stays
  /// where it is, as far as the log has it.
  void resize(LogTime start, LogTime end);

 private:
  LogTime start_{}, end_{Nanoseconds(1)};
  LogTime from_{}, until_{Nanoseconds(1)};
};

}  // namespace rocinante
