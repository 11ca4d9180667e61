#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/bundle/cell_bundle.h"
#include "core/copy/log_make.h"

namespace rocinante {

/// The largest file that can be attached.
inline constexpr std::uint64_t kMaxAttachedBytes = std::uint64_t{1} << 30;

struct NewAttachment {
  std::string name;
  std::string media_type;
  Bytes data;
};

/// Files to add to a log.
struct AttachOptions {
  std::vector<NewAttachment> files;
  const CellBundle* cell = nullptr;  ///< borrowed; null for none
  /// Replace attachments of the same names, or the cell; otherwise these are refused.
  bool replace = false;
};

/// Copies the log with more attachments, as `make` says. Attachments do not extend the session.
Result<CopyReport> attachToLog(const std::filesystem::path& log, const AttachOptions& attach,
                               const MakeOptions& make);

}  // namespace rocinante
