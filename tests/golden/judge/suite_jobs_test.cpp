#include "golden/judge/suite_jobs.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/atomic_file.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

constexpr int kCases = 500;
const std::filesystem::path kDemo = std::filesystem::path(ROCINANTE_SOURCE_DIR) / "examples/demo";

/// What was asked of every drawer of a run.
struct Asked {
  int drawers = 0;
  std::vector<LogTime> moments;
};

/// Draws one pixel of the moment's colour, and remembers what it was asked for.
class CountingDrawer : public FrameDrawer {
 public:
  explicit CountingDrawer(Asked& asked) : asked_(asked) { ++asked_.drawers; }
  Result<Picture> frame(const FrameRequest& request) override {
    asked_.moments.push_back(request.time);
    return pictureAt(request.time);
  }
  Result<SceneIdentity> identity(const FrameRequest&) override { return SceneIdentity{}; }
  std::string renderer() const override { return "counted"; }
  const std::string& inputsHash() const override { return inputs_; }
  Result<std::vector<PicturedView>> views(const FrameRequest&) override {
    return std::vector<PicturedView>{};
  }
  Result<SessionState> state(const FrameRequest&) override { return SessionState{}; }
  const Cell& cell() const override { return cell_; }

  static Picture pictureAt(LogTime time) {
    const auto ms = time.time_since_epoch() / std::chrono::milliseconds(1);
    return {1, 1, {static_cast<std::uint8_t>(ms), static_cast<std::uint8_t>(ms >> 8), 0, 255}};
  }

 private:
  Asked& asked_;
  std::string inputs_;
  Cell cell_;
};

class SuiteOfFiveHundred : public testing::Test {
 protected:
  SuiteOfFiveHundred() {
    std::string text =
        fmt::format("format = 1\ncell = \"{}\"\nlog = \"{}\"\n[defaults]\nsamples = 1\n",
                    (kDemo / "demo.cell.toml").string(), (kDemo / "session.mcap").string());
    for (int i = 0; i < kCases; ++i) {
      // 7 and 500 have no common divisor: every moment once, in no order.
      text += fmt::format("[[case]]\nname = \"case-{}\"\nat = \"{}ms\"\n", i,
                          500 + i * 7 % kCases * 36);
    }
    EXPECT_TRUE(writeFileWhole(folder_ / "suite.toml", bytesOf(text), true).ok());
    options_.now_ms = [] { return 0.0; };
    options_.drawers = [this]() -> Result<std::unique_ptr<FrameDrawer>> {
      return std::unique_ptr<FrameDrawer>(std::make_unique<CountingDrawer>(asked_));
    };
  }

  Result<SuiteSession> open() { return SuiteSession::open(folder_ / "suite.toml", options_); }

  /// Goldens of all frames, of which there is nothing but the hash: a manifest without pictures.
  void acceptHashesAlone() {
    auto session = open();
    ASSERT_TRUE(session.ok()) << session.error().text();
    Manifest manifest;
    for (const SuiteFrame& frame : session->frames()) {
      manifest.accept(frame.name,
                      {*session->key(*frame.suite_case), frame.name + ".png",
                       pictureXxh3(CountingDrawer::pictureAt(*frame.time)), "", "", "ada", "", ""});
    }
    std::filesystem::create_directories(session->folder().goldens());
    ASSERT_TRUE(manifest.write(session->folder().goldens()).ok());
    asked_ = {};
  }

  test::TemporaryFolder folder_;
  Asked asked_;
  SuiteOptions options_;
};

TEST_F(SuiteOfFiveHundred, GoesThroughTheLogOnceAndDecodesNothing) {
  acceptHashesAlone();
  auto session = open();
  ASSERT_TRUE(session.ok()) << session.error().text();
  std::vector<std::string> told;
  JobOptions options;
  options.tell = [&](const JudgedFrame& judged) { told.push_back(judged.frame.name); };
  const auto judged = judgeAll(*session, options);
  ASSERT_TRUE(judged.ok()) << judged.error().text();
  EXPECT_EQ(asked_.drawers, 1);
  EXPECT_EQ(asked_.moments.size(), std::size_t{kCases});  // each frame once
  EXPECT_TRUE(std::ranges::is_sorted(asked_.moments));    // never backwards
  ASSERT_EQ(judged->size(), std::size_t{kCases});
  for (int i = 0; i < kCases; ++i) {
    // There is no picture that could have been decoded.
    EXPECT_EQ((*judged)[static_cast<std::size_t>(i)].verdict, FrameVerdict::same) << i;
    EXPECT_EQ(told[static_cast<std::size_t>(i)], fmt::format("case-{}", i));
  }
}

TEST_F(SuiteOfFiveHundred, OneThatFailsIsDrawnTwiceMoreAndTheRestGoesOn) {
  acceptHashesAlone();
  auto manifest = Manifest::read(folder_ / "goldens");
  ASSERT_TRUE(manifest.ok());
  manifest->cases.erase("case-41");
  ASSERT_TRUE(manifest->write(folder_ / "goldens").ok());
  auto session = open();
  ASSERT_TRUE(session.ok()) << session.error().text();
  const auto judged = judgeAll(*session, {});
  ASSERT_TRUE(judged.ok()) << judged.error().text();
  EXPECT_EQ((*judged)[41].verdict, FrameVerdict::missing);
  EXPECT_EQ(std::ranges::count(*judged, FrameVerdict::same, &JudgedFrame::verdict), kCases - 1);
  EXPECT_EQ(asked_.drawers, 2);  // one in a context of its own
  // Itself, another in between, itself again, and itself in the other context: all at its moment.
  EXPECT_EQ(asked_.moments.size(), std::size_t{kCases + 3});
  EXPECT_TRUE(std::ranges::is_sorted(asked_.moments));
}

}  // namespace
}  // namespace rocinante
