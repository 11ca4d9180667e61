#include "viewer/ui/program/legibility.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

constexpr std::string_view kHead = "fault,panel,text,x,y,width,height,contrast,cut_px\n";

TEST(Legibility, NamesTheFaultOfEachText) {
  const std::vector<PanelText> texts{{"Scene", "say \"a\", b", {1, 2, 30, 12}, 7.25, 0.5F},
                                     {"Scene", "dim", {1, 20, 30, 12}, 4.49, 0},
                                     {"", "long na", {1, 40, 30, 12}, 4.5, 1.5F}};
  EXPECT_EQ(legibilityTable(texts, {}, {}),
            std::string(kHead) +
                "-,\"Scene\",\"say \"\"a\"\", b\",1,2,30,12,7.25,0.5\n"
                "faint,\"Scene\",\"dim\",1,20,30,12,4.49,0.0\n"
                "cut,\"\",\"long na\",1,40,30,12,4.50,1.5\n");
}

TEST(Legibility, NamesThePanelsThatLieOnAnInset) {
  const std::vector<NamedPlace> panels{{"Scene", {0, 0, 100, 300}}, {"Device", {300, 0, 100, 90}}};
  const std::vector<NamedPlace> insets{{"map", {100, 0, 80, 60}}, {"over", {290, 50, 60, 60}}};
  EXPECT_EQ(legibilityTable({}, panels, insets),
            std::string(kHead) + "over inset,\"Device\",\"over\",300,50,50,40,,\n");
}

}  // namespace
}  // namespace rocinante
