#pragma once

#include <set>
#include <string>

#include "core/base/time.h"
#include "core/behaviour/run_coverage.h"
#include "core/cell/cell.h"
#include "core/packet/session_state.h"
#include "golden/approval/manifest.h"
#include "golden/suite/suite.h"

namespace rocinante {

/// What a frame judges: the devices that are drawn and whose pose or joints the session states by
/// then, if the model takes all joint values that are stated ("arm"); and the joint values of drawn
/// devices that it states: "arm/elbow", or "arm/*" where that is all that the model takes, which
/// keeps manifests small. `masked` has the devices that the case masks or hides completely,
/// `left_out` what no device takes; `lost` stays empty. The moment is what `state` is of; `origin`
/// the log's.
RunCoverage frameCoverage(const SuiteCase& made, const Cell& cell, const SessionState& state,
                          LogTime origin);

/// Devices and joints that an accepted picture covers and the frame neither judges nor masks; of a
/// device that is lost as a whole not its joints. Empty for a picture that was accepted without
/// coverage; one that covers devices alone loses no joint.
std::set<std::string> lostSince(const AcceptedPicture& accepted, const RunCoverage& now);

/// For people: "arm/elbow"; "arm (its joints)" for "arm/*".
std::string coveredText(const std::string& item);

/// "arm: not judged, since the cell has no such device, though it was accepted", for the first of
/// `coverage.lost`, which is not empty; the others are counted.
std::string lostSentence(const RunCoverage& coverage);

}  // namespace rocinante
