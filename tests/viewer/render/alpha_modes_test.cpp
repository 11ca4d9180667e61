// What a material's opacity, wrap and texture transform mean in a picture: colours, shadows, whose
// pixels are whose.

#include <gtest/gtest.h>

#include <numeric>

#include "core/math/trigonometry.h"
#include "tests/support/temporary_folder.h"
#include "tests/viewer/render/looks_studio.h"
#include "viewer/picture/picture.h"

namespace rocinante {
namespace {

using test::at;
using test::colored;
using test::Rgb;
using test::squareMesh;
using test::Studio;
using test::TestCell;

bool isRedish(const Rgb& c) { return c.r > 100 && c.g < 70 && c.b < 70; }
bool isBlueish(const Rgb& c) { return c.b > 100 && c.r < 70 && c.g < 70; }

class AlphaModes : public testing::Test {
 protected:
  AlphaModes() {
    // Four stripes of one red, of alpha 0, 64, 160 and 255.
    Picture stripes{64, 64, {}};
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) {
        const std::uint8_t alpha[] = {0, 64, 160, 255};
        stripes.rgba.insert(stripes.rgba.end(), {255, 0, 0, alpha[x / 16]});
      }
    }
    EXPECT_TRUE(writePng(folder_ / "stripes.png", stripes, true).has_value());
  }

  Material striped(AlphaMode mode, float opacity = 1, float cutoff = 0.5F) const {
    Material material = colored(1, 1, 1, opacity);
    material.diffuse_map = folder_ / "stripes.png";
    material.alpha_mode = mode;
    material.alpha_cutoff = cutoff;
    material.wrap_u = TextureWrap::clamp_to_edge;
    return material;
  }

  /// A card of 8 m before a blue wall: stripes of 32 pixels from 16 on.
  static void addCard(TestCell& cell, const Material& material) {
    cell.add("wall", squareMesh(9.5), {0, 3, 0}, colored(0, 0, 1));
    cell.add("card", squareMesh(8), {0, 0, 0}, material);
  }

  /// "rrbb": red where the card is, blue where one sees through, by stripe; "." for neither.
  static std::string stripesOf(const Picture& picture) {
    std::string seen;
    for (const int x : {32, 64, 96, 128}) {
      const Rgb color = at(picture, x, 80);
      seen += isRedish(color) ? 'r' : isBlueish(color) ? 'b' : '.';
    }
    return seen;
  }

  test::TemporaryFolder folder_;
};

TEST_F(AlphaModes, AreDrawnAsTheyMean) {
  struct Case {
    Material material;
    const char* stripes;
  };
  Material plain_mask = colored(1, 0, 0, 0.4F);
  plain_mask.alpha_mode = AlphaMode::mask;
  Material plain_opaque = plain_mask;
  plain_opaque.alpha_mode = AlphaMode::opaque;
  Material low_mask = plain_mask;
  low_mask.alpha_cutoff = 0.3F;
  for (const Case& each : {
           Case{striped(AlphaMode::opaque), "rrrr"},
           Case{striped(AlphaMode::opaque, 0), "rrrr"},
           Case{striped(AlphaMode::mask), "bbrr"},
           Case{striped(AlphaMode::mask, 1, 0.2F), "brrr"},
           Case{striped(AlphaMode::mask, 1, 0.99F), "bbbr"},
           Case{striped(AlphaMode::mask, 0.7F), "bbbr"},  // 0.63 * 0.7 is below 0.5
           Case{striped(AlphaMode::mask, 0.4F), "bbbb"},
           Case{striped(AlphaMode::mask, 1, 0), "rrrr"},
           Case{striped(AlphaMode::blend), "bb.r"},
           Case{plain_opaque, "rrrr"},
           Case{plain_mask, "bbbb"},
           Case{low_mask, "rrrr"},
       }) {
    TestCell cell;
    addCard(cell, each.material);
    Studio studio(cell);
    for (const char* shading : {"shading=standard", "shading=plain"}) {
      EXPECT_EQ(stripesOf(studio.drawn({shading})), each.stripes)
          << shading << " mode " << static_cast<int>(each.material.alpha_mode) << " opacity "
          << each.material.diffuse.a << " cutoff " << each.material.alpha_cutoff;
    }
    const std::vector<std::string> owners = studio.owners({});
    for (std::size_t i = 0; i < 4; ++i) {
      const std::string& owner = owners[80 * 160 + 32 + 32 * i];
      if (each.stripes[i] == 'r') {
        EXPECT_EQ(owner, "card") << i;
      }
      if (each.stripes[i] == 'b' && each.material.alpha_mode != AlphaMode::blend) {
        EXPECT_EQ(owner, "wall") << i;
      }
    }
  }
}

TEST_F(AlphaModes, AMaskedCardIsDrawnWithEveryLook) {
  TestCell cell;
  addCard(cell, striped(AlphaMode::mask));
  Studio studio(cell);
  for (const std::vector<std::string>& words : {std::vector<std::string>{"shadows=on"},
                                                {"contact=on"},
                                                {"shadows=on", "contact=on"},
                                                {"edges=on"},
                                                {"limits=on"}}) {
    EXPECT_EQ(stripesOf(studio.drawn(words)), "bbrr") << words[0];
  }
  // See-through, its holes stay holes.
  const Picture seen_through = studio.drawn({"transparent=card@0.5"});
  EXPECT_TRUE(isBlueish(at(seen_through, 32, 80)));
  EXPECT_GT(at(seen_through, 128, 80).r, 80);
  EXPECT_GT(at(seen_through, 128, 80).b, 40);
}

TEST_F(AlphaModes, TheShadowOfAMaskedCardHasItsHoles) {
  const auto wallUnder = [&](AlphaMode mode) {
    TestCell cell;
    cell.cell().scene.light_direction = {-0.6, -1, 0};
    addCard(cell, striped(mode));
    Studio studio(cell);
    std::vector<int> brightness;
    const Picture lit = studio.drawn({}), shaded = studio.drawn({"shadows=on"});
    int dark = 0;
    for (int x = 5; x < 155; ++x)
      dark += at(shaded, x, 80).sum() < at(lit, x, 80).sum() - 10 ? 1 : 0;
    return dark;
  };
  // The shadow lies 1.8 m aside; the wall ends 12 pixels beyond the card.
  const int whole = wallUnder(AlphaMode::opaque), cut = wallUnder(AlphaMode::mask);
  EXPECT_GT(whole, 8);
  EXPECT_GT(cut, 8) << "the right half keeps light away";
  TestCell cell;
  cell.cell().scene.light_direction = {0.6, -1, 0};
  addCard(cell, striped(AlphaMode::mask));
  Studio studio(cell);
  // To the left falls the shadow of the left edge: the hole.
  const Picture lit = studio.drawn({}), shaded = studio.drawn({"shadows=on"});
  EXPECT_EQ(at(lit, 8, 80), at(shaded, 8, 80));
}

TEST_F(AlphaModes, OnePictureIsWrappedInSeveralWays) {
  Picture halves{64, 64, {}};
  for (int i = 0; i < 64 * 64; ++i) {
    const bool left = i % 64 < 32;
    halves.rgba.insert(halves.rgba.end(),
                       {std::uint8_t(left ? 255 : 0), 0, std::uint8_t(left ? 0 : 255), 255});
  }
  ASSERT_TRUE(writePng(folder_ / "halves.png", halves, true).has_value());
  Material material = colored(1, 1, 1);
  material.diffuse_map = folder_ / "halves.png";
  material.map_scale = {3, 1};
  material.map_offset = {-1, 0};
  TestCell cell;
  int row = 0;
  for (const TextureWrap wrap :
       {TextureWrap::repeat, TextureWrap::mirrored_repeat, TextureWrap::clamp_to_edge}) {
    material.wrap_u = wrap;
    cell.add("strip" + std::to_string(row), squareMesh(3), {0, 0, 3.2 - 3.2 * row}, material);
    ++row;
  }
  Studio studio(cell);
  for (const char* shading : {"shading=standard", "shading=plain"}) {
    const Picture picture = studio.drawn({shading});
    const auto rowOf = [&](int y) {
      std::string seen;
      // 48 pixels: 3 pictures of 16, looked at in the middle of each half.
      for (int i = 0; i < 6; ++i) seen += isRedish(at(picture, 56 + 4 + 8 * i, y)) ? 'r' : 'b';
      return seen;
    };
    EXPECT_EQ(rowOf(29), "rbrbrb") << shading;
    EXPECT_EQ(rowOf(80), "brrbbr") << shading;
    EXPECT_EQ(rowOf(131), "rrrbbb") << shading;
  }
}

TEST_F(AlphaModes, ATurnedTextureIsTurned) {
  // A quarter turn counter-clockwise of the coordinates: u is where v was.
  Material material = striped(AlphaMode::opaque);
  Picture halves{64, 64, {}};
  for (int i = 0; i < 64 * 64; ++i) {
    const bool left = i % 64 < 32;
    halves.rgba.insert(halves.rgba.end(),
                       {std::uint8_t(left ? 255 : 0), 0, std::uint8_t(left ? 0 : 255), 255});
  }
  ASSERT_TRUE(writePng(folder_ / "turned.png", halves, true).has_value());
  material.diffuse_map = folder_ / "turned.png";
  material.map_rotation = static_cast<float>(kPi / 2);
  material.map_offset = {1, 0};
  TestCell cell;
  cell.add("card", squareMesh(8), {0, 0, 0}, material);
  Studio studio(cell);
  const Picture picture = studio.drawn({});
  // u' = 1 - v: the upper half shows the picture's left.
  EXPECT_TRUE(isRedish(at(picture, 80, 40)));
  EXPECT_TRUE(isBlueish(at(picture, 80, 120)));
}

}  // namespace
}  // namespace rocinante
