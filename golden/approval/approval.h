#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "golden/approval/golden_folder.h"
#include "golden/approval/manifest.h"
#include "golden/approval/staging_folder.h"
#include "viewer/picture/picture.h"

namespace rocinante {

/// Makes pictures the goldens of their cases; each case is approved completely or not at all.
/// Several processes may approve in one folder at once: goldens that another process approved since
/// `seen` was read are kept.
///
/// stage() writes a picture to a private folder. commit() locks the golden folder, reads the
/// manifest again, moves staged files to `.NAME.new`, writes the manifest (the new goldens are
/// valid from here: see GoldenFolder::read) and renames the pictures. A process killed at any point
/// leaves either the old or the new goldens valid; the next commit() removes its leftovers.
class Approval {
 public:
  Approval(GoldenFolder folder, Manifest seen)
      : folder_(std::move(folder)), seen_(std::move(seen)) {}
  Approval(const Approval&) = delete;
  Approval& operator=(const Approval&) = delete;

  /// True when this picture is already accepted with its coverage, for any key, and its file
  /// exists.
  bool isAccepted(const std::string& case_name, const AcceptedPicture& accepted) const;

  /// Sets the cell files that pictures staged from now on were drawn from; commit() records them.
  void describeCell(FileHashes files, FileTexts texts = {}) {
    cell_ = cellKey(files);
    cell_files_ = std::move(files);
    cell_texts_ = std::move(texts);
  }

  /// `accepted` has all fields except file names and cell. `areas` may be null. `beside`: keep the
  /// accepted pictures of its key. An accepted picture that differs in coverage alone is replaced,
  /// under its own key. On an error nothing is staged.
  Status stage(const std::string& case_name, AcceptedPicture accepted, const Picture& picture,
               const Picture* areas, bool beside);
  std::size_t staged() const { return staged_.size(); }

  /// Returns the frames that another process approved meanwhile; they are left unchanged. On an
  /// error nothing is approved. Removes leftovers of killed processes even when nothing is staged.
  Result<std::vector<std::string>> commit();

 private:
  struct Staged {
    std::string case_name;
    AcceptedPicture accepted;
    bool beside = false;
    std::filesystem::path picture_file, areas_file;  ///< the latter empty without areas
  };

  Result<std::filesystem::path> writeStaged(const Picture& picture);
  void cleanFolders(const Manifest& now) const;
  Status nameFiles(const Manifest& now, Staged& staged) const;
  Status moveToArriving(const Staged& staged) const;

  GoldenFolder folder_;
  Manifest seen_;
  std::optional<StagingFolder> staging_;  ///< of staged files; in the store if there is one
  std::vector<Staged> staged_;
  std::string cell_;
  FileHashes cell_files_;
  FileTexts cell_texts_;
  std::size_t files_ = 0;
};

/// Renames `.NAME.new` pictures that the manifest lists, and removes the other `.new` files.
/// Requires the folder's lock.
void finishArrivals(const GoldenFolder& folder, const Manifest& manifest);

}  // namespace rocinante
