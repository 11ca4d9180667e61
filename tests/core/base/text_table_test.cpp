#include "core/cli/text_table.h"

#include <gtest/gtest.h>

#include <string>

namespace rocinante::cli {
namespace {

std::size_t places(std::string_view line) {
  std::size_t count = 0;
  while (firstPlaces(line, count).size() < line.size()) ++count;
  return count;
}

void expectNoLineOver(std::size_t columns, std::string_view text) {
  for (; !text.empty(); text.remove_prefix(text.find('\n') + 1)) {
    const std::string_view line = text.substr(0, text.find('\n'));
    EXPECT_LE(places(line), columns) << line;
  }
}

TextTable channels() {
  TextTable table;
  table.is_number = {false, false, true, false};
  table.rows = {{"channel", "sender", "messages", "activity"},
                {"/udp/239.255.19.96:23456/arm", "192.0.2.2:36761", "2,009", "########"},
                {"/udp/239.255.19.96:23456/gripper", "192.0.2.2:41279", "46", "..#....#"}};
  return table;
}

TEST(TextTable, IsAsWideAsItsCellsWhereNothingLimitsIt) {
  const std::string whole =
      "  channel                           sender           messages  activity\n"
      "  /udp/239.255.19.96:23456/arm      192.0.2.2:36761     2,009  ########\n"
      "  /udp/239.255.19.96:23456/gripper  192.0.2.2:41279        46  ..#....#\n";
  EXPECT_EQ(channels().text(), whole);
  EXPECT_EQ(channels().text(71), whole);
}

TEST(TextTable, CutsTheWidestNamesInTheMiddle) {
  EXPECT_EQ(channels().text(64),
            "  channel                    sender           messages  activity\n"
            "  /udp/239.25...6:23456/arm  192.0.2.2:36761     2,009  ########\n"
            "  /udp/239.25...456/gripper  192.0.2.2:41279        46  ..#....#\n");
}

TEST(TextTable, LeavesOutWhatIsExpendableBeforeNamesAreUnreadable) {
  TextTable table = channels();
  table.expendable = {1};
  table.whole = {3};
  EXPECT_EQ(table.text(48),
            "  channel                     messages  activity\n"
            "  /udp/239.255...6:23456/arm     2,009  ########\n"
            "  /udp/239.255...456/gripper        46  ..#....#\n"
            "  (a wider terminal shows more: sender)\n");
  EXPECT_EQ(table.text(71).find("wider"), std::string::npos);
}

TEST(TextTable, NoLineIsLongerThanTheTerminal) {
  TextTable table = channels();
  table.rows[1][3] = "ümläute and a text that does not end here, and not here either";
  for (std::size_t columns = 24; columns < 130; ++columns)
    expectNoLineOver(columns, table.text(columns));
}

TEST(TextTable, CutTextsHaveTheirPlaces) {
  EXPECT_EQ(withoutMiddle("shoulder_pan_jöint", 12), "shoul...öint");
  EXPECT_EQ(withoutMiddle("shoulder_pan_jöint", 18), "shoulder_pan_jöint");
  EXPECT_EQ(withoutMiddle("shoulder_pan_jöint", 0), "shoulder_pan_jöint");
  EXPECT_EQ(withoutMiddle("shoulder_pan_jöint", 3), "sho");
  EXPECT_EQ(withoutEnd("shoulder_pan_jöint", 12), "shoulder_...");
  EXPECT_EQ(withoutEnd("elbow", 5), "elbow");
  for (std::size_t most = 1; most < 20; ++most) {
    EXPECT_LE(places(withoutMiddle("schräg über größeren", most)), most);
    EXPECT_LE(places(withoutEnd("schräg über größeren", most)), most);
  }
}

TEST(Wrapped, BreaksAtSpacesAndGoesOnBehindTheIndent) {
  EXPECT_EQ(wrapped("  losses      kernel 1, queue 2, disk 3, truncated 4", 40, 14),
            "  losses      kernel 1, queue 2, disk 3,\n"
            "              truncated 4");
  EXPECT_EQ(wrapped("two\n  lines that are\n", 24, 4), "two\n  lines that are\n");
  EXPECT_EQ(wrapped("any length without a terminal", 0, 2), "any length without a terminal");
}

TEST(Wrapped, KeepsWordsThatAreLongerThanALineWhole) {
  EXPECT_EQ(wrapped("recorded /a/path/that/is/longer/than/a/line once", 24, 2),
            "recorded\n  /a/path/that/is/longer/than/a/line\n  once");
  EXPECT_EQ(wrapped("/a/path/that/is/longer/than/a/line", 24, 2),
            "/a/path/that/is/longer/than/a/line");
  EXPECT_EQ(wrapped(std::string(60, ' '), 24, 2), std::string(60, ' '));
}

}  // namespace
}  // namespace rocinante::cli
