#include "viewer/ui/program/input_record.h"

#include <gtest/gtest.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/support/temporary_folder.h"
#include "viewer/ui/commands/command.h"
#include "viewer/ui/program/view_content.h"
#include "viewer/ui/program/view_script.h"

namespace rocinante {
namespace {

FrameInput dragging() {
  FrameInput input;
  input.width = 640;
  input.height = 480;
  input.scale = 1.25;
  input.mouse = {320.0, 200.0};
  input.down[2] = true;
  input.held = {GLFW_KEY_LEFT_SHIFT};
  return input;
}

/// Does what the lines say to `input`, as a script does.
Status doAgain(const std::string& lines, FrameInput& input) {
  ViewContent empty = emptyContent();
  ViewerRequests requests;
  const auto script = parseViewScript(lines, "s");
  if (!script.ok()) return script.error();
  for (const ViewCommand& command : *script) {
    const Status done =
        runCommand(command.name, command.words, {*empty.model, {}, 1, requests, &input});
    if (!done) return done;
  }
  return {};
}

TEST(InputLines, SayThatAClickIsTheSecondOfTwo) {
  FrameInput click;
  click.down[0] = true;
  click.again = true;
  EXPECT_EQ(inputLines({}, click), "button left down again\n");
  FrameInput input;
  ASSERT_TRUE(doAgain("button left down again\n", input));
  EXPECT_TRUE(input.again);
  input.endFrame();
  EXPECT_FALSE(input.again);
}

TEST(InputLines, SayWhatChangedAndNothingElse) {
  EXPECT_EQ(inputLines({}, dragging()),
            "window-size 640 480 1.25\nmouse 320 200\nbutton middle down\nhold shift\n");
  EXPECT_EQ(inputLines(dragging(), dragging()), "");
  FrameInput after = dragging();
  after.mouse.reset();
  after.down[2] = false;
  after.wheel = -1;
  after.held.clear();
  after.presses = {{GLFW_KEY_P, true, true, true}, {GLFW_KEY_ENTER, false, false, false}};
  after.typed = "a #1%\xc3\xa9";
  EXPECT_EQ(inputLines(dragging(), after),
            "mouse-out\nbutton middle up\nwheel -1\nrelease shift\npress ctrl+shift+P again\n"
            "press enter\ntype a%20%231%25\xc3\xa9\n");
}

TEST(InputLines, MakeTheSameInputAgain) {
  FrameInput again;
  ASSERT_TRUE(doAgain(inputLines({}, dragging()), again));
  EXPECT_EQ(inputLines(dragging(), again), "");
  FrameInput next = dragging();
  next.presses = {{GLFW_KEY_ESCAPE, false, false, false}};
  next.typed = "x y";
  next.wheel = 0.5;
  next.wheel_across = -0.25;
  ASSERT_TRUE(doAgain(inputLines(dragging(), next), again));
  EXPECT_EQ(inputLines({}, again), inputLines({}, next));
}

TEST(InputLines, HaveWhatIsPasted) {
  FrameInput input;
  input.pasted = "look here\n";
  EXPECT_EQ(inputLines({}, input), "clipboard look%20here%0A\n");
  FrameInput again;
  ASSERT_TRUE(doAgain(inputLines({}, input), again));
  EXPECT_EQ(again.pasted, input.pasted);
  input.pasted = "\xff is of no script";
  EXPECT_EQ(inputLines({}, input), "clipboard\n");
  // As much as goes into a line, up to a whole letter.
  input.pasted = std::string(4095, 'x') + "\xc3\xa9" + std::string(9000, 'y');
  EXPECT_EQ(inputLines({}, input), "clipboard " + std::string(4095, 'x') + "\n");
  again.endFrame();
  EXPECT_FALSE(again.pasted.has_value());
}

TEST(InputRecord, TimesAreCountedFromTheFirstFrameAndGrow) {
  const test::TemporaryFolder folder;
  auto record = InputRecord::begin(folder / "r.txt");
  ASSERT_TRUE(record.ok());
  const SteadyTime began{std::chrono::hours(3)};
  record->add({}, began);
  record->addDrop({"a b.urdf"});
  record->addFilesCame();
  record->add({}, began + std::chrono::milliseconds(1500));
  record->add({}, began + std::chrono::milliseconds(1500));
  std::ifstream file(folder / "r.txt");
  const std::string text(std::istreambuf_iterator<char>(file), {});
  EXPECT_NE(text.find("frame-at 0.000000000s\ndrop a%20b.urdf\nawait-files\n"
                      "frame-at 1.500000000s\nframe-at 1.500000001s\n"),
            std::string::npos)
      << text;
  EXPECT_TRUE(parseViewScript(text, "r").ok());
}

TEST(InputRecord, AKeyThatWentDownAndUpWithinAFrameIsNotHeld) {
  FrameInput down;
  down.presses = {{GLFW_KEY_ENTER, false, false, false}};
  down.held = {GLFW_KEY_ENTER};
  EXPECT_EQ(inputLines({}, down), "press enter\n");
}

TEST(InputRecord, HasTheKeysThatFlyWhileTheyAreHeld) {
  const test::TemporaryFolder folder;
  auto record = InputRecord::begin(folder / "r.txt");
  ASSERT_TRUE(record.ok());
  FrameInput flying;
  flying.down[1] = true;
  flying.held = {GLFW_KEY_W};
  flying.presses = {{GLFW_KEY_W, false, false, false}};
  record->add(flying, SteadyTime{});
  flying.endFrame();
  record->add(flying, SteadyTime{} + std::chrono::milliseconds(10));
  flying.held.clear();
  record->add(flying, SteadyTime{} + std::chrono::milliseconds(20));
  std::ifstream file(folder / "r.txt");
  const std::string text(std::istreambuf_iterator<char>(file), {});
  EXPECT_NE(text.find("button right down\npress W\nframe-at 0.000000000s\n"
                      "hold W\nframe-at 0.010000000s\nrelease W\nframe-at 0.020000000s\n"),
            std::string::npos)
      << text;
  FrameInput again;
  ASSERT_TRUE(doAgain("hold E\nhold W\nhold Q\nrelease E\n", again));
  EXPECT_EQ(again.held, (std::vector<int>{GLFW_KEY_Q, GLFW_KEY_W}));
}

TEST(InputRecord, SaysWhenTheDiskIsFull) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP();
  const auto record = InputRecord::begin("/dev/full");
  ASSERT_FALSE(record.ok());
  EXPECT_EQ(record.error().text(), "cannot be written: No space left on device (/dev/full)");
}

TEST(InputCommands, TakeKeysAsTablesNameThem) {
  for (const auto& [word, name] :
       std::initializer_list<std::pair<const char*, const char*>>{{"Ctrl+G", "ctrl+G"},
                                                                  {"ctrl+g", "ctrl+G"},
                                                                  {"Shift+Ctrl+z", "ctrl+shift+Z"},
                                                                  {"Enter", "enter"},
                                                                  {"Shift+left", "shift+left"},
                                                                  {"Esc", "escape"},
                                                                  {"f1", "F1"},
                                                                  {"Shift+comma", "shift+,"},
                                                                  {"full-stop", "."},
                                                                  {"g", "G"},
                                                                  {"Page-Up", "page-up"}}) {
    FrameInput input;
    EXPECT_TRUE(doAgain(std::string("press ") + word, input)) << word;
    EXPECT_EQ(inputLines({}, input), std::string("press ") + name + "\n");
  }
}

TEST(InputCommands, RefuseWhatNoMouseAndNoKeyboardDoes) {
  FrameInput input;
  for (const auto& [line, fault] : std::initializer_list<std::pair<const char*, const char*>>{
           {"mouse 1e300 0", "`1e300` must be from -100000 to 100000"},
           {"mouse nan 0", "`nan` is not a number"},
           {"button left up again", "only a button that goes down can go down `again`"},
           {"button left down twice", "only a button that goes down can go down `again`"},
           {"button left sideways", "`sideways` is neither down nor up"},
           {"button sixth down", "`sixth` is not a button: left, right, middle, fourth, fifth"},
           {"wheel 100000", "`100000` must be from -1000 to 1000"},
           {"press hyper", "`hyper` is not a key: use G, ctrl+G, shift+left or enter"},
           {"press ctrl+ctrl+G", "`ctrl+ctrl+G` is not a key: use G, ctrl+G, shift+left or enter"},
           {"hold H", "`H` means nothing while it is held"},
           {"type %0", "`%0` has a % without two hexadecimal digits"},
           {"type %00", "`%00` has a NUL"},
           {"type %ff", "`%ff` is not UTF-8"},
           {"window-size 0 10", "`0` must be from 1 to 8192"},
           {"window-size 10 10 9", "`9` must be from 1 to 4"}}) {
    SCOPED_TRACE(line);
    const Status done = doAgain(line, input);
    ASSERT_FALSE(done);
    EXPECT_EQ(done.error().text(), fault);
  }
  EXPECT_EQ(inputLines({}, input), "");
}

}  // namespace
}  // namespace rocinante
