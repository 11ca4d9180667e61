#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "core/cell/cell.h"
#include "core/cell/posed_scene.h"
#include "core/kinematics/kinematics.h"
#include "core/math/transform.h"
#include "core/packet/packet_text.h"
#include "player/demo/demo_motion.h"
#include "player/demo/demo_script.h"

// The demo's cell (examples/demo) and its motion (player/demo/demo_script.h) repeat each other's
// lengths and places: these tests compare them.
namespace rocinante {
namespace {

class DemoCell : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    const auto file = std::filesystem::path(ROCINANTE_SOURCE_DIR) / "examples/demo/demo.cell.toml";
    Result<Cell> loaded = loadCell(file, CellOptions{});
    ASSERT_TRUE(loaded.ok()) << loaded.error().text();
    cell_ = new Cell(std::move(*loaded));
  }
  static void TearDownTestSuite() {
    delete cell_;
    cell_ = nullptr;
  }

  static const Model& modelOf(std::string_view device) {
    return *cell_->models.at(cell_->findDevice(device)->model);
  }

  /// The cell at a moment of the motion.
  static SessionState stateAt(double seconds) {
    static const std::vector<DemoDatagram> datagrams = demoDatagrams(
        std::vector<DemoPart>(std::begin(kDemoParts), std::end(kDemoParts)), DemoOptions{});
    PacketTextDecoder decoder;
    SessionState state;
    for (const DemoDatagram& datagram : datagrams) {
      if (datagram.at > Nanoseconds(static_cast<std::int64_t>(seconds * 1e9))) break;
      const Packet* packet = decoder.decode(std::as_bytes(std::span(datagram.payload)));
      state.apply(LogTime(datagram.at), *packet);
    }
    return state;
  }

  static inline Cell* cell_ = nullptr;
};

TEST_F(DemoCell, LoadsWithoutAFault) {
  for (const ModelFault& fault : cell_->faults) ADD_FAILURE() << fault.print();
  for (const char* camera : {"overview", "arm", "gantry", "top"}) {
    EXPECT_NE(cell_->findCamera(camera), nullptr) << camera;
  }
}

TEST_F(DemoCell, EveryNormalPointsOutOfItsFace) {
  // Triangles that face away from their normals would be lit from behind.
  for (const auto& [name, model] : cell_->models) {
    SCOPED_TRACE(name);
    for (const Link& link : model->links) {
      for (const Visual& visual : link.visuals) {
        ASSERT_NE(visual.mesh, nullptr) << link.name;
        const Mesh& mesh = *visual.mesh;
        std::size_t wrong = 0;
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
          const Vertex& a = mesh.vertices[mesh.indices[i]];
          const Vertex& b = mesh.vertices[mesh.indices[i + 1]];
          const Vertex& c = mesh.vertices[mesh.indices[i + 2]];
          const Vec3 face =
              glm::cross(Vec3(b.position) - Vec3(a.position), Vec3(c.position) - Vec3(a.position));
          wrong += glm::dot(face, Vec3(a.normal) + Vec3(b.normal) + Vec3(c.normal)) < 0 ? 1 : 0;
        }
        EXPECT_EQ(wrong, 0U) << link.name;
      }
    }
  }
}

TEST_F(DemoCell, TheUrdfHasTheKinematicsOfTheClosedForm) {
  const Model& arm = modelOf("arm");
  ASSERT_EQ(arm.positionalCount(), 6U);
  const std::size_t tip = arm.findLink("tip").value();
  for (double t = 0; t < 20; t += 0.05) {
    SCOPED_TRACE(t);
    const ArmJoints joints = armJointsAt(t);
    JointVector values = zeroJoints(arm);
    const std::vector<std::size_t> movable = arm.movableJoints();
    for (std::size_t i = 0; i < joints.size(); ++i) {
      values.values[values.first_value[movable[i]]] = joints[i];
    }
    const Pose by_model = poseOf(linkPoses(arm, values)[tip]);
    const Pose by_script = armTip(joints);
    EXPECT_LT(glm::length(by_model.position - by_script.position), 1e-12);
    EXPECT_GT(std::abs(glm::dot(by_model.orientation, by_script.orientation)), 1 - 1e-12);
  }
}

TEST_F(DemoCell, TheMotionKeepsEveryLimit) {
  const Model& arm = modelOf("arm");
  const Model& gantry = modelOf("gantry");
  const auto expectWithin = [](const Joint& joint, double value, double later) {
    ASSERT_TRUE(joint.limits.has_value() && joint.limits->velocity.has_value()) << joint.name;
    EXPECT_GE(value, joint.limits->lower) << joint.name;
    EXPECT_LE(value, joint.limits->upper) << joint.name;
    EXPECT_LE(std::abs(later - value) / 1e-3, *joint.limits->velocity) << joint.name;
  };
  const std::vector<std::size_t> arm_joints = arm.movableJoints();
  const std::vector<std::size_t> gantry_joints = gantry.movableJoints();
  ASSERT_EQ(gantry_joints.size(), 4U);
  for (int i = 0; i < 20000; ++i) {
    const double t = i * 1e-3;
    const ArmJoints a = armJointsAt(t), b = armJointsAt(t + 1e-3);
    const GantryJoints g = gantryJointsAt(t), h = gantryJointsAt(t + 1e-3);
    for (std::size_t k = 0; k < 6; ++k) expectWithin(arm.joints[arm_joints[k]], a[k], b[k]);
    for (std::size_t k = 0; k < 4; ++k) expectWithin(gantry.joints[gantry_joints[k]], g[k], h[k]);
    if (::testing::Test::HasFailure()) FAIL() << "at " << t << " s";
  }
}

TEST_F(DemoCell, TheGripperIsWhereTheScriptHasIt) {
  const PosedScene zero = poseScene(*cell_, SessionState());
  const Vec3 gripper = positionOf(zero.find("gantry", "gripper").value());
  EXPECT_LT(glm::length(gripper - kGripperAtZero), 1e-12);
  const Vec3 canister = positionOf(zero.find("canister", "").value());
  EXPECT_LT(glm::length(canister - kCanisterAtPallet), 1e-12);
  const Vec3 arm = positionOf(zero.find("arm", "").value());
  EXPECT_LT(glm::length(arm - kArmBase), 1e-12);
}

TEST_F(DemoCell, TheCanisterHangsInTheGripperAndThenStandsOnTheStation) {
  const PosedScene carried = poseScene(*cell_, stateAt(7.9));
  const Vec3 below = positionOf(carried.find("canister", "").value()) -
                     positionOf(carried.find("gantry", "gripper").value());
  EXPECT_LT(glm::length(below - kCanisterInGripper), 1e-9);
  const PosedScene placed = poseScene(*cell_, stateAt(15));
  EXPECT_LT(glm::length(positionOf(placed.find("canister", "").value()) - kCanisterAtStation),
            1e-9);
}

TEST_F(DemoCell, TheProbeTouchesTheLid) {
  const PosedScene scene = poseScene(*cell_, stateAt(15.2));
  const double tip = positionOf(scene.find("arm", "tip").value()).z;
  // The ball's radius is 8 mm; the lid is the highest part of the canister except chime and bung.
  EXPECT_NEAR(tip - 0.008, kCanisterAtStation.z + 0.488, 1e-6);
}

}  // namespace
}  // namespace rocinante
