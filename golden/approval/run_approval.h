#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "golden/approval/golden_folder.h"
#include "golden/approval/manifest.h"

namespace rocinante {

/// A log to accept for a run.
struct RunCandidate {
  std::string run;
  std::filesystem::path log;
  std::string accepted_by, accepted_at, reason;
  FileHashes cell_files{};  ///< of the cell that it was accepted with; empty: unknown
  FileTexts cell_texts{};
  std::string kinematics{};          ///< AcceptedRun::kinematics
  std::vector<std::string> masks{};  ///< AcceptedRun::masks
  bool replace = false;              ///< the logs accepted so far are no longer
};

enum class RunApproved : std::uint8_t { added, already };

/// Adds a log to those accepted for a run: a copy in the golden folder, or in the store. Completely
/// or not at all: the copy has its own name, which depends on its content, before the manifest
/// names it; a process killed in between leaves a file that `list` tells of and a repetition uses.
/// Several processes may approve at once. damaged when a part of the log cannot be read; refused
/// when the run has kMaxOfOneRun.
Result<RunApproved> approveRun(const GoldenFolder& folder, const RunCandidate& candidate);

inline constexpr std::size_t kMaxOfOneRun = 16;

}  // namespace rocinante
