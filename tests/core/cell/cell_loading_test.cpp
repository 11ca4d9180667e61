// Loading cells: strictly or as far as they are valid, on several threads, and the memory used.
#include <fmt/format.h>

#include <atomic>
#include <thread>

#include "core/cell/posed_scene.h"
#include "core/math/transform.h"
#include "tests/core/cell/cell_fixture.h"

namespace rocinante {
namespace {

using test::writeFile;

class CellLoading : public test::CellFolder {
 protected:
  Result<Cell> loadStrictly(const std::string& name) {
    CellOptions options;
    options.strict = true;
    return loadCell(folder_ / name, options);
  }
  /// A grid of 2 * side * side triangles at a place of its own.
  static std::string gridOf(int side, int where) {
    std::string text;
    for (int y = 0; y <= side; ++y) {
      for (int x = 0; x <= side; ++x) {
        text += fmt::format("v {} {} {}\n", x, y, where + x * y * 0.01);
      }
    }
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        const int a = y * (side + 1) + x + 1, c = a + side + 2;
        text += fmt::format("f {} {} {}\nf {} {} {}\n", a, a + 1, c, a, c, c - 1);
      }
    }
    return text;
  }
  /// A robot whose links each have their own mesh.
  void writeRobot(int links, int side) {
    std::string robot = "<robot name=\"many\"><link name=\"base\"/>\n";
    for (int i = 0; i < links; ++i) {
      writeFile(folder_ / fmt::format("part{}.obj", i), gridOf(side, i));
      robot += fmt::format(
          "<link name=\"l{0}\"><visual><geometry><mesh filename=\"part{0}.obj\"/></geometry>"
          "</visual></link><joint name=\"j{0}\" type=\"fixed\"><parent link=\"base\"/>"
          "<child link=\"l{0}\"/></joint>\n",
          i);
    }
    writeFile(folder_ / "many.urdf", robot + "</robot>\n");
  }
};

TEST_F(CellLoading, StrictTakesWhatIsSoundAndWhatOnlyWarns) {
  EXPECT_TRUE(loadStrictly("arm.urdf").ok());
  writeFile(folder_ / "warns.urdf", "<robot><link name=\"a\"/></robot>");
  const auto cell = loadStrictly("warns.urdf");
  ASSERT_TRUE(cell.ok()) << cell.error().text();
  EXPECT_EQ(cell->faults.size(), 1U) << "no robot name";
}

TEST_F(CellLoading, StrictRefusesWithTheFirstErrorItsPlaceAndHowManyThereAre) {
  const std::string text =
      "format = 1\n[[device]]\nmodel = \"arm.urdf\"\ncolour = \"#ff0000\"\nlayer = 7\n";
  writeFile(folder_ / "test.cell.toml", text);
  const auto loose = loadCell(folder_ / "test.cell.toml", {});
  ASSERT_TRUE(loose.ok());
  EXPECT_EQ(loose->devices.size(), 1U) << "as much as is sound";
  const auto cell = loadStrictly("test.cell.toml");
  ASSERT_FALSE(cell.ok());
  EXPECT_EQ(cell.error().where, (folder_ / "test.cell.toml").string() + ":4:1");
  EXPECT_NE(cell.error().what.find("`colour`"), std::string::npos) << cell.error().text();
  EXPECT_TRUE(cell.error().what.ends_with("; 2 errors in all")) << cell.error().text();
}

TEST_F(CellLoading, AMeshAloneThatShowsNothingIsRefusedWithTheReason) {
  const auto refusalOf = [&](const std::string& name, const std::string& text) {
    writeFile(folder_ / name, text);
    const auto cell = loadCell(folder_ / name, {});
    if (cell.ok()) return std::string("read");
    std::string refusal = cell.error().text();
    const std::string folder = folder_.path().string() + "/";
    return refusal.replace(refusal.find(folder), folder.size(), "");
  };
  const auto collada = [](const std::string& instance) {
    return "<COLLADA version=\"1.4.1\"><asset><up_axis>Z_UP</up_axis></asset>\n"
           "<library_geometries><geometry id=\"hull\"><convex_mesh convex_hull_of=\"#g\"/>"
           "</geometry></library_geometries>\n"
           "<library_visual_scenes><visual_scene id=\"s\"><node>\n" +
           instance +
           "</node></visual_scene></library_visual_scenes>"
           "<scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>";
  };
  EXPECT_EQ(refusalOf("a.dae", collada("<instance_geometry url=\"#g\"/>")),
            "the mesh `a.dae` is not used: holds no triangle that can be drawn; "
            "<instance_geometry> refers to `#g`, but the file has no such <geometry> (a.dae:4)");
  EXPECT_EQ(refusalOf("b.dae", collada("<instance_geometry url=\"other.dae#g\"/>")),
            "the mesh `b.dae` is not used: holds no triangle that can be drawn; "
            "<instance_geometry> refers to another file, `other.dae#g`, which is not read "
            "(b.dae:4)");
  EXPECT_EQ(refusalOf("c.dae", collada("<instance_geometry url=\"#hull\"/>")),
            "the mesh `c.dae` is not used: holds no triangle that can be drawn; element "
            "`convex_mesh` is left out: convex hulls are not drawn (c.dae:2)");
  // The texture that it lacks is not why.
  EXPECT_EQ(
      refusalOf("d.gltf",
                R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":0,"material":0}]}],
"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],
"textures":[{"source":0}],"images":[{"uri":"none.png"}],
"accessors":[{"bufferView":0,"componentType":5126,"count":1,"type":"VEC3"}],
"bufferViews":[{"buffer":0,"byteLength":12}],
"buffers":[{"byteLength":12,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAA"}]})"),
      "the mesh `d.gltf` is not used: holds no triangle that can be drawn; primitive `points` is "
      "left out: meshes[0]: only triangles are drawn (d.gltf)");
  EXPECT_EQ(refusalOf("e.stl", "solid e\nendsolid e\n"),
            "the mesh `e.stl` is not used: holds no triangle that can be drawn (e.stl)");
}

TEST_F(CellLoading, StrictRefusesWhatAFileFarBelowLacks) {
  writeFile(folder_ / "lacks.urdf",
            "<robot name=\"r\"><link name=\"a\"><visual><geometry><mesh filename=\"no.obj\"/>"
            "</geometry></visual></link></robot>");
  writeFile(folder_ / "test.cell.toml", "format = 1\n[[device]]\nmodel = \"lacks.urdf\"\n");
  const auto cell = loadStrictly("test.cell.toml");
  ASSERT_FALSE(cell.ok());
  EXPECT_NE(cell.error().text().find("lacks.urdf:1:"), std::string::npos) << cell.error().text();
}

TEST_F(CellLoading, SeveralThreadsLoadTheSameAndTellHowFarTheyAre) {
  writeRobot(40, 3);
  writeFile(folder_ / "part7.obj", "v 0 0 0\nf 1 2 3\n");
  writeFile(folder_ / "part11.obj", "v 0 0\n");
  const auto one = loadCell(folder_ / "many.urdf", {});
  CellOptions options;
  std::size_t told = 0, last_files = 0;
  options.progress = [&](const LoadProgress& now) {
    ++told;
    EXPECT_GT(now.files_done, last_files);
    EXPECT_LE(now.bytes_done, now.bytes_total);
    last_files = now.files_done;
  };
  options.parallel = [](std::size_t count, const std::function<void(std::size_t)>& task) {
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
      for (std::size_t i = next++; i < count; i = next++) task(i);
    };
    std::jthread other(work), third(work);
    work();
  };
  const auto several = loadCell(folder_ / "many.urdf", options);
  ASSERT_TRUE(one.ok() && several.ok());
  EXPECT_EQ(told, 40U);
  EXPECT_EQ(test::printed(one->faults), test::printed(several->faults));
  EXPECT_FALSE(one->faults.empty());
  EXPECT_EQ(one->files, several->files);
  const Model &a = *one->modelOf(one->devices[0]), &b = *several->modelOf(several->devices[0]);
  for (std::size_t i = 0; i < a.links.size(); ++i) {
    ASSERT_EQ(a.links[i].visuals.size(), b.links[i].visuals.size());
    for (std::size_t v = 0; v < a.links[i].visuals.size(); ++v) {
      const Mesh *left = a.links[i].visuals[v].mesh.get(),
                 *right = b.links[i].visuals[v].mesh.get();
      ASSERT_EQ(left == nullptr, right == nullptr);
      if (left == nullptr) continue;
      EXPECT_EQ(left->indices, right->indices);
      EXPECT_EQ(left->bounds.max, right->bounds.max);
    }
  }
}

TEST_F(CellLoading, AThousandMeshesTakeTheMemoryThatTheDocumentationNames) {
  constexpr int kMeshes = 1000, kSide = 15;
  writeRobot(kMeshes, kSide);
  const auto cell = loadCell(folder_ / "many.urdf", {});
  ASSERT_TRUE(cell.ok()) << cell.error().text();
  ASSERT_TRUE(cell->faults.empty());
  std::size_t bytes = 0, least = 0, triangles = 0;
  for (const Link& link : cell->modelOf(cell->devices[0])->links) {
    for (const Visual& visual : link.visuals) {
      const Mesh& mesh = *visual.mesh;
      triangles += mesh.triangleCount();
      least += mesh.vertices.size() * 32 + mesh.triangleCount() * 12;
      bytes += mesh.vertices.capacity() * sizeof(Vertex) +
               mesh.indices.capacity() * sizeof(std::uint32_t) +
               mesh.colors.capacity() * sizeof(std::uint32_t);
    }
  }
  EXPECT_EQ(triangles, static_cast<std::size_t>(kMeshes) * kSide * kSide * 2);
  // docs/meshes.md: 32 bytes a vertex and 12 a triangle; nothing kept in reserve.
  EXPECT_EQ(bytes, least);
  EXPECT_LT(static_cast<double>(bytes) / static_cast<double>(triangles), 32)
      << "a small open patch; 28 of a closed surface";
}

TEST_F(CellLoading, TenThousandDevicesShareOneModelAndItsMeshes) {
  std::string text = "format = 1\n";
  writeFile(folder_ / "part.obj", gridOf(2, 0));
  writeFile(folder_ / "thing.urdf",
            "<robot name=\"thing\"><link name=\"a\"><visual><geometry><mesh "
            "filename=\"part.obj\"/></geometry></visual></link></robot>");
  for (int i = 0; i < 10'000; ++i) {
    text += fmt::format("[[device]]\nname = \"d{}\"\nmodel = \"thing.urdf\"\n", i);
  }
  const auto cell = load(text);
  ASSERT_TRUE(cell.ok());
  ASSERT_EQ(cell->devices.size(), 10'000U);
  const Model* const model = cell->modelOf(cell->devices.front());
  for (const CellDevice& device : cell->devices) ASSERT_EQ(cell->modelOf(device), model);
  // What `add` brings shares it too.
  const SessionState added = test::stateOf("add more thing\n");
  const PosedScene scene = poseScene(*cell, added);
  ASSERT_EQ(scene.devices.size(), 10'001U);
  for (const PosedDevice& device : scene.devices) ASSERT_EQ(device.model, model);
}

}  // namespace
}  // namespace rocinante
