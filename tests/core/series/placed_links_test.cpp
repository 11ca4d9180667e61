#include "core/series/placed_links.h"

#include <gtest/gtest.h>

#include "core/base/atomic_file.h"
#include "core/cell/posed_scene.h"
#include "core/math/transform.h"
#include "core/series/series_scan.h"
#include "core/series/series_table.h"
#include "tests/core/cell/cell_fixture.h"
#include "tests/core/series/spoken_log.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using test::spokenTime;

class PlacedLinksTest : public test::CellFolder {
 protected:
  PlacedLinksTest() {
    auto loaded = load(R"(
format = 1
[[device]]
name = "arm"
model = "arm.urdf"
[[device]]
name = "tool"
model = "arm.urdf"
on = "arm/tip"
pose = { xyz = [0, 0, 0.5] }
[[device]]
name = "away"
model = "arm.urdf"
pose = { xyz = [4, 0, 0], rpy_deg = [0, 0, 90] }
[[source]]
name = "planner"
ghost_of = { plan = "away" }
)");
    EXPECT_TRUE(loaded.ok());
    cell_ = std::move(*loaded);
  }
  Cell cell_;
};

TEST_F(PlacedLinksTest, HaveTheBitsOfTheSceneInTheWorldAndInFrames) {
  PlacedLinks links(cell_);
  const SeriesKey in_world = *parseSeriesKey("tool/tip:x");
  const SeriesKey in_frame = *parseSeriesKey("tool/tip:x in away/tip");
  const SeriesKey of_ghost = *parseSeriesKey("plan/tip:qw in arm");
  EXPECT_EQ(links.add(in_world), 0U);
  EXPECT_EQ(links.add(in_frame), 1U);
  EXPECT_EQ(links.add(of_ghost), 2U);
  EXPECT_EQ(links.add(*parseSeriesKey("tool/tip:qz")), 0U);
  std::string said;
  for (const char* more :
       {"joint arm lift=0.25\n", "pose away 1 2 3 0 0 0 1\n", "joint plan lift=0.5\n",
        "pose tool 0 0 1 0 0 0 1 in away/tip\n", "pose arm 5 0 0 0 0 1 0\n", "remove away\n"}) {
    said += more;
    SCOPED_TRACE(said);
    const SessionState state = test::stateOf(said);
    const PosedScene scene = poseScene(cell_, state);
    links.place(state);
    const auto expectSame = [&](std::size_t link, const std::optional<Mat4>& expected) {
      const auto& pose = links.poses()[link];
      ASSERT_EQ(pose.has_value(), expected.has_value());
      if (!expected) return;
      EXPECT_EQ(poseNumbers(*pose), poseNumbers(poseOf(*expected)));
    };
    const auto in = [&](const std::optional<Mat4>& frame, const std::optional<Mat4>& link) {
      return frame && link ? std::optional(inverseOfRigid(*frame) * *link) : std::nullopt;
    };
    expectSame(0, scene.find("tool", "tip"));
    expectSame(1, in(scene.find("away", "tip"), scene.find("tool", "tip")));
    expectSame(2, in(scene.find("arm", ""), scene.find("plan", "tip")));
  }
}

TEST_F(PlacedLinksTest, NameWhatMovesThem) {
  PlacedLinks links(cell_);
  links.add(*parseSeriesKey("tool/tip:x"));
  links.place(SessionState());
  EXPECT_TRUE(links.devices().contains("tool"));
  EXPECT_TRUE(links.devices().contains("arm")) << "it carries the tool";
  EXPECT_FALSE(links.devices().contains("away"));
}

TEST_F(PlacedLinksTest, UnknownNamesAreRefusedWithThoseThatThereAre) {
  const auto said = [&](const char* key) {
    const Status there = checkLink(cell_, SessionState(), *parseSeriesKey(key));
    return there ? std::string() : there.error().what;
  };
  EXPECT_EQ(said("arm/tip:x in tool"), "");
  EXPECT_EQ(said("amr/tip:x"), "no device is named `amr`: did you mean `arm`?");
  EXPECT_EQ(said("arm/tpi:x"), "`arm` has no link `tpi`: did you mean `tip`?");
  EXPECT_EQ(said("arm/tip:x in tol"), "no device is named `tol`: did you mean `tool`?");
}

/// A log of the arm, of 1 s.
LogReader logOf(const std::filesystem::path& path) {
  test::writeSpoken(path, {{0, "RK1 s 0 -\njoint arm lift=0.25"},
                           {200, "RK1 s 1 -\nsignal arm load 5"},
                           {400, "RK1 s 2 -\njoint arm lift=0.5"},
                           {600, "RK1 s 3 -\nremove arm"}});
  auto reader = LogReader::open(path);
  EXPECT_TRUE(reader.ok());
  return *std::move(reader);
}

TEST_F(PlacedLinksTest, AreFunctionsOfTime) {
  const test::TemporaryFolder folder;
  LogReader log = logOf(folder / "s.mcap");
  const SeriesKey key = *parseSeriesKey("arm/tip:z");
  SeriesScan::Options options;
  options.from = spokenTime(0);
  options.until = spokenTime(1000);
  options.cell = &cell_;
  options.only = {{key}};
  SeriesScan scan(std::move(options));
  for (auto message = log.next(); message.ok() && *message; message = log.next()) {
    scan.add(**message);
  }
  const ValueBins* const bins = scan.values(key);
  ASSERT_NE(bins, nullptr);
  const auto columns = bins->columns(spokenTime(0), spokenTime(1000), 10);
  const auto at = [&](const char* text) {
    return static_cast<float>((*poseScene(cell_, test::stateOf(text)).find("arm", "tip"))[3].z);
  };
  EXPECT_EQ(columns[1].held, at("joint arm lift=0.25\n"));
  EXPECT_FALSE(columns[2].bin.hasSample()) << "a signal moves nothing";
  EXPECT_EQ(columns[4].held, at("joint arm lift=0.5\n"));
  EXPECT_EQ(columns[8].held, std::nullopt);

  SeriesTable table;
  table.keys = {key};
  table.from = spokenTime(0);
  table.until = spokenTime(1000);
  table.cell = &cell_;
  LogReader again = logOf(folder / "t.mcap");
  const auto rows = writeSeriesTable(table, SessionState(), again, folder / "t.csv");
  ASSERT_TRUE(rows.ok());
  EXPECT_EQ(*rows, 2U) << "before anything is stated, and as it moves";
}

TEST_F(PlacedLinksTest, ACarrierThatComesLaterMovesWhatItCarries) {
  const test::TemporaryFolder folder;
  const auto logAt = [&] {
    auto reader = LogReader::open(folder / "s.mcap");
    EXPECT_TRUE(reader.ok());
    return *std::move(reader);
  };
  test::writeSpoken(folder / "s.mcap", {{0, "RK1 s 0 -\npose tool 0 0 1 0 0 0 1 in cart/foot"},
                                        {200, "RK1 s 1 -\nadd cart arm.urdf"},
                                        {400, "RK1 s 2 -\npose cart 3 0 0 0 0 0 1"},
                                        {600, "RK1 s 3 -\npose cart 5 0 0 0 0 0 1"}});
  const SeriesKey key = *parseSeriesKey("tool/tip:x");
  SeriesScan::Options options;
  options.from = spokenTime(0);
  options.until = spokenTime(1000);
  options.cell = &cell_;
  options.only = {{key}};
  SeriesScan scan(std::move(options));
  LogReader log = logAt();
  for (auto message = log.next(); message.ok() && *message; message = log.next()) {
    scan.add(**message);
  }
  ASSERT_NE(scan.values(key), nullptr);
  const auto columns = scan.values(key)->columns(spokenTime(0), spokenTime(1000), 10);
  EXPECT_EQ(columns[1].held, 0.0F) << "in the world, while nobody carries it";
  EXPECT_EQ(columns[4].held, 3.0F);
  EXPECT_EQ(columns[6].held, 5.0F);

  SeriesTable table;
  table.keys = {key};
  table.from = spokenTime(-1);
  table.until = spokenTime(1000);
  table.cell = &cell_;
  LogReader again = logAt();
  const auto rows = writeSeriesTable(table, SessionState(), again, folder / "t.csv");
  ASSERT_TRUE(rows.ok()) << rows.error().text();
  const std::string text = *readFile(folder / "t.csv");
  EXPECT_NE(text.find("\n0.4,3\n0.6,5\n"), std::string::npos) << text;
}

TEST_F(PlacedLinksTest, ForgetCarriersThatAreNamedWithoutEnd) {
  PlacedLinks links(cell_);
  links.add(*parseSeriesKey("tool/tip:x"));
  SessionState state;
  for (int i = 0; i < 3000; ++i) {
    const std::string text = "RK1 s " + std::to_string(i) + " -\npose tool 0 0 1 0 0 0 1 in c" +
                             std::to_string(i) + "/foot";
    PacketTextDecoder decoder;
    state.apply(spokenTime(i), *decoder.decode(bytesOf(text)));
    links.place(state);
  }
  EXPECT_LT(links.devices().size(), 2000U);
  EXPECT_TRUE(links.devices().contains("tool"));
  EXPECT_TRUE(links.devices().contains("c2999"));
}

}  // namespace
}  // namespace rocinante
