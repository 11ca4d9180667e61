#include "viewer/ui/model/camera_append.h"

#include <gtest/gtest.h>

#include "core/base/atomic_file.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"

namespace rocinante {
namespace {

CellCamera besideCamera() {
  CellCamera camera;
  camera.name = "beside \"it\"";
  camera.eye = {1.5, -2, 0.1};
  camera.target = {0, 0, 1};
  return camera;
}

constexpr char kAdded[] =
    "\n[[camera]]\nname = \"beside \\\"it\\\"\"\neye = [1.5, -2, 0.1]\ntarget = [0, 0, 1]\n"
    "fov_deg = 45\n";

TEST(AppendedCamera, FollowsTheWholeCell) {
  const std::string cell = "format = 1 # ours\n[[layer]]\nname = \"a\"\n";
  EXPECT_EQ(*withCamera(cell, besideCamera(), "c.toml"), cell + kAdded);
  EXPECT_EQ(*withCamera("format = 1", besideCamera(), "c.toml"),
            std::string("format = 1\n") + kAdded);
  const auto windows = withCamera("format = 1\r\n", besideCamera(), "c.toml");
  EXPECT_NE(windows->find("\r\n[[camera]]\r\n"), std::string::npos);
  CellCamera flat = besideCamera();
  flat.up = {0, 1, 0};
  flat.ortho_height_m = 2.5;
  const auto made = withCamera("format = 1\n", flat, "c.toml");
  EXPECT_NE(made->find("up = [0, 1, 0]\northo_height_m = 2.5\n"), std::string::npos);
  EXPECT_EQ(made->find("fov_deg"), std::string::npos);
}

TEST(AppendedCamera, IsRefusedWhereItCannotBe) {
  const auto fault = [](const std::string& cell) {
    const auto made = withCamera(cell, besideCamera(), "c.toml");
    return made.ok() ? std::string("made") : made.error().text();
  };
  EXPECT_EQ(fault("format = 1\n" + std::string(kAdded)),
            "the cell has a camera called beside \"it\" already (c.toml)");
  EXPECT_EQ(fault("camera = []\n"),
            "the cell writes its cameras as a list; a [[camera]] cannot be appended (c.toml)");
  EXPECT_NE(fault("format = "), "made");
}

TEST(AppendedCamera, IsAppendedToTheFile) {
  const test::TemporaryFolder folder;
  const std::string cell = "format = 1\n";
  test::writeText(folder / "a.cell.toml", cell);
  ASSERT_TRUE(appendCamera(folder / "a.cell.toml", besideCamera()));
  EXPECT_EQ(*readFile(folder / "a.cell.toml"), cell + kAdded);
  const auto read = loadCell(folder / "a.cell.toml", {});
  ASSERT_TRUE(read.ok());
  ASSERT_NE(read->findCamera("beside \"it\""), nullptr);
  EXPECT_EQ(read->findCamera("beside \"it\"")->eye, besideCamera().eye);
  EXPECT_FALSE(appendCamera(folder / "a.cell.toml", besideCamera()));
  EXPECT_FALSE(appendCamera(folder / "gone.cell.toml", besideCamera()));
  EXPECT_FALSE(appendCamera(folder / "arm.urdf", besideCamera()));
  EXPECT_EQ(*readFile(folder / "a.cell.toml"), cell + kAdded);
}

}  // namespace
}  // namespace rocinante
