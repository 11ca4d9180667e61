#include "viewer/overlay/text_atlas.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>

#include "viewer/overlay/embedded_font.h"

#define STBTT_STATIC
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>

namespace rocinante {
namespace {

constexpr char32_t kReplacement = 0xFFFD;
constexpr int kAtlasWidth = 1024;

constexpr std::array kRanges{
    CharacterRange{0x20, 0x7E},
    CharacterRange{0xA0, 0x17F},  // Latin
    CharacterRange{0x391, 0x3C9},
    CharacterRange{0x401, 0x45F},  // Greek, Cyrillic
    CharacterRange{0x2010, 0x2027},
    CharacterRange{0x2030, 0x203A},  // dashes, quotes
    CharacterRange{0x20AC, 0x20AC},
    CharacterRange{0x2190, 0x2195},  // euro, arrows
    CharacterRange{0x2202, 0x221E},
    CharacterRange{0x2248, 0x2265},  // mathematics
    CharacterRange{0x25A0, 0x25CF},
    CharacterRange{0x2713, 0x2717},  // shapes, ticks
    CharacterRange{kReplacement, kReplacement},
};

int rounded(float number) { return static_cast<int>(std::floor(number + 0.5F)); }

}  // namespace

std::span<const CharacterRange> drawnCharacters() { return kRanges; }

TextAtlas::TextAtlas(int line_px) : line_px_(std::clamp(line_px, 6, 96)), width_(kAtlasWidth) {
  stbtt_fontinfo font;
  const auto* bytes = reinterpret_cast<const unsigned char*>(embeddedFont().data());
  [[maybe_unused]] const int found = stbtt_InitFont(&font, bytes, 0);
  assert(found != 0);
  const float scale = stbtt_ScaleForPixelHeight(&font, static_cast<float>(line_px_));
  int ascent_units = 0;
  int descent_units = 0;
  int gap_units = 0;
  stbtt_GetFontVMetrics(&font, &ascent_units, &descent_units, &gap_units);
  const int ascent = rounded(static_cast<float>(ascent_units) * scale);

  // Shelf packing: glyphs side by side, a new shelf when a row is full, one empty pixel between
  // them.
  int pen_x = 1;
  int pen_y = 1;
  int shelf = 0;
  for (const CharacterRange& range : kRanges) {
    for (char32_t character = range.first; character <= range.last; ++character) {
      const int index = stbtt_FindGlyphIndex(&font, static_cast<int>(character));
      if (index == 0) continue;
      int advance_units = 0;
      int bearing_units = 0;
      stbtt_GetGlyphHMetrics(&font, index, &advance_units, &bearing_units);
      int x0 = 0;
      int y0 = 0;
      int x1 = 0;
      int y1 = 0;
      stbtt_GetGlyphBitmapBox(&font, index, scale, scale, &x0, &y0, &x1, &y1);
      Glyph glyph;
      glyph.left = x0;
      glyph.top = ascent + y0;
      glyph.width = x1 - x0;
      glyph.height = y1 - y0;
      glyph.advance = rounded(static_cast<float>(advance_units) * scale);
      if (pen_x + glyph.width + 1 > width_) {
        pen_x = 1;
        pen_y += shelf + 1;
        shelf = 0;
      }
      glyph.atlas_x = pen_x;
      glyph.atlas_y = pen_y;
      shelf = std::max(shelf, glyph.height);
      height_ = std::max(height_, pen_y + glyph.height + 1);
      coverage_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
      if (glyph.width > 0 && glyph.height > 0) {
        unsigned char* target =
            &coverage_[static_cast<std::size_t>(pen_y) * static_cast<std::size_t>(width_) +
                       static_cast<std::size_t>(pen_x)];
        stbtt_MakeGlyphBitmap(&font, target, glyph.width, glyph.height, width_, scale, scale,
                              index);
      }
      pen_x += glyph.width + 1;
      glyphs_.emplace(character, glyph);
    }
  }
}

const TextAtlas::Glyph& TextAtlas::glyphOf(char32_t character) const {
  const auto found = glyphs_.find(character);
  return found != glyphs_.end() ? found->second : glyphs_.at(kReplacement);
}

std::vector<GlyphQuad> TextAtlas::layout(std::string_view text) const {
  std::vector<GlyphQuad> quads;
  quads.reserve(text.size());
  int pen_x = 0;
  int line_top = 0;
  for (std::size_t at = 0; at < text.size();) {
    const char32_t character = nextCharacter(text, at);
    if (character == '\n') {
      pen_x = 0;
      line_top += line_px_;
      continue;
    }
    const Glyph& glyph = glyphOf(character);
    if (glyph.width > 0 && glyph.height > 0) {
      quads.push_back({pen_x + glyph.left, line_top + glyph.top, glyph.width, glyph.height,
                       glyph.atlas_x, glyph.atlas_y});
    }
    pen_x += glyph.advance;
  }
  return quads;
}

TextSize TextAtlas::measure(std::string_view text) const {
  TextSize size{0, line_px_};
  int pen_x = 0;
  for (std::size_t at = 0; at < text.size();) {
    const char32_t character = nextCharacter(text, at);
    if (character == '\n') {
      pen_x = 0;
      size.height += line_px_;
      continue;
    }
    pen_x += glyphOf(character).advance;
    size.width = std::max(size.width, pen_x);
  }
  return size;
}

void TextAtlas::drawOn(Picture& picture, int x, int y, std::string_view text,
                       std::uint32_t rgba) const {
  const std::array<std::uint32_t, 3> color{rgba >> 24 & 255U, rgba >> 16 & 255U, rgba >> 8 & 255U};
  for (const GlyphQuad& glyph : layout(text)) {
    for (int row = 0; row < glyph.height; ++row) {
      for (int column = 0; column < glyph.width; ++column) {
        const int target_x = x + glyph.x + column;
        const int target_y = y + glyph.y + row;
        if (target_x < 0 || target_y < 0 || target_x >= picture.width ||
            target_y >= picture.height) {
          continue;
        }
        const std::uint32_t covered = coverage_[static_cast<std::size_t>(glyph.atlas_y + row) *
                                                    static_cast<std::size_t>(width_) +
                                                static_cast<std::size_t>(glyph.atlas_x + column)] *
                                      (rgba & 255U);
        std::uint8_t* pixel = &picture.rgba[(static_cast<std::size_t>(target_y) *
                                                 static_cast<std::size_t>(picture.width) +
                                             static_cast<std::size_t>(target_x)) *
                                            4];
        for (std::size_t c = 0; c < 3; ++c) {
          const std::uint32_t mixed = color[c] * covered + pixel[c] * (65025U - covered);
          pixel[c] = static_cast<std::uint8_t>((mixed + 32512U) / 65025U);
        }
      }
    }
  }
}

char32_t nextCharacter(std::string_view text, std::size_t& at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(at++);
  if (lead < 0x80) return lead;
  std::size_t more = 0;
  char32_t character = 0;
  char32_t least = 0;
  if (lead >= 0xC2 && lead <= 0xDF) {
    more = 1, character = lead & 0x1FU, least = 0x80;
  } else if (lead >= 0xE0 && lead <= 0xEF) {
    more = 2, character = lead & 0x0FU, least = 0x800;
  } else if (lead >= 0xF0 && lead <= 0xF4) {
    more = 3, character = lead & 0x07U, least = 0x10000;
  } else {
    return kReplacement;
  }
  const std::size_t begin = at;
  for (std::size_t i = 0; i < more; ++i) {
    if (at >= text.size() || (byte(at) & 0xC0U) != 0x80) {
      at = begin;
      return kReplacement;
    }
    character = character << 6 | (byte(at++) & 0x3FU);
  }
  const bool surrogate = character >= 0xD800 && character <= 0xDFFF;
  return character < least || character > 0x10FFFF || surrogate ? kReplacement : character;
}

}  // namespace rocinante
