// COLLADA and glTF: sizes, axes and sides against known dimensions, in files made here.

#include <fmt/format.h>

#include <cmath>
#include <cstring>

#include "core/math/srgb.h"
#include "core/search/file_search.h"
#include "tests/core/mesh/mesh_test_support.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"

namespace rocinante {
namespace {

using test::expectSound;
using test::ReadMesh;
using test::readMesh;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A wedge, no two sides of which are equal: 2 in x, 3 in y, 4 in z, in units of the file.
constexpr const char* kWedge = "0 0 0 2 0 0 0 3 0 0 0 4";
constexpr const char* kWedgeTurnedYUp = "0 0 0 2 0 0 0 0 -3 0 4 0";
constexpr const char* kWedgeTurnedXUp = "0 0 0 0 -2 0 0 0 -3 4 0 0";

std::string collada(double metres, const std::string& up, const std::string& points,
                    const std::string& scene =
                        "<node name=\"wedge\"><instance_geometry "
                        "url=\"#g\"/></node>",
                    const std::string& nodes = "") {
  return fmt::format(
      R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="u" meter="{}"/>{}</asset>
<library_geometries><geometry id="g" name="g"><mesh>
<source id="p"><float_array id="pa" count="12">{}</float_array><technique_common>
<accessor source="#pa" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/>
<p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles></mesh></geometry></library_geometries>
<library_nodes>{}</library_nodes>
<library_visual_scenes><visual_scene id="s">{}</visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)",
      metres, up.empty() ? "" : "<up_axis>" + up + "</up_axis>", points, nodes, scene);
}

void expectSize(const Mesh& mesh, const Vec3& min, const Vec3& max) {
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(mesh.bounds.min[i], min[i], 1e-6) << "axis " << i;
    EXPECT_NEAR(mesh.bounds.max[i], max[i], 1e-6) << "axis " << i;
  }
}

/// Six times the enclosed volume; negative when the triangles face inward.
double sixVolumes(const Mesh& mesh) {
  double sum = 0;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vec3 a(mesh.vertices[mesh.indices[i]].position);
    const Vec3 b(mesh.vertices[mesh.indices[i + 1]].position);
    const Vec3 c(mesh.vertices[mesh.indices[i + 2]].position);
    sum += glm::dot(a, glm::cross(b, c));
  }
  return sum;
}

TEST(ColladaReader, AnInchFileMeasuresAsItsTwinInMetres) {
  const ReadMesh metres = readMesh(collada(1, "Z_UP", kWedge), "a.dae");
  EXPECT_THAT(metres.faults, IsEmpty());
  expectSound(metres.mesh);
  expectSize(metres.mesh, {0, 0, 0}, {2, 3, 4});
  EXPECT_NEAR(sixVolumes(metres.mesh), 24, 1e-5);
  const ReadMesh inches = readMesh(collada(0.0254, "Z_UP", kWedge), "a.dae");
  EXPECT_THAT(inches.faults, IsEmpty());
  expectSize(inches.mesh, {0, 0, 0}, {2 * 0.0254, 3 * 0.0254, 4 * 0.0254});
}

TEST(ColladaReader, EveryUpAxisComesOutZUpAndNotMirrored) {
  struct Case {
    const char* up;
    const char* points;
  };
  for (const Case& each :
       {Case{"Y_UP", kWedgeTurnedYUp}, Case{"", kWedgeTurnedYUp}, Case{"X_UP", kWedgeTurnedXUp}}) {
    SCOPED_TRACE(each.up);
    const ReadMesh read = readMesh(collada(0.01, each.up, each.points), "a.dae");
    EXPECT_THAT(read.rules(), ElementsAre("mesh.up-axis"));
    expectSound(read.mesh);
    expectSize(read.mesh, {0, 0, 0}, {0.02, 0.03, 0.04});
    EXPECT_NEAR(sixVolumes(read.mesh), 24e-6, 1e-10);
  }
}

TEST(ColladaReader, ACommentedOutUpAxisDoesNotDecide) {
  for (const std::string up :
       {"<!-- <up_axis>Y_UP</up_axis> --><up_axis>Z_UP</up_axis>",
        "<up_axis>Z_UP</up_axis><!-- <up_axis>X_UP</up_axis> -->",
        "<up_axis><!-- Y_UP --> Z_UP</up_axis>", "<up_axis>\n\tZ_UP\r\n</up_axis>"}) {
    SCOPED_TRACE(up);
    std::string text = collada(1, "", kWedge);
    const std::size_t behind = text.find("</asset>");
    text.insert(behind, up);
    const ReadMesh read = readMesh(text, "a.dae");
    EXPECT_THAT(read.faults, IsEmpty());
    expectSize(read.mesh, {0, 0, 0}, {2, 3, 4});
  }
  // None but a commented-out one: Y_UP, by the standard.
  std::string text = collada(1, "", kWedgeTurnedYUp);
  text.insert(text.find("</asset>"), "<!-- <up_axis>Z_UP</up_axis> -->");
  const ReadMesh read = readMesh(text, "a.dae");
  EXPECT_THAT(read.rules(), ElementsAre("mesh.up-axis"));
  expectSize(read.mesh, {0, 0, 0}, {2, 3, 4});
}

TEST(ColladaReader, TheUnitMayHaveBlanksAroundIt) {
  for (const char* metres : {" 0.01", "\n 0.01 ", "1e-2 "}) {
    std::string text = collada(0.01, "Z_UP", kWedge);
    text.replace(text.find("0.01"), 4, metres);
    const ReadMesh read = readMesh(text, "a.dae");
    EXPECT_THAT(read.faults, IsEmpty());
    expectSize(read.mesh, {0, 0, 0}, {0.02, 0.03, 0.04});
  }
}

TEST(ColladaReader, AFileIsReadInEveryEncodingThatItsXmlNames) {
  std::string text = collada(1, "Z_UP", kWedge);
  text.replace(text.find("\"wedge\""), 7, "\"gr\xC3\xBCn\"");
  const auto wide = [&](bool big_endian, const std::string& mark) {
    std::string bytes = mark;
    for (std::size_t i = 0; i < text.size(); ++i) {
      const bool umlaut = text[i] == '\xC3';
      if (umlaut) ++i;
      const char low = umlaut ? '\xFC' : text[i];
      bytes += big_endian ? std::string{'\0', low} : std::string{low, '\0'};
    }
    return bytes;
  };
  std::string latin = text;
  latin.replace(latin.find("\xC3\xBC"), 2, "\xFC");
  latin.insert(latin.find("?>"), " encoding=\"ISO-8859-1\"");
  for (const std::string& bytes : {"\xEF\xBB\xBF" + text, wide(false, "\xFF\xFE"),
                                   wide(true, "\xFE\xFF"), wide(false, ""), latin}) {
    const ReadMesh read = readMesh(bytes, "a.dae");
    EXPECT_THAT(read.faults, IsEmpty());
    ASSERT_EQ(read.mesh.parts.size(), 1U);
    EXPECT_EQ(read.mesh.parts[0].group, "gr\xC3\xBCn");
    expectSize(read.mesh, {0, 0, 0}, {2, 3, 4});
  }
  Findings faults;
  text.insert(text.find("?>"), " encoding=\"Shift_JIS\"");
  text.replace(text.find("\xC3\xBC"), 2, "\x83\x41");
  const auto refused = readMeshBytes(bytesOf(text), "a.dae", {}, faults);
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().text(),
            "the file is in the encoding `shift_jis`, which is not read: save it as UTF-8 (a.dae)");
}

TEST(ColladaReader, ASkewLeansItsFirstAxisTowardsItsSecond) {
  const auto skewed = [](const std::string& numbers) {
    return readMesh(
        collada(1, "Z_UP", kWedge,
                "<node><skew>" + numbers + "</skew><instance_geometry url=\"#g\"/></node>"),
        "a.dae");
  };
  // z leans towards x by 45 degrees: its end moves by its height.
  const ReadMesh upright = skewed("45 0 0 2 3 0 0");
  EXPECT_THAT(upright.faults, IsEmpty());
  expectSize(upright.mesh, {0, 0, 0}, {4, 3, 4});
  EXPECT_NEAR(sixVolumes(upright.mesh), 24, 1e-4);
  // Axes that are not perpendicular: x leans along (1, 0, 1) until it is 30 degrees from where it
  // was, and what lies across stays.
  const ReadMesh oblique = skewed("30 1 0 0 1 0 1");
  const glm::vec3 end = oblique.mesh.vertices[2].position;
  EXPECT_NEAR(end.z / end.x, std::tan(M_PI / 6), 1e-5);
  EXPECT_NEAR((end.x - 2) / end.z, 1, 1e-5) << "moved along the second axis";
  EXPECT_NEAR(sixVolumes(oblique.mesh), 24, 1e-4);
  // No matrix leans an axis that far.
  for (const std::string numbers : {"90 0 0 1 1 0 0", "-90 0 0 1 1 0 0", "45 1 0 0 1 0 0",
                                    "45 0 0 0 1 0 0", "46 1 0 0 1 0 1", "1e400 0 0 1 1 0 0"}) {
    SCOPED_TRACE(numbers);
    const ReadMesh plain = skewed(numbers);
    EXPECT_THAT(plain.rules(), ElementsAre("collada.bad-value"));
    expectSize(plain.mesh, {0, 0, 0}, {2, 3, 4});
  }
}

TEST(ColladaReader, TransformsOfNodesAreAppliedAndEachPlaceIsAPart) {
  const ReadMesh read = readMesh(
      collada(1, "Z_UP", kWedge,
              "<node name=\"far\"><translate>10 0 0</translate><node name=\"turned\">"
              "<rotate>0 0 1 90</rotate><scale>1 1 -1</scale><instance_geometry url=\"#g\"/></node>"
              "</node><node name=\"near\"><instance_node url=\"#lib\"/></node>",
              "<node id=\"lib\" name=\"lib\"><translate>0 0 1</translate>"
              "<instance_geometry url=\"#g\"/></node>"),
      "a.dae");
  EXPECT_THAT(read.faults, IsEmpty());
  ASSERT_EQ(read.mesh.parts.size(), 2U);
  EXPECT_EQ(read.mesh.parts[0].group, "turned");
  EXPECT_EQ(read.mesh.parts[1].group, "lib");
  // x to y, y to -x; mirrored in z.
  expectSize(read.mesh, {0, 0, -4}, {10, 3, 5});
  EXPECT_NEAR(sixVolumes(read.mesh), 48, 1e-4) << "a mirrored part keeps its outside";
  expectSound(read.mesh);
}

TEST(ColladaReader, NodesThatContainThemselvesAreRefused) {
  const std::string self = "<node id=\"a\"><instance_node url=\"#b\"/></node>";
  std::string problem;
  for (const std::string& nodes :
       {std::string("<node id=\"b\"><instance_node url=\"#b\"/></node>"),
        std::string("<node id=\"b\"><node><instance_node url=\"#a\"/></node></node>")}) {
    Findings faults;
    const auto mesh =
        readMeshBytes(bytesOf(collada(1, "Z_UP", kWedge, self, nodes)), "a.dae", {}, faults);
    ASSERT_FALSE(mesh.ok());
    EXPECT_EQ(mesh.error().text(), "a <node> contains itself by way of <instance_node> (a.dae)");
  }
  std::string doubling;
  for (int i = 0; i < 40; ++i) {
    doubling += fmt::format(
        "<node id=\"n{}\"><instance_node url=\"#n{}\"/><instance_node url=\"#n{}\"/></node>", i,
        i + 1, i + 1);
  }
  Findings faults;
  const std::string first = "<node id=\"a\"><instance_node url=\"#n0\"/></node>";
  const auto mesh =
      readMeshBytes(bytesOf(collada(1, "Z_UP", kWedge, first, doubling)), "a.dae", {}, faults);
  ASSERT_FALSE(mesh.ok());
  EXPECT_EQ(mesh.error().what, "its nodes expand to more than 1000000 nodes");
}

TEST(ColladaReader, WhatIsNotColladaIsToldInOneSentence) {
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<node>";
  for (const auto& [text, sentence] : std::initializer_list<std::pair<std::string, std::string>>{
           {deep, "the XML is nested deeper than 100 elements (a.dae)"},
           {"PK\x03\x04", "is a ZIP file; unpack it and name the .dae inside (a.dae)"}}) {
    Findings faults;
    const auto mesh = readMeshBytes(bytesOf(text), "a.dae", {}, faults);
    ASSERT_FALSE(mesh.ok());
    EXPECT_EQ(mesh.error().text(), sentence);
  }
  for (const std::string text : {"", "no XML", "<COLLADA/>", "<COLLADA><library_geometries/>"}) {
    Findings faults;
    const auto mesh = readMeshBytes(bytesOf(text), "a.dae", {}, faults);
    ASSERT_FALSE(mesh.ok());
    EXPECT_THAT(mesh.error().text(), HasSubstr("a.dae"));
    EXPECT_EQ(mesh.error().text().find('\n'), std::string::npos);
  }
}

/// glTF of the same wedge, y up in metres as the format demands.
struct Gltf {
  std::string binary;
  std::string images, textures,
      material = R"({"pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,1,1]}})";
  std::string node = R"({"name":"wedge","mesh":0})";
  std::string extra;
  std::string buffer_uri;

  Gltf() {
    const float points[] = {0, 0, 0, 2, 0, 0, 0, 0, -3, 0, 4, 0};
    const float places[] = {0, 0, 1, 0, 0, 1, 0.25F, 0.75F};
    const std::uint8_t colors[] = {255, 0, 0,   255, 0,   255, 0,   255,
                                   0,   0, 255, 255, 255, 255, 255, 255};
    const std::uint16_t corners[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    add(points, sizeof points);
    add(places, sizeof places);
    add(colors, sizeof colors);
    add(corners, sizeof corners);
  }
  void add(const void* from, std::size_t bytes) {
    binary.append(static_cast<const char*>(from), bytes);
  }

  std::string text(
      const std::string& attributes = R"("POSITION":0,"TEXCOORD_0":1,"COLOR_0":2)") const {
    return fmt::format(
        R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{}],
"meshes":[{{"primitives":[{{"attributes":{{{}}},"indices":3,"material":0}}]}}],"materials":[{}],
"accessors":[{{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,-3],"max":[2,4,0]}},
{{"bufferView":1,"componentType":5126,"count":4,"type":"VEC2"}},
{{"bufferView":2,"componentType":5121,"normalized":true,"count":4,"type":"VEC4"}},
{{"bufferView":3,"componentType":5123,"count":12,"type":"SCALAR"}}],
"bufferViews":[{{"buffer":0,"byteLength":48}},{{"buffer":0,"byteOffset":48,"byteLength":32}},
{{"buffer":0,"byteOffset":80,"byteLength":16}},{{"buffer":0,"byteOffset":96,"byteLength":24}}{}],
"buffers":[{{"byteLength":{}{}}}]{}}})",
        node, attributes, material,
        images.empty() ? ""
                       : fmt::format(R"(,{{"buffer":0,"byteOffset":120,"byteLength":{}}})",
                                     binary.size() - 120),
        binary.size(), buffer_uri.empty() ? "" : R"(,"uri":")" + buffer_uri + "\"", extra + images);
  }

  std::string glb() const { return glb(text()); }
  std::string glb(std::string json) const {
    while (json.size() % 4 != 0) json += ' ';
    std::string data = binary;
    while (data.size() % 4 != 0) data += '\0';
    const auto word = [](std::size_t value) {
      const auto narrow = static_cast<std::uint32_t>(value);
      return std::string(reinterpret_cast<const char*>(&narrow), 4);
    };
    return "glTF" + word(2) + word(28 + json.size() + data.size()) + word(json.size()) + "JSON" +
           json + word(data.size()) + std::string("BIN\0", 4) + data;
  }
};

TEST(GltfReader, AYUpMetreFileStandsUprightAndKeepsItsSize) {
  const ReadMesh read = readMesh(Gltf().glb(), "a.glb");
  EXPECT_THAT(read.faults, IsEmpty());
  expectSound(read.mesh);
  expectSize(read.mesh, {0, 0, 0}, {2, 3, 4});
  EXPECT_NEAR(sixVolumes(read.mesh), 24, 1e-5);
  ASSERT_EQ(read.mesh.parts.size(), 1U);
  EXPECT_EQ(read.mesh.parts[0].group, "wedge");
}

TEST(GltfReader, ColoursAreEncodedAndTexturePlacesCountFromTheBottom) {
  const ReadMesh read = readMesh(Gltf().glb(), "a.glb");
  const glm::vec4 diffuse = read.mesh.materials.at(read.mesh.parts.at(0).material).diffuse;
  EXPECT_NEAR(diffuse.r, 0.735357, 1e-5);  // the curve of IEC 61966-2-1 at 0.5
  EXPECT_NEAR(diffuse.g, 0.537099, 1e-5);
  EXPECT_EQ(diffuse.b, 1.0F);
  ASSERT_EQ(read.mesh.colors.size(), read.mesh.vertices.size());
  for (std::size_t i = 0; i < read.mesh.vertices.size(); ++i) {
    const Vertex& vertex = read.mesh.vertices[i];
    if (vertex.position.x == 2) {
      EXPECT_EQ(read.mesh.colors[i], 0x00FF00FFU);
    }
    if (vertex.position.z == 4) {
      EXPECT_EQ(vertex.texture, glm::vec2(0.25F, 0.25F)) << "0.75 from the top";
    }
  }
}

TEST(GltfReader, PicturesInsideTheFileComeWithTheirBytes) {
  Gltf file;
  file.binary += "picture!";
  file.images = R"(,"images":[{"bufferView":4,"mimeType":"image/png"}],"textures":[{"source":0}])";
  file.material = R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})";
  const ReadMesh read = readMesh(file.glb(), "a.glb");
  EXPECT_THAT(read.faults, IsEmpty());
  const Material& material = read.mesh.materials.at(read.mesh.parts.at(0).material);
  EXPECT_EQ(material.diffuse_map, "a.glb#1");
  ASSERT_TRUE(material.diffuse_bytes);
  EXPECT_EQ(textOf(*material.diffuse_bytes), "picture!");
}

TEST(GltfReader, FilesBesideItAreReadByTheSearchAlone) {
  const test::TemporaryFolder folder;
  Gltf file;
  test::writeFile(folder / "robot/the points.bin", file.binary);
  test::writeFile(folder / "outside.bin", file.binary);
  test::writeFile(folder / "robot/skin.png", "x");
  FileSearch search;
  ASSERT_TRUE(search.addRoot(folder / "robot").ok());
  MeshReadOptions options;
  options.resolve = [&](const std::string& name, const std::filesystem::path& beside) {
    return search.find(name, beside);
  };
  file.images = R"(,"images":[{"uri":"skin.png"}],"textures":[{"source":0}])";
  file.material = R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})";
  file.buffer_uri = "the%20points.bin";
  test::writeFile(folder / "robot/a.gltf", file.text());
  Findings faults;
  const auto sound = readMeshFile(folder / "robot/a.gltf", options, faults);
  ASSERT_TRUE(sound.ok()) << sound.error().text();
  expectSize(*sound, {0, 0, 0}, {2, 3, 4});
  EXPECT_THAT(faults, IsEmpty());
  EXPECT_EQ(sound->materials.at(0).diffuse_map, folder / "robot/skin.png");

  for (const char* uri :
       {"../outside.bin", "/etc/passwd", "../../../../../../etc/passwd", "file:///etc/passwd",
        "%2e%2e/outside.bin", "https://example.com/a.bin"}) {
    SCOPED_TRACE(uri);
    file.buffer_uri = uri;
    test::writeFile(folder / "robot/a.gltf", file.text());
    const auto refused = readMeshFile(folder / "robot/a.gltf", options, faults);
    ASSERT_FALSE(refused.ok());
    EXPECT_THAT(refused.error().text(), HasSubstr("which is not found within the search roots"));
  }
}

TEST(GltfReader, MissingTexturesAreNamed) {
  Gltf file;
  file.images = R"(,"images":[{"uri":"no.png"}],"textures":[{"source":0}])";
  file.material = R"({"name":"paint","pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})";
  const ReadMesh read = readMesh(file.glb(), "a.glb");
  ASSERT_THAT(read.rules(), ElementsAre("mesh.missing-texture"));
  EXPECT_EQ(read.faults[0].text, "the texture `no.png` of material `paint` is not found");
}

TEST(GltfReader, NumbersThatLeadNowhereAreRefusedBeforeTheLibrarySeesThem) {
  const Gltf sound;
  struct Change {
    const char* from;
    const char* to;
    const char* sentence;
  };
  for (const Change& change : {
           Change{R"("count":12)", R"("count":13)",
                  "accessors[3]: goes past the end of its bufferView"},
           {R"("byteLength":48})", R"("byteLength":4000000})",
            "bufferViews[0]: goes past the end of its buffer"},
           {R"("buffers":[{"byteLength":)", R"("buffers":[{"byteLength":9)",
            "buffers[0]: says 9120 bytes, and the binary chunk has 120"},
           {R"("POSITION":0)", R"("POSITION":9)",
            "meshes[0]: `POSITION` is not an index into the 4 accessors"},
           {R"("TEXCOORD_0":1)", R"("TEXCOORD_0":3)", "meshes[0]: TEXCOORD_0 has the wrong type"},
           {R"("mesh":0)", R"("mesh":7)", "nodes[0]: `mesh` is not an index into the 1 meshes"},
           {R"("mesh":0)", R"("mesh":0,"children":[0])", "a node is its own descendant"},
           {R"("mesh":0)", R"("mesh":0,"matrix":[1])", "nodes[0]: a transform is not 16 numbers"},
           {R"("nodes":[0])", R"("nodes":[1])",
            "scenes[0]: holds something that is not an index "
            "into the 1 nodes"},
           {R"("material":0)", R"("material":5)",
            "meshes[0]: `material` is not an index into the 1 materials"},
           {R"("version":"2.0")", R"("version":"1.0")", "is glTF 1.0; only 2 is read"},
           {R"("scene":0)", R"("extensionsRequired":["KHR_draco_mesh_compression"])",
            "requires KHR_draco_mesh_compression, which is not read"},
       }) {
    SCOPED_TRACE(change.sentence);
    std::string text = sound.text();
    const std::size_t at = text.find(change.from);
    ASSERT_NE(at, std::string::npos);
    text.replace(at, std::strlen(change.from), change.to);
    Findings faults;
    const auto mesh = readMeshBytes(bytesOf(sound.glb(text)), "a.glb", {}, faults);
    ASSERT_FALSE(mesh.ok());
    EXPECT_EQ(mesh.error().what, change.sentence);
  }
}

TEST(GltfReader, SurvivesEveryPrefix) {
  const std::string whole = Gltf().glb();
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const std::string cut = whole.substr(0, length);
    Findings faults;
    EXPECT_FALSE(readMeshBytes(bytesOf(cut), "a.glb", {}, faults).ok()) << length;
  }
}

TEST(Srgb, TheCurveMeetsItsEndsAndItsKnownPoints) {
  EXPECT_EQ(srgbOfLinear(0), 0);
  EXPECT_EQ(srgbOfLinear(1), 1);
  EXPECT_EQ(srgbOfLinear(NAN), 0);
  for (double linear = 0.0032; linear < 1; linear += 0.0007) {
    EXPECT_NEAR(srgbOfLinear(linear), 1.055 * std::pow(linear, 1 / 2.4) - 0.055, 1e-12);
  }
}

TEST(ColladaReader, TheReactorInInchesStandsAsTallAsInTheYardInMetres) {
  ROCINANTE_NEEDS_SHARED_DATA("env/gazebo_originals/reactor");
  FileSearch search;
  const auto folder = test::sharedData("env/gazebo_originals/reactor");
  ASSERT_TRUE(search.addRoot(folder).ok());
  MeshReadOptions options;
  options.resolve = [&](const std::string& name, const std::filesystem::path& beside) {
    return search.find(name, beside);
  };
  Findings faults;
  const auto reactor = readMeshFile(folder / "meshes/reactor.dae", options, faults);
  ASSERT_TRUE(reactor.ok()) << reactor.error().text();
  EXPECT_EQ(countOf(faults, Severity::note), faults.size());
  expectSound(*reactor);
  EXPECT_EQ(reactor->materials.at(0).diffuse_map.filename(), "reactor_diffuse.jpg");

  const auto yard = readMeshFile(test::sharedData("env/waste_yard/waste_yard.obj"), {}, faults);
  ASSERT_TRUE(yard.ok());
  Bounds in_yard;
  std::size_t triangles = 0;
  for (const MeshPart& part : yard->parts) {
    if (part.group != "reactor_1") continue;
    triangles += part.index_count / 3;
    for (std::uint32_t i = 0; i < part.index_count; ++i) {
      in_yard.add(Vec3(yard->vertices[yard->indices[part.first_index + i]].position));
    }
  }
  EXPECT_EQ(reactor->triangleCount(), triangles);
  EXPECT_NEAR(reactor->bounds.max.z - reactor->bounds.min.z, in_yard.max.z - in_yard.min.z, 1e-3);
}

}  // namespace
}  // namespace rocinante
