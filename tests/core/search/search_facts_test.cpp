#include "core/search/search_facts.h"

#include <gtest/gtest.h>

#include "core/search/file_search.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/write_file.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;
using Kind = SearchFacts::Kind;

TEST(SearchFactsTest, TellWhatIsThere) {
  const test::TemporaryFolder folder;
  const fs::path root = fs::canonical(folder.path());
  test::writeFile(root / "a", "x");
  fs::create_symlink("a", root / "b");
  EXPECT_EQ(SearchFacts::answerFor(root / "b"), (SearchFacts::Answer{Kind::file, root / "a"}));
  EXPECT_EQ(SearchFacts::answerFor(root), (SearchFacts::Answer{Kind::folder, root}));
  EXPECT_EQ(SearchFacts::answerFor(root / "c"), SearchFacts::Answer{});
  EXPECT_EQ(SearchFacts::answerFor("/dev/null").kind, Kind::other);
}

TEST(SearchFactsTest, NameEveryPlaceThatASearchTried) {
  const test::TemporaryFolder folder;
  const fs::path root = fs::canonical(folder.path());
  test::writeFile(root / "far/arm.obj", "x");
  test::writeFile(root / "near/cell.toml", "x");
  SearchFacts facts;
  FileSearch search;
  search.noteFactsIn(&facts);
  ASSERT_TRUE(search.addRoot(root / "near").ok());
  ASSERT_TRUE(search.addRoot(root / "far").ok());
  EXPECT_EQ(search.find("arm.obj", root / "near").path, root / "far/arm.obj");
  EXPECT_EQ(facts.answers().at(root / "near/arm.obj").kind, Kind::missing);
  EXPECT_EQ(facts.answers().at(root / "far/arm.obj").kind, Kind::file);
  EXPECT_EQ(facts.answers().at(root / "far").kind, Kind::folder);
  EXPECT_TRUE(facts.complete());
}

TEST(SearchFactsTest, ReadPackagesCountAndListedFoldersEndIt) {
  const test::TemporaryFolder folder;
  const fs::path root = fs::canonical(folder.path());
  test::writeFile(root / "robot/package.xml", "<package><name>arm</name></package>");
  test::writeFile(root / "robot/urdf/arm.urdf", "x");
  test::writeFile(root / "robot/meshes/arm.obj", "x");
  SearchFacts facts;
  FileSearch search;
  search.noteFactsIn(&facts);
  search.setPackagesAbove(root / "robot/urdf");
  EXPECT_TRUE(facts.contents().contains(root / "robot/package.xml"));
  EXPECT_EQ(facts.answers().at(root / "robot/urdf/package.xml").kind, Kind::missing);
  EXPECT_TRUE(facts.complete());
  // Only the folders about it tell which of them is the package.
  EXPECT_EQ(search.find("package://arm/meshes/arm.obj", root / "robot/urdf").why,
            FoundFile::Why::found);
  EXPECT_FALSE(facts.complete());
}

}  // namespace
}  // namespace rocinante
