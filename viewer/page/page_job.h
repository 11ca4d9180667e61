#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/model_search.h"
#include "core/base/parallel_for.h"
#include "core/base/result.h"
#include "core/cell/cell.h"
#include "core/check/log_account.h"
#include "core/report/account.h"
#include "viewer/page/page_file.h"

namespace rocinante {

struct PageJob : ModelSearch {
  std::filesystem::path log;
  std::filesystem::path cell;  ///< empty: the one that the log carries
  std::filesystem::path output;
  std::filesystem::path
      viewer;  ///< folder of what scripts/build_web made; empty: the installed one
  std::filesystem::path layout;  ///< what the page begins with; empty: nothing is said
  std::string from, until;       ///< session times; empty: the whole log
  std::uint64_t most_bytes = 0;  ///< of the page
  bool thin = false;             ///< make the cell smaller until the page has at most `most_bytes`
  bool overwrite = false;
  ParallelFor parallel;
};

struct PageReport {
  std::uint64_t page_bytes = 0, log_bytes = 0, cell_bytes = 0, viewer_bytes = 0;
  std::vector<std::string> warnings;       ///< faults of the cell
  LogAccount account;                      ///< of the log
  std::uint64_t findings = 0, errors = 0;  ///< what `check` finds; errors are among the findings
  std::string left_out;                    ///< of the cell, for `thin`
  Account layout_left_out;                 ///< what of the layout a page has not
  bool is_whole = true;  ///< nothing of the cell is missing, nothing of the log damaged
};

struct MadePage {
  std::string html;
  PageReport report;
};

/// A page (docs/programs/page.md) that goes to `output`; writes nothing. unsupported, with both
/// sizes, when it would be larger than `most_bytes`, or, when it may be thin, than can be made of
/// it; not_found, with what to do, without the viewer.
Result<MadePage> pageFor(const PageJob& job);
/// The same, and writes it.
Result<PageReport> makePage(const PageJob& job);

/// Writes the log that a page carries. Returns its size.
Result<std::uint64_t> extractLog(const std::filesystem::path& page,
                                 const std::filesystem::path& output, bool overwrite);

/// The log that the page carries: the job's own, byte for byte, or what `rocinante log cut` makes
/// of it for the job's span. The cell that a log carries is left out, since the page has its own; a
/// damaged log keeps it. Warns in the report of damage that the cut had to leave out.
Result<Bytes> carriedLog(const PageJob& job, PageReport& report);

/// The page of these parts with a smaller cell, the largest of a few steps with which it has at
/// most `job.most_bytes`: pictures of half the size, and half of the triangles, by turns. The last
/// step's page when none is small enough. Sets the cell of `parts`, and what it lacks;
/// `whole_bytes` is the size of the page with the whole cell.
std::string thinPage(const Cell& cell, const PageJob& job, std::size_t whole_bytes,
                     PageParts& parts);

}  // namespace rocinante
