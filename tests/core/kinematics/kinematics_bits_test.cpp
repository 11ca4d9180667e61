#include <gtest/gtest.h>

#include <bit>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "core/base/hash.h"
#include "core/kinematics/kinematics.h"
#include "tests/core/kinematics/model_test_support.h"

// Forward kinematics down to the last bit: one constant for every processor, compiler and build
// (docs/decisions/003). A program of its own, so that tests/arm64/fused_kinematics can build it
// with multiplications and additions fused and see it fail.

namespace rocinante {
namespace {

// Every type of joint, origins and axes without round coordinates, a mimic that scales.
constexpr std::string_view kEveryJoint = R"(<robot name="every">
<link name="a"/><link name="b"/><link name="c"/><link name="d"/><link name="e"/><link name="f"/>
<link name="g"/>
<joint name="turn" type="continuous"><parent link="a"/><child link="b"/>
  <origin xyz="0.1 -0.7 1.3" rpy="0.3 -1.1 2.7"/><axis xyz="1 2 -3"/></joint>
<joint name="slide" type="prismatic"><parent link="b"/><child link="c"/>
  <origin xyz="3.3 0.01 -0.2" rpy="-2 0.9 0.1"/><axis xyz="-0.2 0.1 0.7"/>
  <limit lower="-9" upper="9" effort="1" velocity="1"/></joint>
<joint name="floor" type="planar"><parent link="c"/><child link="d"/>
  <origin xyz="0.6 0.6 0.1" rpy="1 1 1"/><axis xyz="1 0.3 0.2"/></joint>
<joint name="free" type="floating"><parent link="d"/><child link="e"/>
  <origin xyz="-0.9 0.2 0.3" rpy="0.01 0.02 3"/></joint>
<joint name="held" type="fixed"><parent link="e"/><child link="f"/>
  <origin xyz="0.123 4.56 -7.89" rpy="0.7 0.8 0.9"/></joint>
<joint name="follows" type="continuous"><parent link="f"/><child link="g"/>
  <origin xyz="10 20 30" rpy="-0.4 0.5 -0.6"/><axis xyz="0.6 -0.1 0.5"/>
  <mimic joint="turn" multiplier="1.7" offset="-0.3"/></joint>
</robot>)";

/// Random numbers from -8 to 8, the same everywhere: all 53 bits are used.
class Lot {
 public:
  double next() {
    seed_ = seed_ * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(seed_ >> 11U) * 0x1p-49 - 8.0;
  }

 private:
  std::uint64_t seed_ = 2026;
};

/// XXH3 over the bits of every link's pose in 5,000 postures.
std::string hashOfPostures(const Model& model) {
  std::string bits;
  Lot lot;
  JointVector joints = zeroJoints(model);
  for (int posture = 0; posture < 5000; ++posture) {
    for (double& value : joints.values) value = lot.next();
    applyMimics(model, joints);
    for (const Mat4& pose : linkPoses(model, joints)) {
      for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
          const auto number = std::bit_cast<std::uint64_t>(pose[column][row]);
          for (int shift = 0; shift < 64; shift += 8) {
            bits += static_cast<char>(number >> shift & 0xFF);
          }
        }
      }
    }
  }
  return hexOf(xxh3(bytesOf(bits)));
}

TEST(KinematicsBits, OfEveryTypeOfJointAreTheSameEverywhere) {
  const test::ReadUrdf read(kEveryJoint);
  EXPECT_EQ(read.faultText(), "");
  ASSERT_TRUE(read.model);
  EXPECT_EQ(hashOfPostures(*read.model), "49cd8046ca48cfebf053794c4d8ce2c0");
}

TEST(KinematicsBits, OfTheDemoArmAreTheSameEverywhere) {
  const std::filesystem::path file =
      std::filesystem::path(ROCINANTE_SOURCE_DIR) / "examples/demo/arm.urdf";
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  FileSearch search;
  MeshStore meshes(search, true);
  Findings faults;
  const std::optional<Model> model = readUrdf(bytesOf(text), file, meshes, faults);
  ASSERT_TRUE(model) << test::printed(faults);
  EXPECT_EQ(hashOfPostures(*model), "005f20fe7e5a51368da6d2e084b52848");
}

}  // namespace
}  // namespace rocinante
