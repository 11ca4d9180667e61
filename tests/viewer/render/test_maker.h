#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"
#include "viewer/render/frame_maker.h"

namespace rocinante::test {

inline constexpr const char* kCameras = R"(
[[camera]]
name = "top"
eye = [0, 0, 6]
target = [0, 0, 0]
[[camera]]
name = "riding"
on = "arm/hand"
eye = [0, 0, 0.2]
target = [1, 0, 0.2]
[[camera]]
name = "flat"
eye = [0, -5, 1]
target = [0, 0, 1]
ortho_height_m = 4
[[camera]]
name = "front"
eye = [0, -5, 0]
target = [0, 0, 0]
)";

/// The arm and its session of test_session.h in a folder, and makers of frames of them.
class MakerTest : public testing::Test {
 protected:
  void SetUp() override {
    writeText(folder_ / "arm.urdf", kArmUrdf);
    writeArmSession(folder_ / "arm.mcap");
  }

  /// Of a cell of the arm with `cell_text` behind it; empty: the bare URDF.
  FrameMaker open(const std::string& cell_text = "", bool with_session = true) {
    std::filesystem::path file = folder_ / "arm.urdf";
    if (!cell_text.empty()) {
      file = folder_ / "arm.cell.toml";
      writeText(file, "format = 1\n[[device]]\nname = \"arm\"\nmodel = \"arm.urdf\"\n" + cell_text);
    }
    return openCell(file, with_session);
  }

  FrameMaker openCell(const std::filesystem::path& file, bool with_session = true) {
    auto cell = loadCell(file, {});
    EXPECT_TRUE(cell.has_value()) << cell.error().text();
    for (const Finding& fault : cell->faults) {
      EXPECT_NE(fault.severity, Severity::error) << fault.print();
    }
    std::optional<Timeline> session;
    if (with_session) {
      auto opened = Timeline::open(folder_ / "arm.mcap");
      EXPECT_TRUE(opened.has_value()) << opened.error().text();
      session = std::move(*opened);
    }
    auto maker = FrameMaker::open(std::move(*cell), std::move(session), Profile::reproducible);
    EXPECT_TRUE(maker.has_value()) << maker.error().text();
    return std::move(*maker);
  }

  static FrameRequest requestAt(std::int64_t milliseconds) {
    FrameRequest request;
    request.time = sessionTime(milliseconds);
    request.width = 160;
    request.height = 120;
    return request;
  }

  static Picture frameOf(FrameMaker& maker, const FrameRequest& request) {
    auto frame = maker.frame(request);
    EXPECT_TRUE(frame.has_value()) << frame.error().text();
    return frame ? std::move(*frame) : Picture{};
  }

  TemporaryFolder folder_;
};

}  // namespace rocinante::test
