#include <fmt/format.h>

#include <cmath>

#include "core/report/account.h"
#include "tests/core/mesh/mesh_test_support.h"

namespace rocinante {
namespace {

using test::expectSound;
using test::flatArea;
using test::ReadMesh;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

ReadMesh readObjText(std::string_view text, const MeshReadOptions& options = {}) {
  return test::readMesh(text, "test.obj", options);
}

Error refusal(std::string_view text) {
  Findings faults;
  const Result<Mesh> mesh = readMeshBytes(bytesOf(text), "test.obj", {}, faults);
  EXPECT_FALSE(mesh.ok());
  return mesh ? Error{} : mesh.error();
}

constexpr std::string_view kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::string square(std::string_view rest) { return std::string(kSquare) + std::string(rest); }

TEST(ObjReader, GivesTheVerticesOfATriangleExactly) {
  const ReadMesh read = readObjText(
      "v 1 2 3\nv 4 2 3\nv 1 6.5 3\n"
      "vt 0 0\nvt 1 0\nvt 0 0.25\n"
      "vn 0 0 1\n"
      "f 1/1/1 2/2/1 3/3/1\n");
  EXPECT_THAT(read.faults, IsEmpty());
  ASSERT_EQ(read.mesh.vertices.size(), 3U);
  EXPECT_THAT(read.mesh.indices, ElementsAre(0, 1, 2));
  EXPECT_EQ(read.mesh.vertices[2].position, glm::vec3(1, 6.5F, 3));
  EXPECT_EQ(read.mesh.vertices[2].normal, glm::vec3(0, 0, 1));
  EXPECT_EQ(read.mesh.vertices[2].texture, glm::vec2(0, 0.25F));
  EXPECT_EQ(read.mesh.bounds.min, Vec3(1, 2, 3));
  EXPECT_EQ(read.mesh.bounds.max, Vec3(4, 6.5, 3));
  ASSERT_EQ(read.mesh.parts.size(), 1U);
  EXPECT_EQ(read.mesh.materials[0].name, "");
}

TEST(ObjReader, ReadsEveryWayToWriteANumber) {
  const ReadMesh read = readObjText(
      "v +1.5 -.5 5.\nv 1e2 1E-2 -0\nv 0.1234567890123456789 123456789012345678901234567890e-29 0\n"
      "f 1 2 3\n");
  EXPECT_THAT(read.faults, IsEmpty());
  EXPECT_EQ(read.mesh.vertices[0].position, glm::vec3(1.5F, -0.5F, 5.0F));
  EXPECT_EQ(read.mesh.vertices[1].position, glm::vec3(100.0F, 0.01F, 0.0F));
  EXPECT_EQ(read.mesh.vertices[2].position, glm::vec3(0.12345679F, 1.2345679F, 0.0F));
}

TEST(ObjReader, SharesCornersThatAreEqualAndNoOthers) {
  const ReadMesh read =
      readObjText(square("vt 0 0\nvt 1 1\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/2/1 4/1/1\n"));
  // Corner 3 has two texture coordinates, corner 1 is shared.
  EXPECT_EQ(read.mesh.vertices.size(), 5U);
  EXPECT_THAT(read.mesh.indices, ElementsAre(0, 1, 2, 0, 3, 4));
}

TEST(ObjReader, CountsNegativeIndicesFromTheLastSoFar) {
  const ReadMesh read = readObjText("v 9 9 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 7 7 7\n");
  EXPECT_THAT(read.faults, IsEmpty());
  EXPECT_EQ(read.triangle(0)[0], glm::vec3(0, 0, 0));
  EXPECT_EQ(read.triangle(0)[2], glm::vec3(0, 1, 0));
}

TEST(ObjReader, ReadsCornersOfAllFourForms) {
  const ReadMesh read = readObjText(
      square("vt 0.5 0.5\nvn 0 0 -1\nf 1 2 3\nf 1/1 2/1 3/1\nf 1//1 2//1 3//1\nf 1/1/1 2/1/1 "
             "3/1/1\n"));
  EXPECT_THAT(read.faults, IsEmpty());
  const auto corner = [&](std::size_t i) { return read.mesh.vertices[read.mesh.indices[i]]; };
  EXPECT_EQ(corner(0).texture, glm::vec2(0, 0));
  EXPECT_EQ(corner(0).normal, glm::vec3(0, 0, 1));
  EXPECT_EQ(corner(3).texture, glm::vec2(0.5F, 0.5F));
  EXPECT_EQ(corner(6).normal, glm::vec3(0, 0, -1));
  EXPECT_EQ(corner(9).normal, glm::vec3(0, 0, -1));
}

TEST(ObjReader, TakesTripleIndicesWithoutTextureCoordinatesOrNormals) {
  const ReadMesh read = readObjText(square("f 1/1/1 2/2/2 3/3/3\n"));
  // As some exporters write them; that the file has none is in the account.
  EXPECT_EQ(countOf(read.faults, Severity::note), read.faults.size());
  EXPECT_EQ(accountBrief(accountOf(read.faults)), "1 `vt`, 1 `vn` are left out");
  EXPECT_EQ(read.mesh.triangleCount(), 1U);
}

TEST(ObjReader, NamesPartsByGroupElseByObject) {
  const ReadMesh read = readObjText(
      square("f 1 2 3\no body\nf 1 2 3\ng left wing\nf 1 2 3\nf 1 3 4\no tail\nf 1 2 3\ng\nf 1 3 "
             "4\n"));
  std::vector<std::string> groups;
  for (const MeshPart& part : read.mesh.parts) groups.push_back(part.group);
  EXPECT_THAT(groups, ElementsAre("", "body", "left wing", "tail"));
  EXPECT_EQ(read.mesh.parts[2].index_count, 6U);
  EXPECT_EQ(read.mesh.parts[3].index_count, 6U);
  expectSound(read.mesh);
}

TEST(ObjReader, FansConvexPolygons) {
  const ReadMesh read = readObjText(square("f 1 2 3 4\n"));
  EXPECT_EQ(read.mesh.triangleCount(), 2U);
  EXPECT_DOUBLE_EQ(flatArea(read.mesh), 2.0);
}

TEST(ObjReader, CutsConcavePolygonsWithoutCoveringTheirNotch) {
  // An L, starting at a corner where a fan would leave it.
  for (int first = 0; first < 6; ++first) {
    SCOPED_TRACE(first);
    std::string text = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf";
    for (int i = 0; i < 6; ++i) text += fmt::format(" {}", (first + i) % 6 + 1);
    const ReadMesh read = readObjText(text + "\n");
    ASSERT_EQ(read.mesh.triangleCount(), 4U);
    EXPECT_DOUBLE_EQ(flatArea(read.mesh), 6.0);
    for (std::size_t i = 0; i < 4; ++i) {
      const auto corners = read.triangle(i);
      const glm::vec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0F;
      EXPECT_FALSE(middle.x > 1 && middle.y > 1) << "triangle " << i << " covers the notch";
      EXPECT_GE(glm::cross(corners[1] - corners[0], corners[2] - corners[0]).z, 0);
    }
  }
}

TEST(ObjReader, CutsAStarAndACombOfManyTeeth) {
  std::string star = "";
  std::string face = "f";
  for (int i = 0; i < 200; ++i) {
    const double radius = i % 2 == 0 ? 2.0 : 1.0;
    star += fmt::format("v {:.9f} {:.9f} 0\n", radius * std::cos(i * M_PI / 100),
                        radius * std::sin(i * M_PI / 100));
    face += fmt::format(" {}", i + 1);
  }
  const ReadMesh read = readObjText(star + face + "\n");
  EXPECT_EQ(read.mesh.triangleCount(), 198U);
  // 200 triangles from the centre, each half * 1 * 2 * sin(pi / 100).
  EXPECT_NEAR(flatArea(read.mesh), 200 * 2 * std::sin(M_PI / 100), 1e-4);
}

TEST(ObjReader, CutsAConcavePolygonInAnyPlane) {
  const std::vector<std::string> planes = {
      "v 0 0 0\nv 0 2 0\nv 0 2 1\nv 0 1 1\nv 0 1 2\nv 0 0 2\n",
      "v 0 0 0\nv 0 0 2\nv 1 0 2\nv 1 0 1\nv 2 0 1\nv 2 0 0\n",
      "v 0 0 0\nv 0 2 0\nv 1 2 0\nv 1 1 0\nv 2 1 0\nv 2 0 0\n"};
  for (const std::string& points : planes) {
    SCOPED_TRACE(points);
    const ReadMesh read = readObjText(points + "f 2 3 4 5 6 1\n");
    Vec3 sum(0.0);
    double area = 0;
    for (std::size_t i = 0; i < read.mesh.triangleCount(); ++i) {
      const auto corners = read.triangle(i);
      const Vec3 normal = glm::cross(Vec3(corners[1] - corners[0]), Vec3(corners[2] - corners[0]));
      sum += normal;
      area += std::sqrt(glm::dot(normal, normal));
    }
    // No triangle overlaps another or is flipped: the length of the sum is the sum of the lengths.
    EXPECT_DOUBLE_EQ(area, 6.0);
    EXPECT_DOUBLE_EQ(std::sqrt(glm::dot(sum, sum)), 6.0);
  }
}

TEST(ObjReader, EndsOnPolygonsThatCrossThemselves) {
  const ReadMesh read = readObjText("v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nv 0 0.5 0\nf 1 2 3 4 5\n");
  EXPECT_EQ(read.mesh.triangleCount(), 3U);
  expectSound(read.mesh);
}

TEST(ObjReader, SmoothsMissingNormalsBelowTheAngleAndKeepsEdgesAbove) {
  // A roof: two squares that meet along the y axis at the given angle.
  const auto roof = [](double angle_deg) {
    const double x = std::cos(angle_deg * M_PI / 180), z = -std::sin(angle_deg * M_PI / 180);
    return readObjText(fmt::format(
        "v -1 0 0\nv -1 1 0\nv 0 0 0\nv 0 1 0\nv {0:.9f} 0 {1:.9f}\nv {0:.9f} 1 {1:.9f}\n"
        "f 1 3 4 2\nf 3 5 6 4\n",
        x, z));
  };
  EXPECT_EQ(roof(30).mesh.vertices.size(), 6U) << "shared along the ridge";
  EXPECT_EQ(roof(50).mesh.vertices.size(), 8U) << "two normals along the ridge";
  const ReadMesh smooth = roof(30);
  const glm::vec3 ridge = smooth.mesh.vertices[1].normal;
  EXPECT_NEAR(ridge.x, std::sin(15 * M_PI / 180), 1e-6);
  EXPECT_NEAR(ridge.z, std::cos(15 * M_PI / 180), 1e-6);
  expectSound(smooth.mesh);
}

TEST(ObjReader, SmoothingGroupsDecideBehindTheirStatement) {
  // Three squares in a row, each 50 degrees, then 30 degrees, steeper than the one before.
  const auto row = [](std::string_view before, std::string_view first, std::string_view second) {
    std::string points;
    double x = 0, z = 0;
    for (const double angle_deg : {0.0, 50.0, 80.0, 0.0}) {
      points += fmt::format("v {0:.9f} 0 {1:.9f}\nv {0:.9f} 1 {1:.9f}\n", x, z);
      x += std::cos(angle_deg * M_PI / 180);
      z -= std::sin(angle_deg * M_PI / 180);
    }
    return readObjText(
        fmt::format("{}{}f 1 3 4 2\n{}f 3 5 6 4\n{}f 5 7 8 6\n", points, before, first, second));
  };
  const auto vertices = [&](std::string_view before, std::string_view first = {},
                            std::string_view second = {}) {
    const ReadMesh read = row(before, first, second);
    EXPECT_THAT(read.faults, IsEmpty()) << before << first << second;
    expectSound(read.mesh);
    return read.mesh.vertices.size();
  };
  EXPECT_EQ(vertices(""), 10U) << "by angle: an edge at 50 degrees, none at 30";
  EXPECT_EQ(vertices("s 1\n"), 8U) << "no edge within a group";
  EXPECT_EQ(vertices("s off\n"), 12U);
  EXPECT_EQ(vertices("s 0\n"), 12U);
  EXPECT_EQ(vertices("s 1\n", "", "s 2\n"), 10U) << "an edge between two groups";
  EXPECT_EQ(vertices("s 7\n", "s off\n", "s 7\n"), 12U);
  EXPECT_EQ(vertices("", "", "s 1\n"), 12U) << "what comes before the first `s` is by angle";
  EXPECT_EQ(vertices("", "s 1\n"), 10U);
  EXPECT_THAT(row("s perhaps\n", "", "").rules(), ElementsAre("obj.bad-number"));
}

TEST(ObjReader, ACommentMayStandBehindNumbersAndCorners) {
  const ReadMesh read =
      readObjText("v 0 0 0 # here\nv 1 0 0 #\nv 1 1 0\nv 0 1 0\nf 1 2 3 4 # a square\nf 1 2 3#\n");
  EXPECT_EQ(read.mesh.triangleCount(), 2U);
  EXPECT_THAT(read.rules(), ElementsAre("obj.bad-face")) << "a comment begins behind a blank";
}

TEST(ObjReader, SmoothsOverPointsThatAreWrittenTwice) {
  const ReadMesh read = readObjText(
      "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
      "v 1 0 0\nv 1 1 0.3\nv 0 1 0\nf 4 5 6\n");
  const auto normal = [&](std::size_t i) {
    return read.mesh.vertices[read.mesh.indices[i]].normal;
  };
  EXPECT_EQ(normal(1), normal(3));
  EXPECT_NE(normal(0), normal(4));
}

TEST(ObjReader, DoesNotSmoothOverTheBorderOfGroups) {
  const ReadMesh read =
      readObjText("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0.3\ng a\nf 1 2 3\ng b\nf 2 4 3\n");
  EXPECT_EQ(read.mesh.vertices[read.mesh.indices[1]].normal, glm::vec3(0, 0, 1));
}

TEST(ObjReader, ComputesNormalsThatPointNowhere) {
  const ReadMesh read = readObjText(square("vn 0 0 0\nvn 0 0 3\nf 1//1 2//1 3//2\n"));
  for (const Vertex& vertex : read.mesh.vertices) EXPECT_EQ(vertex.normal, glm::vec3(0, 0, 1));
}

TEST(ObjReader, AppliesUnitAndUpAxis) {
  MeshReadOptions options;
  options.unit_m = 0.0254;
  options.up = UpAxis::y;
  const ReadMesh read =
      readObjText("v 1 2 3\nv 2 2 3\nv 1 3 3\nvn 0 1 0\nf 1//1 2//1 3//1\n", options);
  EXPECT_EQ(read.mesh.vertices[0].position, glm::vec3(0.0254F, -3 * 0.0254, 2 * 0.0254));
  EXPECT_EQ(read.mesh.vertices[0].normal, glm::vec3(0, 0, 1));
}

TEST(ObjReader, ReadsAnyLineEndBomAndContinuation) {
  const std::string plain = "v 0 0 0\nv 1 0 0\nv 0 1 0\ng a b\nf 1 2 3\n";
  std::string crlf, cr;
  for (const char c : plain) {
    crlf += c == '\n' ? "\r\n" : std::string(1, c);
    cr += c == '\n' ? '\r' : c;
  }
  const std::string continued = "v 0 \\\n0 0\nv 1 0 0\nv 0 1 0\ng a\\\nb\nf 1 \\\r\n 2\\\n 3";
  for (const std::string& text : {plain, crlf, cr, "\xEF\xBB\xBF" + plain, continued}) {
    SCOPED_TRACE(text);
    const ReadMesh read = readObjText(text);
    EXPECT_THAT(read.faults, IsEmpty());
    ASSERT_EQ(read.mesh.triangleCount(), 1U);
    EXPECT_EQ(read.mesh.parts[0].group, "a b");
    EXPECT_EQ(read.mesh.bounds.max, Vec3(1, 1, 0));
  }
}

TEST(ObjReader, TellsTheLineOfAFaultAlsoAfterContinuedLines) {
  const ReadMesh read = readObjText(square("g a\\\nb\r\nf 1 2 3\rf 1 2 9\n"));
  ASSERT_EQ(read.faults.size(), 1U);
  EXPECT_EQ(read.faults[0].line, 8);
  EXPECT_EQ(read.faults[0].rule, "obj.bad-index");
  EXPECT_EQ(read.faults[0].text, "a face uses point 9 of the 4 so far");
}

TEST(ObjReader, LeavesOutFacesOfPointsThatAreNotThere) {
  for (const char* corner :
       {"0", "5", "-5", "9223372036854775808", "-9223372036854775809", "99999999999999999999999",
        "4294967297", "x", "1/x", "1.5", "1/2/3/4", "/1", ""}) {
    SCOPED_TRACE(corner);
    const ReadMesh read = readObjText(square(fmt::format("f 1 2 3\nf 1 2 {}\n", corner)));
    EXPECT_EQ(read.mesh.triangleCount(), 1U);
    ASSERT_EQ(countOf(read.faults, Severity::error), 1U);
    EXPECT_EQ(read.faults[0].severity, Severity::error);
    EXPECT_EQ(read.faults[0].line, 6);
  }
}

TEST(ObjReader, LeavesOutFacesOfTextureCoordinatesAndNormalsThatAreNotThere) {
  const ReadMesh read =
      readObjText(square("vt 0 0\nvn 0 0 1\nf 1 2 3\nf 1/2 2/1 3/1\nf 1//1 2//-2 3//1\n"));
  EXPECT_EQ(read.mesh.triangleCount(), 1U);
  EXPECT_THAT(read.rules(), ElementsAre("obj.bad-index", "obj.bad-index"));
}

TEST(ObjReader, KeepsTheNumbersOfPointsAfterOneThatIsNoNumber) {
  for (const char* bad : {"nan 0 0", "0 inf 0", "1e999 0 0", "1e39 0 0", "3e38 0 0", "0x10 0 0",
                          "1 2", "1,5 0 0", "", "1.2.3 0 0", "- 0 0", ". 0 0", "1e 0 0"}) {
    SCOPED_TRACE(bad);
    const ReadMesh read =
        readObjText(fmt::format("v {}\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 2 3 4\n", bad));
    EXPECT_EQ(read.mesh.triangleCount(), 1U);
    EXPECT_EQ(read.mesh.bounds.max, Vec3(1, 1, 0));
    EXPECT_THAT(read.rules(), ElementsAre("obj.bad-number", "obj.bad-face"));
    EXPECT_EQ(read.faults[0].line, 1);
  }
}

TEST(ObjReader, ReadsColoursAtThePoints) {
  const ReadMesh read =
      readObjText("v 0 0 0 1\nv 1 0 0 1 0 0\nv 0 1 0 0 0.5 1\nv 1 1 0 255 0 0\nf 1 2 3\nf 2 4 3\n");
  EXPECT_THAT(read.rules(), ElementsAre("obj.color-range"));
  ASSERT_EQ(read.mesh.colors.size(), read.mesh.vertices.size());
  EXPECT_EQ(read.mesh.colors[0], 0xFFFFFFFFU) << "a weight is not a colour";
  EXPECT_EQ(read.mesh.colors[1], 0xFF0000FFU);
  EXPECT_EQ(read.mesh.colors[2], 0x0080FFFFU);
  EXPECT_EQ(read.mesh.colors[3], 0xFF0000FFU);
  EXPECT_EQ(read.mesh.materials[0].diffuse, glm::vec4(1.0F)) << "no grey darkens them";
}

TEST(ObjReader, NamesWhatItDoesNotDraw) {
  const ReadMesh read = readObjText(
      "# comment\nv 0 0 0 1 0.5 0.5\nv 1 0 0 1.0\nv 0 1 0 1 0 0 1\nv 0 0 0 0.5\nv 0 0 0 x\n"
      "vt 0 0 0.5\nvt 0 0 0\ns 1\ns off\nl 1 2\nl 2 3\np 1\n\n   \nf 1 2 3\n");
  EXPECT_THAT(read.leftOut(),
              ElementsAre("value `weight of v`", "value `v`", "value `third number of vt`",
                          "statement `l`", "statement `p`"));
  EXPECT_THAT(read.blame(), IsEmpty());
  EXPECT_EQ(read.faults[3].count, 2U);
  EXPECT_EQ(read.mesh.triangleCount(), 1U);
  EXPECT_THAT(readObjText(square("vn 0 0 1\ns 1\nf 1//1 2//1 3//1\n")).faults, IsEmpty())
      << "smoothing groups change nothing where all normals are given";
}

TEST(ObjReader, NamesKeywordsThatItDoesNotKnow) {
  const ReadMesh read = readObjText(square("f 1 2 3\ncurv 0 1 1 2\nfoo\x01 bar\n"));
  EXPECT_THAT(read.rules(), ElementsAre("obj.unsupported", "obj.unknown-keyword"));
  EXPECT_THAT(read.leftOut(), ElementsAre("statement `curv`", "statement `foo\\x01`"));
}

TEST(ObjReader, ListsAHundredFaultsOfARuleAndCountsTheRest) {
  std::string text = square("f 1 2 3\n");
  for (int i = 0; i < 1000; ++i) text += "f 1 2 99\n";
  const ReadMesh read = readObjText(text);
  ASSERT_EQ(read.faults.size(), 101U);
  EXPECT_EQ(read.faults.back().text, "900 more of these");
  EXPECT_EQ(read.faults.back().rule, "obj.bad-index");
}

TEST(ObjReader, RefusesWhatHoldsNothingToDraw) {
  EXPECT_EQ(refusal("").kind, ErrorKind::damaged);
  EXPECT_EQ(refusal("v 0 0 0\n").text(), "holds no face that can be drawn (test.obj)");
  EXPECT_EQ(refusal("f 1 2 3\n").kind, ErrorKind::damaged);
}

TEST(ObjReader, RefusesUtf16WithASentence) {
  for (const std::string_view text :
       {std::string_view("\xFF\xFEv\0 \0", 6), std::string_view("\xFE\xFF\0v\0 ", 6),
        std::string_view("v\0 \0001\0", 6), std::string_view("\0v\0 \0001", 6)}) {
    const Error error = refusal(text);
    EXPECT_EQ(error.kind, ErrorKind::unsupported);
    EXPECT_EQ(error.text(), "is UTF-16 text; save it as UTF-8 (test.obj)");
  }
}

TEST(ObjReader, DrawsAFaceOfAMillionCorners) {
  std::string text;
  std::string face = "f";
  for (int i = 0; i < 1000000; ++i) {
    // A comb: concave everywhere, far too large for ear clipping.
    text += fmt::format("v {} {} 0\n", i, i % 2);
    face += fmt::format(" {}", i + 1);
  }
  const ReadMesh read = readObjText(text + face + "\n");
  EXPECT_EQ(read.mesh.triangleCount(), 999998U);
  EXPECT_THAT(read.rules(), ElementsAre("obj.large-face"));
}

TEST(ObjReader, StaysQuickWhenEveryCornerLiesOnOnePoint) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < 100000; ++i) text += fmt::format("vt {} 0\nf 1/-1 2/-1 3/-1\n", i);
  const ReadMesh read = readObjText(text);
  EXPECT_EQ(read.mesh.vertices.size(), 300000U);
  expectSound(read.mesh);
}

TEST(ObjReader, GivesTheSameMeshForEveryPrefixOrRefusesIt) {
  const std::string text =
      square("vt 0 1\nvn 0 0 1\ng a\nusemtl m\nf 1/1/1 2/1/1 3/1/1 4/1/1\nf 1 3 4\n");
  for (std::size_t length = 0; length <= text.size(); ++length) {
    SCOPED_TRACE(length);
    const std::string cut(text.data(), length);
    Findings faults;
    const Result<Mesh> mesh = readMeshBytes(bytesOf(cut), "cut.obj", {}, faults);
    if (mesh) expectSound(*mesh);
  }
}

}  // namespace
}  // namespace rocinante
