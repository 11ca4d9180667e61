#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "core/check/check.h"
#include "core/check/report_formats.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

constexpr const char* kTrajectory = "recordings/panda_exciting_trajectory/panda_joints.csv";

/// The real Panda session, as `source --csv` would say it, judged against a model that a cell gives
/// the device `panda`.
CheckReport judgeAgainst(const std::string& model) {
  const test::TemporaryFolder folder;
  const std::filesystem::path cell_file = folder / "p.cell.toml";
  const auto robots = std::filesystem::canonical(test::sharedData("robots"));
  std::ofstream(cell_file) << "format = 1\nsearch = [\"" << robots.string() << "\", \""
                           << (robots / model).parent_path().string()
                           << "\"]\n[[device]]\nname = \"panda\"\nmodel = \""
                           << (robots / model).string() << "\"\n";
  const Result<Cell> cell = loadCell(cell_file, {});
  EXPECT_TRUE(cell.ok()) << cell.error().text();
  if (!cell) return {};
  SessionCheck session(*cell);
  std::ifstream csv(test::sharedData(kTrajectory));
  std::string line;
  std::getline(csv, line);
  std::string order = "order panda";
  std::istringstream header(line);
  std::string column;
  std::getline(header, column, ',');
  while (std::getline(header, column, ',')) order += " " + column;
  if (order.ends_with('\r')) order.pop_back();
  for (std::uint64_t row = 0; std::getline(csv, line); ++row) {
    const std::size_t comma = line.find(',');
    const double seconds = std::stod(line.substr(0, comma));
    std::string values = line.substr(comma);
    for (char& c : values) c = c == ',' ? ' ' : c;
    // As `source` says it: the order first, and again with a restatement every two seconds or so.
    const std::string text = fmt::format("RK1 panda@1 {} {:.9f}{}\n{}\njoints panda{}\n", row,
                                         seconds, row % 2000 == 0 && row > 0 ? " restated" : "",
                                         row % 2000 == 0 ? order : "#", values);
    session.add(LogTime(Nanoseconds(static_cast<std::int64_t>(seconds * 1e9))), "rk1", true,
                bytesOf(text));
  }
  return checkSession(*cell, session);
}

TEST(RealPandaSession, FitsThePanda) {
  ROCINANTE_NEEDS_SHARED_DATA(kTrajectory);
  const CheckReport report = judgeAgainst("franka_panda/panda.urdf");
  EXPECT_EQ(report.verdict, Verdict::compatible) << checkText(report);
  EXPECT_EQ(report.packets, 20544U);
  for (const Finding& finding : report.findings) {
    // True: the recording has the seven joints of the arm, and not those of its fingers.
    if (finding.rule == "joint.undriven" && finding.severity == Severity::note) continue;
    EXPECT_EQ(finding.rule, "obj.missing-mtllib") << finding.text;
  }
}

TEST(RealPandaSession, DoesNotFitTheKuka) {
  ROCINANTE_NEEDS_SHARED_DATA(kTrajectory);
  const CheckReport report = judgeAgainst("kuka_iiwa/model.urdf");
  EXPECT_EQ(report.verdict, Verdict::incompatible) << checkText(report);
  std::size_t unknown = 0;
  for (const Finding& finding : report.findings) unknown += finding.rule == "packet.unknown-joint";
  EXPECT_EQ(unknown, 7U) << checkText(report);
}

}  // namespace
}  // namespace rocinante
