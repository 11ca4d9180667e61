#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>

#include "core/math/transform.h"
#include "core/mesh/glb_container.h"
#include "core/report/json_text.h"
#include "recorder/export/exports.h"
#include "tests/recorder/export/written_session.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using test::Said;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kUrdf = R"(<robot name="m">
  <link name="base"><visual><geometry><box size="1 1 1"/></geometry></visual></link>
  <link name="arm"><visual><origin xyz="0 0 0.5"/><geometry><box size="0.1 0.1 1"/></geometry></visual></link>
  <link name="tool"/>
  <joint name="j" type="revolute"><parent link="base"/><child link="arm"/><origin xyz="0 0 0.5"/>
    <axis xyz="0 1 0"/><limit lower="-3" upper="3" effort="1" velocity="1"/></joint>
  <joint name="f" type="fixed"><parent link="arm"/><child link="tool"/><origin xyz="0 0 1"/></joint>
</robot>)";

constexpr const char* kCell = R"(format = 1
[[camera]]
name = "side"
eye = [0, -5, 1]
target = [0, 0, 1]
[[device]]
name = "a"
model = "m.urdf"
pose = { xyz = [1, 2, 0] }
[[device]]
name = "late"
model = "m.urdf"
optional = true
)";

/// A read .glb.
struct Scene {
  Json json;
  Bytes binary;

  const Json& node(const std::string& name) const {
    for (const Json& node : json["nodes"]) {
      if (node["name"] == name) return node;
    }
    static const Json none;
    ADD_FAILURE() << "no node " << name;
    return none;
  }

  std::vector<float> numbers(std::size_t accessor) const {
    const Json& of = json["accessors"][accessor];
    const Json& view = json["bufferViews"][of["bufferView"].get<std::size_t>()];
    const std::size_t width = of["type"] == "SCALAR" ? 1 : of["type"] == "VEC3" ? 3 : 4;
    std::vector<float> numbers(of["count"].get<std::size_t>() * width);
    const std::size_t from = view["byteOffset"].get<std::size_t>() + of.value("byteOffset", 0U);
    EXPECT_LE(from + numbers.size() * sizeof(float), binary.size());
    std::memcpy(numbers.data(), binary.data() + from, numbers.size() * sizeof(float));
    return numbers;
  }

  struct Channel {
    std::vector<float> times, values;
    std::string interpolation;
  };
  /// Empty when the node has no such channel.
  Channel channel(const std::string& name, const std::string& path) const {
    if (!json.contains("animations")) return {};
    const Json& animation = json["animations"][0];
    for (const Json& channel : animation["channels"]) {
      const std::size_t node = channel["target"]["node"].get<std::size_t>();
      if (json["nodes"][node]["name"] != name || channel["target"]["path"] != path) continue;
      const Json& sampler = animation["samplers"][channel["sampler"].get<std::size_t>()];
      return {numbers(sampler["input"].get<std::size_t>()),
              numbers(sampler["output"].get<std::size_t>()),
              sampler["interpolation"].get<std::string>()};
    }
    return {};
  }
};

class GltfExport : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder_ / "m.urdf") << kUrdf;
    std::ofstream(folder_ / "c.cell.toml") << kCell;
  }

  Scene exported(const std::vector<Said>& all, const GltfExportOptions& given = {}) {
    test::writeSession(folder_ / "s.mcap", all);
    auto session = MomentWalk::open(folder_ / "s.mcap");
    auto cell = loadCell(folder_ / "c.cell.toml", {});
    auto recording = GltfRecording::make(folder_.path().string());
    EXPECT_TRUE(session.ok() && cell.ok() && recording.ok());
    GltfExportOptions options = given;
    if (options.until == LogTime{}) options.until = LogTime::max();
    const Status recorded = recordGltf(*session, *cell, *recording, options, left_out_);
    EXPECT_TRUE(recorded.ok());
    Bytes glb;
    const auto sink = makeMemorySink(glb);
    auto facts = recording->write(*sink);
    EXPECT_TRUE(facts.ok());
    facts_ = std::move(*facts);
    const auto parts = gltfParts(glb);
    EXPECT_TRUE(parts.ok());
    return {Json::parse(parts->text), Bytes(parts->binary.begin(), parts->binary.end())};
  }

  static constexpr std::int64_t kSecond = 1'000'000'000;
  test::TemporaryFolder folder_;
  GltfRecording::Facts facts_;
  Account left_out_;
};

TEST_F(GltfExport, ALinkTurnsInItsParentsSpace) {
  const Scene scene = exported({{0, "RK1 s 0 -\njoint a j=0\n"},
                                {kSecond / 2, "RK1 s 1 -\njoint a j=1\n"},
                                {kSecond, "RK1 s 2 -\njoint a j=2\n"}});
  const auto turned = scene.channel("a/arm", "rotation");
  EXPECT_THAT(turned.times, ElementsAre(0, 0.5, 1));
  EXPECT_EQ(turned.interpolation, "LINEAR");
  ASSERT_EQ(turned.values.size(), 12U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(turned.values[i * 4 + 1], std::sin(static_cast<double>(i) / 2), 1e-6);
    EXPECT_NEAR(turned.values[i * 4 + 3], std::cos(static_cast<double>(i) / 2), 1e-6);
  }
  // What does not move is no animation.
  EXPECT_THAT(scene.channel("a/arm", "translation").times, IsEmpty());
  EXPECT_THAT(scene.channel("a/tool", "translation").times, IsEmpty());
  EXPECT_THAT(scene.channel("a", "translation").times, IsEmpty());
  EXPECT_EQ(scene.node("a")["translation"], Json::array({1.0, 2.0, 0.0}));
  EXPECT_EQ(scene.node("a/arm")["translation"], Json::array({0.0, 0.0, 0.5}));
  EXPECT_EQ(scene.node("a/tool")["translation"], Json::array({0.0, 0.0, 1.0}));
  EXPECT_EQ(scene.node("camera side")["camera"], 0);
  EXPECT_EQ(facts_.meshes, 2U);
  EXPECT_EQ(facts_.triangles, 24U);
  EXPECT_DOUBLE_EQ(facts_.seconds, 1);
}

TEST_F(GltfExport, TheRestIsThatOfTheFirstMoment) {
  GltfExportOptions options;
  options.from = LogTime(Nanoseconds(test::kWrittenOrigin + kSecond * 3 / 4));
  const Scene scene = exported({{0, "RK1 s 0 -\njoint a j=0\n"},
                                {kSecond / 2, "RK1 s 1 -\njoint a j=1\n"},
                                {kSecond, "RK1 s 2 -\njoint a j=2\n"}},
                               options);
  EXPECT_THAT(scene.channel("a/arm", "rotation").times, ElementsAre(0, 0.25));
  EXPECT_NEAR(scene.node("a/arm")["rotation"][1].get<double>(), std::sin(0.5), 1e-6);
  EXPECT_EQ(scene.json["scenes"][0]["extras"]["rocinante_start_ns"],
            std::to_string(test::kWrittenOrigin + kSecond * 3 / 4));
}

TEST_F(GltfExport, AGridAsksForItsOwnMoments) {
  GltfExportOptions options;
  options.every = Nanoseconds(kSecond / 4);
  const Scene scene = exported({{0, "RK1 s 0 -\njoint a j=0\n"},
                                {kSecond / 10, "RK1 s 1 -\njoint a j=1\n"},
                                {kSecond, "RK1 s 2 -\njoint a j=2\n"}},
                               options);
  EXPECT_THAT(scene.channel("a/arm", "rotation").times, ElementsAre(0, 0.25, 1));
}

TEST_F(GltfExport, DevicesComeAndGoByScale) {
  const Scene scene =
      exported({{0, "RK1 s 0 -\njoint a j=0\n"},
                {kSecond, "RK1 s 1 -\nadd late m.urdf\npose late 9 0 0 0 0 0 1\n"},
                {2 * kSecond, "RK1 s 2 -\nhide a/base\n"},
                {3 * kSecond, "RK1 s 3 -\nremove late\nshow a/base\nhide a/arm\n"}});
  const auto late = scene.channel("late", "scale");
  EXPECT_EQ(late.interpolation, "STEP");
  EXPECT_THAT(late.times, ElementsAre(0, 1, 3));
  EXPECT_THAT(late.values, ElementsAre(0, 0, 0, 1, 1, 1, 0, 0, 0));
  EXPECT_EQ(scene.node("late")["scale"], Json::array({0.0, 0.0, 0.0}));
  EXPECT_EQ(scene.node("late")["translation"], Json::array({9.0, 0.0, 0.0}));
  EXPECT_THAT(scene.channel("a/base shown", "scale").values,
              ElementsAre(1, 1, 1, 0, 0, 0, 1, 1, 1));
  EXPECT_THAT(scene.channel("a/arm shown", "scale").values, ElementsAre(1, 1, 1, 0, 0, 0));
  EXPECT_THAT(scene.channel("a", "scale").times, IsEmpty());
  // Both have one model: its boxes are in the file once.
  EXPECT_EQ(facts_.meshes, 2U);
}

TEST_F(GltfExport, AFarDeviceMovesInANodeThatIsThere) {
  const Scene scene =
      exported({{0, "RK1 s 0 -\npose a 5400000.25 4649776.5 0 0 0 0 1\njoint a j=0\n"},
                {kSecond, "RK1 s 1 -\npose a 5400000.45 4649776.5 0 0 0 0 1\n"}});
  EXPECT_THAT(facts_.gaps, IsEmpty());
  EXPECT_EQ(facts_.keys, 2U);
  const Json& far = scene.node("a offset");
  EXPECT_EQ(far["translation"], Json::array({5'399'552.0, 4'649'984.0, 0.0}));
  ASSERT_EQ(far["children"].size(), 1U);
  EXPECT_EQ(scene.json["nodes"][far["children"][0].get<std::size_t>()]["name"], "a");
  const auto moved = scene.channel("a", "translation");
  ASSERT_EQ(moved.values.size(), 6U);
  EXPECT_NEAR(moved.values[3] - moved.values[0], 0.2, 1e-4);
}

TEST_F(GltfExport, SaysWhereFloatsLoseATimeOrAPlace) {
  std::vector<Said> all{{0, "RK1 s 0 -\njoint a j=0\npose a 0 0 0 0 0 0 1\n"}};
  for (int i = 0; i < 100; ++i) {
    all.push_back({18'000 * kSecond + i * kSecond / 1000,
                   "RK1 s " + std::to_string(i + 1) + " -\njoint a j=" + std::to_string(i) + "\n"});
  }
  exported(all);
  EXPECT_THAT(facts_.gaps, ElementsAre(HasSubstr("floats, 0.002 s apart at 18000 s")));
  GltfExportOptions later;
  later.from = LogTime(Nanoseconds(test::kWrittenOrigin + 17'999 * kSecond));
  exported(all, later);
  EXPECT_THAT(facts_.gaps, IsEmpty());
  exported({{0, "RK1 s 0 -\npose a 0 0 0 0 0 0 1\n"},
            {kSecond, "RK1 s 1 -\npose a 5400000.3 0 0 0 0 0 1\n"}});
  EXPECT_THAT(facts_.gaps, ElementsAre(HasSubstr("a is off by up to 0.2 m")));
}

TEST_F(GltfExport, WhatHasNoPlaceThereIsNamed) {
  exported({{0, "RK1 s 0 -\njoint a j=0\nline path #ffffff 0 0 0 1 1 1\n"},
            {kSecond, "RK1 s 1 -\ncolor a #ff0000\n"}});
  EXPECT_THAT(facts_.notes, ElementsAre("colours change, and are those of the first moment: a"));
  EXPECT_EQ(accountSentence(left_out_),
            "left out: 1 statement `line` (a glTF scene has nothing for it)");
}

TEST_F(GltfExport, AnEmptySpanIsRefused) {
  test::writeSession(folder_ / "s.mcap", std::vector<Said>{{0, "RK1 s 0 -\njoint a j=0\n"}});
  auto session = MomentWalk::open(folder_ / "s.mcap");
  auto cell = loadCell(folder_ / "c.cell.toml", {});
  auto recording = GltfRecording::make(folder_.path().string());
  GltfExportOptions options;
  options.from = LogTime(Nanoseconds(test::kWrittenOrigin + kSecond));
  options.until = LogTime::max();
  EXPECT_EQ(recordGltf(*session, *cell, *recording, options, left_out_).error().kind,
            ErrorKind::not_found);
}

}  // namespace
}  // namespace rocinante
