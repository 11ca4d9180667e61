#include "viewer/ui/study/nearest_study.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"

namespace rocinante {
namespace {

class NearestStudyTest : public testing::Test {
 protected:
  NearestStudyTest() {
    test::writeFile(folder_ / "box.urdf",
                    R"(<robot name="box"><link name="box"><visual><geometry><box size="1 1 1"/>
</geometry></visual></link></robot>)");
    // Its post stands on its foot; between its post and its lid is a metre.
    test::writeFile(folder_ / "press.urdf", R"(<robot name="press">
<link name="foot"><visual><geometry><box size="1 1 1"/></geometry></visual></link>
<link name="post"><visual><geometry><box size="1 1 1"/></geometry></visual></link>
<link name="lid*"><visual><geometry><box size="1 1 1"/></geometry></visual></link>
<joint name="a" type="prismatic"><parent link="foot"/><child link="post"/><origin xyz="0 0 1"/>
<axis xyz="0 0 1"/><limit lower="0" upper="1" effort="1" velocity="1"/></joint>
<joint name="b" type="prismatic"><parent link="post"/><child link="lid*"/><origin xyz="0 0 2"/>
<axis xyz="0 0 1"/><limit lower="0" upper="1" effort="1" velocity="1"/></joint></robot>)");
    std::string text = "format = 1\n";
    // A name that is a pattern, too, means itself alone.
    const std::pair<const char*, double> devices[] = {{"b*", 0}, {"box", 3}, {"bin", -2.25}};
    for (const auto& [name, x] : devices) {
      text += fmt::format(
          "[[device]]\nname = \"{}\"\nmodel = \"box.urdf\"\npose = {{ xyz = [{}, 0, 0] }}\n", name,
          x);
    }
    for (const auto& [name, y] : {std::pair("layer", 20), std::pair("press", 23)}) {
      text += fmt::format(
          "[[device]]\nname = \"{}\"\nmodel = \"press.urdf\"\npose = {{ xyz = [0, {}, 0] }}\n",
          name, y);
    }
    test::writeFile(folder_ / "cell.toml", text);
    auto cell = loadCell(folder_ / "cell.toml", {});
    EXPECT_TRUE(cell.ok());
    cell_ = std::move(*cell);
  }
  NearestFound measured(const NearestQuery& wish) {
    if (!study_) study_.emplace(cell_);
    EXPECT_TRUE(study_->ask(wish, SessionState(), LogTime(Nanoseconds(7))));
    study_->wait();
    EXPECT_TRUE(study_->takeNews());
    EXPECT_FALSE(study_->takeNews());
    return study_->found().value_or(NearestFound());
  }

  test::TemporaryFolder folder_;
  Cell cell_;
  std::optional<NearestStudy> study_;
};

TEST_F(NearestStudyTest, FindsTheNearestOtherDeviceAndWhereItIs) {
  const NearestFound found = measured({"b*", "", "", ""});
  EXPECT_EQ(found.other, "bin");
  EXPECT_NEAR(found.distance_m, 1.25, 1e-12);
  EXPECT_NEAR(found.on_device.x, -0.5, 1e-12);
  EXPECT_NEAR(found.on_other.x, -1.75, 1e-12);
  EXPECT_EQ(found.moment, LogTime(Nanoseconds(7)));
}

TEST_F(NearestStudyTest, MeasuresFromTheOneThatIsAskedFor) {
  const NearestFound found = measured({"b*", "", "box", ""});
  EXPECT_EQ(found.other, "box");
  EXPECT_NEAR(found.distance_m, 2, 1e-12);
  EXPECT_NEAR(measured({"bin", "", "box", ""}).distance_m, 4.25, 1e-12)
      << "another wish after the first";
}

TEST_F(NearestStudyTest, MeasuresTheTwoLinksAndNamesThem) {
  EXPECT_NEAR(measured({"layer", "", "press", ""}).distance_m, 2, 1e-12) << "whole devices";
  const NearestFound found = measured({"layer", "foot", "press", "lid*"});
  EXPECT_NEAR(found.distance_m, std::sqrt(2 * 2 + 2 * 2), 1e-12);
  EXPECT_NEAR(found.on_device.y, 20.5, 1e-12);
  EXPECT_NEAR(found.on_other.z, 2.5, 1e-12);
  EXPECT_EQ(nearestText(found), "layer/foot: 2828.43 mm from press/lid*");
  const NearestFound to_all = measured({"press", "lid*", "layer", ""});
  EXPECT_NEAR(to_all.distance_m, 2, 1e-12);
  EXPECT_EQ(nearestText(to_all), "press/lid*: 2000.00 mm from layer");
  EXPECT_EQ(nearestText(measured({"press", "", "layer", ""})), "2000.00 mm from layer");
}

TEST_F(NearestStudyTest, MeasuresTwoLinksOfOneDeviceThatNoJointJoins) {
  const NearestFound found = measured({"press", "lid*", "press", "foot"});
  EXPECT_NEAR(found.distance_m, 2, 1e-12);
  EXPECT_EQ(nearestText(found), "press/lid*: 2000.00 mm from press/foot");
  EXPECT_EQ(measured({"press", "foot", "press", "post"}).other, "");
}

TEST_F(NearestStudyTest, SaysThatThereIsNothingToMeasure) {
  EXPECT_EQ(measured({"nobody", "", "", ""}).other, "");
}

TEST_F(NearestStudyTest, EndsWhileItMeasures) {
  study_.emplace(cell_);
  EXPECT_TRUE(study_->ask({"b*", "", "", ""}, SessionState(), {}));
  study_.reset();
}

}  // namespace
}  // namespace rocinante
