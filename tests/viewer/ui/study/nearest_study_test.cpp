#include "viewer/ui/study/nearest_study.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

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
    std::string text = "format = 1\n";
    // A name that is a pattern, too, means itself alone.
    const std::pair<const char*, double> devices[] = {{"b*", 0}, {"box", 3}, {"bin", -2.25}};
    for (const auto& [name, x] : devices) {
      text += fmt::format(
          "[[device]]\nname = \"{}\"\nmodel = \"box.urdf\"\npose = {{ xyz = [{}, 0, 0] }}\n", name,
          x);
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
  const NearestFound found = measured({"b*", ""});
  EXPECT_EQ(found.other, "bin");
  EXPECT_NEAR(found.distance_m, 1.25, 1e-12);
  EXPECT_NEAR(found.on_device.x, -0.5, 1e-12);
  EXPECT_NEAR(found.on_other.x, -1.75, 1e-12);
  EXPECT_EQ(found.moment, LogTime(Nanoseconds(7)));
}

TEST_F(NearestStudyTest, MeasuresFromTheOneThatIsAskedFor) {
  const NearestFound found = measured({"b*", "box"});
  EXPECT_EQ(found.other, "box");
  EXPECT_NEAR(found.distance_m, 2, 1e-12);
  EXPECT_NEAR(measured({"bin", "box"}).distance_m, 4.25, 1e-12) << "another wish after the first";
}

TEST_F(NearestStudyTest, SaysThatThereIsNothingToMeasure) {
  EXPECT_EQ(measured({"nobody", ""}).other, "");
}

TEST_F(NearestStudyTest, EndsWhileItMeasures) {
  study_.emplace(cell_);
  EXPECT_TRUE(study_->ask({"b*", ""}, SessionState(), {}));
  study_.reset();
}

}  // namespace
}  // namespace rocinante
