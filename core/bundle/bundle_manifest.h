#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/search/file_search.h"

namespace rocinante {

/// Limits of a cell inside a log: a larger one is neither attached nor unpacked.
inline constexpr std::size_t kMaxBundledFiles = 10'000;
inline constexpr std::size_t kMaxBundledFolders = 20'000;
inline constexpr std::uint64_t kMaxBundledBytes = std::uint64_t{1} << 30;
inline constexpr std::size_t kMaxBundledNames = 200'000;
inline constexpr std::size_t kMaxManifestBytes = std::size_t{32} << 20;

/// The list of the files of a cell inside a log, and of the meaning of the names in them
/// (docs/log-format.md, section "The cell"). Names of files and folders are relative, with `/`.
struct BundleManifest {
  struct File {
    std::string name;
    std::uint64_t bytes = 0;
    std::string sha256;  ///< lower-case hexadecimal
    bool operator==(const File&) const = default;
  };
  /// A name that a file in folder `in` says. `means` is one of the files, or empty; `why` as
  /// FoundFile has it.
  struct Name {
    std::string in, written, means;
    FoundFile::Why why = FoundFile::Why::found;
    bool operator==(const Name&) const = default;
  };
  std::string main;         ///< the file that is the cell
  std::vector<File> files;  ///< by name
  std::vector<Name> names;  ///< by `in` and `written`, each pair once
  /// Folders that were search roots when the cell was attached (--search).
  std::vector<std::string> search;
  /// Folders that the cell names as search roots, with or without files in them.
  std::vector<std::string> folders;
  /// Folders of packages whose names differ from their packages'.
  std::map<std::string, std::string> packages;
  bool operator==(const BundleManifest&) const = default;
};

/// True for a name that stays below the folder it is unpacked into: parts between `/`, none of them
/// empty, `.` or `..`, at most 255 bytes each and 1,024 in all, without control characters and
/// backslashes.
bool isBundleName(std::string_view name);

/// The manifest as JSON text: the same bytes for the same manifest.
std::string manifestText(const BundleManifest& manifest);

/// Reads it back without trusting it: damaged or unsupported, with a message. `where` names it.
Result<BundleManifest> parseManifest(ByteView text, const std::string& where);

}  // namespace rocinante
