#include <gtest/gtest.h>

#include "viewer/page/page_file.h"

namespace rocinante {
namespace {

TEST(PageLink, NamesWhatIsGiven) {
  EXPECT_EQ(pageLink(Nanoseconds(12'500'000'000), "overview", {false, "arm", "link4"}),
            "#t=12.5&camera=overview&select=arm/link4");
  EXPECT_EQ(pageLink(Nanoseconds(-1), "", {false, "arm", ""}), "#t=-0.000000001&select=arm");
  EXPECT_EQ(pageLink(std::nullopt, "", {}), "");
}

TEST(PageLink, KeepsNamesThatHaveSignsOfALink) {
  // A name's own slash is encoded for the PATH, and that again for the address.
  EXPECT_EQ(pageLink(std::nullopt, "a&b=c d#e", {false, "tank/1", "100%"}),
            "#camera=a%26b%3Dc%20d%23e&select=tank%252F1/100%2525");
  EXPECT_EQ(pageLink(std::nullopt, "@1,2,3:4,5,6", {}), "#camera=@1,2,3:4,5,6");
}

}  // namespace
}  // namespace rocinante
