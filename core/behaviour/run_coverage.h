#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/behaviour/run_spec.h"
#include "core/behaviour/session_track.h"
#include "core/report/account.h"

namespace rocinante {

/// What a judgement looked at, and what not: a verdict that does not carry it is worth nothing
/// (docs/decisions/040).
struct RunCoverage {
  /// Items: "arm/elbow", "arm", "event/picked", "drawing/p/path", "signal arm current".
  std::set<std::string> judged;
  std::set<std::string> lost;    ///< accepted, and neither judged now nor masked
  std::set<std::string> masked;  ///< for the whole session
  Account left_out{};            ///< statements of the session under test that no item shows
  /// Of a frame: joints that it does not judge, of devices of which it judges others. Not in
  /// reports.
  std::set<std::string> unstated{};
};

/// "arm" or "arm/elbow".
std::string itemOf(std::string_view device, const TrackColumn& column);
/// "event/picked".
std::string itemOf(const Event& event);
/// "visibility of arm/link3" is the item arm/link3, "drawing/planner/path\t2" the drawing.
std::string itemOfFact(std::string_view fact);

/// The fact that says in what a signal is: "unit of signal arm load". Its item is the signal.
std::string unitFact(std::string_view signal);

/// Why a signal of an import that no accepted session has is not judged: a newer version makes more
/// of the same recording.
inline constexpr const char* kNotAcceptedSignal = "no accepted session states it";

/// True when any column of the device has a value anywhere in the session.
bool isStated(const DeviceTrack& device);

/// Everything that a session states and that can be judged.
std::set<std::string> itemsOf(const SessionTrack& track);

/// `accepted` has at least one session.
RunCoverage coverageOf(const RunSpec& spec, const std::vector<const SessionTrack*>& accepted,
                       const SessionTrack& run);

/// Why nothing of a device is judged, as a clause, from what was left out of its session:
/// "the cell has no such device"; empty when the session states nothing of it.
std::string whyLeftOut(const Account& left_out, std::string_view device);

/// Names of `mask` and `limits` that match nothing which the cell or a session has, each as a
/// sentence with its place: "mask `lampp` matches nothing (did you mean `lamp`?)". `items`: of all
/// sessions, accepted or not.
std::vector<std::string> namesThatMatchNothing(const RunSpec& spec, const Cell& cell,
                                               const std::set<std::string>& items);

/// Limits of another kind than what they are given for, each as a sentence: "limits of `signal arm
/// load`: nothing takes its `joint_deg`; it takes event_ms, signal and signal_share". Names of the
/// complaint above are passed over. `numbers`: those of the items that are signals' numbers.
std::vector<std::string> limitsThatNothingTakes(const RunSpec& spec, const Cell& cell,
                                                const std::set<std::string>& items,
                                                const std::set<std::string>& numbers);

}  // namespace rocinante
