#pragma once

#include <functional>

#include "golden/approval/golden_folder.h"
#include "golden/approval/manifest.h"
#include "golden/judge/case_mask.h"
#include "golden/judge/judged_frame.h"

namespace rocinante {

/// Judges `judged.drawn` by the ladder of docs/golden-suites.md, section "Verdicts": fills in the
/// verdict, its rule and figures, the nearest golden and its picture. What is drawn again to tell
/// an unstable frame is not its business. `judged` has the frame, its tolerance, key and pixels;
/// `areas` are those of the case, null when it has no masks.
void judgeDrawn(const Manifest& manifest, const GoldenFolder& folder, const CaseAreas* areas,
                JudgedFrame& judged);

/// Turns different into expected, and same into unexpected, for a case that expects a difference.
void applyExpectation(JudgedFrame& judged);

}  // namespace rocinante
