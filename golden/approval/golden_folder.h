#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "golden/approval/manifest.h"
#include "golden/store/git_store.h"
#include "golden/suite/suite.h"
#include "viewer/picture/picture.h"

namespace rocinante {

/// Location of a suite's accepted pictures: beside the manifest, or in a store, which is a folder
/// of pictures named by their pixel hash that several suites may share, or a ref of git.
/// docs/golden-suites.md.
class GoldenFolder {
 public:
  GoldenFolder(std::filesystem::path goldens, std::filesystem::path store)
      : goldens_(std::move(goldens)), store_(std::move(store)) {}
  /// The store's files are those of a ref, brought when they are read.
  GoldenFolder(std::filesystem::path goldens, GitStore git)
      : goldens_(std::move(goldens)), store_(git.files()), git_(std::move(git)) {}
  /// The folder of a suite. refused when its store is a ref and it is in no repository.
  static Result<GoldenFolder> of(const Suite& suite);

  const std::filesystem::path& goldens() const { return goldens_; }
  const std::filesystem::path& store() const { return store_; }
  bool hasStore() const { return !store_.empty(); }
  /// Null unless the store is a ref.
  const GitStore* git() const { return git_ ? &*git_ : nullptr; }

  /// True for a picture named by its hash, when there is a store.
  bool isInStore(const std::string& picture, const std::string& pixels) const {
    return hasStore() && picture == pixels + ".png";
  }
  /// Path of a picture of the manifest.
  std::filesystem::path fileOf(const std::string& picture, const std::string& pixels) const;
  /// Path of a picture until the manifest lists it; see Approval.
  std::filesystem::path arrivingFile(const std::string& picture) const;
  bool has(const AcceptedPicture& accepted) const;

  /// Path of an accepted log.
  std::filesystem::path fileOf(const AcceptedRun& accepted) const;
  /// Checks that the log is the one that was accepted: not_found, unsupported for a Git LFS
  /// pointer, otherwise damaged.
  Status verify(const AcceptedRun& accepted) const;

  /// Reads the picture and checks its pixel hash against the manifest. not_found when it is
  /// missing, unsupported for a Git LFS pointer, otherwise damaged.
  Result<Picture> read(const AcceptedPicture& accepted) const;
  /// The same for its areasPicture.
  Result<Picture> readAreas(const AcceptedPicture& accepted) const;

 private:
  Result<Picture> readVerified(const std::string& picture, const std::string& pixels) const;

  std::filesystem::path goldens_, store_;
  std::optional<GitStore> git_;
};

}  // namespace rocinante
