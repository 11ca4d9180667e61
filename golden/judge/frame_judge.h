#pragma once

#include <functional>

#include "golden/approval/golden_folder.h"
#include "golden/approval/manifest.h"
#include "golden/judge/case_mask.h"
#include "golden/judge/judged_frame.h"

namespace rocinante {

/// Judges `judged.drawn` by the rules of docs/golden-suites.md, section "Verdicts": sets the
/// verdict, its rule and figures, the nearest golden and its picture. Does not test stability.
/// `judged` must have the frame, its tolerance, key and pixels, and its coverage without `lost`,
/// unless that is unknown; `areas` is null when the case has no masks.
void judgeDrawn(const Manifest& manifest, const GoldenFolder& folder, const CaseAreas* areas,
                JudgedFrame& judged);

/// Changes different to expected, and same to unexpected, for a case that expects a difference.
void applyExpectation(JudgedFrame& judged);

}  // namespace rocinante
