#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/document/toml_table.h"
#include "core/search/file_search.h"

namespace rocinante {

/// Most bytes of a cell file; more is refused.
inline constexpr std::size_t kMaxCellBytes = std::size_t{4} << 20;
/// Most files of one cell, itself counted, and how deep they may include each other.
inline constexpr std::size_t kMaxCellFiles = 64;
inline constexpr std::size_t kMaxIncludeDepth = 16;

/// A file of a cell: the cell itself or an included one.
struct CellFile {
  std::filesystem::path path, folder;
  TomlNode document;
  std::unique_ptr<FaultList> faults;
  std::unique_ptr<TomlTable> root;  ///< of `document`
  std::vector<std::size_t> includes;
};

/// A cell's text with all that it includes (docs/cell-format.md, section "Include"), each file
/// once.
class CellFiles {
 public:
  /// `search` and `faults` are borrowed. Without `own_roots`, `search` keys are only read.
  CellFiles(FileSearch& search, Findings& faults, bool own_roots)
      : search_(search), faults_(faults), own_roots_(own_roots) {}

  /// Reads the cell itself; an error when it is not one. Its own roots are added to the search.
  Status readMain(ByteView bytes, const std::filesystem::path& path);
  /// Reads all included files, transitively; one that cannot be read is a fault.
  void readIncluded();

  /// The cell first, and every file before those that it includes.
  const std::vector<CellFile*>& inOrder() const { return order_; }
  /// Whether `above` includes `below`, directly or not: names of FaultList::file.
  bool includes(const std::string& above, const std::string& below) const;
  /// Reports keys that nothing asked for, and closes the lists of faults.
  void finish();

 private:
  CellFile& add(const std::filesystem::path& path, TomlNode document);
  void readIncludesOf(std::size_t file, std::size_t depth);
  void readInclude(std::size_t file, const TomlNode& name, std::size_t depth);
  /// Describes file `at` of those being read to the file that includes it again.
  std::string placeInLoop(std::ptrdiff_t at) const;
  void putInOrder();

  FileSearch& search_;
  Findings& faults_;
  bool own_roots_;
  std::vector<std::unique_ptr<CellFile>> files_;
  std::map<std::filesystem::path, std::size_t> by_path_;  // without links
  std::vector<std::size_t> reading_;                      // files that are being read now
  std::vector<CellFile*> order_;
};

}  // namespace rocinante
