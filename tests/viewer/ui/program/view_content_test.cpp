#include "viewer/ui/program/view_content.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"

namespace rocinante {
namespace {

class OpenedFiles : public testing::Test {
 protected:
  void SetUp() override {
    test::writeText(folder_ / "arm.urdf", test::kArmUrdf);
    test::writeSession(folder_ / "s.mcap", {{0, "event \"begun\"\n"}});
  }
  const test::TemporaryFolder folder_;
};

TEST_F(OpenedFiles, AreACellALogOrBoth) {
  const auto model = requestOf({folder_ / "arm.urdf"}, {});
  ASSERT_TRUE(model.ok());
  EXPECT_EQ(model->cell, folder_ / "arm.urdf");
  EXPECT_TRUE(model->log.empty());

  const auto both = requestOf({folder_ / "s.mcap", folder_ / "arm.urdf"}, {});
  ASSERT_TRUE(both.ok());
  EXPECT_EQ(both->cell, folder_ / "arm.urdf");
  EXPECT_EQ(both->log, folder_ / "s.mcap");

  test::writeSession(folder_ / "t.mcap", {{0, "event \"begun\"\n"}});
  const auto three = requestOf({folder_ / "s.mcap", folder_ / "arm.urdf", folder_ / "t.mcap"}, {});
  ASSERT_TRUE(three.ok());
  EXPECT_EQ(three->log, folder_ / "s.mcap");
  EXPECT_EQ(three->beside, folder_ / "t.mcap");
  EXPECT_FALSE(three->beside_alone);
}

TEST_F(OpenedFiles, WithALogComesTheShownCell) {
  ContentRequest shown;
  shown.cell = folder_ / "arm.urdf";
  const auto request = requestOf({folder_ / "s.mcap"}, shown);
  ASSERT_TRUE(request.ok());
  const auto content = loadContent(*request, {});
  ASSERT_TRUE(content.ok()) << content.error().text();
  EXPECT_EQ(content->request.cell, folder_ / "arm.urdf");
  EXPECT_NE(content->model->cursor(), nullptr);

  const auto alone = loadContent(*requestOf({folder_ / "s.mcap"}, {}), {});
  ASSERT_TRUE(alone.ok()) << alone.error().text();
  EXPECT_TRUE(alone->request.cell.empty());
  ASSERT_FALSE(alone->warnings.empty());
  EXPECT_TRUE(alone->warnings[0].starts_with("this log carries no cell")) << alone->warnings[0];
}

TEST_F(OpenedFiles, ALogWithoutACellShowsItsPosesAsAxes) {
  test::writeSession(folder_ / "tf.mcap", {{0,
                                            "pose base 1 2 3 0 0 0 1\n"
                                            "pose tool 0 0 1 0 0 0 1\n"
                                            "signal plc load 5 kg\nsignal - estop true\n"}});
  const auto content = loadContent(*requestOf({folder_ / "tf.mcap"}, {}), {});
  ASSERT_TRUE(content.ok()) << content.error().text();
  ViewModel& model = *content->model;
  EXPECT_EQ(model.style().frames, std::vector<std::string>{"*"});
  ASSERT_TRUE(model.update(SteadyTime{}).ok());
  const PosedDevice* const tool = model.scene().findDevice("tool");
  ASSERT_NE(tool, nullptr);
  EXPECT_TRUE(tool->bare && tool->placed);
  const PosedDevice* const plc = model.scene().findDevice("plc");
  ASSERT_NE(plc, nullptr);
  EXPECT_FALSE(plc->placed);
  EXPECT_FALSE(isHopeless(model.cell()));
}

TEST_F(OpenedFiles, AreRefusedWithASentence) {
  const auto what = [&](const std::vector<std::filesystem::path>& files,
                        const ContentRequest& shown) {
    const auto request = requestOf(files, shown);
    return request.ok() ? std::string("taken") : request.error().what;
  };
  EXPECT_EQ(what({folder_.path()}, {}), "a folder cannot be shown; open a file of it");
  EXPECT_EQ(what({folder_ / "gone.urdf"}, {}), "there is no such file");
  EXPECT_EQ(what({folder_ / "arm.urdf", folder_ / "arm.urdf"}, {}),
            "a window shows one cell, one log and one beside it at a time");
  const std::filesystem::path log = folder_ / "s.mcap";
  EXPECT_EQ(what({log, log, log}, {}),
            "a window shows one cell, one log and one beside it at a time");
}

TEST_F(OpenedFiles, OfALiveWindowKeepWhatConcernsLiveSessions) {
  ContentRequest live;
  live.live.emplace();
  live.cell = folder_ / "other.urdf";
  live.trust = "keys.trust";
  live.keep.bytes = 1;
  using Leaving = ContentRequest::Leaving;
  const auto cell = requestOf({folder_ / "arm.urdf"}, live);
  ASSERT_TRUE(cell.ok());
  EXPECT_EQ(cell->leaving, Leaving::goes_along);
  const auto log = requestOf({folder_ / "s.mcap"}, live);
  ASSERT_TRUE(log.ok());
  EXPECT_EQ(log->leaving, Leaving::stays_behind);
  EXPECT_EQ(log->fallback_cell, folder_ / "other.urdf");
  // Nothing that is not signed is shown by connecting again.
  const ContentRequest again = connectionOf({":5000"}, *log);
  EXPECT_EQ(again.trust, "keys.trust");
  EXPECT_EQ(again.keep.bytes, 1U);
  EXPECT_EQ(withoutConnection(live, false).leaving, Leaving::ends_unheard);
  EXPECT_EQ(withoutConnection(live, true).leaving, Leaving::ends);
}

TEST(LooksLikeEndpoint, ButNotLikeAFile) {
  for (const char* const endpoint :
       {":19960", "127.0.0.1:5000", "[::1]:5000", "robot7:19960", "udp://239.1.2.3:5000?ttl=1",
        "239.1.2.3:5000?interface=eth0", "pcap://lo", "nats://h/x", "subscribe://h:1"}) {
    EXPECT_TRUE(looksLikeEndpoint(endpoint)) << endpoint;
  }
  for (const char* const other : {"", "arm", "arm.urdf", "./a:1", "/logs/12:30", "a:", "a:123456",
                                  "a:b", "take 12:30.mcap", ":1x"}) {
    EXPECT_FALSE(looksLikeEndpoint(other)) << other;
  }
}

TEST_F(OpenedFiles, TheirErrorsAreNotesOverThePicture) {
  const auto opened = [&](const std::string& cell) {
    test::writeText(folder_ / "c.cell.toml", "format = 1\n" + cell);
    return loadContent(*requestOf({folder_ / "c.cell.toml"}, {}), {});
  };
  const std::string arm = "[[device]]\nname = \"arm\"\nmodel = \"arm.urdf\"\n";
  const auto whole = opened(arm);
  ASSERT_TRUE(whole.ok());
  EXPECT_TRUE(whole->model->viewer.panels.notes.empty());
  EXPECT_FALSE(isHopeless(whole->model->cell()));
  // Something is drawn.
  const auto half = opened(arm + "[[device]]\nname = \"b\"\nmodel = \"gone.urdf\"\n");
  ASSERT_TRUE(half.ok());
  ASSERT_EQ(half->model->viewer.panels.notes.size(), 1U);
  EXPECT_TRUE(half->model->viewer.panels.notes[0].is_error);
  EXPECT_NE(half->model->viewer.panels.notes[0].text.find("gone.urdf"), std::string::npos);
  EXPECT_EQ(half->warnings, std::vector<std::string>{half->model->viewer.panels.notes[0].text});
  EXPECT_FALSE(isHopeless(half->model->cell()));
  const auto typo = opened("[[devise]]\nname = \"arm\"\nmodel = \"arm.urdf\"\n");
  ASSERT_TRUE(typo.ok());
  EXPECT_FALSE(typo->model->viewer.panels.notes.empty());
  EXPECT_TRUE(isHopeless(typo->model->cell()));
}

TEST_F(OpenedFiles, WhatIsLeftOutOfThemIsANote) {
  Cell cell;
  Finding ignored;
  ignored.rule = "model.left-out";
  ignored.severity = Severity::note;
  ignored.text = "maps of <pbr> are not drawn";
  ignored.left_out = "element `pbr`";
  cell.faults = {ignored};
  EXPECT_FALSE(isHopeless(cell)) << "no error";
  const auto notes = notesOf(cell);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_FALSE(notes[0].is_error);
  EXPECT_NE(notes[0].text.find("`pbr`"), std::string::npos) << notes[0].text;
}

TEST_F(OpenedFiles, AreLoadedInAThread) {
  ContentLoader loader;
  EXPECT_FALSE(loader.busy());
  EXPECT_FALSE(loader.poll());
  loader.start(*requestOf({folder_ / "arm.urdf"}, {}));
  EXPECT_TRUE(loader.busy());
  EXPECT_EQ(loader.name(), "arm.urdf");
  const auto loaded = loader.waitFor(std::chrono::hours(1));
  ASSERT_TRUE(loaded && loaded->ok());
  EXPECT_EQ((*loaded)->model->cell().devices.size(), 1U);
  EXPECT_FALSE(loader.busy());
  loader.start(*requestOf({folder_ / "s.mcap", folder_ / "arm.urdf"}, {}));
  const auto next = loader.waitFor(std::chrono::hours(1));
  ASSERT_TRUE(next && next->ok());
  Timeline* const session = (*next)->model->session();
  ASSERT_NE(session, nullptr);
  EXPECT_TRUE(session->stateAt(session->end()).ok()) << "it is read on after it was taken";
  // One that is not waited for ends with the loader.
  loader.start(*requestOf({folder_ / "arm.urdf"}, {}));
}

TEST_F(OpenedFiles, AreListedWithFoldersFirst) {
  std::filesystem::create_directory(folder_ / "z");
  test::writeText(folder_ / "readme.txt", "");
  test::writeText(folder_ / ".hidden.urdf", "");
  test::writeText(folder_ / "B.STL", "");
  const auto listed = listFolder(folder_.path());
  ASSERT_TRUE(listed.ok());
  EXPECT_EQ(*listed, (std::vector<FileEntry>{
                         {"z/", true}, {"B.STL", false}, {"arm.urdf", false}, {"s.mcap", false}}));
  EXPECT_FALSE(listFolder(folder_ / "nowhere").ok());
  EXPECT_FALSE(canBeShown(".urdf"));
}

TEST_F(OpenedFiles, ListRecordingsOfOtherPrograms) {
  std::filesystem::create_directory(folder_ / "bag");
  std::filesystem::copy_file(folder_ / "s.mcap", folder_ / "bag/bag_0.mcap");
  test::writeText(folder_ / "bag/metadata.yaml", "");
  std::filesystem::create_directory(folder_ / "empty");
  test::writeText(folder_ / "empty/metadata.yaml", "");
  test::writeText(folder_ / "table.csv", "time,arm.turn\n0,1\n1,2\n");
  test::writeText(folder_ / "prices.csv", "fruit,price\napple,1\n");
  test::writeText(folder_ / "net.PCAP", "");
  const auto listed = listFolder(folder_.path());
  ASSERT_TRUE(listed.ok());
  EXPECT_EQ(*listed, (std::vector<FileEntry>{{"empty/", true},
                                             {"arm.urdf", false},
                                             {"bag/", false},
                                             {"net.PCAP", false},
                                             {"s.mcap", false},
                                             {"table.csv", false}}));
  // Chosen there, it is called as a file is.
  const auto request = requestOf({folder_ / "bag/"}, {});
  ASSERT_TRUE(request.ok());
  EXPECT_EQ(request->log, folder_ / "bag");
}

}  // namespace
}  // namespace rocinante
