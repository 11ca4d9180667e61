#include "viewer/bake/cell_cache.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>

#include "core/base/atomic_file.h"
#include "core/report/finding.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"
#include "viewer/bake/bake_cell.h"
#include "viewer/bake/cell_inputs.h"
#include "viewer/picture/picture.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTriangle =
    "mtllib part.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
    "usemtl skin\nf 1/1 2/2 3/3\n";

class CellCacheTest : public testing::Test {
 protected:
  CellCacheTest() {
    test::writeFile(folder_ / "cell/meshes/part.obj", kTriangle);
    fs::create_directory(folder_ / "cell/more");
    test::writeFile(folder_ / "cell/meshes/part.mtl", "newmtl skin\nKd 1 1 1\nmap_Kd skin.png\n");
    EXPECT_TRUE(writePng(folder_ / "cell/meshes/skin.png", {1, 1, {9, 8, 7, 255}}).ok());
    test::writeFile(cellFile(), cellText("meshes/part.obj"));
    // Files that are seconds old are not trusted to be what was read; this hour all are old.
    cache_.tellTimeBy([] {
      return std::chrono::time_point_cast<Nanoseconds>(std::chrono::system_clock::now()) +
             std::chrono::hours(1);
    });
  }

  static std::string cellText(const std::string& mesh) {
    return "format = 1\nsearch = [\"more\"]\n[[model]]\nname = \"part\"\nobj = \"" + mesh +
           "\"\nunit = \"m\"\nup = \"z\"\n[[device]]\nname = \"one\"\nmodel = \"part\"\n";
  }
  fs::path cellFile() const { return folder_ / "cell/a.cell.toml"; }
  fs::path kept() const {
    std::error_code none;
    const fs::directory_iterator first(folder_ / "cache", none);
    return none || first == fs::directory_iterator() ? fs::path() : first->path();
  }
  std::size_t keptCount() const {
    std::error_code none;
    const fs::directory_iterator entries(folder_ / "cache", none);
    return none ? 0 : static_cast<std::size_t>(std::distance(begin(entries), end(entries)));
  }
  /// Loads through the cache.
  Cell load(const CellOptions& options = {}) const {
    auto cell = cache_.load(cellFile(), options);
    EXPECT_TRUE(cell.ok()) << cell.error().text();
    return cell.ok() ? std::move(*cell) : Cell{};
  }
  /// Equal to the cell as it is loaded without a cache, with its pictures' pixels.
  void expectAsLoaded(const Cell& cell, const CellOptions& options = {}) const {
    const auto plain = loadCell(cellFile(), options);
    ASSERT_TRUE(plain.ok());
    BakeOptions bare;
    bare.pictures = false;
    EXPECT_EQ(bakeCell(cell, bare), bakeCell(*plain, bare));
    EXPECT_EQ(bakeCell(cell, {}), bakeCell(*plain, {}));
  }
  /// A load makes a new entry only if the kept one was not used.
  bool isUsedAgain(const CellOptions& options = {}) const {
    const fs::path entry = kept();
    if (entry.empty()) return false;
    const std::string marker = entry.string() + ".seen";
    fs::create_hard_link(entry, marker);
    expectAsLoaded(load(options), options);
    // A new entry is another file of this name.
    const bool same = fs::equivalent(entry, marker);
    fs::remove(marker);
    return same;
  }

  const test::TemporaryFolder folder_;
  CellCache cache_{folder_ / "cache", CellCache::kDefaultBytes, 0};
};

TEST_F(CellCacheTest, KeepsACellAndGivesItBack) {
  const Cell first = load();
  expectAsLoaded(first);
  EXPECT_EQ(first.pictures.size(), 1U) << "decoded once, while it was kept";
  ASSERT_EQ(keptCount(), 1U);
  EXPECT_TRUE(isUsedAgain());
  const Cell second = load();
  expectAsLoaded(second);
  ASSERT_EQ(second.pictures.size(), 1U);
  const auto picture = decodePng(second.pictures.begin()->second, "p");
  ASSERT_TRUE(picture.ok());
  EXPECT_EQ(picture->rgba, (std::vector<std::uint8_t>{9, 8, 7, 255}));
}

TEST_F(CellCacheTest, AChangeOfAnyFileIsSeenEvenIfItsSizeAndTimeAreAsBefore) {
  for (const char* name :
       {"a.cell.toml", "meshes/part.obj", "meshes/part.mtl", "meshes/skin.png"}) {
    const fs::path file = folder_ / "cell" / name;
    load();
    ASSERT_TRUE(isUsedAgain()) << name;
    const auto before = fs::last_write_time(file);
    if (file.extension() == ".png") {
      ASSERT_TRUE(writePng(file, {1, 1, {1, 2, 3, 255}}).ok());
    } else {
      std::string text = *readFile(file);
      text[text.find(file.extension() == ".toml" ? "one" : "1")] = '7';
      std::ofstream(file) << text;
    }
    fs::last_write_time(file, before);
    EXPECT_FALSE(isUsedAgain()) << name;
    EXPECT_TRUE(isUsedAgain()) << name << ": the new one is kept";
  }
}

TEST_F(CellCacheTest, AFileThatWouldNowBeFoundFirstIsSeen) {
  test::writeFile(cellFile(), cellText("part.obj"));
  test::writeFile(folder_ / "cell/more/part.obj", kTriangle);
  load();
  ASSERT_TRUE(isUsedAgain());
  test::writeFile(folder_ / "cell/part.obj", std::string("v 5 5 5\n") + kTriangle);
  EXPECT_FALSE(isUsedAgain()) << "beside the cell comes before its search roots";
  ASSERT_TRUE(isUsedAgain());
  fs::remove(folder_ / "cell/part.obj");
  EXPECT_FALSE(isUsedAgain());
}

TEST_F(CellCacheTest, AMissingPictureThatAppearsIsSeen) {
  fs::remove(folder_ / "cell/meshes/skin.png");
  EXPECT_EQ(load().faults.size(), 1U);
  ASSERT_TRUE(isUsedAgain());
  ASSERT_TRUE(writePng(folder_ / "cell/meshes/skin.png", {1, 1, {9, 8, 7, 255}}).ok());
  EXPECT_FALSE(isUsedAgain());
  EXPECT_TRUE(load().faults.empty());
}

TEST_F(CellCacheTest, ALinkThatLeadsElsewhereIsSeen) {
  fs::rename(folder_ / "cell/meshes", folder_ / "cell/first");
  fs::copy(folder_ / "cell/first", folder_ / "cell/second");
  fs::create_directory_symlink("first", folder_ / "cell/meshes");
  load();
  ASSERT_TRUE(isUsedAgain());
  fs::remove(folder_ / "cell/meshes");
  fs::create_directory_symlink("second", folder_ / "cell/meshes");
  EXPECT_FALSE(isUsedAgain()) << "faults and texts may name other files";
}

TEST_F(CellCacheTest, ADamagedEntryIsMadeAnew) {
  load();
  const std::string whole = *readFile(kept());
  for (std::size_t at = 0; at < whole.size(); at += 1 + whole.size() / 40) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    const fs::path entry = kept();
    fs::remove(entry);
    std::ofstream(entry, std::ios::binary) << damaged;
    expectAsLoaded(load());
    EXPECT_EQ(*readFile(entry), whole) << "byte " << at;
    fs::remove(entry);
    std::ofstream(entry, std::ios::binary) << whole.substr(0, at);
    expectAsLoaded(load());
    EXPECT_EQ(*readFile(entry), whole) << "cut at " << at;
  }
}

TEST_F(CellCacheTest, OtherRequestsHaveOtherEntries) {
  load();
  CellOptions options;
  options.search = {folder_ / "cell"};
  expectAsLoaded(load(options), options);
  EXPECT_EQ(keptCount(), 2U);
  ASSERT_EQ(::setenv("ROCINANTE_PATH", (folder_ / "cell/meshes").c_str(), 1), 0);
  options.search_environment = true;
  load(options);
  ::unsetenv("ROCINANTE_PATH");
  load(options);
  EXPECT_EQ(keptCount(), 4U);
}

TEST_F(CellCacheTest, WhatCannotBeToldFromAnotherIsNotKept) {
  CellOptions names_only;
  names_only.geometry = false;
  load(names_only);
  EXPECT_EQ(keptCount(), 0U) << "no geometry";
  CellCache now(folder_ / "cache", CellCache::kDefaultBytes, 0);
  ASSERT_TRUE(now.load(cellFile(), {}).ok());
  EXPECT_EQ(keptCount(), 0U) << "its files may have been written after they were read";
  CellCache large(folder_ / "cache");
  ASSERT_TRUE(large.load(cellFile(), {}).ok());
  EXPECT_EQ(keptCount(), 0U) << "a small cell";
  test::writeFile(folder_ / "cell/meshes/part.obj", "not an obj");
  ASSERT_TRUE(cache_.load(cellFile(), {}).ok());
  EXPECT_EQ(keptCount(), 0U) << "a cell with errors";
  EXPECT_FALSE(cache_.load(folder_ / "cell/none.cell.toml", {}).ok());
  fs::create_directory(folder_ / "file");
  std::ofstream(folder_ / "file/not-a-folder") << "x";
  CellCache refused(folder_ / "file/not-a-folder", CellCache::kDefaultBytes, 0);
  EXPECT_TRUE(refused.load(cellFile(), {}).ok()) << "a folder that cannot be written to";
}

TEST_F(CellCacheTest, StaysWithinItsSize) {
  load();
  const auto bytes = fs::file_size(kept());
  CellCache small(folder_ / "cache", bytes + bytes / 2, 0);
  small.tellTimeBy([] {
    return std::chrono::time_point_cast<Nanoseconds>(std::chrono::system_clock::now()) +
           std::chrono::hours(1);
  });
  CellOptions options;
  options.search = {folder_ / "cell"};
  ASSERT_TRUE(small.load(cellFile(), options).ok());
  EXPECT_EQ(keptCount(), 1U) << "the older one went";
}

TEST(CellInputsTest, BytesOfOthersAreNone) {
  CellInputs inputs;
  inputs.files = {{"a.obj", 3, {1, 2}}};
  inputs.answers = {{"b", {SearchFacts::Kind::folder, "/b"}}};
  inputs.libraries = {{"/lib/c.so", 4, 5}};
  const Bytes bytes = encodeInputs(inputs);
  ASSERT_TRUE(decodeInputs(bytes).has_value());
  EXPECT_EQ(encodeInputs(*decodeInputs(bytes)), bytes);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    EXPECT_FALSE(decodeInputs(ByteView(bytes).first(i)).has_value());
    Bytes forged = bytes;
    forged[i] = std::byte{0xFF};
    decodeInputs(forged);
  }
}

}  // namespace
}  // namespace rocinante
