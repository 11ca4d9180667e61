#include "viewer/ui/model/pose_edit.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <fstream>
#include <iterator>

#include "core/math/transform.h"
#include "core/math/trigonometry.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

Pose poseAt(double x, double y, double z, const Vec3& rpy_deg = {0, 0, 0}) {
  return {{x, y, z},
          quaternionFromRpy({radiansOf(rpy_deg.x), radiansOf(rpy_deg.y), radiansOf(rpy_deg.z)})};
}

std::string moved(const std::string& cell, const Pose& before, const Pose& after) {
  const auto text = withDevicePose(cell, "arm", before, after, "c.toml");
  return text.ok() ? *text : text.error().text();
}

TEST(PoseEdit, ChangesNumbersAndNothingElse) {
  EXPECT_EQ(moved("# ours\nformat = 1\n[[device]]\n  name = \"arm\"   # the one\n  model = 'a'\n"
                  "  pose = {xyz=[ 1.50 , 2,0.0 ],  rpy_deg = [0, 0, 90] }  # measured\n"
                  "[[device]]\nname = \"b\"\nmodel = 'b'\n",
                  poseAt(1.5, 2, 0, {0, 0, 90}), poseAt(1.5, -2.25, 0, {0, 0, 90})),
            "# ours\nformat = 1\n[[device]]\n  name = \"arm\"   # the one\n  model = 'a'\n"
            "  pose = {xyz=[ 1.50 , -2.25,0.0 ],  rpy_deg = [0, 0, 90] }  # measured\n"
            "[[device]]\nname = \"b\"\nmodel = 'b'\n");
}

TEST(PoseEdit, KeepsTheWordsOfARotation) {
  const std::string head = "format = 1\n[[device]]\nname = \"arm\"\nmodel = 'a'\n";
  EXPECT_EQ(moved(head + "pose = { rpy_deg = [0, 0, 90] }\n", poseAt(0, 0, 0, {0, 0, 90}),
                  poseAt(0, 0, 0, {0, 0, -45})),
            head + "pose = { rpy_deg = [0, 0, -45] }\n");
  EXPECT_EQ(moved(head + "pose = { rpy = [0, 0, 0.5] }\n", poseAt(0, 0, 0, {0, 0, degreesOf(0.5)}),
                  poseAt(0, 0, 0, {0, 0, degreesOf(0.25)})),
            head + "pose = { rpy = [0, 0, 0.25] }\n");
  EXPECT_EQ(moved(head + "pose = { quaternion = [0, 0, 0, 1] }\n", poseAt(0, 0, 0),
                  poseAt(0, 0, 0, {0, 0, 180})),
            head + "pose = { quaternion = [0, 0, 1, 0] }\n");
}

TEST(PoseEdit, AddsWhatIsNotThere) {
  EXPECT_EQ(moved("[[device]]\nname = \"arm\"\nmodel = 'a'\n", poseAt(0, 0, 0), poseAt(1, 0, 0.25)),
            "[[device]]\nname = \"arm\"\npose = { xyz = [1, 0, 0.25] }\nmodel = 'a'\n");
  EXPECT_EQ(moved("[[device]]\r\n\tmodel = 'x/arm.urdf' # alone", poseAt(0, 0, 0),
                  poseAt(0, 0, 0, {0, 0, 90})),
            "[[device]]\r\n\tmodel = 'x/arm.urdf' # alone\n\tpose = { rpy_deg = [0, 0, 90] }\n");
  EXPECT_EQ(moved("device = [{ name = \"arm\", model = 'a' }]\n", poseAt(0, 0, 0), poseAt(1, 2, 3)),
            "device = [{ name = \"arm\", pose = { xyz = [1, 2, 3] }, model = 'a' }]\n");
  EXPECT_EQ(moved("[[device]]\nname = \"arm\"\npose = { rpy_deg = [0, 0, 90] }\n",
                  poseAt(0, 0, 0, {0, 0, 90}), poseAt(0, 0, 2, {0, 0, 90})),
            "[[device]]\nname = \"arm\"\npose = { xyz = [0, 0, 2], rpy_deg = [0, 0, 90] }\n");
  EXPECT_EQ(moved("[[device]]\nname = \"arm\"\npose = {}\n", poseAt(0, 0, 0), poseAt(0, 0, 2)),
            "[[device]]\nname = \"arm\"\npose = { xyz = [0, 0, 2] }\n");
}

TEST(PoseEdit, OtherFormsOfTablesAreEditedWhereTheyHaveTheNumbers) {
  EXPECT_EQ(moved("[[device]]\nname = \"arm\"\npose.xyz = [\n  1, # along\n  2,\n  3\n]\n",
                  poseAt(1, 2, 3), poseAt(4, 2, 3)),
            "[[device]]\nname = \"arm\"\npose.xyz = [\n  4, # along\n  2,\n  3\n]\n");
  EXPECT_EQ(
      moved("[[device]]\nname = \"\xc3\xa9\"\n[[device]]\nname = \"arm\"\nmodel = \"\xc3\xa9\"\n"
            "[device.pose]\nxyz = [1, 2, 3]\n",
            poseAt(1, 2, 3), poseAt(1, 2, 4)),
      "[[device]]\nname = \"\xc3\xa9\"\n[[device]]\nname = \"arm\"\nmodel = \"\xc3\xa9\"\n"
      "[device.pose]\nxyz = [1, 2, 4]\n");
  EXPECT_EQ(moved("[[device]]\nname = \"arm\"\npose.rpy_deg = [0, 0, 0]\n", poseAt(0, 0, 0),
                  poseAt(1, 2, 4)),
            "the pose of arm is written in a form that cannot be changed in place; write pose = { "
            "xyz = [1, 2, 4], rpy_deg = [0, 0, 0] } (c.toml)");
}

TEST(PoseEdit, RefusesWhatIsNotAsItWas) {
  EXPECT_EQ(moved("[[device]]\nname = \"other\"\n", poseAt(0, 0, 0), poseAt(1, 0, 0)),
            "the file has no device arm (c.toml)");
  EXPECT_EQ(moved("[[device]]\nname = \"arm\"\npose = { xyz = [9, 0, 0] }\n", poseAt(0, 0, 0),
                  poseAt(1, 0, 0)),
            "the file has arm elsewhere than when it was opened (c.toml)");
  EXPECT_FALSE(withDevicePose("[[device", "arm", poseAt(0, 0, 0), poseAt(1, 0, 0), "c.toml").ok());
}

RC_GTEST_PROP(PoseEdit, AnyPoseIsReadBack, ()) {
  const auto number = [](int most) { return *rc::gen::inRange(-most, most) * 1e-3; };
  const Pose first = poseAt(number(50'000), number(50'000), number(9000),
                            {number(180'000), number(89'000), number(180'000)});
  const Pose second = poseAt(number(50'000), number(50'000), number(9000),
                             {number(180'000), number(89'000), number(180'000)});
  const std::string bare = "[[device]]\nname = \"arm\"\n# end\n";
  const auto once = withDevicePose(bare, "arm", {}, first, "c");
  RC_ASSERT(once.ok());
  const auto twice = withDevicePose(*once, "arm", first, second, "c");
  RC_ASSERT(twice.ok());
  RC_ASSERT(twice->ends_with("# end\n"));
  // It is there now: to the micrometre.
  RC_ASSERT(withDevicePose(*twice, "arm", second, first, "c").ok());
}

TEST(PoseEdit, FindsTheFileThatDefinesADevice) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "main.cell.toml") << "format = 1\n[[device]]\nname = \"arm\"\n";
  std::ofstream(folder / "site.cell.toml")
      << "[[device]]\nname = \"arm\"\n[[device]]\nname = 'b'\n";
  std::ofstream(folder / "twin.cell.toml") << "[[device]]\nname = \"c\"\n";
  std::ofstream(folder / "same.cell.toml") << "[[device]]\nname = \"c\"\n";
  const std::filesystem::path main = folder / "main.cell.toml";
  const std::vector<std::filesystem::path> files{
      folder / "site.cell.toml", folder / "same.cell.toml", folder / "twin.cell.toml"};
  EXPECT_EQ(*fileOfDevice(main, files, "arm"), main);
  EXPECT_EQ(*fileOfDevice(main, files, "b"), files[0]);
  EXPECT_EQ(fileOfDevice(main, files, "c").error().what,
            "same.cell.toml and twin.cell.toml both have a device c");
  EXPECT_EQ(fileOfDevice(main, files, "d").error().what, "no file of the cell has a device d");
  EXPECT_EQ(fileOfDevice("arm.urdf", files, "arm").error().what,
            "only a cell (*.cell.toml) can keep a pose");
}

TEST(PoseEdit, ALinkStaysALinkAndAFaultIsASentence) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "real.toml") << "[[device]]\nname = \"arm\"\n";
  std::filesystem::create_symlink(folder / "real.toml", folder / "link.toml");
  ASSERT_TRUE(savePose(folder / "link.toml", "arm", {}, poseAt(1, 0, 0)));
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.toml"));
  std::ifstream file(folder / "real.toml");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}),
            "[[device]]\nname = \"arm\"\npose = { xyz = [1, 0, 0] }\n");
  EXPECT_FALSE(savePose(folder / "none.toml", "arm", {}, poseAt(1, 0, 0)));
}

}  // namespace
}  // namespace rocinante
