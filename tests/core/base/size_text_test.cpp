#include <gtest/gtest.h>

#include "core/base/figure_text.h"

namespace rocinante {
namespace {

TEST(SizeText, ReadsWell) {
  EXPECT_EQ(sizeText(0), "0 B");
  EXPECT_EQ(sizeText(999), "999 B");
  EXPECT_EQ(sizeText(1'000), "1.0 kB");
  EXPECT_EQ(sizeText(999'949), "999.9 kB");
  EXPECT_EQ(sizeText(999'950), "1.0 MB");
  EXPECT_EQ(sizeText(~std::uint64_t{0}), "18.4 EB");
}

TEST(ParseSize, TakesDecimalAndBinaryUnits) {
  EXPECT_EQ(parseSize("4096").value(), 4'096U);
  EXPECT_EQ(parseSize("0").value(), 0U);
  EXPECT_EQ(parseSize("512B").value(), 512U);
  EXPECT_EQ(parseSize("1kB").value(), 1'000U);
  EXPECT_EQ(parseSize("1GB").value(), 1'000'000'000U);
  EXPECT_EQ(parseSize("512MiB").value(), 512U << 20U);
  EXPECT_EQ(parseSize("2TiB").value(), std::uint64_t{2} << 40U);
  EXPECT_EQ(parseSize("1.5 GB").value(), 1'500'000'000U);
  EXPECT_EQ(parseSize("0.1MiB").value(), 104'857U);
  EXPECT_EQ(parseSize("64mb").value(), 64'000'000U);
  EXPECT_EQ(parseSize("0.999999TiB").value(), 1'099'510'528'264U);
}

TEST(ParseSize, RefusesWhatIsNone) {
  for (const std::string_view text :
       {"", "MB", "-1", "+1", "1e6", "1.", ".5GB", "1 0", "1GBs", "1G", "1Gb ", "1  GB", "0x10",
        "1.0000001GB", "9223372036854775808", "8388608TiB", "99999999999999999999", "1PB"}) {
    SCOPED_TRACE(text);
    const auto size = parseSize(text);
    ASSERT_FALSE(size.ok());
    EXPECT_EQ(size.error().kind, ErrorKind::bad_argument);
  }
}

}  // namespace
}  // namespace rocinante
