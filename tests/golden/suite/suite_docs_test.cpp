// Every example of docs/golden-suites.md is read as users' files are.
#include <gtest/gtest.h>

#include "core/base/atomic_file.h"
#include "golden/approval/approval_list.h"
#include "golden/approval/manifest.h"
#include "golden/suite/suite.h"

namespace rocinante {
namespace {

/// What stands between "```LANGUAGE" and "```".
std::vector<std::string> examplesIn(const std::string& page, const std::string& language) {
  std::vector<std::string> examples;
  const std::string fence = "\n```" + language + "\n";
  for (std::size_t begin = 0; (begin = page.find(fence, begin)) != std::string::npos;) {
    begin += fence.size();
    const std::size_t end = page.find("\n```\n", begin);
    examples.push_back(page.substr(begin, end + 1 - begin));
    begin = end + 4;  // the line's end before the next fence may be this one's
  }
  return examples;
}

std::string suitesPage() {
  const auto page = readFile(std::filesystem::path(ROCINANTE_SOURCE_DIR) / "docs/golden-suites.md");
  EXPECT_TRUE(page.ok());
  return page.ok() ? *page : std::string();
}

TEST(SuiteDocs, EverySuiteIsRead) {
  const auto suites = examplesIn(suitesPage(), "toml");
  ASSERT_FALSE(suites.empty());
  for (const std::string& text : suites) {
    const auto suite = parseSuite(text, "docs.toml");
    EXPECT_TRUE(suite.ok()) << suite.error().text();
  }
  const auto suite = parseSuite(suites[0], "docs.toml");
  ASSERT_TRUE(suite.ok());
  ASSERT_EQ(suite->cases.size(), 5U);
  EXPECT_EQ(suite->cases[0].tolerance.name, "gripper");
  EXPECT_EQ(suite->cases[0].mask.size(), 3U);
  EXPECT_TRUE(suite->cases[4].expect_different);
}

TEST(SuiteDocs, EveryManifestIsRead) {
  const auto manifests = examplesIn(suitesPage(), "json");
  ASSERT_FALSE(manifests.empty());
  for (const std::string& text : manifests) {
    const auto manifest = Manifest::parse(text, "docs.json");
    ASSERT_TRUE(manifest.ok()) << manifest.error().text();
    EXPECT_EQ(manifest->cases.size(), 1U);
  }
}

TEST(SuiteDocs, TheListOfApprovalsIsRead) {
  const std::string page = suitesPage();
  const auto lists = examplesIn(page.substr(page.find("### Lists of approvals")), "");
  ASSERT_FALSE(lists.empty());
  const auto list = parseApprovalList(lists[0], "docs.txt");
  ASSERT_TRUE(list.ok()) << list.error().text();
  EXPECT_EQ(list->size(), 2U);
}

}  // namespace
}  // namespace rocinante
