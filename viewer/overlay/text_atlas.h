#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string_view>
#include <vector>

#include "viewer/picture/picture.h"

namespace rocinante {

/// One glyph of a laid-out text. Whole pixels, so that text is sharp and the same everywhere; x to
/// the right, y down from the top of the first line.
struct GlyphQuad {
  int x = 0, y = 0;  ///< top left on the target
  int width = 0, height = 0;
  int atlas_x = 0, atlas_y = 0;  ///< top left in the atlas
};

struct TextSize {
  int width = 0, height = 0;
};

/// Characters from `first` to `last`.
struct CharacterRange {
  char32_t first, last;
};

/// What pictures and panels have glyphs for, ascending: Latin, Greek, Cyrillic, common symbols, and
/// U+FFFD. Valid as long as the process.
std::span<const CharacterRange> drawnCharacters();

/// The glyphs of the embedded font at one size, drawn on the CPU, of drawnCharacters(). A missing
/// character shows as U+FFFD. Immutable; any thread may read it.
class TextAtlas {
 public:
  /// `line_px`: from the top of one line to the top of the next, 6 to 96.
  explicit TextAtlas(int line_px);

  int linePixels() const { return line_px_; }
  int width() const { return width_; }
  int height() const { return height_; }
  /// Coverage, 0 to 255: width * height, rows top to bottom.
  const std::vector<std::uint8_t>& coverage() const { return coverage_; }

  /// UTF-8, with line feeds; a malformed byte shows as U+FFFD.
  std::vector<GlyphQuad> layout(std::string_view text) const;
  TextSize measure(std::string_view text) const;

  /// Blends `text` over `picture`, its top left at (x, y), clipped at the edges.
  void drawOn(Picture& picture, int x, int y, std::string_view text, std::uint32_t rgba) const;

 private:
  struct Glyph {
    int left = 0, top = 0;  ///< from the pen, at the top of the line
    int width = 0, height = 0;
    int atlas_x = 0, atlas_y = 0;
    int advance = 0;
  };
  const Glyph& glyphOf(char32_t character) const;

  int line_px_;
  int width_ = 0, height_ = 0;
  std::vector<std::uint8_t> coverage_;
  std::map<char32_t, Glyph> glyphs_;
};

/// Reads the UTF-8 character at `at` and advances `at`; U+FFFD for a malformed byte.
char32_t nextCharacter(std::string_view text, std::size_t& at);

}  // namespace rocinante
