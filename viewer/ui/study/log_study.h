#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/cell/cell.h"
#include "core/series/series_scan.h"
#include "core/session/event_alignment.h"

namespace rocinante {

/// What the time line and the plots of a window show.
struct StudyWish {
  std::vector<SeriesKey> keys;
  LogTime from{}, until{};
  std::size_t columns = 0;        ///< pixels from `from` to `until`, at most 8192
  std::size_t strip_columns = 0;  ///< of the sources' rates, at most 8192
  bool operator==(const StudyWish&) const = default;
};

/// Packets and losses of one source, or of all (with an empty name): by column, per second.
struct SourceStrip {
  std::string source;
  std::vector<float> rates, lost;
  float most = 0;  ///< of `rates` in the whole log, so that zooming changes no height
};

/// The answer to a wish, ready to be drawn.
struct StudyPicture {
  StudyWish wish;
  /// By key: the values of joints and poses, and rates as if they were values. Empty for a value
  /// that no packet states.
  std::vector<std::vector<ValueColumn>> curves;
  std::vector<SourceStrip> strips;                   ///< all, then by source
  std::vector<std::pair<LogTime, LogTime>> damaged;  ///< packets may be missing there
  LogTime reached{};                                 ///< known until here
  bool whole = false;  ///< everything is known, as finely as pixels are
  std::string fault;   ///< why the log cannot be read; one sentence, or empty
};

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

  /// Asks for a picture, and returns the newest there is, which may answer an earlier wish or show
  /// less; null: none yet. When `waits`, it returns the answer, whole.
  std::shared_ptr<const StudyPicture> show(const StudyWish& wish);
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

/// The curves of a picture of the log beside, at the times of `wish`, which is of the shown log.
std::shared_ptr<const StudyPicture> alignedPicture(const StudyPicture& beside,
                                                   const StudyWish& wish,
                                                   const EventAlignment& alignment);

}  // namespace rocinante
