#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <numeric>

#include "core/base/atomic_file.h"
#include "core/behaviour/run_judge.h"
#include "core/behaviour/track_cache.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

SessionTrack smallTrack() {
  SessionTrack track;
  track.origin = track.start = LogTime(std::chrono::seconds(5));
  track.end = track.start + std::chrono::milliseconds(40);
  DeviceTrack& arm = track.devices["arm"];
  arm.columns = {{"turn", TrackColumn::Kind::full_angle, 0, 0, true}};
  arm.series = {{1, 3, {0}}};
  arm.updates = {1, 2, 3};
  track.facts["drawing/planner/path"] = {{track.start, "line", {1, 2, 3}}, {track.end, "", {}}};
  track.events = {{track.start, "planner", "go"}};
  SampleStore samples;
  for (const std::int64_t time : {0, 20'000'000, 40'000'000}) {
    samples.append(std::as_bytes(std::span(&time, 1)));
  }
  const double values[] = {0.1, 0.2, 0.3};
  samples.append(std::as_bytes(std::span(values)));
  track.samples = *samples.finish();
  return track;
}

Bytes fileOf(const SessionTrack& track, std::string_view key) {
  Bytes bytes(track.samples->view().begin(), track.samples->view().end());
  const Bytes tail = encodeTrackTail(track, key);
  bytes.insert(bytes.end(), tail.begin(), tail.end());
  return bytes;
}

class TrackFile : public testing::Test {
 protected:
  std::optional<SessionTrack> decoded(ByteView bytes, std::string_view key) {
    EXPECT_TRUE(writeFileWhole(folder_ / "a.track", bytes, true).has_value());
    auto file = MappedFile::open(folder_ / "a.track");
    return file.ok() ? decodeTrack(std::move(*file), key) : std::nullopt;
  }

  test::TemporaryFolder folder_;
};

TEST_F(TrackFile, GivesBackWhatWasWritten) {
  const SessionTrack track = smallTrack();
  const auto read = decoded(fileOf(track, "key"), "key");
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(fileOf(*read, "key"), fileOf(track, "key"));
  EXPECT_EQ(read->devices.at("arm").columns[0].part, "turn");
  EXPECT_EQ(read->facts.at("drawing/planner/path")[0].shape, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(read->events[0].text, "go");
  EXPECT_TRUE(judgeRun({}, {&track}, *read).findings.empty());
  EXPECT_FALSE(decoded(fileOf(track, "key"), "other").has_value());
}

TEST_F(TrackFile, IsRefusedWhenCutAnywhereOrChanged) {
  const Bytes whole = fileOf(smallTrack(), "key");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_FALSE(decoded(ByteView(whole).first(size), "key").has_value()) << size;
  }
  for (std::size_t at = 0; at < whole.size(); ++at) {
    Bytes changed = whole;
    changed[at] ^= std::byte{0x40};
    EXPECT_FALSE(decoded(changed, "key").has_value()) << at;
  }
}

/// Numbers that lead outside of the samples, under a right checksum.
TEST_F(TrackFile, IsRefusedWhenItsPlacesAreOutside) {
  const auto refused = [&](auto change) {
    SessionTrack track = smallTrack();
    change(track.devices["arm"]);
    return !decoded(fileOf(track, "key"), "key").has_value();
  };
  EXPECT_TRUE(refused([](DeviceTrack& arm) { arm.series[0].rows = 4; }));
  EXPECT_TRUE(refused([](DeviceTrack& arm) { arm.series[0].rows = std::uint64_t{1} << 63; }));
  EXPECT_TRUE(refused([](DeviceTrack& arm) { arm.series[0].width = std::uint64_t{1} << 61; }));
  EXPECT_TRUE(refused([](DeviceTrack& arm) { arm.series[0].blocks = {8}; }));
  EXPECT_TRUE(refused([](DeviceTrack& arm) { arm.columns[0].offset = 1; }));
  EXPECT_TRUE(refused([](DeviceTrack& arm) { arm.columns[0].series = 1; }));
  EXPECT_TRUE(refused([](DeviceTrack& arm) { arm.columns[0].kind = TrackColumn::Kind::pose; }));
  EXPECT_FALSE(refused([](DeviceTrack&) {}));
}

TEST(SampleStore, GivesBackWhatItTookFromMemoryOrAFile) {
  for (const std::size_t count : {std::size_t{1'000}, std::size_t{3'000'000}}) {  // 24 kB, 72 MB
    SampleStore store;
    std::vector<double> block(3'000);
    for (std::size_t i = 0; i < count * 3 / block.size(); ++i) {
      std::iota(block.begin(), block.end(), static_cast<double>(i * block.size()));
      store.append(std::as_bytes(std::span(block)));
    }
    const auto bytes = store.finish();
    ASSERT_TRUE(bytes.ok()) << bytes.error().text();
    const ByteView view = (*bytes)->view();
    ASSERT_EQ(view.size(), count * 3 * sizeof(double));
    for (std::size_t i = 0; i < count * 3; i += 997) {
      double value = 0;
      std::memcpy(&value, view.data() + i * sizeof value, sizeof value);
      ASSERT_EQ(value, static_cast<double>(i));
    }
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
  const auto first = cache.track(*cell, demo / "session.mcap", "some bytes");
  ASSERT_TRUE(first.ok());
  // From the cache: the log is not looked at.
  const auto again = cache.track(*cell, folder / "nowhere.mcap", "some bytes");
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(fileOf(*again, ""), fileOf(*first, ""));
  EXPECT_FALSE(cache.track(*cell, folder / "nowhere.mcap", "other bytes").ok());
  EXPECT_FALSE(cache.track(*cell, folder / "nowhere.mcap", "some bytes", {"arm/link6"}).ok());
  for (const auto& entry : std::filesystem::directory_iterator(folder / "runs")) {
    std::ofstream(entry.path(), std::ios::binary | std::ios::trunc) << "broken";
  }
  EXPECT_TRUE(cache.track(*cell, demo / "session.mcap", "some bytes").ok());
}

}  // namespace
}  // namespace rocinante
