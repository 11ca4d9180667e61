#include "viewer/ui/commands/command.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "tests/support/temporary_folder.h"
#include "tests/viewer/support/test_session.h"
#include "viewer/ui/commands/key_commands.h"

namespace rocinante {
namespace {

std::string pageOfView() {
  std::ifstream file(std::string(ROCINANTE_SOURCE_DIR) + "/docs/programs/view.md");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

ViewModel armModel(const test::TemporaryFolder& folder, bool with_log) {
  test::writeText(folder / "arm.urdf", test::kArmUrdf);
  std::optional<Timeline> session;
  if (with_log) {
    test::writeSession(
        folder / "s.mcap",
        {{0, "event \"begun\"\n"}, {500, "event \"half\"\n"}, {1000, "event \"x\"\n"}});
    session = std::move(*Timeline::open(folder / "s.mcap"));
  }
  return std::move(*ViewModel::make(std::move(*loadCell(folder / "arm.urdf", {})),
                                    std::move(session), std::nullopt, {}, {}));
}

TEST(Commands, HaveOneNameAndOneMeaningForEachKey) {
  std::set<std::string_view> names;
  std::set<std::string> keys;
  for (const Command& command : allCommands()) {
    SCOPED_TRACE(command.name);
    EXPECT_TRUE(names.insert(command.name).second);
    EXPECT_NE(command.run, nullptr);
    EXPECT_FALSE(command.means.empty());
    EXPECT_LE(command.leastWords(), command.mostWords());
    for (const Shortcut& shortcut : command.shortcuts) {
      EXPECT_TRUE(keys.insert(std::string(shortcut.key)).second) << shortcut.key;
      const auto press = parseKey(shortcut.key);
      ASSERT_TRUE(press) << shortcut.key;
      EXPECT_EQ(commandOfKey(*press)->shortcut, &shortcut);
      EXPECT_TRUE(checkCommand(command.name, splitWords(shortcut.words).size()).ok());
    }
  }
}

// The page is written by hand around these rows; a command that is added, renamed or bound to
// another key must be there.
TEST(Commands, AreInThePageOfTheProgram) {
  const std::string page = pageOfView();
  ASSERT_FALSE(page.empty());
  for (const Command& command : allCommands()) {
    std::string row =
        fmt::format("| `{}{}{}` | {} | {} |\n", command.name, command.arguments.empty() ? "" : " ",
                    command.arguments, shownKeys(command), command.means);
    // A bar in a table is written with a backslash.
    for (std::size_t bar = row.find('|', 1); bar < row.find("` |"); bar = row.find('|', bar + 2)) {
      row.insert(bar, "\\");
    }
    EXPECT_NE(page.find(row), std::string::npos) << row;
  }
}

TEST(Commands, CheckTheNumberOfWords) {
  EXPECT_EQ(checkCommand("orbit", 1).error().text(), "`orbit` takes 2 words, not 1");
  EXPECT_EQ(checkCommand("speed", 2).error().text(), "`speed` takes 1 word, not 2");
  EXPECT_EQ(checkCommand("panels", 2).error().text(), "`panels` takes 0 to 1 word, not 2");
  EXPECT_EQ(checkCommand("dance", 0).error().text(), "unknown command `dance`");
  EXPECT_TRUE(checkCommand("panels", 0).ok());
}

TEST(Commands, ThatNeedALogSayThatThereIsNone) {
  const test::TemporaryFolder folder;
  ViewModel model = armModel(folder, false);
  ViewerRequests requests;
  const CommandStage stage{model, SteadyTime{}, 480, requests};
  EXPECT_EQ(runCommand("play", {}, stage).error().text(), "`play` needs a log");
  EXPECT_TRUE(runKey(*parseKey("space"), stage));  // a key then does nothing
}

TEST(Commands, ConnectAndAskTheProgramToWaitInAScript) {
  const test::TemporaryFolder folder;
  ViewModel model = armModel(folder, false);
  ViewerRequests requests;
  const CommandStage stage{model, SteadyTime{}, 480, requests};
  const std::vector<std::string> words{":5000", "pcap://lo"};
  EXPECT_TRUE(runCommand("connect", words, stage));
  EXPECT_EQ(requests.connect, words);
  EXPECT_TRUE(requests.await_files);
  EXPECT_FALSE(model.viewer.panels.open.shown);
  requests = {};
  EXPECT_TRUE(runCommand("connect", {}, stage));
  EXPECT_TRUE(model.viewer.panels.open.shown) << "where endpoints are offered";
  EXPECT_FALSE(requests.await_files);
  EXPECT_TRUE(runCommand("live", {}, stage));
  EXPECT_TRUE(requests.to_live && requests.await_files);
  const std::vector<std::string> other{"everything"};
  EXPECT_EQ(runCommand("disconnect", other, stage).error().text(), "`everything` is not forget");
  const std::vector<std::string> forget{"forget"};
  EXPECT_TRUE(runCommand("disconnect", forget, stage));
  EXPECT_EQ(requests.disconnect, true);
}

TEST(Commands, ShowALogBesideTheOneThatIsShown) {
  const test::TemporaryFolder folder;
  ViewModel model = armModel(folder, true);
  ViewerRequests requests;
  const CommandStage stage{model, SteadyTime{}, 480, requests};
  const auto run = [&](std::string_view line) {
    requests = {};
    const std::vector<std::string> words = splitWords(line);
    const Status done = runCommand("beside", words, stage);
    return done ? std::string() : done.error().text();
  };
  constexpr const char* kNone = "there is no session beside (`beside FILE`, or view --beside LOG)";
  EXPECT_EQ(run("on"), kNone);
  EXPECT_EQ(run("none"), kNone);
  model.viewer.panels.open.beside_comes = true;
  EXPECT_EQ(run("on"), kNone);
  EXPECT_EQ(run("none"), "") << "one is being loaded";
  ASSERT_TRUE(requests.beside);
  EXPECT_TRUE(requests.beside->file.empty());
  model.viewer.panels.open.beside_comes = false;
  EXPECT_EQ(run("b%20c.mcap event:the gripper opens"), "");
  ASSERT_TRUE(requests.beside);
  EXPECT_EQ(requests.beside->file, "b c.mcap");
  EXPECT_EQ(requests.beside->align, "event:the gripper opens");
  EXPECT_TRUE(requests.await_files) << "a script has it when it goes on";
  EXPECT_EQ(run(""), "");
  EXPECT_TRUE(model.viewer.panels.open.shown && model.viewer.panels.open.beside);
  EXPECT_FALSE(requests.beside);
  ASSERT_TRUE(model.showBeside(std::move(*Timeline::open(folder / "s.mcap")), "").ok());
  EXPECT_EQ(run(""), "");
  EXPECT_FALSE(model.beside_shown);
  EXPECT_EQ(run("on"), "");
  EXPECT_TRUE(model.beside_shown);
  EXPECT_EQ(run("off 1s"), "`beside off` takes no other word");
  EXPECT_EQ(run("none"), "");
  ASSERT_TRUE(requests.beside);
  EXPECT_TRUE(requests.beside->file.empty());
}

TEST(Commands, RunByKeyWithTheWordsOfTheKey) {
  const test::TemporaryFolder folder;
  ViewModel model = armModel(folder, true);
  ASSERT_TRUE(model.update(SteadyTime{}).ok());
  ViewerRequests requests;
  const CommandStage stage{model, SteadyTime{}, 480, requests};
  const auto at = [&] { return model.cursor()->position(SteadyTime{}) - model.origin(); };
  const auto press = [&](std::string_view key) { EXPECT_TRUE(runKey(*parseKey(key), stage)); };
  press("end");
  EXPECT_EQ(at(), std::chrono::seconds(1));
  press("shift+left");
  EXPECT_EQ(at(), std::chrono::milliseconds(900));
  press(",");
  EXPECT_EQ(at(), std::chrono::milliseconds(500));
  press(".");
  press("home");
  EXPECT_EQ(at(), Nanoseconds(0));

  press("shift+E");  // nothing else is meant by it
  EXPECT_EQ(model.style().edges, EdgeStyle::over);
  KeyPress held = *parseKey("E");
  held.repeated = true;
  EXPECT_TRUE(runKey(held, stage));
  EXPECT_EQ(model.style().edges, EdgeStyle::over);
  KeyPress with_control = *parseKey("E");
  with_control.control = true;
  EXPECT_TRUE(runKey(with_control, stage));
  EXPECT_EQ(model.style().edges, EdgeStyle::over);

  press("F");
  EXPECT_TRUE(requests.fit);
  press("shift+F");
  EXPECT_TRUE(requests.fit_selected);
}

TEST(Commands, SayWhatTheyDoWithTheirKeys) {
  EXPECT_EQ(commandHint("start"), "the start of the log (Home)");
  EXPECT_EQ(commandHint("step", "-1"), "a second back (left)");
  EXPECT_EQ(commandHint("event", "next"), "the next event (full stop)");
  EXPECT_EQ(commandHint("pause"), "stay at this moment");
  EXPECT_EQ(commandHint("dance"), "");
}

TEST(Commands, OpenATabOfTheLeftPanel) {
  const test::TemporaryFolder folder;
  ViewModel model = armModel(folder, true);
  ASSERT_TRUE(model.update(SteadyTime{}).ok());
  ViewerRequests requests;
  const CommandStage stage{model, SteadyTime{}, 480, requests};
  PanelState& panels = model.viewer.panels;
  panels.shown = false;
  panels.places.places["Scene"].collapsed = true;
  EXPECT_TRUE(runCommand("tab", std::vector<std::string>{"check"}, stage));
  EXPECT_EQ(panels.wanted_tab, "Check");
  EXPECT_TRUE(panels.shown);
  EXPECT_FALSE(panels.places.places["Scene"].collapsed);
}

TEST(Commands, DismissTheLinesOverThePicture) {
  const test::TemporaryFolder folder;
  ViewModel model = armModel(folder, false);
  ViewerRequests requests;
  PanelState& panels = model.viewer.panels;
  panels.notes = {{"a texture is missing", false}};
  const std::vector<NoticeKey> said{{"driving", true}, {"kept: the disk is full"}};
  EXPECT_EQ(panels.notices.order(said).size(), 2U);
  EXPECT_TRUE(runCommand("dismiss", {}, {model, SteadyTime{}, 480, requests}));
  EXPECT_TRUE(panels.notes.empty());
  EXPECT_EQ(panels.notices.order(said), std::vector<std::size_t>{0});
}

TEST(Commands, AskForABuiltInCameraUnlessTheCellHasOneOfThatName) {
  const test::TemporaryFolder folder;
  ViewModel model = armModel(folder, false);
  ASSERT_TRUE(model.update(SteadyTime{}).ok());
  ViewerRequests requests;
  const CommandStage stage{model, SteadyTime{}, 480, requests};
  EXPECT_TRUE(runCommand("camera", std::vector<std::string>{"map"}, stage));
  EXPECT_EQ(requests.built_in_camera, "map");
  requests = {};
  CellCamera own;
  own.name = "map";
  own.eye = {1, 2, 3};
  model.addCamera(own);
  EXPECT_TRUE(runCommand("camera", std::vector<std::string>{"map"}, stage));
  EXPECT_FALSE(requests.built_in_camera);
  EXPECT_EQ(model.cameraName(), "map");
}

TEST(Commands, ALayoutAsksForItsBuiltInCameraAsTheCommandForCamerasDoes) {
  const test::TemporaryFolder folder;
  ViewModel model = armModel(folder, false);
  ASSERT_TRUE(model.update(SteadyTime{}).ok());
  ViewerRequests requests;
  const CommandStage stage{model, SteadyTime{}, 480, requests};
  test::writeText(folder / "l.layout.toml", "format = 1\ncamera = \"fit:arm\"\n");
  const std::vector<std::string> words{(folder / "l.layout.toml").string()};
  ASSERT_TRUE(runCommand("layout", words, stage));
  EXPECT_EQ(requests.built_in_camera, "fit:arm") << "in this frame";
  EXPECT_EQ(model.viewer.built_in_wanted, "") << "no later one";
  EXPECT_TRUE(model.viewer.panels.notes.empty());
  requests = {};
  test::writeText(folder / "l.layout.toml", "format = 1\ntheme = \"light\"\n");
  ASSERT_TRUE(runCommand("layout", words, stage));
  EXPECT_FALSE(requests.built_in_camera);
}

TEST(Commands, RefuseWrongWords) {
  const test::TemporaryFolder folder;
  ViewModel model = armModel(folder, true);
  ASSERT_TRUE(model.update(SteadyTime{}).ok());
  ViewerRequests requests;
  const CommandStage stage{model, SteadyTime{}, 480, requests};
  for (const char* line :
       {"seek later", "step far",         "step 1e9",       "event first",     "packet x",
        "speed 0",    "loop maybe",       "camera nowhere", "camera-number 0", "camera-number 1.5",
        "fit all",    "orbit a b",        "pan 1 b",        "zoom nan",        "edges many",
        "shadows 2",  "hide nobody",      "show layer",     "auto x/y/z",      "select nobody",
        "insets all", "style edges many", "detail 10",      "panels 1",        "help me",
        "click 1 b",  "key enter2",       "frame few",      "wait long",       "clock utc",
        "tab Check",  "tab sources",      "tab all"}) {
    std::vector<std::string> words = splitWords(line);
    const std::string name = words.front();
    words.erase(words.begin());
    EXPECT_FALSE(runCommand(name, words, stage)) << line;
  }
}

}  // namespace
}  // namespace rocinante
