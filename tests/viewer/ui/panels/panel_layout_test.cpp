#include "viewer/ui/panels/panel_layout.h"

#include <gtest/gtest.h>

namespace rocinante {
namespace {

TEST(PanelLayout, AListTakesTheHeightThatItsRowsNeedAndThatIsThere) {
  EXPECT_EQ(listHeight(5, 20, 1000), 100);
  EXPECT_EQ(listHeight(40, 20, 500), 500);
  EXPECT_EQ(listHeight(1, 20, 500), 60);
  EXPECT_EQ(listHeight(40, 20, -10), 60);
}

}  // namespace
}  // namespace rocinante
