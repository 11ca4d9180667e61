#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/kinematics/sdf_test_support.h"

namespace rocinante {
namespace {

using test::kTwoParts;
using test::ReadSdf;

TEST(SdfReader, NamesWhatItDoesNotDraw) {
  ROCINANTE_NEEDS_SDF;
  const ReadSdf read(R"(<sdf version="1.7"><model name="m"><static>1</static><link name="l">
<visual name="a"><geometry><box><size>1 1 1</size></box></geometry>
<material><script><uri>x.material</uri><name>My/Rust</name></script><pbr><metal/></pbr></material></visual>
<visaul name="b"/><sensor name="s" type="ray"/><light name="lamp" type="point"/>
<visual name="p"><geometry><plane><normal>0 0 1</normal></plane></geometry></visual>
<visual name="w"><geometry><mesh><uri>two.obj</uri><submesh><name>rigth</name></submesh></mesh>
</geometry></visual></link></model></sdf>)",
                     kTwoParts);
  ASSERT_TRUE(read.model);
  EXPECT_FALSE(read.model->links[0].visuals.at(0).material) << "nothing known, so not black";
  EXPECT_EQ(
      read.faultText(),
      "arm.sdf:1:36: note: element `static` is left out: motion is shown, not simulated "
      "[model.left-out]\n"
      "arm.sdf:3:11: warning: script `My/Rust` is left out: of material scripts only the plain "
      "colours of Gazebo are known [model.left-out]\n"
      "arm.sdf:3:69: note: element `pbr` is left out: maps of <pbr> are not drawn "
      "[model.left-out]\n"
      "arm.sdf:4:1: warning: element `visaul` is left out: <link> has no such element (did you "
      "mean `visual`?) [sdf.unknown-element]\n"
      "arm.sdf:4:19: note: element `sensor` is left out: what is for a simulator is not read "
      "[model.left-out]\n"
      "arm.sdf:4:48: note: element `light` is left out: lamps of a model are not lit "
      "[model.left-out]\n"
      "arm.sdf:5:28: note: element `plane` is left out: a shape that is not drawn "
      "[model.left-out]\n"
      "arm.sdf:6: warning: `w` is not drawn: the mesh `two.obj` has no submesh `rigth` (did you "
      "mean `right`?) [sdf.unknown-submesh]\n");
}

}  // namespace
}  // namespace rocinante
