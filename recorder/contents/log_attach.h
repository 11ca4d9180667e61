#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/bundle/cell_bundle.h"
#include "recorder/copy/log_make.h"

namespace rocinante {

/// The largest file that is attached.
inline constexpr std::uint64_t kMaxAttachedBytes = std::uint64_t{1} << 30;

struct NewAttachment {
  std::string name;
  std::string media_type;
  Bytes data;
};

/// What a log is to carry besides what it has.
struct AttachOptions {
  std::vector<NewAttachment> files;
  const CellBundle* cell = nullptr;  ///< borrowed; null: none
  /// In place of what the log has under the same names, or as its cell; else that is refused.
  bool replace = false;
};

/// The log with more attached to it, as `make` says. Attachments count for no time of the session.
Result<CopyReport> attachToLog(const std::filesystem::path& log, const AttachOptions& attach,
                               const MakeOptions& make);

}  // namespace rocinante
