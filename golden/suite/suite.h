#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/base/time.h"
#include "core/behaviour/run_spec.h"
#include "golden/compare/compare.h"
#include "golden/compare/picture_mask.h"
#include "viewer/view/picture_terms.h"

namespace rocinante {

class SuiteTable;

/// A [[run]] of a suite: sessions judged as motion (docs/golden-suites.md, "Runs").
struct SuiteRun {
  std::string name;  ///< the log under test is given by `--log NAME=FILE`
  RunSpec spec;
  std::vector<std::string> tags;
  int line = 0;  ///< in the suite's file
};

/// Reads a [[run]].
SuiteRun readSuiteRun(SuiteTable& table);

/// The moments that a case draws: at most one of `at`, `event`, `events` and `every` is set.
struct CaseMoment {
  std::optional<std::string> at;      ///< a session time as text: its origin is the log's
  std::optional<std::string> event;   ///< the event with exactly this text
  int occurrence = 1;                 ///< of `event`: 1 the first, 2 the second, -1 the last
  std::optional<std::string> events;  ///< a pattern: one frame per event whose text matches
  std::optional<Nanoseconds> every;   ///< from the origin to the end of the log
  Nanoseconds after{0};               ///< added to the time of each event
};

/// A part of a picture.
struct PictureArea {
  std::optional<MaskRectangle> rectangle;
  /// Without a rectangle, the pixels of this PATH: DEVICE, DEVICE/LINK, layer/NAME or
  /// drawing/SOURCE/ID, as a pattern.
  std::string path;
  int grow_px = 0;  ///< pixels added on every side
  bool operator==(const PictureArea&) const = default;
  /// As named in messages: "layer/labels", "0,0,64x20".
  std::string text() const;
};

struct SuiteCase : PictureTerms {
  std::string name;
  CaseMoment moment;
  std::vector<std::string> cameras;  ///< one frame each; empty: one, chosen as by `render`
  std::optional<std::vector<std::string>> layers;  ///< draw only these
  std::vector<PictureArea> mask;                   ///< not judged
  std::vector<PictureArea> judge_only;             ///< empty: everything outside masks
  Tolerance tolerance;
  /// The tolerance for a golden of another key; a tolerance of the case sets both.
  Tolerance across_keys = Tolerance::rounding();
  std::string limit_from = "the default";  ///< where the tolerance was set
  bool expect_different = false;
  std::string reason;  ///< why a difference is expected
  std::vector<std::string> tags;
  int line = 0;  ///< in the suite's file
};

/// A suite of cases to draw and judge, and of runs to judge as motion (docs/golden-suites.md).
/// Paths are relative to the suite's file.
struct Suite {
  std::filesystem::path file;
  std::filesystem::path cell;                ///< empty: the one that the log carries
  std::optional<std::filesystem::path> log;  ///< without one every case is the cell at rest
  std::filesystem::path goldens;             ///< folder of pictures with manifest.json
  /// Pictures named by their pixel hash, for goldens too large for the repository; empty: none.
  std::filesystem::path store;
  /// "refs/goldens/files": the store is a ref of the repository's remote (GitStore); empty: it is
  /// not.
  std::string store_ref{};
  std::map<std::string, Tolerance, std::less<>> tolerances;  ///< [tolerance.NAME]
  std::vector<SuiteCase> cases;
  std::vector<SuiteRun> runs;
};

/// Reads a suite. Returns the first fault, with its line and column.
Result<Suite> readSuite(const std::filesystem::path& path);
Result<Suite> parseSuite(std::string_view text, const std::filesystem::path& path);

}  // namespace rocinante
