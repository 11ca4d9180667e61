// Recordings and robots from other projects, through the program: matching ones are clean or have
// correct findings, explained here; mismatches are reported clearly.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "core/recording/session_writer.h"
#include "tests/support/programs.h"
#include "tests/support/shared_data.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::IsEmpty;
using ::testing::Pair;
using ::testing::UnorderedElementsAre;

constexpr const char* kPandaMotion = "recordings/panda_exciting_trajectory/panda_joints.csv";
constexpr const char* kKukaMotion = "recordings/kuka_block_grasp/block_grasp_log.csv";

/// The packets of one source.
struct Script {
  std::string source;
  std::string order;  ///< statements sent first and restated now and then
  std::vector<std::pair<double, std::string>> packets;  ///< seconds, and the other statements
};

/// The script as a log that a recorder could have written: TIME is the script's, arrival 0.2 ms
/// later, the static state restated every two seconds.
void writeLog(const fs::path& path, const Script& script) {
  Result<LogWriter> log = LogWriter::create(path, {}, "test");
  ASSERT_TRUE(log.ok()) << log.error().text();
  SessionWriter writer(std::move(*log), {});
  const auto channel = writer.addChannel("/udp/19960/" + script.source, "rk1", {});
  ASSERT_TRUE(channel.ok());
  double restated = script.packets.front().first;
  std::uint32_t sequence = 0;
  for (const auto& [seconds, statements] : script.packets) {
    const bool again = seconds - restated >= 2;
    if (again) restated = seconds;
    const std::string text = fmt::format("RK1 {}@1 {} {:.9f}{}\n{}{}", script.source, sequence,
                                         seconds, again ? " restated" : "",
                                         again || sequence == 0 ? script.order : "", statements);
    const auto ns = static_cast<std::int64_t>(std::llround(seconds * 1e9));
    ASSERT_TRUE(
        writer.write(*channel, sequence++, LogTime(Nanoseconds(ns + 200'000)), ns, bytesOf(text)));
  }
  ASSERT_TRUE(writer.log().close("done"));
}

/// The result of `check`: verdict and findings.
struct Judged {
  int exit_code = -1;
  std::string verdict, text;
  std::uint64_t packets = 0;
  std::map<std::string, int> findings;  ///< by rule; each finding counts once, whatever its count
};

/// Judges the script against a cell whose devices have models of the robots' folder.
Judged judge(const Script& script, const std::map<std::string, std::string>& model_of_device) {
  const test::TemporaryFolder folder;
  writeLog(folder / "session.mcap", script);
  const fs::path robots = fs::canonical(test::sharedData("robots"));
  std::string text = "format = 1\nsearch = [\"" + robots.string() + "\"]\n";
  for (const auto& [device, model] : model_of_device) {
    text += fmt::format("[[device]]\nname = \"{}\"\nmodel = \"{}\"\n", device,
                        (robots / model).string());
  }
  std::ofstream(folder / "robot.cell.toml") << text;
  const test::ProgramResult result = test::runProgram(
      "rocinante-check", {"robot.cell.toml", "session.mcap", "--json"}, folder.path());
  Judged judged{result.exit_code, {}, result.out + result.err, 0, {}};
  const auto json = nlohmann::json::parse(result.out, nullptr, false);
  if (json.is_discarded()) return judged;
  judged.verdict = json.at("verdict");
  judged.packets = json.at("packets");
  // The robots have inertias and dynamics, which urdf_account_test.cpp judges.
  for (const auto& finding : json.at("findings")) {
    if (finding.at("rule") != "model.left-out") ++judged.findings[finding.at("rule")];
  }
  return judged;
}

/// The rows of a table, each as its fields.
std::vector<std::vector<std::string>> rowsOf(const fs::path& path) {
  std::vector<std::vector<std::string>> rows;
  std::ifstream csv(path);
  for (std::string line; std::getline(csv, line);) {
    if (line.ends_with('\r')) line.pop_back();
    std::istringstream fields(line);
    rows.emplace_back();
    for (std::string field; std::getline(fields, field, ',');) rows.back().push_back(field);
  }
  return rows;
}

std::string joined(const std::vector<std::string>& fields, std::size_t from, std::size_t count) {
  std::string text;
  for (std::size_t i = from; i < from + count; ++i) text += " " + fields.at(i);
  return text;
}

/// Seven joints of real hardware, as `source --csv` would send them for this device.
Script pandaScript(const std::string& device) {
  const auto rows = rowsOf(test::sharedData(kPandaMotion));
  Script script{device, "order " + device + joined(rows[0], 1, 7) + "\n", {}};
  for (std::size_t i = 1; i < rows.size(); ++i) {
    script.packets.emplace_back(std::stod(rows[i][0]),
                                "joints " + device + joined(rows[i], 1, 7) + "\n");
  }
  return script;
}

TEST(RealPandaSession, FitsThePanda) {
  ROCINANTE_NEEDS_SHARED_DATA(kPandaMotion);
  const Judged judged = judge(pandaScript("panda"), {{"panda", "franka_panda/panda.urdf"}});
  EXPECT_EQ(judged.exit_code, 0) << judged.text;
  EXPECT_EQ(judged.verdict, "compatible");
  EXPECT_EQ(judged.packets, 20'544U);
  // Correct: the recording has the arm's seven joints but not its fingers', and nine OBJ files of
  // collision shapes name missing material libraries.
  EXPECT_THAT(judged.findings,
              UnorderedElementsAre(Pair("joint.undriven", 1), Pair("obj.missing-mtllib", 9)))
      << judged.text;
}

TEST(RealPandaSession, DoesNotFitTheKuka) {
  ROCINANTE_NEEDS_SHARED_DATA(kPandaMotion);
  const Judged judged = judge(pandaScript("panda"), {{"panda", "kuka_iiwa/model.urdf"}});
  EXPECT_EQ(judged.exit_code, 1) << judged.text;
  EXPECT_EQ(judged.verdict, "incompatible");
  EXPECT_THAT(judged.findings, Contains(Pair("packet.unknown-joint", 7))) << judged.text;
}

/// The simulator's recording: the arm with its gripper, the tray, and the block that it grasps.
/// Joint values are positional; `values` of them.
Script kukaScript(std::size_t values, bool with_objects) {
  Script script{"bullet", "", {}};
  const std::map<std::string, std::string> name_of_object{
      {"0", "kuka"}, {"1", "tray"}, {"2", "block"}};
  const auto rows = rowsOf(test::sharedData(kKukaMotion));
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const std::vector<std::string>& row = rows[i];
    const double seconds = std::stod(row[1]);
    const std::string& name = name_of_object.at(row[2]);
    if (name != "kuka" && !with_objects) continue;
    if (script.packets.empty() || script.packets.back().first != seconds) {
      script.packets.emplace_back(seconds, "");
    }
    std::string& text = script.packets.back().second;
    text += "pose " + name + joined(row, 3, 7) + "\n";
    if (name == "kuka") text += "joints kuka" + joined(row, 10, values) + "\n";
  }
  return script;
}

TEST(RealKukaSession, FitsTheArmItsGripperAndWhatItGrasps) {
  ROCINANTE_NEEDS_SHARED_DATA(kKukaMotion);
  const Judged judged = judge(kukaScript(11, true), {{"kuka", "kuka_iiwa/kuka_with_gripper.sdf"},
                                                     {"tray", "kuka_iiwa/objects/tray.urdf"},
                                                     {"block", "kuka_iiwa/objects/block.urdf"}});
  if (judged.findings.contains("sdf.no-module")) GTEST_SKIP() << "built without ROCINANTE_SDF";
  EXPECT_EQ(judged.exit_code, 0) << judged.text;
  EXPECT_EQ(judged.packets, 2'105U);
  // Correct: the SDF names its meshes by absolute paths of another machine.
  EXPECT_THAT(judged.findings,
              UnorderedElementsAre(Pair("model.absolute-path", 1), Pair("model.zero-velocity", 1)))
      << judged.text;
}

TEST(RealKukaSession, TheArmAloneFitsItsOtherModel) {
  ROCINANTE_NEEDS_SHARED_DATA(kKukaMotion);
  const Judged judged = judge(kukaScript(7, false), {{"kuka", "kuka_iiwa/model.urdf"}});
  EXPECT_EQ(judged.exit_code, 0) << judged.text;
  EXPECT_THAT(judged.findings, IsEmpty()) << judged.text;
}

TEST(RealKukaSession, ElevenValuesDoNotFitSevenJoints) {
  ROCINANTE_NEEDS_SHARED_DATA(kKukaMotion);
  const Judged judged = judge(kukaScript(11, false), {{"kuka", "kuka_iiwa/model.urdf"}});
  EXPECT_EQ(judged.exit_code, 1) << judged.text;
  EXPECT_THAT(judged.findings, Contains(Pair("packet.joint-count", 1))) << judged.text;
}

/// There is no recording of these two: a slow motion of the named joints, each about its middle.
struct Swing {
  const char* joint;
  double middle, width;
};
Script swinging(const std::string& device, const std::vector<Swing>& joints, double factor) {
  Script script{device, "order " + device, {}};
  for (const Swing& joint : joints) script.order += std::string(" ") + joint.joint;
  script.order += "\n";
  for (int i = 0; i < 500; ++i) {
    std::string text = "joints " + device;
    for (const Swing& joint : joints) {
      text += fmt::format(" {:.6f}", factor * (joint.middle + joint.width * std::sin(i * 0.01)));
    }
    script.packets.emplace_back(100 + i * 0.01, text + "\n");
  }
  return script;
}

constexpr double kDegrees = 57.29577951308232;

TEST(RealPuma, AMotionWithinItsLimitsFitsAndDegreesForRadiansDoNot) {
  ROCINANTE_NEEDS_SHARED_DATA("robots/puma560_description");
  const std::vector<Swing> joints{{"j1", 0, 0.3}, {"j2", -0.5, 0.3}, {"j3", 0.5, 0.3},
                                  {"j4", 0, 0.3}, {"j5", 0, 0.3},    {"j6", 0, 0.3}};
  const std::map<std::string, std::string> cell{
      {"puma", "puma560_description/urdf/puma560_robot.urdf"}};
  const Judged fits = judge(swinging("puma", joints, 1), cell);
  EXPECT_EQ(fits.exit_code, 0) << fits.text;
  EXPECT_THAT(fits.findings, UnorderedElementsAre(Pair("model.zero-velocity", 1))) << fits.text;
  const Judged degrees = judge(swinging("puma", joints, kDegrees), cell);
  EXPECT_EQ(degrees.exit_code, 1) << degrees.text;
  EXPECT_THAT(degrees.findings, Contains(Pair("joint.degrees", 1))) << degrees.text;
}

TEST(RealR2D2, AMotionOfEveryJointFitsAndAnotherRobotsOrderDoesNot) {
  ROCINANTE_NEEDS_SHARED_DATA("robots/r2d2");
  const std::vector<Swing> joints{
      {"right_front_wheel_joint", 0, 3}, {"right_back_wheel_joint", 0, 3},
      {"left_front_wheel_joint", 0, 3},  {"left_back_wheel_joint", 0, 3},
      {"gripper_extension", -0.2, 0.1},  {"left_gripper_joint", 0.2, 0.1},
      {"right_gripper_joint", 0.2, 0.1}, {"head_swivel", 0, 0.4}};
  const std::map<std::string, std::string> cell{{"r2d2", "r2d2/r2d2.urdf"}};
  const Judged fits = judge(swinging("r2d2", joints, 1), cell);
  EXPECT_EQ(fits.exit_code, 0) << fits.text;
  EXPECT_THAT(fits.findings, IsEmpty()) << fits.text;
  const Judged differs = judge(pandaScript("r2d2"), cell);
  EXPECT_EQ(differs.exit_code, 1) << differs.text;
  EXPECT_THAT(differs.findings, Contains(Pair("packet.unknown-joint", 7))) << differs.text;
}

}  // namespace
}  // namespace rocinante
