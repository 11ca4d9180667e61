#include "golden/approval/manifest.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/base/atomic_file.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

AcceptedPicture accepted(std::string key, std::string pixels) {
  std::string file = "pick." + pixels + ".png";
  return {std::move(key), std::move(file), std::move(pixels), "inputs",
          "session",      "ada",           "2026-02-03",      "first"};
}

TEST(Manifest, AFolderWithoutOneHasNoGoldens) {
  const test::TemporaryFolder folder;
  const auto manifest = Manifest::read(folder.path());
  ASSERT_TRUE(manifest.ok());
  EXPECT_TRUE(manifest->cases.empty());
}

TEST(Manifest, WhatIsWrittenIsRead) {
  const test::TemporaryFolder folder;
  Manifest manifest;
  manifest.accept("pick", accepted("llvmpipe 640x480 4x", "aa"));
  manifest.accept("pick", accepted("other 640x480 4x", "bb"));
  ASSERT_TRUE(manifest.write(folder.path()).ok());
  const auto read = Manifest::read(folder.path());
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->cases, manifest.cases);
}

TEST(Manifest, AcceptingReplacesThePictureOfTheSameKeyAlone) {
  Manifest manifest;
  manifest.accept("pick", accepted("a 640x480 4x", "old"));
  manifest.accept("pick", accepted("b 640x480 4x", "other"));
  manifest.accept("pick", accepted("a 640x480 4x", "new"));
  ASSERT_EQ(manifest.find("pick", "a 640x480 4x").size(), 1U);
  EXPECT_EQ(manifest.find("pick", "a 640x480 4x").front()->pixels, "new");
  EXPECT_EQ(manifest.find("pick", "b 640x480 4x").front()->pixels, "other");
  EXPECT_TRUE(manifest.find("place", "a 640x480 4x").empty());
}

TEST(Manifest, SeveralPicturesOfOneKeyStandBesideEachOther) {
  Manifest manifest;
  manifest.accept("pick", accepted("a 640x480 4x", "one"), true);
  manifest.accept("pick", accepted("a 640x480 4x", "two"), true);
  manifest.accept("pick", accepted("a 640x480 4x", "two"), true);
  EXPECT_EQ(manifest.find("pick", "a 640x480 4x").size(), 2U);
  EXPECT_EQ(manifest.files(), (std::set<std::string>{"pick.one.png", "pick.two.png"}));
  manifest.accept("pick", accepted("a 640x480 4x", "three"));
  EXPECT_EQ(manifest.find("pick", "a 640x480 4x").size(), 1U);
}

TEST(Manifest, RemembersWhereMasksLay) {
  const test::TemporaryFolder folder;
  Manifest manifest;
  AcceptedPicture masked = accepted("a 640x480 4x", "aa");
  masked.areas = "pick.areas.png";
  masked.areas_pixels = "bb";
  manifest.accept("pick", masked);
  ASSERT_TRUE(manifest.write(folder.path()).ok());
  const auto read = Manifest::read(folder.path());
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->cases, manifest.cases);
}

TEST(Manifest, RemembersTheDevicesThatAPictureJudges) {
  const test::TemporaryFolder folder;
  Manifest manifest;
  AcceptedPicture covered = accepted("a 640x480 4x", "aa");
  covered.coverage = {"arm", "gantry"};
  manifest.accept("pick", covered);
  covered = accepted("a 640x480 4x", "bb");
  covered.coverage.emplace();  // none is not unknown
  manifest.accept("place", covered);
  manifest.accept("old", accepted("a 640x480 4x", "cc"));
  ASSERT_TRUE(manifest.write(folder.path()).ok());
  const auto read = Manifest::read(folder.path());
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->cases, manifest.cases);
  for (const char* wrong : {"\"arm\"", "[1]"}) {
    const std::string text = fmt::format(
        R"({{"format": 1, "cases": {{"pick": [{{"key": "k", "picture": "a.png", "pixels": "aa",
            "coverage": {}}}]}}}})",
        wrong);
    EXPECT_FALSE(Manifest::parse(text, "manifest.json").ok()) << wrong;
  }
}

TEST(Manifest, RemembersTheFilesOfTheCellThatPicturesWereAcceptedOf) {
  const test::TemporaryFolder folder;
  const std::string text = "format = 1\n";
  const FileHashes files{{"arm.obj", "aa"}, {"arm.toml", fileSha256(bytesOf(text))}};
  Manifest manifest;
  AcceptedPicture drawn = accepted("a 640x480 4x", "aa");
  drawn.cell = cellKey(files);
  manifest.cells[drawn.cell] = files;
  manifest.cells["nobody's"] = {{"old.obj", "cc"}};
  manifest.texts = {{files.at("arm.toml"), text}, {fileSha256(bytesOf("old")), "old"}};
  manifest.accept("pick", drawn);
  manifest.dropUnusedCells();
  ASSERT_TRUE(manifest.write(folder.path()).ok());

  const auto read = Manifest::read(folder.path());
  ASSERT_TRUE(read.ok());
  EXPECT_EQ(read->cases, manifest.cases);
  EXPECT_EQ(read->cells, (std::map<std::string, FileHashes>{{drawn.cell, files}}));
  EXPECT_EQ(read->texts, (FileTexts{{files.at("arm.toml"), text}})) << "of files that count";
  const FileHashes* const found = read->cellOf(*read->find("pick", "a 640x480 4x").front());
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(*found, files);
  EXPECT_EQ(read->cellOf(accepted("a 640x480 4x", "of a folder without cells")), nullptr);
  EXPECT_NE(cellKey(files), cellKey({{"arm.obj", "ab"}, {"arm.toml", "bb"}}));
}

TEST(Manifest, ATextThatIsNotWhatItsHashSaysIsLeftOut) {
  const std::string hash = fileSha256(bytesOf("true"));
  for (const std::string& texts : {fmt::format(R"({{"{}": "false"}})", hash), std::string("[]"),
                                   fmt::format(R"({{"{}": 7}})", hash)}) {
    const auto manifest = Manifest::parse(
        fmt::format(R"({{"format": 1, "cases": {{}}, "texts": {}}})", texts), "manifest.json");
    ASSERT_TRUE(manifest.ok()) << texts;
    EXPECT_TRUE(manifest->texts.empty()) << texts;
  }
}

TEST(Manifest, CellsThatAreNoneExplainNothingAndJudgeAsBefore) {
  for (const std::string_view cells :
       {"[]", "7", R"({"k": []})", R"({"k": {"arm.obj": 7}})", R"({"": {}})"}) {
    const auto manifest = Manifest::parse(
        fmt::format(R"({{"format": 1, "cases": {{}}, "cells": {}}})", cells), "manifest.json");
    ASSERT_TRUE(manifest.ok()) << cells;
    for (const auto& [key, files] : manifest->cells) EXPECT_TRUE(files.empty()) << cells;
  }
}

TEST(Manifest, EqualPixelsAreFoundUnderAnyKeyAndThoseOfTheOwnOneFirst) {
  Manifest manifest;
  manifest.accept("pick", accepted("a 640x480 4x", "x"));
  AcceptedPicture own = accepted("b 640x480 4x", "x");
  own.picture = "own.png";
  manifest.accept("pick", own);
  manifest.accept("pick", accepted("c 640x480 4x", "y"));
  const auto found = manifest.findPixels("pick", "x", "b 640x480 4x");
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(*found[0], own);
  EXPECT_EQ(found[1]->key, "a 640x480 4x");
  EXPECT_EQ(manifest.findPixels("pick", "y", "b 640x480 4x").size(), 1U);
  EXPECT_TRUE(manifest.findPixels("pick", "z", "b 640x480 4x").empty());
  EXPECT_TRUE(manifest.findPixels("place", "x", "b 640x480 4x").empty());
  EXPECT_EQ(manifest.findAll("pick").size(), 3U);
}

TEST(Manifest, AKeyIsARendererAndAShape) {
  EXPECT_EQ(rendererOf("llvmpipe-x 640x480 4x"), "llvmpipe-x");
  EXPECT_EQ(shapeOf("llvmpipe-x 640x480 4x"), "640x480 4x");
  EXPECT_EQ(shapeOf("llvmpipe-x"), "");
  EXPECT_EQ(shapeOf("llvmpipe-x "), "");
  EXPECT_EQ(rendererOf(""), "");
}

TEST(Manifest, AKeyWithAPackagesRevisionIsThatOfItsVersion) {
  const auto manifest = Manifest::parse(
      R"({"format": 1, "cases": {"pick": [
        {"key": "llvmpipe-mesa25.0.7-2-llvm19.1.7-x86_64-sse4.1 8x8 1x", "picture": "a.png",
         "pixels": "aa"},
        {"key": "llvmpipe-mesa25.0.7-2+deb13u1-llvm19.1.7-x86_64-sse4.1 8x8 1x",
         "picture": "b.png", "pixels": "bb"}]}})",
      "manifest.json");
  ASSERT_TRUE(manifest.ok()) << manifest.error().text();
  const std::string key = "llvmpipe-mesa25.0.7-llvm19.1.7-x86_64-sse4.1 8x8 1x";
  EXPECT_EQ(manifest->find("pick", key).size(), 2U);
  // What is approved next takes the place of both.
  Manifest after = *manifest;
  after.accept("pick", accepted(key, "cc"));
  EXPECT_EQ(after.files(), std::set<std::string>{"pick.cc.png"});
}

TEST(Manifest, ABrokenOneIsToldWithItsFile) {
  const test::TemporaryFolder folder;
  const auto faultOf = [&](std::string_view text) {
    EXPECT_TRUE(writeFileWhole(folder / "manifest.json", bytesOf(text), true).ok());
    const auto manifest = Manifest::read(folder.path());
    return manifest.ok() ? std::string("none") : manifest.error().what;
  };
  EXPECT_EQ(faultOf("{"), "the manifest of goldens is broken: it is not JSON");
  EXPECT_EQ(faultOf("{\"format\": 2}"), "the manifest of goldens has a format other than 1");
  EXPECT_EQ(faultOf("{\"format\": 1}"), "the manifest of goldens is broken: it has no `cases`");
  EXPECT_EQ(faultOf("{\"format\":1,\"cases\":{\"a\":[{\"key\":\"k\",\"pixels\":\"p\","
                    "\"picture\":\"../../etc/passwd\"}]}}"),
            "the manifest of goldens is broken: a picture of case `a` lacks its key, its pixel "
            "hash or a plain file name");
  const auto named = [&](const std::string& picture) {
    return faultOf(
        "{\"format\":1,\"cases\":{\"a\":[{\"key\":\"k\",\"pixels\":\"p\",\"picture\":\"" + picture +
        "\"}]}}");
  };
  EXPECT_EQ(named("a.png"), "none");
  for (const char* hostile : {"manifest.json", ".a.png", "..", ".png", "a\\u0000.png", "a\\n.png",
                              "a/b.png", "\\u001b[2J.png", "caf\\u00e9.png"}) {
    EXPECT_NE(named(hostile), "none") << hostile;
  }
}

TEST(Manifest, WhatAMergeLeftIsToldWithItsLine) {
  const auto faultOf = [](std::string_view text) {
    const auto manifest = Manifest::parse(text, "goldens/manifest.json");
    return manifest.ok() ? std::string("none") : manifest.error().text();
  };
  EXPECT_EQ(faultOf("{\n  \"format\": 1,\n<<<<<<< HEAD\n  \"cases\": {}\n=======\n>>>>>>> b\n}\n"),
            "the manifest of goldens holds a conflict of a git merge: take one side of the folder "
            "(`git checkout --ours` or `--theirs`, pictures too), then approve what is drawn "
            "(goldens/manifest.json:3:1)");
  EXPECT_EQ(faultOf("{\"format\": 1,\n \"cases\": {},\n}"),
            "the manifest of goldens is broken: it is not JSON (goldens/manifest.json:3:1)");
  // Of two of one name, one would be forgotten.
  EXPECT_EQ(faultOf("{\"format\":1,\"cases\":{\"a\":[],\"b\":[],\"a\":[]}}"),
            "the manifest of goldens is broken: it has case `a` twice (goldens/manifest.json)");
  EXPECT_EQ(faultOf("{\"format\":1,\"cases\":{\"cases\":[]},\"cells\":{\"a\":{},\"a\":{}}}"),
            "none");
}

TEST(Manifest, TwoGoldensInOneFileAreRefused) {
  const test::TemporaryFolder folder;
  const std::string entry = R"({"key":"K","pixels":"P","picture":"a.png"})";
  const std::string text = "{\"format\":1,\"cases\":{\"a\":[" + entry + "],\"b\":[" + entry + "]}}";
  ASSERT_TRUE(writeFileWhole(folder / "manifest.json", bytesOf(text), true).ok());
  const auto manifest = Manifest::read(folder.path());
  ASSERT_FALSE(manifest.ok());
  EXPECT_EQ(manifest.error().what,
            "the manifest of goldens is broken: two goldens share the file a.png");
}

TEST(GoldenFileName, DiffersByKey) {
  EXPECT_NE(goldenFileName("pick", "a"), goldenFileName("pick", "b"));
  EXPECT_TRUE(goldenFileName("pick", "a").starts_with("pick."));
}

}  // namespace
}  // namespace rocinante
