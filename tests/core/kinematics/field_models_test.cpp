#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/base/loaded_module.h"
#include "core/cell/cell.h"
#include "core/kinematics/kinematics.h"
#include "core/math/transform.h"
#include "core/report/account.h"
#include "tests/core/kinematics/model_test_support.h"
#include "tests/support/shared_data.h"

// URDF and SDF files from public bug reports: the README of each states what is right.

namespace rocinante {
namespace {

using testing::HasSubstr;

constexpr glm::vec4 kRed(1, 0, 0, 1), kGreen(0, 1, 0, 1), kBlue(0, 0, 1, 1);

struct FieldModel {
  const char* file;
  std::function<void(const Model&, const std::string& faults)> holds;
};

glm::vec4 colorOf(const Model& model, std::size_t link, std::size_t visual) {
  const auto& material = model.links.at(link).visuals.at(visual).material;
  return material ? material->diffuse : glm::vec4(0);
}

/// The link's poses with the first joints at these values.
std::vector<Mat4> posedAt(const Model& model, const std::vector<double>& values) {
  JointVector joints = zeroJoints(model);
  std::size_t next = 0;
  for (const std::size_t joint : model.movableJoints()) {
    for (std::size_t i = 0; i < valueCount(model.joints[joint].type); ++i) {
      if (next < values.size()) joints.values[joints.first_value[joint] + i] = values[next++];
    }
  }
  applyMimics(model, joints);
  return linkPoses(model, joints);
}

double yawOf(const Mat4& pose) { return std::atan2(pose[0][1], pose[0][0]); }

Vec3 placeOf(const Model& model, const char* link) {
  return positionOf(posedAt(model, {})[model.findLink(link).value()]);
}

void isOneBox(const Model& model, const std::string& faults) {
  EXPECT_EQ(faults, "");
  EXPECT_EQ(model.links.at(0).visuals.at(0).mesh->bounds.max, Vec3(0.5, 0.5, 0.5));
}

const FieldModel kModels[] = {
    {"10-urdf-anonymous-materials/sw.urdf",
     [](const Model& model, const std::string& faults) {
       EXPECT_EQ(faults, "");
       EXPECT_EQ(colorOf(model, 0, 0), kRed);
       EXPECT_EQ(colorOf(model, 1, 0), kGreen);
       EXPECT_EQ(colorOf(model, 2, 0), kBlue);
     }},
    {"10-urdf-anonymous-materials/SW.URDF",
     [](const Model& model, const std::string&) { EXPECT_EQ(colorOf(model, 0, 0), kRed); }},
    {"11-urdf-capsule/cap.urdf",
     [](const Model& model, const std::string& faults) {
       EXPECT_EQ(faults, "");
       EXPECT_NEAR(model.links.at(0).visuals.at(0).mesh->bounds.max.z, 0.5, 1e-6);
       EXPECT_NEAR(model.links.at(0).visuals.at(0).mesh->bounds.max.x, 0.2, 1e-6);
     }},
    {"12-urdf-mimic-chain/m.urdf",
     [](const Model& model, const std::string& faults) {
       EXPECT_EQ(faults, "");
       JointVector joints = zeroJoints(model);
       joints.values[joints.first_value[model.findJoint("a").value()]] = 0.3;
       applyMimics(model, joints);
       const auto valueOf = [&](const char* name) {
         return joints.values[joints.first_value[model.findJoint(name).value()]];
       };
       EXPECT_NEAR(valueOf("b"), 0.7, 1e-12);
       EXPECT_NEAR(valueOf("c"), -0.15, 1e-12);
       EXPECT_NEAR(valueOf("d"), -0.45, 1e-12);
     }},
    {"13-urdf-continuous-limit/k.urdf",
     [](const Model& model, const std::string& faults) {
       EXPECT_THAT(faults, testing::Not(HasSubstr("error")));
       EXPECT_THAT(faults, HasSubstr("attribute `limit/@lower` is left out"));
       for (const Joint& joint : model.joints) EXPECT_TRUE(std::isinf(joint.limits->upper));
     }},
    {"14-urdf-whitespace-locale/w.urdf",
     [](const Model& model, const std::string& faults) {
       EXPECT_EQ(faults, "");
       EXPECT_EQ(placeOf(model, "l"), Vec3(0.5, 0.25, 5));
     }},
    {"15-urdf-mesh-paths/robots/humanoid/robot.urdf",
     [](const Model& model, const std::string& faults) {
       EXPECT_THAT(faults, testing::Not(HasSubstr("error")));
       for (const Visual& visual : model.links.at(0).visuals) EXPECT_NE(visual.mesh, nullptr);
     }},
    {"16-urdf-mirrored/mir.urdf",
     [](const Model& model, const std::string& faults) {
       EXPECT_EQ(faults, "");
       EXPECT_EQ(model.links.at(0).visuals.at(1).scale, Vec3(1, -1, 1));
     }},
    {"17-urdf-material-precedence/t.urdf",
     [](const Model& model, const std::string&) {
       const auto& visuals = model.links.at(0).visuals;
       ASSERT_EQ(visuals.size(), 3U);
       EXPECT_FALSE(visuals[0].material) << "what has a material of its own keeps it";
       EXPECT_EQ(visuals[1].material->diffuse, kGreen);
       EXPECT_EQ(visuals[1].mesh, visuals[0].mesh);
       EXPECT_EQ(visuals[2].material->diffuse, kGreen);
     }},
    {"18-sdf-mesh-colour/m.sdf",
     [](const Model& model, const std::string&) {
       EXPECT_EQ(colorOf(model, 0, 0), kRed);
       EXPECT_EQ(colorOf(model, 0, 1), kRed);
     }},
    {"20-sdf-frames/f.sdf",
     [](const Model& model, const std::string& faults) {
       EXPECT_EQ(faults, "");
       const std::size_t arm = model.findLink("arm").value();
       for (const double turn : {0.0, std::acos(0.0)}) {
         const Mat4 pose = posedAt(model, {turn})[arm];
         EXPECT_NEAR(glm::distance(positionOf(pose), Vec3(1, 1, 1)), 0, 1e-9);
         EXPECT_NEAR(std::remainder(yawOf(pose) - std::acos(0.0) - turn, 4 * std::acos(0.0)), 0,
                     1e-9);
       }
       const Mat4 visual =
           posedAt(model, {})[arm] * matrixOf(model.links[arm].visuals.at(0).origin);
       EXPECT_NEAR(glm::distance(positionOf(visual), Vec3(1, 0, 0.5)), 0, 1e-9);
     }},
    {"21-sdf-scripts/g.sdf",
     [](const Model& model, const std::string& faults) {
       EXPECT_EQ(colorOf(model, 0, 0), kRed);
       EXPECT_EQ(colorOf(model, 0, 1), glm::vec4(0, 1, 0, 0.5));
       EXPECT_FALSE(model.links.at(0).visuals.at(2).material);
       EXPECT_EQ(colorOf(model, 0, 3), kBlue);
       EXPECT_FALSE(model.links.at(0).visuals.at(4).material);
       EXPECT_THAT(faults, HasSubstr("element `pbr` is left out"));
     }},
    {"22-sdf-nested/n.sdf",
     [](const Model& model, const std::string& faults) {
       EXPECT_EQ(faults, "");
       EXPECT_EQ(placeOf(model, "hand::palm"), Vec3(0, 0, 1));
       EXPECT_EQ(model.joints.at(0).parent, model.findLink("base").value());
     }},
    {"45-collision-only/c.urdf",
     [](const Model& model, const std::string& faults) {
       EXPECT_EQ(model.links.at(0).collisions.size(), 1U);
       EXPECT_THAT(faults, HasSubstr("nothing of the model is drawn"));
       EXPECT_THAT(faults, HasSubstr("render --collision '*'"));
     }},
    {"50-xml-oddities/bom.urdf", isOneBox},
    {"50-xml-oddities/comment.urdf", isOneBox},
    {"50-xml-oddities/entity.urdf",
     [](const Model&, const std::string& faults) {
       EXPECT_THAT(faults, HasSubstr(":3:55: error: `size` of <box> is `&w; 1 1`"));
       EXPECT_THAT(faults, HasSubstr("an entity"));
     }},
    {"50-xml-oddities/latin1.urdf",
     [](const Model& model, const std::string& faults) {
       isOneBox(model, faults);
       EXPECT_EQ(model.links.at(0).name, "Tr\xC3\xA4ger");
     }},
    {"50-xml-oddities/newline.urdf", isOneBox},
    {"50-xml-oddities/ns.urdf", isOneBox},
    {"50-xml-oddities/refs.urdf",
     [](const Model& model, const std::string& faults) {
       isOneBox(model, faults);
       EXPECT_EQ(model.links.at(0).name, "caf\xC3\xA9 & co");
     }},
    {"50-xml-oddities/scale1.urdf",
     [](const Model&, const std::string& faults) {
       EXPECT_THAT(faults, HasSubstr("`scale` of <mesh> is `0.001`, where 3 numbers are expected"));
     }},
    {"50-xml-oddities/utf16.urdf", isOneBox},
    {"54-sdf-bad-value/future.sdf",
     [](const Model& model, const std::string& faults) {
       EXPECT_EQ(model.links.size(), 1U);
       EXPECT_THAT(faults, HasSubstr("the file is in version `1.99` of SDF, newer than"));
     }},
    {"55-urdf-loaders/robot/urdf/r.urdf",
     [](const Model& model, const std::string& faults) {
       EXPECT_EQ(faults, "");
       EXPECT_NE(model.links.at(0).visuals.at(0).mesh, nullptr);
     }},
    {"65-urdf-textured-box/b.urdf",
     [](const Model& model, const std::string& faults) {
       EXPECT_EQ(faults, "");
       for (const Link& link : model.links) {
         EXPECT_EQ(link.visuals.at(0).material->diffuse_map.filename(), "t.png");
         bool has_coordinates = false;
         for (const Vertex& vertex : link.visuals[0].mesh->vertices) {
           has_coordinates = has_coordinates || vertex.texture != glm::vec2(0, 0);
         }
         EXPECT_TRUE(has_coordinates) << link.name;
       }
     }},
    {"69-floating-planar/f.urdf",
     [](const Model& model, const std::string& faults) {
       EXPECT_EQ(faults, "");
       EXPECT_EQ(model.positionalCount(), 10U);
       const auto poses = posedAt(model, {1, 2, 3, 0, 0, 0, 1, 0.5, 0.25, 0});
       EXPECT_EQ(positionOf(poses[model.findLink("o").value()]), Vec3(1, 2, 4));
       EXPECT_EQ(positionOf(poses[model.findLink("p").value()]), Vec3(1.5, 0.25, 0));
     }},
};

bool needsSdf(std::string_view file) { return file.ends_with(".sdf"); }

class FieldModels : public testing::TestWithParam<FieldModel> {};

TEST_P(FieldModels, AreReadAsTheirReadmeStates) {
  ROCINANTE_NEEDS_SHARED_FIELD(GetParam().file);
  if (needsSdf(GetParam().file) && !loadModule("librocinante_sdformat.so").ok()) {
    GTEST_SKIP() << "built without ROCINANTE_SDF (libsdformat)";
  }
  const auto cell = loadCell(test::sharedField(GetParam().file), {});
  ASSERT_TRUE(cell.ok()) << cell.error().text();
  GetParam().holds(*cell->modelOf(cell->devices.at(0)), test::printed(cell->faults));
}

INSTANTIATE_TEST_SUITE_P(Field, FieldModels, testing::ValuesIn(kModels),
                         [](const testing::TestParamInfo<FieldModel>& each) {
                           std::string name = each.param.file;
                           std::ranges::replace_if(
                               name, [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
                           return name;
                         });

TEST(FieldModels, ThatAreRefusedNameTheValueAndItsPlace) {
  ROCINANTE_NEEDS_SHARED_FIELD("54-sdf-bad-value");
  const std::pair<const char*, const char*> cases[] = {
      {"pose.sdf", "<pose> is `0 0 O.5 0 0 0`, where 6 numbers are expected"},
      {"noversion.sdf", "<sdf> lacks its attribute `version`"}};
  for (const auto& [file, what] : cases) {
    const auto cell = loadCell(test::sharedField("54-sdf-bad-value") / file, {});
    ASSERT_FALSE(cell.ok());
    // Without libsdformat that is said, and nothing else.
    if (!loadModule("librocinante_sdformat.so").ok()) {
      EXPECT_THAT(cell.error().what, HasSubstr("SDF is not read without its module"));
      continue;
    }
    EXPECT_THAT(cell.error().what, HasSubstr(what));
    EXPECT_THAT(cell.error().where, HasSubstr(std::string(file) + ":1:"));
    EXPECT_THAT(cell.error().what, testing::Not(HasSubstr("robot")));
  }
}

}  // namespace
}  // namespace rocinante
