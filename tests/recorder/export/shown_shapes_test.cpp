#include "recorder/export/shown_shapes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "core/mesh/glb_container.h"
#include "core/report/json_text.h"
#include "recorder/export/exports.h"
#include "tests/recorder/export/written_session.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using testing::ElementsAre;

constexpr const char* kShownUrdf = R"(<robot name="m">
  <link name="base"><visual><geometry><box size="1 1 1"/></geometry></visual></link>
  <link name="tool"/>
  <link name="tip"><visual><geometry><sphere radius="0.1"/></geometry></visual></link>
  <joint name="f" type="fixed"><parent link="base"/><child link="tool"/></joint>
  <joint name="g" type="fixed"><parent link="tool"/><child link="tip"/></joint>
</robot>)";

/// Notes shapes and events alone, a line each.
class ShapeFormat final : public SessionFormat {
 public:
  std::string profile() const override { return ""; }
  Nanoseconds framesLast() const override { return {}; }
  Status frames(MessageSink&, LogTime, const std::string&, std::span<const FramePose>) override {
    return {};
  }
  Status joints(MessageSink&, LogTime, const std::string&, std::span<const NamedValue>) override {
    return {};
  }
  Status drawings(MessageSink&, LogTime, const std::string&, const Drawings&) override {
    return {};
  }
  Status event(MessageSink&, LogTime time, EventLevel level, std::string_view name,
               std::string_view text) override {
    return note(time, (level == EventLevel::error ? "error " : "event ") + std::string(name) + " " +
                          std::string(text));
  }
  Status shapes(MessageSink&, LogTime time, const std::string& device,
                std::span<const LinkShape> shapes) override {
    std::string line = "shapes " + device + ":";
    for (const LinkShape& shape : shapes) {
      line += " " + shape.frame;
      const auto parts = gltfParts(*shape.glb);
      EXPECT_TRUE(parts.ok());
      const Json json = Json::parse(parts->text);
      EXPECT_EQ(json["nodes"][1]["name"], shape.frame + "#1");
      colors.push_back(json["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"][0]);
    }
    return note(time, line);
  }
  Status description(MessageSink&, LogTime, const std::string&, std::string_view) override {
    return {};
  }

  std::vector<std::string> notes;
  std::vector<double> colors;

 private:
  Status note(LogTime time, const std::string& line) {
    notes.push_back(std::to_string(nanosecondsOf(time) - test::kWrittenOrigin) + " " + line);
    return {};
  }
};

TEST(ShownShapes, AreSaidWhenALinkComesGoesOrChangesItsColour) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "m.urdf") << kShownUrdf;
  std::ofstream(folder / "c.cell.toml")
      << "format = 1\n[[device]]\nname = \"a\"\nmodel = \"m.urdf\"\n";
  const std::vector<test::Said> all = {{0, "RK1 s 0 -\npose a 0 0 1 0 0 0 1\n"},
                                       {10, "RK1 s 1 -\npose a 0 0 2 0 0 0 1\n"},
                                       {20, "RK1 s 2 -\nhide a/tip\n"},
                                       {30, "RK1 s 3 -\ncolor a #ff0000\n"},
                                       {40, "RK1 s 4 -\nremove a\n"}};
  test::writeSession(folder / "s.mcap", all);
  auto session = MomentWalk::open(folder / "s.mcap");
  auto cell = loadCell(folder / "c.cell.toml", {});
  Bytes bytes;
  auto out = ExportedMcap::start(makeMemorySink(bytes), "");
  ASSERT_TRUE(session.ok() && cell.ok() && out.ok());
  ShapeFormat format;
  MessageExportOptions options;
  options.until = LogTime::max();
  options.shapes = true;
  const LogTime origin{Nanoseconds(test::kWrittenOrigin)};
  options.notes = {{origin + Nanoseconds(25), EventLevel::error, "joint.limit", "too far"},
                   {origin - Nanoseconds(1), EventLevel::error, "early", "left out"}};
  options.from = origin;
  ASSERT_TRUE(exportMessages(*session, &*cell, format, *out, options).ok());
  EXPECT_THAT(format.notes,
              ElementsAre("0 shapes a: a/base a/tip", "20 shapes a: a/base",
                          "25 error joint.limit too far", "30 shapes a: a/base", "40 shapes a:"));
  ASSERT_EQ(format.colors.size(), 4U);
  EXPECT_LT(format.colors[2], 1.0);
  EXPECT_EQ(format.colors[3], 1.0);
}

}  // namespace
}  // namespace rocinante
