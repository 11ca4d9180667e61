#include <gmock/gmock.h>

#include "core/foreign/decode/datagram_decoders.h"

namespace rocinante::decode {
namespace {

using ::testing::HasSubstr;

Result<std::shared_ptr<const DecoderSet>> parsed(std::string_view text) {
  return parseDecoders(text, "a.decoders.toml");
}

std::string faultOf(std::string_view text) {
  const auto set = parsed(text);
  return set ? "no fault" : set.error().text();
}

constexpr std::string_view kSound = R"(
[[decoder]]
name = "arm"
kind = "struct"
[[decoder.field]]
name = "q"
at = 4
type = "f32"
[[decoder.joint]]
device = "arm"
joint = "elbow"
field = "q"
)";

std::string changed(std::string_view from, std::string_view to) {
  std::string text(kSound);
  text.replace(text.find(from), from.size(), to);
  return text;
}

TEST(Declaration, ASoundOneIsReadWhole) {
  const auto set = parsed(kSound);
  ASSERT_TRUE(set) << set.error().text();
  ASSERT_EQ((*set)->decoders.size(), 1U);
  const Decoder& decoder = (*set)->decoders[0];
  EXPECT_EQ(decoder.fields[0].at, 4U);
  EXPECT_TRUE(decoder.fields[0].used);
  EXPECT_EQ((*set)->hash.size(), 64U);
}

TEST(Declaration, AnyChangeOfItsTextChangesItsHash) {
  EXPECT_NE((*parsed(kSound))->hash, (*parsed(changed("at = 4", "at = 8")))->hash);
}

TEST(Declaration, FaultsNameTheirPlaceAndWhatToDo) {
  EXPECT_EQ(faultOf(changed("field = \"q\"", "field = \"p\"")),
            "decoder `arm` has no field `p` (there is only q) (a.decoders.toml:12:9)");
  EXPECT_THAT(faultOf(changed("kind = \"struct\"", "kind = \"stuct\"")),
              HasSubstr("`stuct` is not a `kind` (did you mean `struct`?"));
  EXPECT_THAT(faultOf(changed("type = \"f32\"", "type = \"real\"")),
              HasSubstr("`real` is not a type"));
  EXPECT_THAT(faultOf(changed("at = 4", "at = -4")), HasSubstr("a.decoders.toml:7:6"));
  EXPECT_THAT(faultOf(changed("at = 4", "offset = 4")), HasSubstr("needs `at`"));
  EXPECT_THAT(faultOf(changed("type = \"f32\"", "type = \"u8\"\nbits = [4, 5]")),
              HasSubstr("`bits` must be a whole number from 1 to 4"));
  EXPECT_THAT(faultOf(changed("device = \"arm\"", "device = \"arm-{n}\"")),
              HasSubstr("has no field `n`"));
  EXPECT_THAT(faultOf(changed("device = \"arm\"", "device = \"arm-{\"")),
              HasSubstr("has no other one"));
  EXPECT_THAT(faultOf(changed("name = \"arm\"", "name = \"an arm\"")),
              HasSubstr("is not a decoder's name"));
  EXPECT_THAT(faultOf("format = 2\n" + std::string(kSound)), HasSubstr("only format 1"));
  EXPECT_THAT(faultOf(std::string(kSound) + std::string(kSound)), HasSubstr("a second decoder"));
  EXPECT_THAT(faultOf(""), HasSubstr("no [[decoder]]"));
  EXPECT_THAT(faultOf("[[decoder]]\nname=\"a\"\nkind=\"json\""), HasSubstr("makes nothing"));
  EXPECT_THAT(faultOf("[[decoder]\n"), HasSubstr("a.decoders.toml:1"));
}

TEST(Declaration, MoreFieldsThanTheLimitAreRefused) {
  std::string text = "[[decoder]]\nname = \"a\"\nkind = \"struct\"\n";
  for (int i = 0; i < 5; ++i) {
    text += "[[decoder.field]]\nname = \"f" + std::to_string(i) +
            "\"\nat = 0\ntype = \"u8\"\ncount = 1024\n";
  }
  text += "[[decoder.joint]]\ndevice = \"a\"\njoint = \"j\"\nfield = \"f0[0]\"\n";
  EXPECT_THAT(faultOf(text), HasSubstr("at most 4096 fields"));
}

TEST(Declaration, AFileCutAnywhereIsReadOrRefused) {
  for (std::size_t bytes = 0; bytes < kSound.size(); ++bytes) {
    const std::string cut(kSound.substr(0, bytes));
    const auto set = parsed(cut);
    EXPECT_TRUE(set || !set.error().what.empty());
  }
}

}  // namespace
}  // namespace rocinante::decode
