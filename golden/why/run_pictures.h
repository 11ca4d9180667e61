#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "golden/judge/judged_run.h"
#include "golden/judge/suite_session.h"
#include "viewer/render/frame_maker.h"

namespace rocinante {

/// The other devices that cover the device when they cover more than half of it in a frame of this
/// request, by name; else none. Drawings of the session do not count.
Result<std::vector<std::string>> devicesInFront(FrameMaker& maker, const FrameRequest& request,
                                                const std::string& device);

inline constexpr std::size_t kMaxRunPictures = 4;

/// File name of a picture of a run in a report's folder: "NAME.run-1.png".
std::string runPictureFile(const JudgedRun& run, std::size_t index);

/// For a run of `log` that is different: draws the devices of its first findings where they are
/// farthest from what was accepted, with the accepted log as a clear ghost, in the reproducible
/// profile, at most kMaxRunPictures. No verdict depends on them: when they cannot be drawn, a note
/// of the run says why.
void drawRunPictures(const Cell& cell, const std::filesystem::path& log,
                     const std::filesystem::path& accepted, JudgedRun& run);
/// The same with the logs of a suite: the first accepted one.
void drawRunPictures(const SuiteSession& session, JudgedRun& run);

}  // namespace rocinante
