#include "golden/why/file_change.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace rocinante {
namespace {

using testing::ElementsAre;

std::vector<std::string> linesOf(const std::vector<FileChange>& changes) {
  std::vector<std::string> lines;
  for (const FileChange& change : changes) lines.push_back(change.text);
  return lines;
}

TEST(FileChanges, NameWhatAFileIs) {
  EXPECT_THAT(
      linesOf(fileChanges({{"a.obj", "1"}, {"a.mtl", "1"}, {"t.PNG", "1"}, {"same.stl", "1"}},
                          {{"a.obj", "2"}, {"a.mtl", "2"}, {"same.stl", "1"}, {"b.urdf", "1"}})),
      ElementsAre("a.mtl: the materials have changed", "a.obj: the mesh has changed",
                  "b.urdf: the model is new", "t.PNG: the texture is no longer part of the cell"));
}

TEST(FileChanges, AnotherNameIsNoChange) {
  const auto lines = [](const FileHashes& golden, const FileHashes& frame) {
    return linesOf(fileChanges(golden, frame));
  };
  EXPECT_THAT(lines({{"a.urdf", "1"}, {"b.stl", "2"}}, {{"arm.urdf", "1"}, {"b.stl", "2"}}),
              ElementsAre());
  EXPECT_THAT(
      lines({{"a.urdf", "1"}}, {{"arm.urdf", "2"}}),
      ElementsAre("a.urdf: the model is no longer part of the cell", "arm.urdf: the model is new"));
  EXPECT_THAT(lines({{"a.urdf", "1"}}, {{"a.urdf", "1"}, {"copy.urdf", "1"}}),
              ElementsAre("copy.urdf: the model is new"));
  EXPECT_THAT(
      lines({{"a.urdf", "1"}}, {{"a.png", "1"}}),
      ElementsAre("a.png: the texture is new", "a.urdf: the model is no longer part of the cell"));
}

TEST(FileChanges, AFileThatIsStillNamedIsMissing) {
  const FileTexts texts = {{"1", "newmtl a\nmap_Kd textures/skin.png\n"},
                           {"2", "newmtl b\nmap_Kd textures/skin.png\n"},
                           {"3", "newmtl a\nmap_Kd oak-skin.png\n"}};
  const auto lines = [&](const FileHashes& golden, const FileHashes& frame) {
    return linesOf(fileChanges(golden, frame, texts));
  };
  EXPECT_THAT(lines({{"a.mtl", "1"}, {"textures/skin.png", "9"}}, {{"a.mtl", "1"}}),
              ElementsAre("textures/skin.png: the texture is missing, though a.mtl names it"));
  EXPECT_THAT(lines({{"a.mtl", "1"}}, {{"a.mtl", "2"}, {"textures/skin.png", "9"}}),
              ElementsAre("a.mtl: the materials have changed",
                          "textures/skin.png: the texture is there now; it was missing, though "
                          "a.mtl named it"));
  EXPECT_THAT(lines({{"a.mtl", "1"}, {"skin.png", "9"}}, {{"a.mtl", "3"}}),
              ElementsAre("a.mtl: the materials have changed",
                          "skin.png: the texture is no longer part of the cell"));
}

TEST(FileChanges, ACommentIsNoChange) {
  const FileTexts texts = {{"1", "<robot name=\"a\"><link name=\"x\"/></robot>"},
                           {"2", "<robot name=\"a\"><!-- of 2026 --><link name=\"x\"/></robot>\n"},
                           {"3", "<robot name=\"a\"><link name=\"y\"/></robot>"},
                           {"4", "name = \"a # b\"\n"},
                           {"5", "# of 2026\nname =  \"a # b\" # c"},
                           {"6", "name = \"a # c\"\n"}};
  const auto changed = [&](const char* file, const char* before, const char* now) {
    return !fileChanges({{file, before}}, {{file, now}}, texts).empty();
  };
  EXPECT_FALSE(changed("a.urdf", "1", "2"));
  EXPECT_TRUE(changed("a.urdf", "1", "3"));
  EXPECT_TRUE(changed("a.urdf", "1", "unknown"));
  EXPECT_FALSE(changed("cell.toml", "4", "5"));
  EXPECT_TRUE(changed("cell.toml", "4", "6"));
}

}  // namespace
}  // namespace rocinante
