#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"
#include "core/time.h"
#include "golden/compare.h"

namespace rocinante {

/// Which moments a case draws: one of these is set.
struct CaseMoment {
  std::optional<std::string> at;     ///< a session time as text: its origin is the log's
  std::optional<std::string> event;  ///< the first event with this text
  std::optional<Nanoseconds> every;  ///< from the origin to the end of the log
  Nanoseconds after{0};              ///< added to the event's time
};

struct SuiteCase {
  std::string name;
  CaseMoment moment;
  std::string camera;  ///< empty: as render chooses
  int width = 640, height = 480;
  int samples = 4;
  std::vector<std::string> hide, show;
  Tolerance tolerance;
  std::vector<std::string> tags;
  int line = 0;  ///< in the suite's file
};

/// What to draw and judge (docs/golden-suites.md). Paths are resolved against the suite's file.
struct Suite {
  std::filesystem::path file;
  std::filesystem::path cell;                ///< empty: the one that the log carries
  std::optional<std::filesystem::path> log;  ///< without one every case is the cell at rest
  std::filesystem::path goldens;             ///< folder of pictures with manifest.json
  std::vector<SuiteCase> cases;
};

/// Reads a suite; every fault names its line and column, and the first one is returned.
Result<Suite> readSuite(const std::filesystem::path& path);
Result<Suite> parseSuite(std::string_view text, const std::filesystem::path& path);

}  // namespace rocinante
