#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/kinematics/sdf_test_support.h"

namespace rocinante {
namespace {

using test::kTwoParts;
using test::ReadSdf;
using ::testing::HasSubstr;

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
      "arm.sdf:5:28: warning: shape `plane` is left out: its visual is not drawn "
      "[model.left-out]\n"
      "arm.sdf:6: warning: `w` is not drawn: the mesh `two.obj` has no submesh `rigth` (did you "
      "mean `right`?) [sdf.unknown-submesh]\n");
}

TEST(SdfReader, NamesTheSubmeshesThatThereAre) {
  ROCINANTE_NEEDS_SDF;
  const auto faultOf = [](const std::string& obj) {
    return ReadSdf(
               "<sdf version='1.7'><model name='m'><link name='l'><visual name='v'><geometry>"
               "<mesh><uri>two.obj</uri><submesh><name>wheel</name></submesh></mesh>"
               "</geometry></visual></link></model></sdf>",
               obj)
        .faultText();
  };
  const std::string unknown =
      "arm.sdf:1: warning: `v` is not drawn: the mesh `two.obj` has no submesh `wheel` ";
  const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_EQ(faultOf(points + "f 1 2 3\n"),
            unknown +
                "(none of its parts has a name: leave out <submesh> to draw the whole mesh) "
                "[sdf.unknown-submesh]\n");
  EXPECT_EQ(faultOf(points + "f 1 2 3\ng hull\nf 1 2 3\n"),
            unknown + "(there is only hull) [sdf.unknown-submesh]\n");
  // Of two materials, so of two parts.
  EXPECT_EQ(faultOf(points + "g hull\nusemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\ng lid\nf 1 2 3\n"),
            unknown + "(there are hull, lid) [sdf.unknown-submesh]\n");
}

TEST(SdfReader, WarnsOfShapesThatThePictureLacksAndNotOfTheGround) {
  ROCINANTE_NEEDS_SDF;
  const auto severityOf = [](const std::string& owner, const std::string& shape) {
    const ReadSdf read("<sdf version='1.7'><model name='m'><link name='l'><" + owner +
                       " name='v'><geometry>" + shape + "</geometry></" + owner +
                       "></link></model></sdf>");
    const auto left_out = std::ranges::find_if(
        read.faults, [](const Finding& fault) { return !fault.left_out.empty(); });
    EXPECT_NE(left_out, read.faults.end()) << shape;
    return left_out == read.faults.end()
               ? std::string()
               : std::string(nameOf(left_out->severity)) + " " + left_out->left_out;
  };
  const std::string polyline =
      "<polyline><point>0 0</point><point>1 0</point><point>0 1</point><height>1</height>"
      "</polyline>";
  EXPECT_EQ(severityOf("visual", polyline), "warning shape `polyline`");
  EXPECT_EQ(severityOf("collision", polyline), "note element `polyline`");
  for (const char* name : {"heightmap", "image"}) {
    EXPECT_EQ(severityOf("visual", fmt::format("<{0}><uri>t.png</uri></{0}>", name)),
              fmt::format("warning shape `{}`", name));
  }
  EXPECT_EQ(severityOf("visual", "<cone><radius>1</radius><length>1</length></cone>"),
            "warning shape `cone`");
  EXPECT_EQ(severityOf("visual", "<ellipsoid><radii>1 2 3</radii></ellipsoid>"),
            "warning shape `ellipsoid`");
  const auto plane = [](std::string_view normal, std::string_view size) {
    return fmt::format("<plane><normal>{}</normal><size>{}</size></plane>", normal, size);
  };
  EXPECT_EQ(severityOf("visual", plane("0 0 1", "100 100")), "note element `plane`");
  EXPECT_EQ(severityOf("visual", "<plane><size>10 40</size></plane>"), "note element `plane`");
  EXPECT_EQ(severityOf("collision", plane("1 0 0", "1 1")), "note element `plane`");
  // Markers, pictures, walls.
  EXPECT_EQ(severityOf("visual", plane("0 0 1", "0.2 0.2")), "warning shape `plane`");
  EXPECT_EQ(severityOf("visual", plane("0 0 1", "40 0.5")), "warning shape `plane`");
  EXPECT_EQ(severityOf("visual", plane("1 0 0", "100 100")), "warning shape `plane`");
}

TEST(SdfReader, WarnsOfAnImageThatTheSurfaceLacks) {
  ROCINANTE_NEEDS_SDF;
  const auto account = [](const std::string& pbr) {
    return ReadSdf(
               "<sdf version='1.7'><model name='m'><link name='l'><visual name='v'><geometry>"
               "<box><size>1 1 1</size></box></geometry><material><diffuse>1 0 0 1</diffuse>"
               "<pbr>" +
               pbr + "</pbr></material></visual></link></model></sdf>")
        .faultText();
  };
  const std::string note =
      "arm.sdf:1:154: note: element `pbr` is left out: maps of <pbr> are not drawn "
      "[model.left-out]\n";
  EXPECT_EQ(account("<metal><metalness>1</metalness><normal_map>t.png</normal_map></metal>"), note);
  EXPECT_EQ(account("<metal><albedo_map/></metal>"), note);
  for (const char* workflow : {"metal", "specular"}) {
    SCOPED_TRACE(workflow);
    const std::string text =
        account(fmt::format("<{0}><albedo_map>t.png</albedo_map></{0}>", workflow));
    EXPECT_THAT(text, HasSubstr(note));
    EXPECT_THAT(text, HasSubstr("warning: element `albedo_map` is left out: the image of a "
                                "<pbr> surface is not drawn [model.left-out]\n"));
  }
}

}  // namespace
}  // namespace rocinante
