#include "core/bundle/bundle_manifest.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/bundle/bundle_names.h"

namespace rocinante {
namespace {

const std::string kSha(64, 'a');

BundleManifest manifest() {
  BundleManifest made;
  made.main = "demo.cell.toml";
  made.files = {{"arm/base.obj", 12, kSha}, {"demo.cell.toml", 3, std::string(64, '0')}};
  made.names = {{"", "arm/base.obj", "arm/base.obj", FoundFile::Why::found},
                {"", "gone.png", "", FoundFile::Why::missing},
                {"arm", "/home/x/base.obj", "arm/base.obj", FoundFile::Why::found_elsewhere}};
  made.search = {"search/1/share"};
  made.folders = {"models"};
  return made;
}

std::string refusalOf(const std::string& text) {
  const auto read = parseManifest(bytesOf(text), "a.mcap:cell.json");
  return read.ok() ? "" : read.error().what;
}

/// The manifest's text with `what` replaced by `with`, once.
std::string changed(const std::string& what, const std::string& with) {
  std::string text = manifestText(manifest());
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

TEST(BundleManifest, ComesBackAsItWasWritten) {
  const auto read = parseManifest(bytesOf(manifestText(manifest())), "x");
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_EQ(*read, manifest());
}

TEST(BundleManifest, NamesThatLeaveTheFolderAreRefused) {
  for (const char* name : {"/etc/passwd", "../x", "a/../../x", "a/..", "./a", "a//b", "a/", "", ".",
                           "..", "a\\\\b", "a\\u0000b", "a\\nb"}) {
    SCOPED_TRACE(name);
    EXPECT_THAT(
        refusalOf(changed("\"name\": \"arm/base.obj\"", std::string("\"name\": \"") + name + "\"")),
        testing::HasSubstr("the name of one of its files is not allowed"));
    if (std::string_view(name).empty()) continue;  // the folder itself
    EXPECT_THAT(refusalOf(changed("\"in\": \"arm\"", std::string("\"in\": \"") + name + "\"")),
                testing::HasSubstr("a folder in it has a name that is not allowed"));
    EXPECT_THAT(refusalOf(changed("\"models\"", std::string("\"") + name + "\"")),
                testing::HasSubstr("a folder in it has a name that is not allowed"));
  }
}

TEST(BundleManifest, LongNamesAreRefused) {
  EXPECT_TRUE(isBundleName(std::string(255, 'x')));
  EXPECT_FALSE(isBundleName(std::string(256, 'x')));
  std::string deep = "a";
  while (deep.size() + 2 <= 1024) deep += "/a";
  EXPECT_TRUE(isBundleName(deep));
  EXPECT_FALSE(isBundleName(deep + "/a"));
}

TEST(BundleManifest, RefusalsSayWhatIsWrong) {
  const auto says = [](const char* text) { return testing::HasSubstr(text); };
  EXPECT_THAT(refusalOf("no json"), says("it is not JSON"));
  EXPECT_THAT(refusalOf("[]"), says("it is not a JSON object"));
  EXPECT_THAT(refusalOf("{}"), says("it states no format"));
  EXPECT_THAT(refusalOf(changed("\"format\": 1", "\"format\": 2")), says("it has format 2"));
  EXPECT_THAT(refusalOf(changed("\"main\": \"demo.cell.toml\"", "\"main\": \"other\"")),
              says("its main file is not among its files"));
  EXPECT_THAT(refusalOf(changed("\"main\": \"demo.cell.toml\"", "\"main\": 7")),
              says("it lacks the string `main`"));
  EXPECT_THAT(
      refusalOf(changed("\"demo.cell.toml\",\n   \"bytes\"", "\"arm/base.obj\",\n   \"bytes\"")),
      says("arm/base.obj is in it twice"));
  EXPECT_THAT(refusalOf(changed(kSha, "ABC")),
              says("the SHA-256 of arm/base.obj is not 64 hexadecimal digits"));
  EXPECT_THAT(refusalOf(changed("\"bytes\": 12", "\"bytes\": -1")), says("the size of"));
  EXPECT_THAT(refusalOf(changed("\"bytes\": 12", "\"bytes\": 1073741824")),
              says("it is larger than 1024 MiB"));
  EXPECT_THAT(refusalOf(changed("\"bytes\": 12", "\"bytes\": 18446744073709551615")),
              says("it is larger than 1024 MiB"));
  EXPECT_THAT(refusalOf(changed("\"why\": \"missing\"", "\"why\": \"lost\"")),
              says("it gives an unknown reason"));
  EXPECT_THAT(refusalOf(changed("\"means\": \"arm/base.obj\"", "\"means\": \"arm/other.obj\"")),
              says("a name in it means a file that it does not have"));
  EXPECT_THAT(refusalOf(changed("\"search\": [", "\"search\": 1, \"x\": [")),
              says("it lacks the array `search`"));
}

TEST(BundleManifest, TextCutAnywhereIsRefused) {
  const std::string text = manifestText(manifest());
  // Without the last brace and line feed.
  for (std::size_t length = 0; length + 2 <= text.size(); ++length) {
    SCOPED_TRACE(length);
    EXPECT_NE(refusalOf(text.substr(0, length)), "");
  }
}

TEST(BundleManifest, DeepNestingIsRefusedNotFollowed) {
  EXPECT_NE(refusalOf(std::string(1'000'000, '[')), "");
  EXPECT_NE(refusalOf("{\"format\":1,\"main\":" + std::string(1'000'000, '[') +
                      std::string(1'000'000, ']') + "}"),
            "");
}

TEST(BundleManifest, ManyKeysAreReadInReasonableTime) {
  std::string text = "{\"format\":1";
  for (int i = 0; i < 500'000; ++i) text += ",\"" + std::to_string(i) + "\":0";
  EXPECT_THAT(refusalOf(text + "}"), testing::HasSubstr("it lacks the string `main`"));
}

TEST(ManifestWord, LeavesTextAndEncodesTheRest) {
  EXPECT_EQ(manifestWord("meshes/große Datei.obj"), "meshes/große Datei.obj");
  EXPECT_EQ(manifestWord("caf\xe9.png"), "caf%E9.png");
  EXPECT_EQ(manifestWord("a\nb"), "a%0Ab");
}

TEST(BundleNames, KeepWhatFilesHaveInCommonAndNoMore) {
  BundleNames names("/home/me/work/cell");
  names.addOwnRoot("/home/me/work/models");
  EXPECT_EQ(names.nameOf("/home/me/work/cell/a.cell.toml"), "cell/a.cell.toml");
  EXPECT_EQ(names.nameOf("/home/me/work/models/arm.urdf"), "models/arm.urdf");
  EXPECT_EQ(names.nameOf("/home/me/work"), "");
}

TEST(BundleNames, FoldersBesideTheCellsShareNothingWithIt) {
  BundleNames names("/home/me/cell");
  names.addOtherRoot("/opt/ros/share");
  names.addOwnRoot("/srv/models");
  EXPECT_EQ(names.nameOf("/home/me/cell/a.urdf"), "a.urdf");
  EXPECT_EQ(names.nameOf("/opt/ros/share/pkg/b.stl"), "search/1/share/pkg/b.stl");
  EXPECT_EQ(names.nameOf("/srv/models/c.stl"), "search/2/models/c.stl");
  EXPECT_EQ(names.nameOf("/elsewhere"), "");
  EXPECT_THAT(names.otherRoots(), testing::ElementsAre("search/1/share", "search/2/models"));
}

}  // namespace
}  // namespace rocinante
