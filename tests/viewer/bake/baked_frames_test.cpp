// Frames of baked cells have the bits, and the inputs' hash, of frames of the loaded ones.
#include <gtest/gtest.h>

#include "core/session/timeline.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"
#include "viewer/bake/bake_cell.h"
#include "viewer/render/frame_maker.h"

namespace rocinante {
namespace {

void expectSameFrames(const std::filesystem::path& file, const CellOptions& options,
                      const std::vector<std::string>& cameras, const std::filesystem::path& log) {
  auto loaded = loadCell(file, options);
  ASSERT_TRUE(loaded.ok()) << loaded.error().text();
  const auto bytes = std::make_shared<const Bytes>(bakeCell(*loaded, {}));
  const auto parsed = BakedFile::parse(*bytes, "baked");
  ASSERT_TRUE(parsed.ok()) << parsed.error().text();
  auto baked = readBakedCell(*parsed, bytes);
  ASSERT_TRUE(baked.ok()) << baked.error().text();
  BakeOptions bare;
  bare.pictures = false;
  EXPECT_EQ(bakeCell(*baked, bare), bakeCell(*loaded, bare)) << "every field";

  std::vector<Picture> frames;
  std::vector<std::string> inputs;
  for (Cell* cell : {&*loaded, &*baked}) {
    std::optional<Timeline> session;
    if (!log.empty()) {
      auto opened = Timeline::open(log);
      ASSERT_TRUE(opened.ok()) << opened.error().text();
      session = std::move(*opened);
    }
    FrameRequest request;
    request.width = 320;
    request.height = 200;
    if (session) request.time = session->origin() + std::chrono::seconds(4);
    auto maker = FrameMaker::open(std::move(*cell), std::move(session), Profile::reproducible);
    ASSERT_TRUE(maker.ok()) << maker.error().text();
    inputs.push_back(maker->inputsHash());
    for (const std::string& camera : cameras) {
      request.camera = camera;
      auto frame = maker->frame(request);
      ASSERT_TRUE(frame.ok()) << frame.error().text();
      frames.push_back(std::move(*frame));
    }
  }
  EXPECT_EQ(inputs[0], inputs[1]);
  for (std::size_t i = 0; i < cameras.size(); ++i) {
    EXPECT_EQ(frames[i], frames[cameras.size() + i]) << "camera " << cameras[i];
  }
}

TEST(BakedFramesTest, OfTheDemo) {
  const std::filesystem::path demo = std::filesystem::path(ROCINANTE_SOURCE_DIR) / "examples/demo";
  expectSameFrames(demo / "demo.cell.toml", {}, {"overview", ""}, demo / "session.mcap");
}

TEST(BakedFramesTest, OfTheWasteYard) {
  ROCINANTE_NEEDS_SHARED_DATA("env/waste_yard");
  expectSameFrames(test::sharedData("env/waste_yard/waste_yard.obj"), {}, {""}, {});
}

TEST(BakedFramesTest, OfThePanda) {
  ROCINANTE_NEEDS_SHARED_DATA("robots/franka_panda");
  CellOptions options;
  options.search = {test::sharedData("robots")};
  expectSameFrames(test::sharedData("robots/franka_panda/panda.urdf"), options, {""}, {});
}

}  // namespace
}  // namespace rocinante
