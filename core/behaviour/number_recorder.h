#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/behaviour/fact_recorder.h"
#include "core/behaviour/session_track.h"
#include "core/packet/packet.h"
#include "core/packet/session_state.h"

namespace rocinante {

/// In a series of numbers, while none is stated.
inline constexpr double kUnstated = std::numeric_limits<double>::quiet_NaN();

/// Keeps the numbers of a session's signals, each signal a series, and how often each signal is
/// stated. What is a boolean or a text is a fact (FactRecorder). One thread.
class NumberRecorder {
 public:
  using Numbers = std::map<std::string, TrackSeries, std::less<>>;

  using Rhythms = std::map<std::string, TrackSeries, std::less<>>;

  /// Adds to all, which are borrowed.
  NumberRecorder(Numbers& numbers, Rhythms& rhythms, SampleStore& store)
      : numbers_(numbers), rhythms_(rhythms), store_(store) {}

  /// What was stated before the first packet, as if at `time`.
  void begin(const SessionState& state, LogTime start);
  /// A statement of the packet that is being read; others than of signals are passed over.
  void read(const Statement& statement);
  /// The packet was folded: what was read of it is kept, and what `state` has lost meanwhile is not
  /// stated any more. True when it says a fact: a state, a unit, or a number where there was none.
  /// `is_restated`: the packet repeats what was stated, and does not count.
  bool keep(const SessionState& state, LogTime time, bool is_restated = false);
  /// The signals that may say another fact than at the last call, each once, as `state` has them,
  /// which is the last one kept and outlives their use. Nothing when it may be any.
  std::optional<std::vector<ChangedSignal>> takeChanged(const SessionState& state);
  /// It was not: what was read of it is forgotten.
  void drop() { statements_.clear(); }
  /// Names what is beyond kMaxSignals.
  void finish(Account& left_out);

  /// Signals of one session that are judged.
  static constexpr std::size_t kMaxSignals = 262'144;

 private:
  struct Device;
  struct Signal {
    Device* device = nullptr;
    const SignalName* name = nullptr;
    std::string unit;
    SignalKind kind = SignalKind::number;
    std::string text{};                  ///< of texts
    std::size_t place = kUnstatedPlace;  ///< in the device's `stated`
    bool is_number = false;
    bool is_changed = false;            ///< it is in `changed_`
    std::vector<double> times, values;  ///< that are not in the store yet
    std::vector<double> rhythm;         ///< rows of three that are not in the store yet
    std::int64_t rhythm_bin = -1;
    std::optional<LogTime> last_said{};
  };
  using Signals = std::map<SignalName, Signal, SignalOrder>;
  struct Device {
    const std::string* name = nullptr;
    Signals signals;
    std::vector<Signal*> stated;
  };
  static constexpr std::size_t kUnstatedPlace = ~std::size_t{0};
  struct Said {
    Device* removed = nullptr;  ///< or else
    Signal* signal = nullptr;
    bool is_stated = false;
    SignalKind kind = SignalKind::number;
    double number = 0;
    bool has_unit = false;
    std::string_view unit{}, text{};
  };

  /// Both null beyond kMaxSignals.
  Device* deviceOf(std::string_view name);
  Signal* signalOf(std::string_view device, std::string_view link, std::string_view name);
  /// Of those that are stated the last takes its place.
  void takeBack(Signal& signal, LogTime time);
  void takeBackLost(const SessionState& state, LogTime time);
  void change(Signal& signal);
  void add(Signal& signal, LogTime time, double value);
  void count(Signal& signal, LogTime time);
  void store(Signal& signal);
  void storeRhythm(Signal& signal);

  Numbers& numbers_;
  Rhythms& rhythms_;
  SampleStore& store_;
  LogTime start_{};
  std::map<std::string, Device, std::less<>> devices_;
  Device* last_device_ = nullptr;
  Signals::iterator next_;  ///< behind the last signal that was said of it
  std::size_t count_ = 0, stated_ = 0;
  std::size_t unseen_ = 0;    ///< signals of the state that are not in `stated_`
  std::uint64_t beyond_ = 0;  ///< values of signals beyond the limit
  std::vector<Said> statements_;
  bool says_fact_ = false;  ///< what is being kept
  std::vector<Signal*> changed_;
  bool is_astray_ = false;  ///< the state has had others than were seen here
};

}  // namespace rocinante
