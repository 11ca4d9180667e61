#include "golden/run/track_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "golden/run/run_judge.h"
#include "golden/run/track_cache.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

SessionTrack smallTrack() {
  SessionTrack track;
  track.origin = track.start = LogTime(std::chrono::seconds(5));
  track.end = track.start + std::chrono::milliseconds(40);
  track.step = std::chrono::milliseconds(20);
  track.samples = 3;
  DeviceTrack& arm = track.devices["arm"];
  arm.columns = {{"turn", TrackColumn::Kind::full_angle, 0}};
  arm.width = 1;
  arm.rows = {0.1, 0.2, 0.3};
  arm.updates = {1, 2, 3};
  track.facts["drawing/planner/path"] = {{track.start, "line", {1, 2, 3}}, {track.end, "", {}}};
  track.events = {{track.start, "planner", "go"}};
  return track;
}

TEST(TrackFile, GivesBackWhatWasWritten) {
  const SessionTrack track = smallTrack();
  const auto read = decodeTrack(encodeTrack(track, "key"), "key");
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->devices.at("arm").rows, track.devices.at("arm").rows);
  EXPECT_EQ(read->devices.at("arm").columns[0].part, "turn");
  EXPECT_EQ(read->facts.at("drawing/planner/path")[0].shape, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(read->events[0].text, "go");
  EXPECT_TRUE(judgeRun({}, {&track}, *read).findings.empty());
  EXPECT_FALSE(decodeTrack(encodeTrack(track, "key"), "other").has_value());
}

TEST(TrackFile, IsRefusedWhenCutAnywhereOrChanged) {
  const Bytes whole = encodeTrack(smallTrack(), "key");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_FALSE(decodeTrack(cut, "key").has_value()) << size;
  }
  for (std::size_t at = 0; at < whole.size(); ++at) {
    Bytes changed = whole;
    changed[at] ^= std::byte{0x40};
    EXPECT_FALSE(decodeTrack(changed, "key").has_value()) << at;
  }
}

TEST(TrackCache, GivesWhatReadingTheLogGives) {
  const std::filesystem::path demo = std::filesystem::path(ROCINANTE_SOURCE_DIR) / "examples/demo";
  CellOptions options;
  options.geometry = false;
  const auto cell = loadCell(demo / "demo.cell.toml", options);
  ASSERT_TRUE(cell.ok());
  const test::TemporaryFolder folder;
  const TrackCache cache(folder / "runs");
  const Nanoseconds step = std::chrono::milliseconds(20);
  const auto first = cache.track(*cell, demo / "session.mcap", "some bytes", step);
  ASSERT_TRUE(first.ok());
  // From the cache: the log is not looked at.
  const auto again = cache.track(*cell, folder / "nowhere.mcap", "some bytes", step);
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(encodeTrack(*again, ""), encodeTrack(*first, ""));
  EXPECT_FALSE(cache.track(*cell, folder / "nowhere.mcap", "other bytes", step).ok());
  EXPECT_FALSE(cache.track(*cell, folder / "nowhere.mcap", "some bytes", 2 * step).ok());
  for (const auto& entry : std::filesystem::directory_iterator(folder / "runs")) {
    std::ofstream(entry.path(), std::ios::binary | std::ios::trunc) << "broken";
  }
  EXPECT_TRUE(cache.track(*cell, demo / "session.mcap", "some bytes", step).ok());
}

}  // namespace
}  // namespace rocinante
