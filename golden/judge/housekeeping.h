#pragma once

#include <span>
#include <string>
#include <vector>

#include "golden/approval/golden_folder.h"
#include "golden/approval/manifest.h"
#include "golden/judge/judged_frame.h"

namespace rocinante {

/// Faults of a golden folder, one sentence each, sorted: goldens of frames that the suite does not
/// have, goldens without a file, pictures that are not goldens, leftovers of an interrupted
/// approve; the same of accepted logs. `frames` and `runs` must be all of the suite; what belongs
/// to one of `neighbours`, which share the folder, is not stale. `verify` also checks the hash of
/// every picture and log.
std::vector<std::string> folderFaults(const Manifest& manifest, const GoldenFolder& folder,
                                      std::span<const SuiteFrame> frames, bool verify,
                                      std::span<const SuiteRun> runs = {},
                                      std::span<const Suite> neighbours = {});

/// Notes of a run on the suite itself, one sentence each: masks that hid nothing in any frame of
/// their case, limits more than four times the largest figure of a passing frame, and what the
/// frames do not judge: goldens without coverage, devices that are masked since they were accepted,
/// and what no device of the cell takes.
std::vector<std::string> suiteNotes(std::span<const JudgedFrame> judged);

}  // namespace rocinante
