#include "viewer/backdrop/backdrop.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/base/atomic_file.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

Picture flat(int width, int height, std::uint8_t grey) {
  Picture picture{width, height, {}};
  picture.rgba.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4, grey);
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4) picture.rgba[i] = 255;
  return picture;
}

std::uint8_t greyAt(const Picture& picture, int x, int y) {
  return picture.rgba[(static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                       static_cast<std::size_t>(x)) *
                      4];
}

TEST(LensMap, WithoutDistortionIsThePictureItself) {
  const CameraIntrinsics lens{50, 55, 31.5, 23.5, 64, 48};
  Picture picture = flat(64, 48, 0);
  for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
    picture.rgba[i] = static_cast<std::uint8_t>(i % 251);
  }
  EXPECT_EQ(LensMap(lens, {}, 64, 48).straightened(picture), picture);
}

/// Numbers of cv2.projectPoints for the point (0.4, -0.3, 1), by its documented formula:
/// r2 = 0.25, radial = 1 - 0.3 * 0.25 + 0.1 * 0.0625 + 0.02 * 0.015625 = 0.9315625,
/// x = 0.4 * radial + 2 * 0.001 * -0.12 + -0.002 * (0.25 + 0.32) = 0.371245,
/// y = -0.3 * radial + 0.001 * (0.25 + 0.18) + 2 * -0.002 * -0.12 = -0.27855875.
TEST(LensMap, TakesAPixelFromWhereTheLensHasIt) {
  const CameraIntrinsics lens{100, 100, 63, 47, 128, 96};
  const LensDistortion distortion{-0.3, 0.1, 0.001, -0.002, 0.02};
  // Grey by column, then by row: what a straightened pixel has says where it is from.
  Picture columns = flat(128, 96, 0), rows = flat(128, 96, 0);
  for (std::size_t i = 0; i < columns.rgba.size(); ++i) {
    if (i % 4 == 3) continue;
    columns.rgba[i] = static_cast<std::uint8_t>(i / 4 % 128 * 2);
    rows.rgba[i] = static_cast<std::uint8_t>(i / 4 / 128 * 2);
  }
  const LensMap map(lens, distortion, 128, 96);
  // (0.4, -0.3) lies at pixel 103, 17 of the straight picture.
  EXPECT_NEAR(greyAt(map.straightened(columns), 103, 17) / 2.0, 63 + 37.1245, 0.3);
  EXPECT_NEAR(greyAt(map.straightened(rows), 103, 17) / 2.0, 47 - 27.855875, 0.3);
  // A lens that sees less than the pinhole would: nothing is made up.
  const LensMap narrow(lens, {0.9, 0, 0, 0, 0}, 128, 96);
  EXPECT_EQ(narrow.straightened(columns).rgba[3], 0) << "transparent in the corner";
}

TEST(PictureFolder, CountsAsPeopleDo) {
  EXPECT_TRUE(comesBefore("f9.png", "f10.png"));
  EXPECT_TRUE(comesBefore("f009.png", "f10.png"));
  EXPECT_FALSE(comesBefore("f10.png", "f9.png"));
  EXPECT_TRUE(comesBefore("a2", "b1"));
  EXPECT_TRUE(comesBefore("f1", "f1b"));
  EXPECT_NE(comesBefore("f01", "f1"), comesBefore("f1", "f01"));
  EXPECT_FALSE(comesBefore("f1", "f1"));
}

TEST(BackdropRequest, TakesItsWordsFromTheEnd) {
  const auto request = parseBackdrop("a,b=c/x.png,fps=12.5,camera=left");
  ASSERT_TRUE(request);
  EXPECT_EQ(request->file, "a,b=c/x.png");
  EXPECT_EQ(request->camera, "left");
  EXPECT_EQ(request->period, Nanoseconds(80'000'000));
  EXPECT_EQ(parseBackdrop(backdropText(*request, "left"))->period, request->period);
  EXPECT_FALSE(parseBackdrop("x,fps=0"));
  EXPECT_FALSE(parseBackdrop("x,fps=fast"));
  EXPECT_FALSE(parseBackdrop(",camera=left"));
}

TEST(VideoFacts, AreThoseOfShownPicturesInOrder) {
  const auto facts = parseVideoFacts(
      "packet|pts_time=1.5|flags=K__\npacket|pts_time=1.58|flags=___\n"
      "packet|pts_time=1.54|flags=___\npacket|pts_time=1.46|flags=_D_\n"
      "packet|pts_time=N/A|flags=___\nstream|width=320|height=180\nformat|start_time=1.46\n");
  ASSERT_TRUE(facts) << facts.error().text();
  EXPECT_EQ(facts->times,
            (std::vector<Nanoseconds>{Nanoseconds(1'500'000'000), Nanoseconds(1'540'000'000),
                                      Nanoseconds(1'580'000'000)}));
  EXPECT_EQ(facts->width, 320);
  EXPECT_EQ(facts->start, Nanoseconds(1'460'000'000));
  EXPECT_FALSE(parseVideoFacts(""));
  EXPECT_FALSE(parseVideoFacts("packet|pts_time=0\nstream|width=70000|height=70000\n"));
  EXPECT_FALSE(parseVideoFacts("stream|width=320|height=180\n"));
}

/// A camera of 64x48 pixels and pictures in a folder, each of its number's grey.
struct BackdropTest : testing::Test {
  test::TemporaryFolder folder;
  Cell cell;

  BackdropTest() {
    CellCamera camera;
    camera.name = "left";
    camera.intrinsics = CameraIntrinsics{50, 50, 31.5, 23.5, 64, 48};
    cell.cameras.push_back(camera);
    for (const int number : {9, 10, 11}) {
      EXPECT_TRUE(writePng(folder / ("f" + std::to_string(number) + ".png"),
                           flat(64, 48, static_cast<std::uint8_t>(number))));
    }
  }
  Result<Backdrop> opened(const std::string& text) {
    auto request = parseBackdrop(text);
    if (!request) return request.error();
    return Backdrop::open(*request, cell, LogTime{}, LogTime{});
  }
};

TEST_F(BackdropTest, AFolderHoldsEachPictureUntilTheNext) {
  std::ofstream(folder / "times.txt") << "# taken\n0.5\n1s\n 2.5 \n";
  auto backdrop = opened(folder.path().string());
  ASSERT_TRUE(backdrop) << backdrop.error().text();
  const auto at = [&](double seconds) {
    return backdrop->numberAt(Nanoseconds(static_cast<std::int64_t>(seconds * 1e9)));
  };
  EXPECT_EQ(at(0.49), std::nullopt);
  EXPECT_EQ(at(0.5), 0);
  EXPECT_EQ(at(2.4), 1);
  EXPECT_EQ(at(3.9), 2);
  EXPECT_EQ(at(4.0), std::nullopt) << "the last one as long as the one before it";
  backdrop->setOffset(std::chrono::seconds(10));
  EXPECT_EQ(at(10.5), 0);
  const auto picture = backdrop->picture(1, {});
  ASSERT_TRUE(picture);
  EXPECT_EQ(greyAt((*picture)->levels.front(), 5, 5), 10);
  EXPECT_EQ((*picture)->levels.back().width, 1);
  EXPECT_EQ(*backdrop->picture(1, {}), *picture) << "it is kept";
}

TEST_F(BackdropTest, SaysWhatItCannotUse) {
  const std::string path = folder.path().string();
  const auto why = [&](const std::string& text) { return opened(text).error().what; };
  EXPECT_EQ(why(path),
            "when its pictures were taken is unknown: give FOLDER,fps=N, or a times.txt "
            "in it, one time a line");
  EXPECT_TRUE(opened(path + ",fps=10"));
  std::ofstream(folder / "times.txt") << "1\n1\n";
  EXPECT_EQ(why(path), "this time is not after the one before");
  std::ofstream(folder / "times.txt") << "1\n2\n";
  EXPECT_EQ(why(path), "2 times for 3 pictures");
  EXPECT_EQ(why(path + "/f9.png,camera=right"),
            "the backdrop's camera `right` is unknown: there is only left");
  EXPECT_EQ(why(path + "/f8.png"), "there is no such file");
  ASSERT_TRUE(writePng(folder / "wide.png", flat(64, 40, 1)));
  EXPECT_EQ(why(path + "/wide.png"),
            "the picture has 64x40 pixels, and camera `left` is calibrated for 64x48");
  ASSERT_TRUE(writePng(folder / "large.png", flat(128, 96, 1)));
  EXPECT_TRUE(opened(path + "/large.png"));
  cell.cameras.clear();
  EXPECT_EQ(why(path + "/f9.png"),
            "no camera of the cell has `intrinsics`, which a backdrop needs");
}

}  // namespace
}  // namespace rocinante
