#pragma once

#include <span>
#include <string>
#include <vector>

#include "golden/approval/golden_folder.h"
#include "golden/approval/manifest.h"
#include "golden/judge/judged_frame.h"

namespace rocinante {

/// What lies in a folder of goldens and should not, or should and does not, a sentence each,
/// sorted: goldens of frames that the suite does not have, goldens without a file, pictures that no
/// golden names, what an interrupted approve left. `frames` are all of the suite. `verify` reads
/// every picture and holds it against its hash.
std::vector<std::string> folderFaults(const Manifest& manifest, const GoldenFolder& folder,
                                      std::span<const SuiteFrame> frames, bool verify);

/// What a run shows about the suite itself, a sentence each: masks that hid nothing in any frame of
/// their case, and limits more than four times what any frame that passed needed.
std::vector<std::string> suiteNotes(std::span<const JudgedFrame> judged);

}  // namespace rocinante
