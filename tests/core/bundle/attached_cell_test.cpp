#include "core/bundle/attached_cell.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/hash.h"
#include "core/log/log_profile.h"
#include "tests/core/bundle/bundle_fixture.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class AttachedCellTest : public testing::Test {
 protected:
  AttachedCellTest() {
    test::writeTank(folder_ / "cell", "steel.png");
    test::writeFile(folder_ / "cell/steel.png", "picture-of-steel");
    auto bundle = collectCell(folder_ / "cell/tank.obj", {});
    EXPECT_TRUE(bundle.ok()) << bundle.error().text();
    bundle_ = std::move(*bundle);
    fs::remove_all(folder_ / "cell");
  }
  fs::path log() const { return folder_ / "session.mcap"; }
  /// The log as writeLog() makes it, with one change to its attachments.
  void writeLogWith(const std::vector<BundleAttachment>& attachments, const LogMetadata& metadata) {
    auto writer = LogWriter::create(log(), {}, "session-1");
    ASSERT_TRUE(writer.ok());
    for (const BundleAttachment& each : attachments) {
      ASSERT_TRUE(writer->writeAttachment(each.name, each.media_type, {}, each.data).ok());
    }
    ASSERT_TRUE(writer->writeMetadata(metadata).ok());
    ASSERT_TRUE(writer->close("test").ok());
  }
  std::string refusal() const {
    const auto cell = loadCellOrLog(log(), {});
    return cell.ok() ? "" : cell.error().text();
  }

  test::TemporaryFolder folder_;
  CellBundle bundle_;
};

TEST_F(AttachedCellTest, TheLogAloneIsACell) {
  test::writeLog(log(), &bundle_);
  const auto cell = loadCellOrLog(log(), {});
  ASSERT_TRUE(cell.ok()) << cell.error().text();
  EXPECT_EQ(cell->file, log().string() + ":cell/tank.obj");
  EXPECT_EQ(cell->devices.at(0).name, "tank");
}

TEST_F(AttachedCellTest, WhatIsReadIsWhatWasAttached) {
  test::writeLog(log(), &bundle_);
  const auto reader = LogReader::open(log());
  ASSERT_TRUE(reader.ok());
  const auto read = readAttachedCell(*reader);
  ASSERT_TRUE(read.ok()) << read.error().text();
  ASSERT_TRUE(read->has_value());
  EXPECT_EQ((*read)->manifest, bundle_.manifest);
  EXPECT_EQ((*read)->contents, bundle_.contents);
}

TEST_F(AttachedCellTest, TheCellOfOneLogCanGoIntoAnother) {
  test::writeLog(log(), &bundle_);
  const auto bundle = collectCellOrLog(log(), {});
  ASSERT_TRUE(bundle.ok()) << bundle.error().text();
  EXPECT_EQ(bundle->manifest, bundle_.manifest);
  EXPECT_EQ(bundle->contents, bundle_.contents);
}

TEST_F(AttachedCellTest, ALogWithoutItsAttachmentsHasNoCell) {
  const AttachedBundle attached(bundle_);
  writeLogWith({}, attached.metadata());
  EXPECT_THAT(refusal(), HasSubstr("the log carries no cell"));
}

TEST_F(AttachedCellTest, ALogWithoutOneSaysHowToGiveOne) {
  test::writeLog(log(), nullptr);
  EXPECT_THAT(refusal(), HasSubstr("the log carries no cell"));
  EXPECT_THAT(refusal(), HasSubstr("rocinante log attach"));
}

TEST_F(AttachedCellTest, AKilledRecordersLogHasItsCell) {
  test::writeLog(log(), &bundle_);
  const std::string whole = test::fileText(log());
  // After the metadata record nothing more is needed; before its end there is no cell yet.
  const std::size_t record = whole.find("rocinante.cell");
  ASSERT_NE(record, std::string::npos);
  test::writeFile(log(), whole.substr(0, record + 400));
  EXPECT_EQ(refusal(), "");
  test::writeFile(log(), whole.substr(0, record + 20));
  EXPECT_THAT(refusal(), HasSubstr("the log carries no cell"));
}

TEST_F(AttachedCellTest, AFlippedByteIsDamageThatNamesTheAttachment) {
  test::writeLog(log(), &bundle_);
  std::string bytes = test::fileText(log());
  bytes.at(bytes.find("picture-of-steel")) ^= 1;
  test::writeFile(log(), bytes);
  EXPECT_THAT(refusal(), HasSubstr("attachment cell/steel.png fails its checksum"));
}

TEST_F(AttachedCellTest, AnotherFileUnderTheNameIsNotTaken) {
  const AttachedBundle attached(bundle_);
  std::vector<BundleAttachment> attachments = attached.attachments();
  for (BundleAttachment& each : attachments) {
    if (each.name == "cell/steel.png") each.data = bytesOf("picture-of-stone");
  }
  writeLogWith(attachments, attached.metadata());
  EXPECT_THAT(refusal(), HasSubstr("attachment cell/steel.png is not what was attached"));
}

TEST_F(AttachedCellTest, OfSeveralOfANameTheRightOneIsTaken) {
  const AttachedBundle attached(bundle_);
  std::vector<BundleAttachment> attachments = attached.attachments();
  attachments.insert(attachments.begin(), {"cell/steel.png", "", bytesOf("picture-of-stone")});
  attachments.insert(attachments.begin(), {"cell.json", "", bytesOf("{}")});
  const std::string too_long(4096, 'x');
  attachments.push_back({"cell/tank.obj", "", bytesOf(too_long)});
  writeLogWith(attachments, attached.metadata());
  EXPECT_EQ(refusal(), "");
}

TEST_F(AttachedCellTest, AMissingAttachmentIsNamed) {
  const AttachedBundle attached(bundle_);
  std::vector<BundleAttachment> attachments = attached.attachments();
  std::erase_if(attachments, [](const auto& each) { return each.name == "cell/tank.mtl"; });
  writeLogWith(attachments, attached.metadata());
  EXPECT_THAT(refusal(), HasSubstr("attachment cell/tank.mtl is missing"));
}

TEST_F(AttachedCellTest, ALaterFormatIsNotGuessedAt) {
  const AttachedBundle attached(bundle_);
  LogMetadata metadata = attached.metadata();
  metadata.entries[std::string(profile::kFormatKey)] = "2";
  writeLogWith(attached.attachments(), metadata);
  EXPECT_THAT(refusal(), HasSubstr("the log's cell has format 2"));
}

TEST_F(AttachedCellTest, SearchRootsAreRefusedWithACellThatHasAllItsFiles) {
  test::writeLog(log(), &bundle_);
  CellOptions options;
  options.search = {folder_.path()};
  const auto cell = loadCellOrLog(log(), options);
  ASSERT_FALSE(cell.ok());
  EXPECT_EQ(cell.error().kind, ErrorKind::bad_argument);
}

TEST_F(AttachedCellTest, NothingInALogOpensAFileOfTheMachine) {
  // A manifest made by hand: its cell names a file that exists.
  test::writeFile(folder_ / "secret.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  CellBundle made;
  const std::string cell_text = "format = 1\nsearch = [\"" + folder_.path().string() +
                                "\"]\n[[model]]\nname = \"s\"\nobj = \"" +
                                (folder_ / "secret.obj").string() +
                                "\"\nunit = \"m\"\nup = \"z\"\n[[device]]\nname = \"s\"\n"
                                "model = \"s\"\n";
  made.manifest.main = "a.cell.toml";
  Sha256 sha256;
  sha256.add(bytesOf(cell_text));
  made.manifest.files = {{"a.cell.toml", cell_text.size(), hexOf(sha256.finish())}};
  const ByteView bytes = bytesOf(cell_text);
  made.contents = {Bytes(bytes.begin(), bytes.end())};
  test::writeLog(log(), &made);
  const auto cell = loadCellOrLog(log(), {});
  ASSERT_TRUE(cell.ok()) << cell.error().text();
  EXPECT_EQ(cell->files.size(), 1U);
  EXPECT_TRUE(std::ranges::any_of(
      cell->faults, [](const Finding& fault) { return fault.rule == "model.missing-file"; }));
}

TEST_F(AttachedCellTest, AFileWithTheMagicIsALogWhateverItIsCalled) {
  test::writeLog(folder_ / "session.bin", &bundle_);
  EXPECT_TRUE(isLog(folder_ / "session.bin"));
  test::writeFile(folder_ / "a.obj", "\x89MCAP");
  EXPECT_FALSE(isLog(folder_ / "a.obj"));
  EXPECT_FALSE(isLog(folder_.path()));
  EXPECT_FALSE(isLog(folder_ / "none"));
}

}  // namespace
}  // namespace rocinante
