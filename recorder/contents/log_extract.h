#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/log/log_reader.h"

namespace rocinante {

/// A folder that appears whole or not at all: filled under another name beside `path`. With
/// `overwrite` a folder that is there stays, and what is extracted goes into it, file by file.
struct FolderOutput {
  std::filesystem::path path;
  bool overwrite = false;
};

/// What came out.
struct ExtractReport {
  std::size_t files = 0;
  std::uint64_t bytes = 0;
  std::string main;                             ///< of a cell: its file in the folder
  std::vector<std::string> search;              ///< of a cell: folders in the folder for --search
  std::map<std::string, std::string> packages;  ///< the same for --package, by its name
  /// Of a cell: false when it does not load from the folder as it does from the log.
  bool stands_alone = true;
};

/// The attachment that `name` means, or number `index` (from 1); not_found, or bad_argument when
/// several different ones have the name.
Result<std::size_t> findAttachment(const LogReader& log, const std::string& name,
                                   std::optional<std::size_t> index);

/// Every attachment under its own name. A name that would leave the folder, or that two different
/// attachments have, is refused, and nothing is written.
Result<ExtractReport> extractAll(const LogReader& log, const FolderOutput& to);

/// The cell as it was attached, in a folder from which it can be loaded.
Result<ExtractReport> extractCell(const LogReader& log, const FolderOutput& to);

}  // namespace rocinante
