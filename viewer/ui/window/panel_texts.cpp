#include "viewer/ui/window/panel_texts.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>

namespace rocinante {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

/// A colour of Dear ImGui, by parts from 0 to 255.
std::array<double, 4> partsOf(ImU32 color) {
  const auto part = [color](int shift) { return static_cast<double>(color >> shift & 0xFFU); };
  return {part(IM_COL32_R_SHIFT), part(IM_COL32_G_SHIFT), part(IM_COL32_B_SHIFT),
          part(IM_COL32_A_SHIFT)};
}

Rgb mixed(const Rgb& below, const std::array<double, 4>& above) {
  const double seen = above[3] / 255;
  Rgb result{};
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = static_cast<std::uint8_t>(std::lround(seen * above[i] + (1 - seen) * below[i]));
  }
  return result;
}

std::uint32_t rgbaOf(const Rgb& color) {
  return static_cast<std::uint32_t>(color[0]) << 24U | static_cast<std::uint32_t>(color[1]) << 16U |
         static_cast<std::uint32_t>(color[2]) << 8U | 0xFFU;
}

/// In pixels, with fractions.
struct Area {
  double left = 0, top = 0, right = 0, bottom = 0;

  bool empty() const { return right <= left || bottom <= top; }
  Area within(const Area& other) const {
    return {std::max(left, other.left), std::max(top, other.top), std::min(right, other.right),
            std::min(bottom, other.bottom)};
  }
  /// The pixels whose middle lies in it.
  PixelRectangle pixels() const {
    const auto first = [](double edge) { return static_cast<int>(std::ceil(edge - 0.5)); };
    const int x = first(left), y = first(top);
    return {x, y, std::max(0, first(right) - x), std::max(0, first(bottom) - y)};
  }
};

/// The window as the panels paint it, over a picture of one colour: with its letters' rectangles
/// filled, and without any.
class Sheet {
 public:
  Sheet(int width, int height, std::uint8_t picture)
      : width_(width),
        picture_{picture, picture, picture},
        pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                {picture_, picture_, kNoText}) {}

  void write(const PixelRectangle& letter, ImU32 color, int text) {
    const auto parts = partsOf(color);
    for (int y = letter.y; y < letter.y + letter.height; ++y) {
      for (int x = letter.x; x < letter.x + letter.width; ++x) {
        Pixel& pixel = at(x, y);
        pixel.with = mixed(pixel.without, parts);
        pixel.text = text;
      }
    }
  }
  /// `covers`: what is below is not read through it.
  void paint(int x, int y, const std::array<double, 4>& color, bool covers) {
    Pixel& pixel = at(x, y);
    pixel.with = mixed(pixel.with, color);
    pixel.without = mixed(pixel.without, color);
    if (covers) pixel.text = kNoText;
  }
  /// An image is what the picture is.
  void showPicture(int x, int y) { at(x, y) = {picture_, picture_, kNoText}; }

  /// Takes down the least contrast of each text that is seen.
  void judge(std::vector<std::optional<double>>& least) const {
    std::map<std::pair<std::uint32_t, std::uint32_t>, double> known;
    for (const Pixel& pixel : pixels_) {
      if (pixel.text == kNoText) continue;
      const std::pair colors(rgbaOf(pixel.with), rgbaOf(pixel.without));
      const auto [found, is_new] = known.try_emplace(colors);
      if (is_new) found->second = contrastOf(colors.first, colors.second);
      auto& lowest = least[static_cast<std::size_t>(pixel.text)];
      lowest = std::min(lowest.value_or(21), found->second);
    }
  }

 private:
  static constexpr int kNoText = -1;
  struct Pixel {
    Rgb with, without;
    int text;
  };
  Pixel& at(int x, int y) {
    return pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(x)];
  }

  int width_;
  Rgb picture_;
  std::vector<Pixel> pixels_;
};

/// How far a pixel's middle lies to the inner side of an edge; of two triangles that share the
/// edge one has the pixels on it.
struct Edge {
  Edge(const ImVec2& a, const ImVec2& b)
      : x(a.x),
        y(a.y),
        across(static_cast<double>(b.x) - a.x),
        down(static_cast<double>(b.y) - a.y),
        has_its_pixels(down < 0 || (down == 0 && across > 0)) {}
  double of(int px, int py) const { return across * (py + 0.5 - y) - down * (px + 0.5 - x); }
  bool hasInside(double value) const { return value > 0 || (value == 0 && has_its_pixels); }

  double x, y, across, down;
  bool has_its_pixels;
};

using Corners = std::array<const ImDrawVert*, 3>;

/// Calls `take` with each pixel of a triangle in `clip` and the weights of its corners.
template <class Take>
void coverTriangle(Corners corners, const Area& clip, const Take& take) {
  double area =
      Edge(corners[0]->pos, corners[1]->pos).across * Edge(corners[0]->pos, corners[2]->pos).down -
      Edge(corners[0]->pos, corners[1]->pos).down * Edge(corners[0]->pos, corners[2]->pos).across;
  if (area == 0) return;
  if (area < 0) std::swap(corners[1], corners[2]);
  area = std::abs(area);
  const ImVec2 &a = corners[0]->pos, &b = corners[1]->pos, &c = corners[2]->pos;
  const Area bounds{std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y}), std::max({a.x, b.x, c.x}),
                    std::max({a.y, b.y, c.y})};
  const std::array<Edge, 3> edges{Edge(b, c), Edge(c, a), Edge(a, b)};  // opposite its corner
  Area wide = bounds;
  wide.right += 1;  // pixels on an edge, too
  wide.bottom += 1;
  const PixelRectangle part = wide.within(clip).pixels();
  for (int y = part.y; y < part.y + part.height; ++y) {
    for (int x = part.x; x < part.x + part.width; ++x) {
      std::array<double, 3> weights{};
      bool inside = true;
      for (std::size_t i = 0; i < edges.size(); ++i) {
        const double value = edges[i].of(x, y);
        inside = inside && edges[i].hasInside(value);
        weights[i] = value / area;
      }
      if (inside) take(x, y, corners, weights);
    }
  }
}

/// The letters of the font by their places in its texture.
class Letters {
 public:
  Letters() {
    const ImFont& font = *ImGui::GetIO().Fonts->Fonts[0];
#if IMGUI_VERSION_NUM >= 19200
    const auto& glyphs = const_cast<ImFont&>(font).GetFontBaked(font.LegacySize)->Glyphs;
#else
    const auto& glyphs = font.Glyphs;
#endif
    for (const ImFontGlyph& glyph : glyphs) glyphs_.push_back(&glyph);
  }
  /// Null: not of a letter.
  const ImFontGlyph* find(const ImVec2& low, const ImVec2& high) {
    if (high.x <= low.x || high.y <= low.y) return nullptr;
    const auto [found, is_new] = known_.try_emplace({low.x, low.y, high.x, high.y}, nullptr);
    constexpr float kSlack = 1e-5F;
    for (std::size_t i = 0; is_new && found->second == nullptr && i < glyphs_.size(); ++i) {
      const ImFontGlyph& glyph = *glyphs_[i];
      if (low.x >= glyph.U0 - kSlack && low.y >= glyph.V0 - kSlack && high.x <= glyph.U1 + kSlack &&
          high.y <= glyph.V1 + kSlack) {
        found->second = &glyph;
      }
    }
    return found->second;
  }

 private:
  std::vector<const ImFontGlyph*> glyphs_;
  std::map<std::array<float, 4>, const ImFontGlyph*> known_;
};

/// A letter on the window.
struct DrawnLetter {
  const ImFontGlyph* glyph;
  Area seen, whole;  ///< in its place, and as if that had no edges
  ImU32 color;

  /// Plots write smaller than the font is.
  double scale() const { return (whole.bottom - whole.top) / (glyph->Y1 - glyph->Y0); }
  double pen() const { return whole.left - glyph->X0 * scale(); }
  double line() const { return whole.top - glyph->Y0 * scale(); }
};

/// Whether the window or one that it lies in has that scroll bar. (One that has too much for its
/// size scrolls in any case, with nothing that says so.)
bool scrolls(const char* window, bool ImGuiWindow::*bar) {
  const ImGuiWindow* each = window == nullptr ? nullptr : ImGui::FindWindowByName(window);
  for (; each != nullptr; each = each->ParentWindow) {
    if (each->*bar) return true;
    if ((each->Flags & ImGuiWindowFlags_ChildWindow) == 0) break;
  }
  return false;
}

/// Reads the triangles of a frame from below to above.
class Reading {
 public:
  Reading(int width, int height)
      : window_{0, 0, static_cast<double>(width), static_cast<double>(height)},
        sheets_{Sheet(width, height, 0), Sheet(width, height, 255)} {}

  void add(const ImDrawList& list) {
    name_ = list._OwnerName;
    may_cut_ = {scrolls(name_, &ImGuiWindow::ScrollbarX), scrolls(name_, &ImGuiWindow::ScrollbarY)};
    line_goes_on_ = false;
    for (const ImDrawCmd& command : list.CmdBuffer) add(list, command);
  }
  std::vector<PanelText> texts() && {
    std::vector<std::optional<double>> least(texts_.size());
    for (const Sheet& sheet : sheets_) sheet.judge(least);
    std::vector<PanelText> seen;
    for (std::size_t i = 0; i < texts_.size(); ++i) {
      if (!least[i]) continue;
      texts_[i].contrast = *least[i];
      seen.push_back(std::move(texts_[i]));
    }
    return seen;
  }

 private:
  void add(const ImDrawList& list, const ImDrawCmd& command) {
    // To whole pixels, as they are drawn.
    const Area clip = Area{std::trunc(command.ClipRect.x), std::trunc(command.ClipRect.y),
                           std::trunc(command.ClipRect.z), std::trunc(command.ClipRect.w)}
                          .within(window_);
    const auto vertex = [&](unsigned int i) {
      const ImDrawIdx index = list.IdxBuffer[static_cast<int>(command.IdxOffset + i)];
      return &list.VtxBuffer[static_cast<int>(command.VtxOffset + index)];
    };
    for (unsigned int i = 0; i + 2 < command.ElemCount; i += 3) {
      const Corners corners{vertex(i), vertex(i + 1), vertex(i + 2)};
      const bool has_other = i + 5 < command.ElemCount;
      if (has_other && vertex(i + 3) == corners[0] && vertex(i + 4) == corners[2]) {
        if (addLetter(*corners[0], *corners[2], clip)) {
          i += 3;
          continue;
        }
      }
      addTriangle(corners, clip);
    }
  }

  void addTriangle(const Corners& corners, const Area& clip) {
    const auto same = [&](const auto& of) {
      return of(*corners[0]) == of(*corners[1]) && of(*corners[0]) == of(*corners[2]);
    };
    const bool plain = same([](const ImDrawVert& one) { return one.uv.x; }) &&
                       same([](const ImDrawVert& one) { return one.uv.y; });
    const bool one_color = same([](const ImDrawVert& one) { return one.col; });
    const auto first = partsOf(corners[0]->col);
    // Of several colours is the soft edge of something.
    const bool covers = !one_color || first[3] >= 255;
    coverTriangle(corners, clip, [&](int x, int y, const Corners& at, const auto& weights) {
      auto color = first;
      for (std::size_t part = 0; !one_color && part < color.size(); ++part) {
        color[part] = 0;
        for (std::size_t i = 0; i < at.size(); ++i) {
          color[part] += weights[i] * partsOf(at[i]->col)[part];
        }
      }
      for (Sheet& sheet : sheets_)
        plain ? sheet.paint(x, y, color, covers) : sheet.showPicture(x, y);
    });
  }

  bool addLetter(const ImDrawVert& low, const ImDrawVert& high, const Area& clip) {
    const ImFontGlyph* const glyph = letters_.find(low.uv, high.uv);
    if (glyph == nullptr) return false;
    const Area drawn{low.pos.x, low.pos.y, high.pos.x, high.pos.y};
    // Dear ImGui itself cuts some, with their part of the texture.
    const double across = (drawn.right - drawn.left) / (high.uv.x - low.uv.x);
    const double down = (drawn.bottom - drawn.top) / (high.uv.y - low.uv.y);
    const Area whole{drawn.left - (low.uv.x - glyph->U0) * across,
                     drawn.top - (low.uv.y - glyph->V0) * down,
                     drawn.right + (glyph->U1 - high.uv.x) * across,
                     drawn.bottom + (glyph->V1 - high.uv.y) * down};
    add({glyph, drawn.within(clip), whole, low.col});
    return true;
  }

  void add(const DrawnLetter& letter) {
    const double from_last = letter.pen() - next_pen_;
    const double size = ImGui::GetFontSize();
    constexpr double kSame = 0.75;  // pixels, for letters on whole ones
    const bool goes_on = line_goes_on_ && letter.color == color_ &&
                         std::abs(letter.line() - line_) < kSame && from_last > -kSame &&
                         from_last < size / 2;
    if (!goes_on) {
      texts_.push_back({});
      if (name_ != nullptr) texts_.back().panel = name_;
    } else if (from_last > kSame) {
      texts_.back().text += ' ';
    }
    line_goes_on_ = true;
    color_ = letter.color;
    line_ = letter.line();
    next_pen_ = letter.pen() + letter.glyph->AdvanceX * letter.scale();

    PanelText& text = texts_.back();
    std::array<char, 5> bytes{};
    text.text += ImTextCharToUtf8(bytes.data(), letter.glyph->Codepoint);
    text.cut_px = std::max(text.cut_px, static_cast<float>(missing(letter)));
    if (letter.seen.empty()) return;
    const PixelRectangle part = letter.seen.pixels();
    for (Sheet& sheet : sheets_) {
      sheet.write(part, letter.color, static_cast<int>(texts_.size()) - 1);
    }
    if (part.width == 0 || part.height == 0) return;
    PixelRectangle& place = text.place;
    if (place.width == 0) place = part;
    const int right = std::max(place.x + place.width, part.x + part.width);
    const int bottom = std::max(place.y + place.height, part.y + part.height);
    place.x = std::min(place.x, part.x);
    place.y = std::min(place.y, part.y);
    place.width = right - place.x;
    place.height = bottom - place.y;
  }

  /// What is cut off a letter, in pixels, where it may not be.
  double missing(const DrawnLetter& letter) const {
    const Area &seen = letter.seen, &whole = letter.whole;
    const double across = std::max(seen.left - whole.left, whole.right - seen.right);
    const double down = std::max(seen.top - whole.top, whole.bottom - seen.bottom);
    return std::max(may_cut_.x ? 0 : std::min(across, whole.right - whole.left),
                    may_cut_.y ? 0 : std::min(down, whole.bottom - whole.top));
  }

  struct Scrolls {
    bool x = false, y = false;
  };
  Area window_;
  std::array<Sheet, 2> sheets_;
  Letters letters_;
  std::vector<PanelText> texts_;
  const char* name_ = nullptr;
  Scrolls may_cut_;
  bool line_goes_on_ = false;
  ImU32 color_ = 0;
  double line_ = 0, next_pen_ = 0;
};

}  // namespace

std::vector<PanelText> panelTexts(const ImDrawData& data) {
  const int width = static_cast<int>(data.DisplaySize.x);
  const int height = static_cast<int>(data.DisplaySize.y);
  if (width <= 0 || height <= 0) return {};
  Reading reading(width, height);
  for (int i = 0; i < data.CmdListsCount; ++i) reading.add(*data.CmdLists[i]);
  return std::move(reading).texts();
}

}  // namespace rocinante
