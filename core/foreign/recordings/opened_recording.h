#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/base/model_search.h"
#include "core/base/result.h"
#include "core/bundle/private_folder.h"
#include "core/report/account.h"

namespace rocinante {

struct RecordingRequest {
  std::filesystem::path recording;  ///< a log, or what another program recorded, also as a folder
  std::filesystem::path cell;       ///< names the devices; empty: the recording does
  std::string device;               ///< for joints and frames that name none; empty: none
  ModelSearch search;               ///< for the meshes of a robot description
  /// Called now and then with the part that is done, 0 to 1; an error ends the work.
  std::function<Status(double)> progress;
};

/// A recording as a log. Temporary files of it are deleted with the last copy of this.
struct OpenedRecording {
  std::filesystem::path recording;    ///< as it was named
  std::filesystem::path log;          ///< to be read in its place; the same for a log
  bool imported = false;              ///< `log` was made from the recording
  std::vector<std::string> warnings;  ///< what could not be kept or translated, as sentences
  Account left_out;                   ///< what became nothing of the log; LogAccount has more
  std::string not_kept;               ///< why `log` is a temporary file, as a sentence; or empty
  std::shared_ptr<const PrivateFolder> folder;

  /// The error with the recording's name in place of the log's.
  Error named(Error error) const;
};

/// A log of the recording, exactly as `rocinante log import` makes it (docs/other-formats.md): kept
/// in an ImportCache, or where no folder can be written in a temporary one. A log, and anything
/// that no import reads, is passed on as it is. With a cell, the robot that the recording itself
/// describes is attached, so that the two can be compared.
Result<OpenedRecording> openedRecording(const RecordingRequest& request);

/// True for what openedRecording() imports.
bool isForeignRecording(const std::filesystem::path& path);

/// What a program that takes CELL and LOG shall read in their place. Without a LOG, a CELL that is
/// a recording is the LOG too, and its own robot the cell: then both become its log.
struct CellAndRecording {
  std::filesystem::path cell, log;
  OpenedRecording opened;  ///< of the log; keep it as long as the log is read
};
Result<CellAndRecording> openedCellAndRecording(RecordingRequest request);

}  // namespace rocinante
