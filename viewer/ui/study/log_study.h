#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/cell/cell.h"
#include "viewer/ui/study/study_picture.h"

namespace rocinante {

/// Reads a whole log once in a thread of its own, which gathers every value as a function of time
/// (SeriesScan), and then the part that is shown once more whenever pixels are finer than that.
/// Until it has read all of it, pictures show what is known. Its thread has a low priority. For one
/// calling thread.
class LogStudy {
 public:
  /// `cell` is borrowed, and read by the thread.
  /// `grows`: the log, or the first piece of the session, is still being written; pictures grow
  /// with it.
  LogStudy(const Cell& cell, std::filesystem::path log, bool grows = false);
  ~LogStudy();
  LogStudy(const LogStudy&) = delete;
  LogStudy& operator=(const LogStudy&) = delete;

  /// Requests a picture and returns the latest; it may be of an earlier request, or show less.
  /// Null: none yet. When `waits`, it returns the picture of this request, whole.
  std::shared_ptr<const StudyPicture> show(const StudyQuery& wish);
  bool waits = false;
  /// True when there is a picture that show() has not returned.
  bool hasNews() const;
  /// Something is still to come.
  bool isBusy() const;

  /// Writes the table of these values (core/series/series_table.h); when `waits`, before it
  /// returns.
  void writeTable(std::vector<SeriesKey> keys, LogTime from, LogTime until,
                  std::filesystem::path path);
  /// What became of the last table, once: a sentence, or why there is none.
  std::optional<Result<std::string>> takeTable();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante
