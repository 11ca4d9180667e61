#pragma once

#include <cstddef>
#include <vector>

#include "core/bundle/cell_bundle.h"
#include "golden/approval/manifest.h"

namespace rocinante {

/// Replaces the texts of a bundle with the golden's for the lifetime of this object.
class GoldenTexts {
 public:
  GoldenTexts(CellBundle& bundle, const FileHashes& golden, const FileTexts& texts);
  ~GoldenTexts();
  GoldenTexts(const GoldenTexts&) = delete;
  GoldenTexts& operator=(const GoldenTexts&) = delete;

  bool any() const { return !kept_.empty(); }
  /// Number of changed files without a kept text.
  std::size_t unknown() const { return unknown_; }

 private:
  struct Kept {
    std::size_t place;
    BundleManifest::File file;
    Bytes content;
  };
  CellBundle& bundle_;
  std::vector<Kept> kept_;
  std::size_t unknown_ = 0;
};

}  // namespace rocinante
