#include "viewer/overlay/text_atlas.h"

#include <gtest/gtest.h>

#include "core/base/hash.h"
#include "viewer/overlay/embedded_font.h"

namespace rocinante {
namespace {

TEST(EmbeddedFont, IsATrueTypeFile) {
  ASSERT_GT(embeddedFont().size(), 100'000U);
  EXPECT_EQ(hexOf(embeddedFont().first(4)), "00010000");
}

TEST(TextAtlas, LaysGlyphsOutFromLeftToRightOnWholePixels) {
  const TextAtlas atlas(16);
  const auto quads = atlas.layout("AV.");
  ASSERT_EQ(quads.size(), 3U);
  EXPECT_LT(quads[0].x + quads[0].width / 2, quads[1].x + quads[1].width / 2);
  EXPECT_GT(quads[2].y, quads[0].y);  // a full stop sits at the bottom of its line
  EXPECT_LE(quads[2].y + quads[2].height, 16);
}

TEST(TextAtlas, SpacesTakeRoomAndDrawNothing) {
  const TextAtlas atlas(16);
  EXPECT_TRUE(atlas.layout("   ").empty());
  EXPECT_EQ(atlas.measure("   ").width, 3 * atlas.measure(" ").width);
  EXPECT_GT(atlas.measure(" ").width, 0);
}

TEST(TextAtlas, LineFeedsBeginALineAtTheLeft) {
  const TextAtlas atlas(20);
  const auto quads = atlas.layout("il\nil");
  ASSERT_EQ(quads.size(), 4U);
  EXPECT_EQ(quads[2].x, quads[0].x);
  EXPECT_EQ(quads[2].y, quads[0].y + 20);
  EXPECT_EQ(atlas.measure("il\nil").height, 40);
  EXPECT_EQ(atlas.measure("").width, 0);
}

TEST(TextAtlas, UnknownCharactersAndBrokenUtf8ShowTheReplacement) {
  const TextAtlas atlas(16);
  const int replacement = atlas.measure("\xEF\xBF\xBD").width;
  EXPECT_EQ(atlas.measure("\xF0\x9F\x98\x80").width, replacement);  // an emoji
  EXPECT_EQ(atlas.measure("\xFF").width, replacement);
  EXPECT_EQ(atlas.measure("\xC3").width, replacement);          // cut short
  EXPECT_EQ(atlas.measure("\xC0\x80").width, 2 * replacement);  // overlong
  EXPECT_NE(atlas.measure("\xC3\xA4").width, replacement);      // a-umlaut
}

TEST(NextCharacter, ReadsUtf8AndNeverStandsStill) {
  const std::string_view text = "a\xC3\xA4\xE2\x86\x92\xF0\x9F\x98\x80\xED\xA0\x80";
  std::vector<char32_t> characters;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t before = at;
    characters.push_back(nextCharacter(text, at));
    ASSERT_GT(at, before);
  }
  // A surrogate is no character.
  EXPECT_EQ(characters, (std::vector<char32_t>{'a', 0xE4, 0x2192, 0x1F600, 0xFFFD}));
}

TEST(TextAtlas, EveryGlyphLiesInsideAndIsNotEmpty) {
  for (const int size : {6, 16, 40}) {
    const TextAtlas atlas(size);
    for (const GlyphQuad& quad : atlas.layout("The quick brown fox ÄÖÜ Ω Ж → ≤")) {
      ASSERT_LE(quad.atlas_x + quad.width, atlas.width());
      ASSERT_LE(quad.atlas_y + quad.height, atlas.height());
      int ink = 0;
      for (int y = 0; y < quad.height; ++y) {
        for (int x = 0; x < quad.width; ++x) {
          ink += atlas.coverage()[static_cast<std::size_t>((quad.atlas_y + y) * atlas.width() +
                                                           quad.atlas_x + x)];
        }
      }
      EXPECT_GT(ink, 0);
    }
  }
}

TEST(TextAtlas, DrawsOnAPictureAndIsClippedAtItsEdges) {
  const TextAtlas atlas(16);
  Picture picture{40, 20, std::vector<std::uint8_t>(40 * 20 * 4, 255)};
  const Picture white = picture;
  atlas.drawOn(picture, 500, 500, "far away", 0x000000FF);
  atlas.drawOn(picture, -500, -500, "far away", 0x000000FF);
  EXPECT_EQ(picture, white);
  atlas.drawOn(picture, 30, -8, "WW", 0xFF0000FF);
  EXPECT_NE(picture, white);
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
    EXPECT_EQ(picture.rgba[i], 255);  // red text on white leaves red alone
  }
}

}  // namespace
}  // namespace rocinante
