#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/bundle/cell_bundle.h"
#include "core/copy/log_make.h"
#include "core/log/log_reader.h"

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

/// A folder that appears whole or not at all: filled under another name beside `path`. With
/// `overwrite` an existing folder stays, and files are extracted into it one by one.
struct FolderOutput {
  std::filesystem::path path;
  bool overwrite = false;
};

struct ExtractReport {
  std::size_t files = 0;
  std::uint64_t bytes = 0;
  std::string main;                             ///< of a cell: its main file in the folder
  std::vector<std::string> search;              ///< of a cell: folders in the folder for --search
  std::map<std::string, std::string> packages;  ///< the same for --package, by its name
  /// Of a cell: false when it loads differently from the folder than from the log.
  bool stands_alone = true;
};

/// The attachment named `name`, or number `index` (from 1); not_found, or bad_argument when several
/// different ones have the name.
Result<std::size_t> findAttachment(const LogReader& log, const std::string& name,
                                   std::optional<std::size_t> index);

/// Extracts every attachment under its own name. Refuses a name that would leave the folder, or
/// that two different attachments have, and then writes nothing.
Result<ExtractReport> extractAll(const LogReader& log, const FolderOutput& to);

/// Extracts the cell as it was attached, into a folder from which it can be loaded.
Result<ExtractReport> extractCell(const LogReader& log, const FolderOutput& to);

}  // namespace rocinante
