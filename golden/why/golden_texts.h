#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "core/bundle/cell_bundle.h"
#include "golden/approval/manifest.h"

namespace rocinante {

/// Contents of files of a cell that is at hand, by SHA-256. Borrowed.
using FileContents = std::map<std::string, ByteView>;
FileContents contentsOf(const CellBundle& bundle);

/// Replaces the texts of a bundle with the golden's for the lifetime of this object, and of its
/// other files those that are `at_hand`, such as meshes in the cell of an accepted log. What the
/// golden had by a name that no file has now comes back by that name, if its content is there.
class GoldenTexts {
 public:
  GoldenTexts(CellBundle& bundle, const FileHashes& golden, const FileTexts& texts,
              const FileContents& at_hand = {});
  ~GoldenTexts();
  GoldenTexts(const GoldenTexts&) = delete;
  GoldenTexts& operator=(const GoldenTexts&) = delete;

  bool any() const { return !kept_.empty() || bundle_.contents.size() > files_; }
  /// Number of changed files without a kept text.
  std::size_t unknown() const { return unknown_; }

 private:
  void addGone(const FileHashes& golden, const FileTexts& texts, const FileContents& at_hand);

  struct Kept {
    std::size_t place;
    BundleManifest::File file;
    Bytes content;
  };
  CellBundle& bundle_;
  std::size_t files_, names_;  ///< of today
  std::vector<Kept> kept_;
  std::size_t unknown_ = 0;
};

}  // namespace rocinante
