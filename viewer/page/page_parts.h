#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/parallel_for.h"
#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/check/rules/check_report.h"
#include "core/packet/session_state.h"
#include "viewer/page/page_file.h"

namespace rocinante {

/// How much smaller a cell is made than it is.
struct Thinness {
  int halvings = 0;      ///< of the triangles, as coarseMesh() leaves them out
  int largest_side = 0;  ///< of a picture, in pixels; 0: as it is
};

/// The baked cell of a page: what is drawn, with pictures compressed. Of paths only the names that
/// tell pictures apart are kept, so that nobody's folders are given away and the same cell gives
/// the same bytes wherever it lies. Findings, rules, decoders and collision geometry are left out.
Bytes pageCell(const Cell& cell, const Thinness& thinness, const ParallelFor& parallel);

/// JSON: the events of a session as a page lists them: ns from the session's origin, and text. The
/// same as the viewer's own of a log (viewer/web/web_session.h, eventsJson()).
std::string pageEvents(const std::vector<Event>& events, LogTime origin);

/// JSON: the findings of a report as a page lists them: severity, rule, text, hint, count, subject,
/// first_ns and last_ns from the session's origin where they have times. Of paths only file names.
std::string pageFindings(const CheckReport& report);

/// Reads what scripts/build_web made from `folder`, or, when it is empty, from where it is
/// installed. not_found, with what to do, when it is not there.
Status readPageViewer(const std::filesystem::path& folder, PageParts& parts);

}  // namespace rocinante
