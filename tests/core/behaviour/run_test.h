#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "core/behaviour/run_judge.h"
#include "core/cell/cell.h"
#include "tests/core/behaviour/said_session.h"
#include "tests/support/temporary_folder.h"

namespace rocinante::test {

inline const std::filesystem::path kDemo =
    std::filesystem::path(ROCINANTE_SOURCE_DIR) / "examples/demo";

inline Cell cellAt(const std::filesystem::path& path) {
  CellOptions options;
  options.geometry = false;
  auto cell = loadCell(path, options);
  EXPECT_TRUE(cell.ok());
  return cell.ok() ? std::move(*cell) : Cell{};
}

inline std::string textOfFindings(const RunJudgement& judged) {
  std::string text = judged.rule + "\n";
  for (const RunFinding& finding : judged.findings) {
    text += fmt::format("  {} [{}] {}\n", nameOf(finding.kind), finding.item, finding.what);
  }
  return text;
}

/// Judges sessions that a test has changed.
class RunTest : public testing::Test {
 protected:
  Result<SessionTrack> trackOf(const Cell& cell, const SaidSession& session) {
    session.write(folder_ / "run.mcap");
    return trackSession(cell, folder_ / "run.mcap", links_);
  }

  static void expectSilent(const char* what, const RunJudgement& judged) {
    EXPECT_TRUE(judged.comparable && judged.findings.empty()) << what << "\n"
                                                              << textOfFindings(judged);
  }

  TemporaryFolder folder_;
  std::vector<std::string> links_;  ///< of tracks, "DEVICE/LINK"
};

}  // namespace rocinante::test
