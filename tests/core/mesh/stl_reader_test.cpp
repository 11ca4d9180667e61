#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "tests/core/mesh/mesh_test_support.h"

namespace rocinante {
namespace {

using test::expectSound;
using test::ReadMesh;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// A binary STL: header, count, then facets of nine coordinates.
std::string binaryStl(std::string header, std::uint32_t count,
                      const std::vector<std::array<float, 9>>& facets,
                      std::string_view attributes = std::string_view("\0\0", 2)) {
  header.resize(80, '\0');
  header.append(reinterpret_cast<const char*>(&count), 4);
  for (const auto& facet : facets) {
    header.append(12, '\0');  // normal: 0 0 0
    header.append(reinterpret_cast<const char*>(facet.data()), 36);
    header.append(attributes.substr(0, 2));
  }
  return header;
}

const std::vector<std::array<float, 9>> kTwoFacets = {{0, 0, 0, 1, 0, 0, 0, 1, 0},
                                                      {1, 0, 0, 1, 1, 0, 0, 1, 0}};

constexpr std::string_view kAscii =
    "solid a part\n"
    "  facet normal 0 0 1\n    outer loop\n      vertex 0 0 0\n      vertex 1e0 0 0\n"
    "      vertex 0 1.0 0\n    endloop\n  endfacet\n"
    "  facet normal 0 0 1\n    outer loop\n      vertex 1 0 0\n      vertex 1 1 0\n"
    "      vertex -0 1 0\n    endloop\n  endfacet\n"
    "endsolid a part\n";

TEST(StlReader, ReadsBinaryAndAsciiAlike) {
  const ReadMesh binary = test::readMesh(binaryStl("made by a test", 2, kTwoFacets), "a.stl");
  const ReadMesh ascii = test::readMesh(kAscii, "a.STL");
  for (const ReadMesh& read : {binary, ascii}) {
    EXPECT_THAT(read.faults, IsEmpty());
    EXPECT_EQ(read.mesh.vertices.size(), 4U) << "points with equal coordinates are joined";
    EXPECT_THAT(read.mesh.indices, ElementsAre(0, 1, 2, 1, 3, 2));
    EXPECT_EQ(read.mesh.vertices[3].position, glm::vec3(1, 1, 0));
    EXPECT_EQ(read.mesh.vertices[3].normal, glm::vec3(0, 0, 1));
    ASSERT_EQ(read.mesh.parts.size(), 1U);
    EXPECT_EQ(read.mesh.parts[0].group, "");
    expectSound(read.mesh);
  }
}

TEST(StlReader, ReadsTextInCapitalsAsText) {
  std::string text(kAscii);
  std::ranges::transform(text, text.begin(), [](char c) {
    return c >= 'a' && c <= 'z' && c != 'e' ? static_cast<char>(c - 'a' + 'A') : c;
  });
  std::ranges::replace(text, 'e', 'E');
  for (const std::string& each :
       {text, "\n  " + text, "made by a program\n" + std::string(kAscii)}) {
    const ReadMesh read = test::readMesh(each, "a.stl");
    EXPECT_EQ(read.mesh.triangleCount(), 2U);
    EXPECT_EQ(read.mesh.bounds.max, Vec3(1, 1, 0));
  }
  EXPECT_THAT(test::readMesh(text, "a.stl").faults, IsEmpty());
  Findings faults;
  const auto utf16 =
      readMeshBytes(bytesOf(std::string_view("\xFF\xFEs\0o\0", 6)), "a.stl", {}, faults);
  ASSERT_FALSE(utf16.ok());
  EXPECT_EQ(utf16.error().what, "is UTF-16 text; save it as UTF-8");
}

TEST(StlReader, NamesColoursAndNormalsThatItDoesNotUse) {
  const ReadMesh colored =
      test::readMesh(binaryStl("COLOR=abcd", 2, kTwoFacets, "\xAB\xCD"), "a.stl");
  EXPECT_THAT(colored.leftOut(), ElementsAre("value `attribute bytes`", "value `COLOR=`"));
  EXPECT_EQ(colored.faults[0].count, 2U);
  std::string turned(kAscii);
  turned.replace(turned.find("0 0 1"), 5, "0 0 -1");
  const ReadMesh read = test::readMesh(turned + "solid b\nendsolid b\n", "a.stl");
  EXPECT_THAT(read.leftOut(), ElementsAre("statement `solid`", "value `normal`"));
  EXPECT_THAT(read.blame(), ElementsAre("model.left-out"));
  EXPECT_EQ(read.mesh.vertices[0].normal, glm::vec3(0, 0, 1)) << "the order of corners decides";
}

TEST(StlReader, ReadsAFileWrittenBeforeItsCountWasKnown) {
  const ReadMesh read = test::readMesh(binaryStl("solid", 0, kTwoFacets), "a.stl");
  EXPECT_EQ(read.mesh.triangleCount(), 2U);
  EXPECT_THAT(read.blame(), ElementsAre("stl.trailing-bytes"));
}

TEST(StlReader, LeavesOutWhatIsTooFarAway) {
  auto facets = kTwoFacets;
  facets[0][4] = 3e38F;
  const ReadMesh read = test::readMesh(binaryStl("x", 2, facets), "a.stl");
  EXPECT_EQ(read.mesh.triangleCount(), 1U);
  EXPECT_EQ(read.faults[0].text, "triangle 0 has a corner that is too far away to be drawn");
}

TEST(StlReader, BelievesTheLengthAndNotTheWordSolid) {
  const ReadMesh read =
      test::readMesh(binaryStl("solid facet normal 0 0 1 outer loop", 2, kTwoFacets), "a.stl");
  EXPECT_THAT(read.faults, IsEmpty());
  EXPECT_EQ(read.mesh.triangleCount(), 2U);
}

TEST(StlReader, ReadsWhatIsThereOfAFileThatLiesAboutItsCount) {
  const ReadMesh cut = test::readMesh(binaryStl("solid", 0xFFFFFFFF, kTwoFacets), "a.stl");
  EXPECT_EQ(cut.mesh.triangleCount(), 2U);
  ASSERT_EQ(cut.faults.size(), 1U);
  EXPECT_EQ(cut.faults[0].rule, "stl.truncated");
  EXPECT_EQ(cut.faults[0].text, "the header says 4294967295 triangles, the file holds 2");
  const ReadMesh more = test::readMesh(binaryStl("x", 1, kTwoFacets), "a.stl");
  EXPECT_EQ(more.mesh.triangleCount(), 1U);
  EXPECT_EQ(more.faults[0].text, "50 bytes follow the 1 triangles of the header");
}

TEST(StlReader, LeavesOutTrianglesThatAreNoNumbers) {
  auto facets = kTwoFacets;
  facets[0][4] = std::numeric_limits<float>::quiet_NaN();
  const ReadMesh read = test::readMesh(binaryStl("x", 2, facets), "a.stl");
  EXPECT_EQ(read.mesh.triangleCount(), 1U);
  EXPECT_THAT(read.rules(), ElementsAre("stl.bad-number"));
  EXPECT_EQ(read.faults[0].text, "triangle 0 has a corner that is not a number");
}

TEST(StlReader, LeavesOutAsciiFacetsThatAreNotThreeCorners) {
  const std::string text =
      "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\n"
      "facet\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendfacet\n"
      "facet\nvertex 0 0 0\nvertex nan 0 0\nvertex 1 1 0\nendfacet\nhello\n"
      "facet\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendfacet\n"
      "facet\nvertex 0 0 0\n";
  const ReadMesh read = test::readMesh(text, "a.stl");
  EXPECT_EQ(read.mesh.triangleCount(), 1U);
  EXPECT_THAT(read.rules(), ElementsAre("stl.bad-facet", "stl.bad-facet", "stl.bad-number",
                                        "stl.unknown-keyword", "stl.truncated"));
  EXPECT_EQ(read.faults[1].line, 12);
}

TEST(StlReader, WarnsOfTextThatEndsWithoutEndsolid) {
  const std::string text(kAscii);
  const ReadMesh cut = test::readMesh(text.substr(0, text.find("endsolid")), "a.stl");
  EXPECT_EQ(cut.mesh.triangleCount(), 2U);
  ASSERT_THAT(cut.rules(), ElementsAre("stl.truncated"));
  EXPECT_EQ(cut.faults[0].print(),
            "a.stl:15: warning: ends without `endsolid`: perhaps not all of it is there "
            "[stl.truncated]");
  // In the next facet, before its first corner; in the second solid.
  for (const char* more : {"facet normal 0 0 1\n outer loop\n", "endsolid\nsolid b\n"}) {
    EXPECT_THAT(test::readMesh(text.substr(0, text.find("endsolid")) + more, "a.stl").blame(),
                ElementsAre("stl.truncated"))
        << more;
  }
  EXPECT_THAT(test::readMesh(text + "\n\n", "a.stl").faults, IsEmpty());
}

TEST(StlReader, SmoothsByAngle) {
  // A box corner is three flat faces: nothing is smoothed over 90 degrees.
  const ReadMesh box = test::readMesh(
      binaryStl(
          "x", 3,
          {{0, 0, 0, 0, 1, 0, 1, 0, 0}, {0, 0, 0, 1, 0, 0, 0, 0, 1}, {0, 0, 0, 0, 0, 1, 0, 1, 0}}),
      "a.stl");
  EXPECT_EQ(box.mesh.vertices.size(), 9U);
  MeshReadOptions all;
  all.smooth_angle_deg = 90;
  const ReadMesh round = test::readMesh(
      binaryStl(
          "x", 3,
          {{0, 0, 0, 0, 1, 0, 1, 0, 0}, {0, 0, 0, 1, 0, 0, 0, 0, 1}, {0, 0, 0, 0, 0, 1, 0, 1, 0}}),
      "a.stl", all);
  EXPECT_EQ(round.mesh.vertices.size(), 4U);
  const float third = -1 / std::sqrt(3.0F);
  EXPECT_NEAR(round.mesh.vertices[0].normal.x, third, 1e-6F);
}

TEST(StlReader, KeepsAFanOfManyFacesFlat) {
  std::vector<std::array<float, 9>> fan;
  for (int i = 0; i < 1000; ++i) {
    const auto x = static_cast<float>(i);
    fan.push_back({0, 0, 0, x + 1, 1000, 5, x, 1000, 5});
  }
  const ReadMesh read = test::readMesh(binaryStl("x", 1000, fan), "a.stl");
  EXPECT_EQ(read.mesh.triangleCount(), 1000U);
  expectSound(read.mesh);
}

TEST(StlReader, AppliesUnitAndUpAxis) {
  MeshReadOptions options;
  options.unit_m = 0.001;
  options.up = UpAxis::y;
  const ReadMesh read =
      test::readMesh(binaryStl("x", 1, {{1000, 2000, 3000, 2000, 2000, 3000, 1000, 3000, 3000}}),
                     "a.stl", options);
  EXPECT_EQ(read.mesh.vertices[0].position, glm::vec3(1, -3, 2));
}

TEST(StlReader, RefusesWhatHoldsNoTriangle) {
  for (const std::string& text :
       {std::string(), std::string("solid x\nendsolid x\n"), std::string(83, '\0'),
        binaryStl("x", 0, {}), binaryStl("x", 7, {})}) {
    Findings faults;
    const Result<Mesh> mesh = readMeshBytes(bytesOf(text), "a.stl", {}, faults);
    ASSERT_FALSE(mesh.ok());
    EXPECT_EQ(mesh.error().text(), "holds no triangle that can be drawn (a.stl)");
  }
}

TEST(StlReader, SurvivesEveryPrefix) {
  for (const std::string& text : {binaryStl("solid x", 2, kTwoFacets), std::string(kAscii)}) {
    for (std::size_t length = 0; length <= text.size(); ++length) {
      SCOPED_TRACE(length);
      const std::vector<char> cut(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(length));
      Findings faults;
      const Result<Mesh> mesh =
          readMeshBytes(bytesOf({cut.data(), cut.size()}), "a.stl", {}, faults);
      if (mesh) expectSound(*mesh);
    }
  }
}

TEST(MeshFile, RefusesOtherEndingsAndMissingFiles) {
  Findings faults;
  const Result<Mesh> step = readMeshBytes({}, "a.step", {}, faults);
  ASSERT_FALSE(step.ok());
  EXPECT_EQ(step.error().kind, ErrorKind::unsupported);
  EXPECT_EQ(
      step.error().text(),
      "is not a mesh that can be read: .obj, .stl, .dae, .gltf and .glb are, not `.step` (a.step)");
  const Result<Mesh> missing = readMeshFile("/nowhere/a.obj", {}, faults);
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().kind, ErrorKind::not_found);
}

}  // namespace
}  // namespace rocinante
