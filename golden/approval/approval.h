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

/// Makes pictures the goldens of their cases: all of it for a case, or none. Several may approve in
/// one folder at once: what another approved since `seen` was read is never taken away.
///
/// stage() writes a picture where nobody reads it. commit() locks the folder, reads the manifest
/// anew, moves what is staged to `.NAME.new`, writes the manifest (from here on it counts: see
/// GoldenFolder::read) and gives the pictures their names. Killed at any point, either the old
/// goldens hold or the new ones do; what is left behind then, the next commit() takes away.
class Approval {
 public:
  Approval(GoldenFolder folder, Manifest seen)
      : folder_(std::move(folder)), seen_(std::move(seen)) {}
  Approval(const Approval&) = delete;
  Approval& operator=(const Approval&) = delete;

  /// True when this very picture is accepted already, for whichever key, and lies there.
  bool isAccepted(const std::string& case_name, const AcceptedPicture& accepted) const;

  /// Of what the pictures that are staged from now on were drawn: commit() writes it down too.
  void describeCell(FileHashes files, FileTexts texts = {}) {
    cell_ = cellKey(files);
    cell_files_ = std::move(files);
    cell_texts_ = std::move(texts);
  }

  /// `accepted` has everything but file names and cell. `areas` may be null. `beside`: accepted
  /// pictures of its key stay. On an error nothing is staged.
  Status stage(const std::string& case_name, AcceptedPicture accepted, const Picture& picture,
               const Picture* areas, bool beside);
  std::size_t staged() const { return staged_.size(); }

  /// The frames that somebody else approved in the meantime, and that were left alone. On an error
  /// nothing is approved. Also with nothing staged it clears what was left by who was killed.
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
  std::optional<StagingFolder> staging_;  ///< where they lie: with a store, in the store
  std::vector<Staged> staged_;
  std::string cell_;
  FileHashes cell_files_;
  FileTexts cell_texts_;
  std::size_t files_ = 0;
};

/// Gives the pictures that the manifest names but that were left as `.NAME.new` their names, and
/// removes others of that kind. For who holds the folder's lock.
void finishArrivals(const GoldenFolder& folder, const Manifest& manifest);

}  // namespace rocinante
