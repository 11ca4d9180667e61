#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "golden/approval/manifest.h"
#include "viewer/picture/picture.h"

namespace rocinante {

/// Where a suite's accepted pictures lie: beside the manifest, or in a store, a folder of pictures
/// named by their pixel hash that several suites may share. docs/golden-suites.md.
class GoldenFolder {
 public:
  GoldenFolder(std::filesystem::path goldens, std::filesystem::path store)
      : goldens_(std::move(goldens)), store_(std::move(store)) {}

  const std::filesystem::path& goldens() const { return goldens_; }
  const std::filesystem::path& store() const { return store_; }
  bool hasStore() const { return !store_.empty(); }

  /// True for a picture named by its hash, when there is a store.
  bool isInStore(const std::string& picture, const std::string& pixels) const {
    return hasStore() && picture == pixels + ".png";
  }
  /// Where a picture of the manifest lies.
  std::filesystem::path fileOf(const std::string& picture, const std::string& pixels) const;
  /// Where approving puts a picture until the manifest names it; see Approval.
  std::filesystem::path arrivingFile(const std::string& picture) const;
  bool has(const AcceptedPicture& accepted) const;

  /// The picture, only if it is the one that the manifest accepted: not_found when it is missing,
  /// unsupported for a pointer of Git LFS, damaged else.
  Result<Picture> read(const AcceptedPicture& accepted) const;
  /// The same of its areasPicture.
  Result<Picture> readAreas(const AcceptedPicture& accepted) const;

 private:
  Result<Picture> readVerified(const std::string& picture, const std::string& pixels) const;

  std::filesystem::path goldens_, store_;
};

}  // namespace rocinante
