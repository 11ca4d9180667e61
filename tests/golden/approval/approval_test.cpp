#include "golden/approval/approval.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "core/base/atomic_file.h"
#include "golden/approval/approval_list.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

using testing::HasSubstr;

constexpr char kTinyKey[] = "llvmpipe 4x4 1x";

Picture tinyPicture(std::uint8_t level) {
  return {4, 4, std::vector<std::uint8_t>(4 * 4 * 4, level)};
}

AcceptedPicture entryOf(const Picture& picture) {
  return {kTinyKey, {}, pictureXxh3(picture), "inputs", "session", "ada", "2026-02-03", "why"};
}

class ApprovalTest : public testing::Test {
 protected:
  Manifest manifest() const {
    auto read = Manifest::read(folder_.goldens());
    EXPECT_TRUE(read.ok());
    return read.ok() ? *read : Manifest{};
  }

  std::vector<std::string> approve(const std::string& name, const Picture& picture,
                                   bool beside = false) const {
    Approval approval(folder_, manifest());
    EXPECT_TRUE(approval.stage(name, entryOf(picture), picture, nullptr, beside).ok());
    const auto left = approval.commit();
    EXPECT_TRUE(left.ok()) << left.error().text();
    return left.ok() ? *left : std::vector<std::string>{};
  }

  std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.goldens())) {
      names.push_back(entry.path().filename().string());
    }
    std::ranges::sort(names);
    return names;
  }

  test::TemporaryFolder root_;
  GoldenFolder folder_{root_ / "goldens", {}};
  std::string pick_ = goldenFileName("pick", kTinyKey);
};

TEST_F(ApprovalTest, WritesPictureAndManifestAndLeavesNothingElse) {
  approve("pick", tinyPicture(10));
  EXPECT_EQ(files(), (std::vector<std::string>{"manifest.json", pick_}));
  approve("pick", tinyPicture(20));
  EXPECT_EQ(files(), (std::vector<std::string>{"manifest.json", pick_}));
  const Manifest now = manifest();
  EXPECT_EQ(*folder_.read(*now.find("pick", kTinyKey).front()), tinyPicture(20));
}

TEST_F(ApprovalTest, WhatIsStagedAloneChangesNothing) {
  approve("pick", tinyPicture(10));
  const auto before = files();
  {
    Approval approval(folder_, manifest());
    ASSERT_TRUE(
        approval.stage("pick", entryOf(tinyPicture(30)), tinyPicture(30), nullptr, false).ok());
    EXPECT_EQ(*folder_.read(*manifest().find("pick", kTinyKey).front()), tinyPicture(10));
  }
  EXPECT_EQ(files(), before);
}

TEST_F(ApprovalTest, SeveralPicturesOfACaseHaveFilesOfTheirOwn) {
  approve("pick", tinyPicture(10));
  approve("pick", tinyPicture(20), true);
  const Manifest now = manifest();
  ASSERT_EQ(now.find("pick", kTinyKey).size(), 2U);
  for (const AcceptedPicture* one : now.find("pick", kTinyKey))
    EXPECT_TRUE(folder_.read(*one).ok());
  // One in place of both: the other's file goes.
  approve("pick", tinyPicture(30));
  EXPECT_EQ(files(), (std::vector<std::string>{"manifest.json", pick_}));
}

TEST_F(ApprovalTest, WhatAnotherApprovedMeanwhileIsKept) {
  approve("pick", tinyPicture(10));
  Approval slow(folder_, manifest());
  ASSERT_TRUE(slow.stage("pick", entryOf(tinyPicture(20)), tinyPicture(20), nullptr, false).ok());
  ASSERT_TRUE(slow.stage("place", entryOf(tinyPicture(21)), tinyPicture(21), nullptr, false).ok());
  approve("pick", tinyPicture(30));
  approve("other", tinyPicture(40));
  const auto left = slow.commit();
  ASSERT_TRUE(left.ok());
  EXPECT_EQ(*left, std::vector<std::string>{"pick"});
  const Manifest now = manifest();
  EXPECT_EQ(*folder_.read(*now.find("pick", kTinyKey).front()), tinyPicture(30));
  EXPECT_EQ(*folder_.read(*now.find("place", kTinyKey).front()), tinyPicture(21));
  EXPECT_EQ(*folder_.read(*now.find("other", kTinyKey).front()), tinyPicture(40));
}

TEST_F(ApprovalTest, TwoThatApproveTheSamePixelsAreBothDone) {
  approve("pick", tinyPicture(10));
  Approval first(folder_, manifest()), second(folder_, manifest());
  for (Approval* approval : {&first, &second}) {
    ASSERT_TRUE(
        approval->stage("pick", entryOf(tinyPicture(20)), tinyPicture(20), nullptr, false).ok());
  }
  for (Approval* approval : {&first, &second}) {
    const auto left_alone = approval->commit();
    ASSERT_TRUE(left_alone.ok()) << left_alone.error().text();
    EXPECT_TRUE(left_alone->empty());
  }
  ASSERT_EQ(manifest().find("pick", kTinyKey).size(), 1U);
  EXPECT_EQ(*folder_.read(*manifest().find("pick", kTinyKey).front()), tinyPicture(20));
  EXPECT_EQ(files(), (std::vector<std::string>{"manifest.json", pick_}));
}

TEST_F(ApprovalTest, APictureOfAnotherKeyIsAcceptedAlready) {
  approve("pick", tinyPicture(10));
  AcceptedPicture other = entryOf(tinyPicture(10));
  other.key = "newer 4x4 1x";
  const auto isAccepted = [&](const AcceptedPicture& accepted) {
    return Approval(folder_, manifest()).isAccepted("pick", accepted);
  };
  EXPECT_TRUE(isAccepted(entryOf(tinyPicture(10))));
  EXPECT_TRUE(isAccepted(other));
  AcceptedPicture changed = other;
  changed.pixels = pictureXxh3(tinyPicture(11));
  EXPECT_FALSE(isAccepted(changed));
  AcceptedPicture masked = other;
  masked.areas_pixels = "elsewhere";
  EXPECT_FALSE(isAccepted(masked));
  // What is gone can be accepted anew.
  std::filesystem::remove(folder_.goldens() / pick_);
  EXPECT_FALSE(isAccepted(other));
}

TEST_F(ApprovalTest, CoverageAloneIsReplacedUnderTheGoldensOwnKey) {
  approve("pick", tinyPicture(10));
  AcceptedPicture covered = entryOf(tinyPicture(10));
  covered.key = "newer 4x4 1x";
  covered.coverage = {"arm"};
  Approval approval(folder_, manifest());
  EXPECT_FALSE(approval.isAccepted("pick", covered));
  ASSERT_TRUE(approval.stage("pick", covered, tinyPicture(10), nullptr, false).ok());
  ASSERT_TRUE(approval.commit().ok());
  const Manifest now = manifest();
  const auto accepted = now.findAll("pick");
  ASSERT_EQ(accepted.size(), 1U);
  EXPECT_EQ(accepted.front()->key, kTinyKey);
  EXPECT_EQ(accepted.front()->coverage, covered.coverage);
  EXPECT_EQ(*folder_.read(*accepted.front()), tinyPicture(10));
  EXPECT_EQ(files(), (std::vector<std::string>{"manifest.json", pick_}));
  EXPECT_TRUE(Approval(folder_, manifest()).isAccepted("pick", covered));
  covered.coverage.reset();  // a report of an older version knows of none
  EXPECT_TRUE(Approval(folder_, manifest()).isAccepted("pick", covered));
}

TEST_F(ApprovalTest, AGoldenOfAnotherKeyStaysBesideTheNewOne) {
  approve("pick", tinyPicture(10));
  AcceptedPicture other = entryOf(tinyPicture(11));
  other.key = "newer 4x4 1x";
  Approval approval(folder_, manifest());
  ASSERT_TRUE(approval.stage("pick", other, tinyPicture(11), nullptr, false).ok());
  ASSERT_TRUE(approval.commit().ok());
  EXPECT_EQ(manifest().findAll("pick").size(), 2U);
  EXPECT_EQ(*folder_.read(*manifest().find("pick", kTinyKey).front()), tinyPicture(10));
}

TEST_F(ApprovalTest, AGoldenOfAnotherKeyKeepsItsFileThoughTheNamesClash) {
  // As where somebody wrote another key into the manifest.
  AcceptedPicture other = entryOf(tinyPicture(10));
  other.key = "older 4x4 1x";
  other.picture = pick_;
  Manifest before;
  before.accept("pick", other);
  std::filesystem::create_directories(folder_.goldens());
  ASSERT_TRUE(writePng(folder_.goldens() / pick_, tinyPicture(10)).ok());
  ASSERT_TRUE(before.write(folder_.goldens()).ok());
  approve("pick", tinyPicture(20));
  EXPECT_EQ(*folder_.read(*manifest().find("pick", "older 4x4 1x").front()), tinyPicture(10));
  EXPECT_EQ(*folder_.read(*manifest().find("pick", kTinyKey).front()), tinyPicture(20));
}

TEST_F(ApprovalTest, WhoApprovesTheSamePixelsOfAnotherKeyMeanwhileIsDone) {
  approve("pick", tinyPicture(10));
  Approval slow(folder_, manifest());
  AcceptedPicture other = entryOf(tinyPicture(20));
  other.key = "newer 4x4 1x";
  ASSERT_TRUE(slow.stage("pick", other, tinyPicture(20), nullptr, false).ok());
  approve("pick", tinyPicture(20));
  const auto left = slow.commit();
  ASSERT_TRUE(left.ok());
  EXPECT_TRUE(left->empty());
  EXPECT_EQ(manifest().findAll("pick").size(), 1U);
}

TEST_F(ApprovalTest, KilledAfterTheManifestTheNewPictureCounts) {
  approve("pick", tinyPicture(10));
  // As it is between the manifest and the last rename.
  Manifest after = manifest();
  AcceptedPicture accepted = entryOf(tinyPicture(20));
  accepted.picture = pick_;
  after.accept("pick", accepted);
  ASSERT_TRUE(writePng(folder_.arrivingFile(pick_), tinyPicture(20)).ok());
  ASSERT_TRUE(after.write(folder_.goldens()).ok());
  EXPECT_EQ(*folder_.read(accepted), tinyPicture(20));
  // Whoever approves next finishes it.
  approve("place", tinyPicture(1));
  EXPECT_EQ(files(),
            (std::vector<std::string>{"manifest.json", pick_, goldenFileName("place", kTinyKey)}));
  EXPECT_EQ(*folder_.read(accepted), tinyPicture(20));
}

TEST_F(ApprovalTest, KilledBeforeTheManifestTheOldPictureCounts) {
  approve("pick", tinyPicture(10));
  ASSERT_TRUE(writePng(folder_.arrivingFile(pick_), tinyPicture(20)).ok());
  EXPECT_EQ(*folder_.read(*manifest().find("pick", kTinyKey).front()), tinyPicture(10));
  approve("place", tinyPicture(1));
  EXPECT_EQ(*folder_.read(*manifest().find("pick", kTinyKey).front()), tinyPicture(10));
  EXPECT_FALSE(std::filesystem::exists(folder_.arrivingFile(pick_)));
}

TEST_F(ApprovalTest, WhatAKilledOneLeftIsClearedAndWhatALivingOneUsesIsNot) {
  approve("pick", tinyPicture(10));
  const auto before = files();
  Approval living(folder_, manifest());
  ASSERT_TRUE(
      living.stage("place", entryOf(tinyPicture(20)), tinyPicture(20), nullptr, false).ok());
  ASSERT_EQ(files().size(), before.size() + 1);  // its staging folder
  const ::pid_t killed = ::fork();
  if (killed == 0) {
    Approval dying(folder_, manifest());
    const bool staged =
        dying.stage("pick", entryOf(tinyPicture(30)), tinyPicture(30), nullptr, false).ok();
    ::_exit(staged ? 0 : 1);  // nothing is tidied up
  }
  int status = -1;
  ASSERT_EQ(::waitpid(killed, &status, 0), killed);
  ASSERT_EQ(status, 0);
  std::ofstream(root_ / "goldens/manifest.json.part12") << "{";
  ASSERT_EQ(files().size(), before.size() + 3);
  // Also when there is nothing to approve.
  ASSERT_TRUE(Approval(folder_, manifest()).commit().ok());
  EXPECT_EQ(files().size(), before.size() + 1);
  ASSERT_TRUE(living.commit().ok());
  EXPECT_EQ(files(),
            (std::vector<std::string>{"manifest.json", pick_, goldenFileName("place", kTinyKey)}));
  EXPECT_EQ(*folder_.read(*manifest().find("place", kTinyKey).front()), tinyPicture(20));
}

TEST_F(ApprovalTest, ABrokenManifestIsNotWrittenOver) {
  approve("pick", tinyPicture(10));
  const Manifest seen = manifest();
  ASSERT_TRUE(writeFileWhole(root_ / "goldens/manifest.json", bytesOf("{"), true).ok());
  Approval approval(folder_, seen);
  ASSERT_TRUE(
      approval.stage("pick", entryOf(tinyPicture(20)), tinyPicture(20), nullptr, false).ok());
  EXPECT_FALSE(approval.commit().ok());
  EXPECT_EQ(*readFile(root_ / "goldens/manifest.json"), "{");
}

TEST_F(ApprovalTest, AStoreHoldsPicturesByTheirHash) {
  folder_ = GoldenFolder(root_ / "goldens", root_ / "store");
  approve("pick", tinyPicture(10));
  approve("place", tinyPicture(10));
  approve("pick", tinyPicture(20));
  EXPECT_EQ(files(), std::vector<std::string>{"manifest.json"});
  EXPECT_TRUE(std::filesystem::exists(root_ / "store" / (pictureXxh3(tinyPicture(10)) + ".png")));
  const Manifest now = manifest();
  EXPECT_EQ(*folder_.read(*now.find("pick", kTinyKey).front()), tinyPicture(20));
  EXPECT_EQ(*folder_.read(*now.find("place", kTinyKey).front()), tinyPicture(10));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(root_ / "store"), {}), 2)
      << "nothing staged stays there";
  // What lies under a hash must be what the hash says.
  ASSERT_TRUE(
      writePng(root_ / "store" / (pictureXxh3(tinyPicture(20)) + ".png"), tinyPicture(21)).ok());
  EXPECT_FALSE(folder_.read(*now.find("pick", kTinyKey).front()).ok());
}

TEST_F(ApprovalTest, APointerOfLfsIsToldAsWhatItIs) {
  approve("pick", tinyPicture(10));
  const std::string pointer =
      "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n";
  ASSERT_TRUE(writeFileWhole(root_ / "goldens" / pick_, bytesOf(pointer), true).ok());
  const auto read = folder_.read(*manifest().find("pick", kTinyKey).front());
  ASSERT_FALSE(read.ok());
  EXPECT_THAT(read.error().text(), HasSubstr("is a Git LFS pointer, not the picture; `git lfs "
                                             "pull` fetches it"));
}

TEST_F(ApprovalTest, ACorruptGoldenIsNamed) {
  approve("pick", tinyPicture(10));
  const std::filesystem::path file = root_ / "goldens" / pick_;
  const std::string whole = *readFile(file);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    std::ofstream(file, std::ios::binary) << whole.substr(0, length);
    const auto read = folder_.read(*manifest().find("pick", kTinyKey).front());
    // Only what no pixel depends on may be missing.
    if (read.ok()) {
      EXPECT_EQ(*read, tinyPicture(10)) << length;
    } else {
      EXPECT_THAT(read.error().text(), HasSubstr(pick_)) << length;
    }
  }
}

TEST(ApprovalList, IsReadAsItIsWritten) {
  const ApprovalList list{{"pick", std::string(32, 'a')},
                          {"tour-00001.000s", std::string(32, '0')}};
  const auto read = parseApprovalList("# chosen in the report\r\n\n" + approvalListText(list), "l");
  ASSERT_TRUE(read.ok()) << read.error().text();
  EXPECT_EQ(*read, list);
}

TEST(ApprovalList, RefusesWhatIsNone) {
  const auto faultOf = [](const std::string& text) {
    const auto list = parseApprovalList(text, "list.txt");
    return list.ok() ? std::string("none") : list.error().text();
  };
  const std::string hash(32, 'a');
  EXPECT_EQ(faultOf(""), "the list has no frames, so nothing would be approved (list.txt)");
  EXPECT_EQ(faultOf("\npick\n"),
            "`pick` is not a frame name and a pixel hash of 32 digits (list.txt:2)");
  EXPECT_EQ(faultOf("pick " + hash + "0\n").substr(0, 6), "`pick ");
  EXPECT_EQ(faultOf("pick " + hash + " x\n").substr(0, 6), "`pick ");
  EXPECT_EQ(faultOf("a " + hash + "\na\t" + hash), "the list has frame a twice (list.txt:2)");
}

}  // namespace
}  // namespace rocinante
