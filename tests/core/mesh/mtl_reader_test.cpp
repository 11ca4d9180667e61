#include <fstream>

#include "tests/core/mesh/mesh_test_support.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;
using test::ReadMesh;
using test::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

class MtlReader : public ::testing::Test {
 protected:
  void write(const fs::path& below, std::string_view text) {
    fs::create_directories((folder_ / below).parent_path());
    std::ofstream(folder_ / below) << text;
  }
  /// Reads an OBJ of one triangle with `head` before its face.
  ReadMesh read(std::string_view head, const MeshReadOptions& options = {}) {
    write("meshes/a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n" + std::string(head) + "\nf 1 2 3\n");
    ReadMesh read;
    Result<Mesh> mesh = readMeshFile(folder_ / "meshes/a.obj", options, read.faults);
    EXPECT_TRUE(mesh.ok()) << mesh.error().text();
    if (mesh) read.mesh = std::move(*mesh);
    return read;
  }
  TemporaryFolder folder_;
};

TEST_F(MtlReader, ReadsColoursOpacityAndShine) {
  write("meshes/a.mtl",
        "newmtl steel plate\nKa 1 1 1\nKd 0.5 0.25 1\nKs 0.1 0.2 0.3\nKe 0 0 0.5\nNs 96.5\nd 0.4\n"
        "illum 2\nnewmtl glass\nKd 0.5\nTr 0.75\nNs -1.96\n");
  const ReadMesh mesh = read("mtllib a.mtl\nusemtl glass");
  EXPECT_THAT(mesh.leftOut(), ElementsAre("statement `Ka`"));
  EXPECT_EQ(mesh.faults.size(), 1U);
  ASSERT_EQ(mesh.mesh.materials.size(), 2U);
  const Material& steel = mesh.mesh.materials[0];
  EXPECT_EQ(steel.name, "steel plate");
  EXPECT_EQ(steel.diffuse, glm::vec4(0.5F, 0.25F, 1, 0.4F));
  EXPECT_EQ(steel.specular, glm::vec3(0.1F, 0.2F, 0.3F));
  EXPECT_EQ(steel.emission, glm::vec3(0, 0, 0.5F));
  EXPECT_EQ(steel.shininess, 96.5F);
  EXPECT_EQ(mesh.mesh.materials[1].diffuse, glm::vec4(0.5F, 0.5F, 0.5F, 0.25F));
  EXPECT_EQ(mesh.mesh.materials[1].shininess, 0.0F);
  EXPECT_EQ(mesh.mesh.parts[0].material, 1U);
}

TEST_F(MtlReader, ReadsTextureOptionsAndNamesWithBlanks) {
  write("meshes/my picture.png", "x");
  write("meshes/a.mtl",
        "newmtl m\nmap_Kd -clamp on -s 2 3 1 -o 0.5 0.25 -bm 1 -mm 0 1 my picture.png\n"
        "newmtl n\nmap_Kd -s 4 my picture.png\n");
  const ReadMesh mesh = read("mtllib a.mtl\nusemtl m");
  EXPECT_THAT(mesh.leftOut(), ElementsAre("option `-bm`", "option `-mm`"));
  EXPECT_EQ(mesh.faults.size(), 2U);
  const Material& material = mesh.mesh.materials[0];
  EXPECT_EQ(material.wrap_u, TextureWrap::clamp_to_edge);
  EXPECT_EQ(material.wrap_v, TextureWrap::clamp_to_edge);
  EXPECT_EQ(mesh.mesh.materials[1].wrap_u, TextureWrap::repeat);
  EXPECT_EQ(material.diffuse_map, folder_ / "meshes/my picture.png");
  EXPECT_EQ(material.map_scale, glm::vec2(2, 3));
  EXPECT_EQ(material.map_offset, glm::vec2(0.5F, 0.25F));
  EXPECT_EQ(mesh.mesh.materials[1].map_scale, glm::vec2(4, 1));
}

TEST_F(MtlReader, TakesKeywordsInCapitalsAndOptionsBehindTheName) {
  write("meshes/a.png", "x");
  write("meshes/b -s 2.png", "x");
  write("meshes/a.mtl",
        "NEWMTL m\nKD 1 0 0\nMap_KD a.png -s 2 3 -clamp on\nnewmtl n\nmap_kd b -s 2.png\n"
        "newmtl o\nmap_Kd a.png -x 3\n");
  const ReadMesh mesh = read("mtllib a.mtl\nusemtl m");
  ASSERT_EQ(mesh.mesh.materials.size(), 3U);
  EXPECT_EQ(mesh.mesh.materials[0].diffuse_map, folder_ / "meshes/a.png");
  EXPECT_EQ(mesh.mesh.materials[0].map_scale, glm::vec2(2, 3));
  EXPECT_EQ(mesh.mesh.materials[0].wrap_v, TextureWrap::clamp_to_edge);
  EXPECT_EQ(mesh.mesh.materials[1].diffuse_map, folder_ / "meshes/b -s 2.png");
  EXPECT_EQ(mesh.mesh.materials[2].missing_map, "a.png -x 3") << "not an option that is known";
}

TEST_F(MtlReader, NamesEveryStatementThatItDoesNotUse) {
  write("meshes/a.mtl",
        "newmtl m\nKa 0 0 0\nNi 1\nTf 1 1 1\nillum 2\nKa 0 0 1\nNi 1.5\nTf 0 1 1\nillum 7\n"
        "map_Ka a\nmap_Ks a\nmap_d a\nbump a\nnorm a\nrefl a\nPr 1\nsharpness 9\nd -halo 0.5\n"
        "unheard 3\nunheard 4\n");
  const ReadMesh mesh = read("mtllib a.mtl\nusemtl m");
  EXPECT_THAT(
      mesh.leftOut(),
      ElementsAre("statement `Ka`", "statement `Ni`", "statement `Tf`", "statement `illum`",
                  "statement `map_Ka`", "statement `map_Ks`", "statement `map_d`",
                  "statement `bump`", "statement `norm`", "statement `refl`", "statement `Pr`",
                  "statement `sharpness`", "option `-halo`", "statement `unheard`"));
  EXPECT_EQ(mesh.faults.back().rule, "mtl.unknown-keyword");
  EXPECT_EQ(mesh.faults.back().count, 2U);
}

TEST_F(MtlReader, AMaterialMayBeUsedBeforeItsFileIsNamed) {
  write("meshes/a.mtl", "newmtl red\nKd 1 0 0\n");
  write("meshes/b.mtl", "newmtl red\nKd 0 0 1\n");
  const ReadMesh mesh = read(
      "f 1 2 3\nusemtl red\nf 1 2 3\nmtllib a.mtl\nusemtl none\nf 1 2 3\nmtllib b.mtl\nusemtl red");
  ASSERT_EQ(mesh.mesh.parts.size(), 4U);
  const auto redOf = [&](std::size_t part) {
    return mesh.mesh.materials[mesh.mesh.parts[part].material].diffuse.r;
  };
  EXPECT_EQ(redOf(0), 0.8F) << "faces before any usemtl are grey, and nobody's fault";
  EXPECT_EQ(redOf(1), 1.0F);
  EXPECT_EQ(redOf(2), 0.8F);
  EXPECT_EQ(redOf(3), 1.0F);
  EXPECT_THAT(mesh.rules(), ElementsAre("mtl.duplicate-material", "obj.unknown-material"));
  EXPECT_EQ(mesh.faults[1].text, "no material file defines `none`");
  EXPECT_EQ(mesh.faults[1].line, 8);
}

TEST_F(MtlReader, FindsTexturesNamedOnAnotherMachine) {
  write("meshes/skin.png", "x");
  write("meshes/tex/below.png", "x");
  write("meshes/a.mtl",
        "newmtl a\nmap_Kd D:\\work\\tex\\skin.png\nnewmtl b\nmap_Kd /home/me/skin.png\n"
        "newmtl c\nmap_Kd tex\\below.png\n");
  const ReadMesh mesh = read("mtllib a.mtl\nusemtl a");
  EXPECT_THAT(mesh.faults, IsEmpty());
  EXPECT_EQ(mesh.mesh.materials[0].diffuse_map, folder_ / "meshes/skin.png");
  EXPECT_EQ(mesh.mesh.materials[1].diffuse_map, folder_ / "meshes/skin.png");
  EXPECT_EQ(mesh.mesh.materials[2].diffuse_map, folder_ / "meshes/tex/below.png");
}

TEST_F(MtlReader, AsksTheResolverForEveryName) {
  write("materials/textures/skin.png", "x");
  write("meshes/a.mtl", "newmtl m\nmap_Kd skin.png\n");
  std::vector<std::string> asked;
  MeshReadOptions options;
  options.resolve = [&](const std::string& name, const fs::path& beside) {
    asked.push_back(name);
    EXPECT_EQ(beside, folder_ / "meshes");
    FoundFile found;
    found.path = (beside / name).lexically_normal();
    return fs::exists(found.path) ? found : FoundFile{};
  };
  const ReadMesh mesh = read("mtllib a.mtl\nusemtl m", options);
  EXPECT_THAT(mesh.faults, IsEmpty());
  EXPECT_EQ(mesh.mesh.materials[0].diffuse_map, folder_ / "materials/textures/skin.png");
  EXPECT_THAT(asked,
              ElementsAre("a.mtl", "skin.png", "skin.png", "../materials/textures/skin.png"));
}

TEST_F(MtlReader, OpensNothingOutsideTheFolderWithoutAResolver) {
  write("secret.mtl", "newmtl m\nKd 1 0 0\n");
  const ReadMesh mesh = read("mtllib ../secret.mtl\nmtllib x/../../secret.mtl\nusemtl m");
  EXPECT_THAT(mesh.rules(), ElementsAre("obj.missing-mtllib", "obj.missing-mtllib"));
  EXPECT_EQ(mesh.mesh.materials[0].diffuse, Material{}.diffuse);
}

TEST_F(MtlReader, NamesMissingTexturesAndKeepsTheMaterial) {
  write("meshes/a.mtl", "newmtl m\nKd 1 0 0\n\nmap_Kd gone.png\nmap_Kd\n");
  const ReadMesh mesh = read("mtllib a.mtl\nusemtl m");
  EXPECT_THAT(mesh.rules(), ElementsAre("mtl.missing-texture", "mtl.missing-texture"));
  EXPECT_EQ(mesh.faults[0].file, (folder_ / "meshes/a.mtl").string());
  EXPECT_EQ(mesh.faults[0].line, 4);
  EXPECT_EQ(mesh.faults[0].text, "the texture `gone.png` of material `m` is not found");
  EXPECT_EQ(mesh.mesh.materials[0].diffuse, glm::vec4(1, 0, 0, 1));
}

TEST_F(MtlReader, ReadsSeveralLibrariesAndOneWithBlanksInItsName) {
  write("meshes/a.mtl", "newmtl a\nKd 1 0 0\nnewmtl same\nKd 1 1 1\n");
  write("meshes/b.mtl", "newmtl b\nKd 0 1 0\nnewmtl same\nKd 0 0 0\n");
  write("meshes/my own.mtl", "newmtl c\nKd 0 0 1\n");
  const ReadMesh mesh = read("mtllib a.mtl b.mtl\nmtllib my own.mtl\nmtllib a.mtl\nusemtl c");
  ASSERT_EQ(mesh.mesh.materials.size(), 4U);
  EXPECT_EQ(mesh.mesh.materials[mesh.mesh.parts[0].material].name, "c");
  EXPECT_EQ(mesh.mesh.materials[1].diffuse.r, 1.0F) << "the first of two definitions counts";
  EXPECT_THAT(mesh.rules(), ElementsAre("mtl.duplicate-material"));
}

TEST_F(MtlReader, LibrariesMayBeQuotedOrInAFolderWithBackslashes) {
  write("meshes/a.mtl", "newmtl a\nKd 1 0 0\n");
  write("meshes/my own.mtl", "newmtl b\nKd 0 1 0\n");
  write("meshes/below/c.mtl", "newmtl c\nKd 0 0 1\n");
  const ReadMesh mesh = read("mtllib \"my own.mtl\" a.mtl  below\\c.mtl\nusemtl c");
  ASSERT_EQ(mesh.mesh.materials.size(), 3U);
  EXPECT_EQ(mesh.mesh.materials[0].name, "b");
  EXPECT_EQ(mesh.mesh.materials[1].name, "a");
  EXPECT_EQ(mesh.mesh.materials[2].diffuse, glm::vec4(0, 0, 1, 1));
  EXPECT_THAT(mesh.rules(), IsEmpty());
  EXPECT_THAT(read("mtllib \"a.mtl\nusemtl a").rules(), ElementsAre("obj.missing-mtllib"));
}

TEST_F(MtlReader, NamesMaterialsThatNoLibraryDefines) {
  write("meshes/a.mtl", "newmtl a\n");
  EXPECT_THAT(read("mtllib a.mtl\nusemtl b").rules(), ElementsAre("obj.unknown-material"));
  EXPECT_THAT(read("mtllib gone.mtl\nusemtl b").rules(), ElementsAre("obj.missing-mtllib"));
  const ReadMesh none = read("usemtl DefaultMaterial");
  EXPECT_THAT(none.faults, IsEmpty()) << "a file without materials misses none";
  EXPECT_EQ(none.mesh.materials[0].name, "DefaultMaterial");
}

TEST_F(MtlReader, ReadsWhatExportersOfTheWildMean) {
  write("meshes/my picture.png", "x");
  write("meshes/a.mtl",
        "newmtl both\nd 0.75\nTr 0.75\nnewmtl other order\nTr 1\nd 1\n"
        "newmtl black\nKd 0 0 0\nd 0.5\nmap_kd \"my picture.png\"\nnewmtl soot\nKd 0 0 0\n");
  const ReadMesh mesh = read("mtllib a.mtl\nusemtl both");
  EXPECT_THAT(mesh.faults, IsEmpty());
  ASSERT_EQ(mesh.mesh.materials.size(), 4U);
  EXPECT_EQ(mesh.mesh.materials[0].diffuse.a, 0.75F) << "where both stand, d is meant";
  EXPECT_EQ(mesh.mesh.materials[1].diffuse.a, 1.0F);
  EXPECT_EQ(mesh.mesh.materials[2].diffuse_map, folder_ / "meshes/my picture.png");
  EXPECT_EQ(mesh.mesh.materials[2].diffuse, glm::vec4(1, 1, 1, 0.5F));
  EXPECT_EQ(mesh.mesh.materials[3].diffuse, glm::vec4(0, 0, 0, 1));
}

TEST_F(MtlReader, GoesOnAfterBadLines) {
  write("meshes/a.mtl",
        "Kd 1 1 1\nnewmtl a\nKd red\nKd 0 1\nKd nan 0 0\nd\nNs x\nshiny 3\nmap_Kd -s x y.png\n"
        "Ks 5 -1 0.5\n");
  const ReadMesh mesh = read("mtllib a.mtl\nusemtl a");
  EXPECT_THAT(mesh.rules(),
              ElementsAre("mtl.no-material", "mtl.bad-number", "mtl.bad-number", "mtl.bad-number",
                          "mtl.bad-number", "mtl.bad-number", "mtl.unknown-keyword",
                          "mtl.bad-number", "mtl.missing-texture"));
  EXPECT_EQ(mesh.mesh.materials[0].diffuse, Material{}.diffuse);
  EXPECT_EQ(mesh.mesh.materials[0].specular, glm::vec3(1, 0, 0.5F)) << "held to [0, 1]";
}

}  // namespace
}  // namespace rocinante
