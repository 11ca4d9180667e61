#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "core/base/data_file.h"
#include "core/cell/cell.h"
#include "core/cell/posed_scene.h"
#include "core/kinematics/kinematics.h"
#include "core/math/transform.h"
#include "core/packet/packet_text.h"
#include "core/session/timeline.h"

// The motion that `source --demo` sends (examples/demo/motion.mcap) and the cell that it moves
// (examples/demo) agree: lengths, places, limits, and what is to be seen when.
namespace rocinante {
namespace {

class DemoMotion : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    const auto folder = std::filesystem::path(ROCINANTE_SOURCE_DIR) / "examples/demo";
    Result<Cell> loaded = loadCell(folder / "demo.cell.toml", CellOptions{});
    ASSERT_TRUE(loaded.ok()) << loaded.error().text();
    cell_ = new Cell(std::move(*loaded));
    Result<Timeline> timeline = Timeline::open(folder / "motion.mcap");
    ASSERT_TRUE(timeline.ok()) << timeline.error().text();
    timeline_ = new Timeline(std::move(*timeline));
  }
  static void TearDownTestSuite() {
    delete timeline_;
    delete cell_;
    timeline_ = nullptr;
    cell_ = nullptr;
  }

  static const Model& modelOf(std::string_view device) {
    return *cell_->models.at(cell_->findDevice(device)->model);
  }
  static SessionState stateAt(double seconds) {
    const Nanoseconds after(static_cast<std::int64_t>(std::llround(seconds * 1e9)));
    return **timeline_->stateAt(timeline_->origin() + after);
  }
  static PosedScene sceneAt(double seconds) { return poseScene(*cell_, stateAt(seconds)); }
  static Vec3 placeOf(const PosedScene& scene, std::string_view device, std::string_view link) {
    return positionOf(scene.find(device, link).value());
  }
  /// The values of the arm, or of the gantry, as they were sent.
  static std::vector<double> valuesOf(const SessionState& state, std::string_view device) {
    const DeviceState& known = *state.findDevice(device);
    if (known.joints) return known.joints->value;
    std::vector<double> values;
    for (const char* name : {"x", "y", "z", "grip"}) {
      values.push_back(known.named_joints.find(name)->second.value);
    }
    return values;
  }

  static inline Cell* cell_ = nullptr;
  static inline Timeline* timeline_ = nullptr;
};

// Seconds from the motion's zero. Everything is at rest for 0.25 s or more after the first four: at
// these moments a frame of a live recording does not depend on how its datagrams were delayed.
constexpr double kPicked = 4.606;
constexpr double kWeighed = 7.7;
constexpr double kLowered = 10.8;
constexpr double kMeasured = 15.1;
constexpr double kPlaced = 11.106;
constexpr double kPathBegins = 11.4;
constexpr double kTraceBegins = 13.5;
constexpr double kTraceEnds = 17.0;
constexpr double kPathEnds = 17.6;
constexpr double kErased = 19.506;

TEST_F(DemoMotion, TheCellLoadsWithoutAFault) {
  for (const Finding& fault : cell_->faults) ADD_FAILURE() << fault.print();
  for (const char* camera : {"overview", "arm", "gantry", "top"}) {
    EXPECT_NE(cell_->findCamera(camera), nullptr) << camera;
  }
}

TEST_F(DemoMotion, EveryNormalPointsOutOfItsFace) {
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

TEST_F(DemoMotion, IsFoundByTheProgramsOfABuildFolder) {
  const auto found = findDataFile("examples/demo/motion.mcap");
  ASSERT_TRUE(found.ok()) << found.error().text();
  EXPECT_TRUE(std::filesystem::equivalent(
      *found, std::filesystem::path(ROCINANTE_SOURCE_DIR) / "examples/demo/motion.mcap"));
  const auto missing = findDataFile("examples/nothing");
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().kind, ErrorKind::not_found);
}

TEST_F(DemoMotion, StreamsAtTheRatesOfItsSourcesWithoutFaultsOrGaps) {
  auto reader =
      LogReader::open(std::filesystem::path(ROCINANTE_SOURCE_DIR) / "examples/demo/motion.mcap")
          .value();
  ASSERT_TRUE(reader.seek(LogTime::min()).ok());
  PacketTextDecoder decoder;
  SessionState state;
  while (const auto message = reader.next().value()) {
    const Packet* packet = decoder.decode(message->payload);
    ASSERT_NE(packet, nullptr);
    ASSERT_TRUE(packet->faults.empty());
    EXPECT_FALSE(packet->header.restated) << "the program restates";
    EXPECT_LE(message->payload.size(), 1'200U);
    ASSERT_EQ(state.apply(message->log_time, *packet), Applied::yes);
  }
  EXPECT_EQ(state.counts().at("arm").packets, 2'000U);
  EXPECT_EQ(state.counts().at("gantry").packets, 1'000U);
  EXPECT_GT(state.counts().at("planner").packets, 10U);
  for (const auto& [source, counts] : state.counts()) EXPECT_EQ(counts.gap, 0U) << source;
  const std::vector<Event> events = state.takeEvents();
  ASSERT_EQ(events.size(), 2U);
  EXPECT_EQ(events[0].text, "picked");
  EXPECT_EQ(events[1].text, "placed");
}

TEST_F(DemoMotion, KeepsEveryLimitAndEndsAsItBegan) {
  const std::pair<const char*, double> devices[] = {{"arm", 0.01}, {"gantry", 0.02}};
  for (const auto& [device, period] : devices) {
    SCOPED_TRACE(device);
    const Model& model = modelOf(device);
    const std::vector<std::size_t> joints = model.movableJoints();
    // The gantry's first packet comes 3 ms after the arm's.
    const std::vector<double> first = valuesOf(stateAt(0.005), device);
    std::vector<double> before = first;
    ASSERT_EQ(joints.size(), before.size());
    for (double t = 0.005 + period; t < 20; t += period) {
      const std::vector<double> now = valuesOf(stateAt(t), device);
      for (std::size_t k = 0; k < joints.size(); ++k) {
        const Joint& joint = model.joints[joints[k]];
        ASSERT_TRUE(joint.limits && joint.limits->velocity) << joint.name;
        ASSERT_GE(now[k], joint.limits->lower) << joint.name << " at " << t;
        ASSERT_LE(now[k], joint.limits->upper) << joint.name << " at " << t;
        ASSERT_LE(std::abs(now[k] - before[k]) / period, *joint.limits->velocity)
            << joint.name << " at " << t;
      }
      before = now;
    }
    for (std::size_t k = 0; k < first.size(); ++k) EXPECT_NEAR(before[k], first[k], 1e-6);
  }
}

TEST_F(DemoMotion, TheGantryCarriesTheCanisterWithoutAJump) {
  const PosedScene zero = poseScene(*cell_, SessionState());
  const Vec3 at_pallet = placeOf(zero, "canister", "");
  EXPECT_LT(glm::length(placeOf(sceneAt(4.5), "canister", "") - at_pallet), 1e-9);
  EXPECT_EQ(stateAt(5.1).devices().at("canister").pose->value.carrier,
            (Path{false, "gantry", "gripper"}));
  EXPECT_EQ(stateAt(11.2).devices().at("canister").pose->value.carrier.first, "");
  for (const double handed : {kPicked, kPlaced}) {
    const Vec3 before = placeOf(sceneAt(handed - 0.01), "canister", "");
    const Vec3 after = placeOf(sceneAt(handed + 0.03), "canister", "");
    EXPECT_LT(glm::length(after - before), 1e-6) << handed;
  }
  const PosedScene carried = sceneAt(7.9);
  EXPECT_GT(placeOf(carried, "canister", "").z, at_pallet.z + 1);
  EXPECT_NEAR(placeOf(carried, "gantry", "gripper").z - placeOf(carried, "canister", "").z, 0.54,
              1e-9);
}

/// The joined points of a drawing.
std::vector<Vec3> pointsOf(const Drawing& drawing) {
  std::vector<Vec3> points;
  for (const auto& part : drawing.parts) {
    EXPECT_TRUE(part.has_value());
    if (!part) continue;
    for (std::size_t i = 0; i + 2 < part->size(); i += 3) {
      points.emplace_back((*part)[i], (*part)[i + 1], (*part)[i + 2]);
    }
  }
  return points;
}

double distanceToLine(const Vec3& point, const std::vector<Vec3>& line) {
  double least = 1e300;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec3 chord = line[i + 1] - line[i];
    const double squared = glm::dot(chord, chord);
    const double along =
        squared > 0 ? std::clamp(glm::dot(point - line[i], chord) / squared, 0.0, 1.0) : 0.0;
    least = std::min(least, glm::length(point - line[i] - along * chord));
  }
  return least;
}

TEST_F(DemoMotion, TheToolFollowsTheDrawnPathWithinAMillimetre) {
  const std::vector<Vec3> line = pointsOf(stateAt(10.5).drawings().at({"planner", "path"}));
  ASSERT_GT(line.size(), 30U);
  double worst = 0;
  for (double t = kPathBegins; t <= kPathEnds; t += 0.02) {
    worst = std::max(worst, distanceToLine(placeOf(sceneAt(t), "arm", "tip"), line));
  }
  EXPECT_LT(worst, 0.001);
}

TEST_F(DemoMotion, TheBallRollsOnTheLid) {
  const Vec3 canister = placeOf(sceneAt(kTraceBegins), "canister", "");
  for (double t = kTraceBegins; t <= kTraceEnds; t += 0.02) {
    SCOPED_TRACE(t);
    const Vec3 tip = placeOf(sceneAt(t), "arm", "tip");
    // The ball's radius is 8 mm; the lid is the highest part of the canister except chime and bung.
    EXPECT_NEAR(tip.z - 0.008, canister.z + 0.488, 3e-6);
    EXPECT_LT(std::hypot(tip.x - canister.x, tip.y - canister.y), 0.1101);
  }
}

TEST_F(DemoMotion, DrawingsComeBeforeTheArmMovesAndAreGoneAtTheEnd) {
  EXPECT_TRUE(stateAt(9.5).drawings().contains({"planner", "path"}));
  EXPECT_TRUE(stateAt(18.5).drawings().contains({"planner", "path"}));
  EXPECT_TRUE(stateAt(kErased).drawings().empty());
  EXPECT_EQ(stateAt(kErased).views().count("lid"), 1U);
}

TEST_F(DemoMotion, StandsStillAtTheMomentsThatGoldensTake) {
  const auto itemsAt = [](double seconds) {
    const SessionState state = stateAt(seconds);
    std::string items;
    for (const auto& [name, device] : state.devices()) {
      items += name;
      if (device.joints || !device.named_joints.empty()) {
        items += ::testing::PrintToString(valuesOf(state, name));
      }
    }
    for (const auto& [id, drawing] : state.drawings()) {
      items += id.second + std::to_string(drawing.rgba);
    }
    return items;
  };
  for (const double begin :
       {0.02, kPicked + 0.03, kWeighed + 0.03, kLowered + 0.03, kMeasured + 0.03, kErased + 0.03}) {
    SCOPED_TRACE(begin);
    for (const double later : {0.05, 0.1, 0.15, 0.2, 0.25}) {
      EXPECT_EQ(itemsAt(begin + later), itemsAt(begin)) << later;
    }
  }
}

}  // namespace
}  // namespace rocinante
