#include "viewer/ui/window/panel_colors.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rocinante {
namespace {

struct ThemedColor {
  PanelColor color;
  std::string_view name;
  std::uint32_t dark, light;
};

/// In the order of the enumeration.
constexpr std::array<ThemedColor, kPanelColors> kThemedColors{{
    {PanelColor::panel, "panel", 0x171C21FF, 0xF2F5F7FF},
    {PanelColor::popup, "popup", 0x1B2026FF, 0xFAFAFCFF},
    {PanelColor::title, "title", 0x212930FF, 0xD4DEE6FF},
    {PanelColor::table_head, "table_head", 0x2A343EFF, 0xD4DEE6FF},
    {PanelColor::row, "row", 0x31414FFF, 0xC8D8E8FF},
    {PanelColor::row_hovered, "row_hovered", 0x374A5BFF, 0xBCD0E4FF},
    {PanelColor::row_held, "row_held", 0x3A4E60FF, 0xB8CDE2FF},
    {PanelColor::button, "button", 0x344758FF, 0xC8D7E6FF},
    {PanelColor::button_hovered, "button_hovered", 0x3F566AFF, 0xB4CBE2FF},
    {PanelColor::button_held, "button_held", 0x466078FF, 0xA8C2DEFF},
    {PanelColor::field, "field", 0x2B3640FF, 0xDDE3E9FF},
    {PanelColor::field_hovered, "field_hovered", 0x323F4AFF, 0xD2DAE2FF},
    {PanelColor::field_held, "field_held", 0x374651FF, 0xC9D3DDFF},
    {PanelColor::tab, "tab", 0x29333DFF, 0xDBE3EBFF},
    {PanelColor::tab_hovered, "tab_hovered", 0x466078FF, 0xA8C4E0FF},
    {PanelColor::tab_chosen, "tab_chosen", 0x3F556AFF, 0xB3CCE6FF},
    {PanelColor::slider_thumb, "slider_thumb", 0xA86214FF, 0xD97A0DFF},
    {PanelColor::slider_thumb_held, "slider_thumb_held", 0x9C5A10FF, 0xE08A1EFF},
    {PanelColor::progress, "progress", 0xA86214FF, 0xD98A2AFF},
    {PanelColor::selected_text, "selected_text", 0x2F5F99FF, 0xA9CBF2FF},
    {PanelColor::plot_ground, "plot_ground", 0xFFFFFF0D, 0x1A1F240D},
    {PanelColor::graph_ground, "graph_ground", 0x14181CFF, 0xE4E9EDFF},
    {PanelColor::text, "text", 0xFFFFFFFF, 0x1A1F24FF},
    {PanelColor::dim_text, "dim_text", 0xB9C1CAFF, 0x47505AFF},
    {PanelColor::heading, "heading", 0xFFA840FF, 0x8F4E00FF},
    {PanelColor::fault, "fault", 0xFFAA84FF, 0x933506FF},
    {PanelColor::error, "error", 0xFF6B5CFF, 0xB5281AFF},
    {PanelColor::warning, "warning", 0xFFBE46FF, 0x855600FF},
    {PanelColor::note, "note", 0xAAB4BEFF, 0x56606AFF},
    {PanelColor::hint, "hint", 0xFFD94DFF, 0x735600FF},
    {PanelColor::done, "done", 0xB3E6BFFF, 0x1D6B32FF},
    {PanelColor::others, "others", 0x99D9FFFF, 0x0B5C8FFF},
    {PanelColor::by_hand, "by_hand", 0xFFB859FF, 0x8A4B00FF},
    {PanelColor::beyond_limit, "beyond_limit", 0xFF9A86FF, 0x9E2410FF},
    {PanelColor::driving, "driving", 0xFF594DFF, 0xB81D12FF},
    {PanelColor::stage_app, "stage_app", 0x78C8FFFF, 0x00628FFF},
    {PanelColor::stage_cull, "stage_cull", 0x96DCA0FF, 0x21693AFF},
    {PanelColor::stage_draw, "stage_draw", 0xFFA840FF, 0x8F4E00FF},
    {PanelColor::stage_ui, "stage_ui", 0xC896E6FF, 0x7A3FA0FF},
    {PanelColor::curve_1, "curve_1", 0x56B4FFFF, 0x0068BCFF},
    {PanelColor::curve_2, "curve_2", 0xFFA840FF, 0x9C5500FF},
    {PanelColor::curve_3, "curve_3", 0x60CD78FF, 0x257536FF},
    {PanelColor::curve_4, "curve_4", 0xFF6969FF, 0xD10000FF},
    {PanelColor::curve_5, "curve_5", 0xC491FFFF, 0x8821FFFF},
    {PanelColor::curve_6, "curve_6", 0xE4CD46FF, 0x756611FF},
    {PanelColor::curve_7, "curve_7", 0x46D2CDFF, 0x1B716EFF},
    {PanelColor::curve_8, "curve_8", 0xFF82C3FF, 0xC80068FF},
    {PanelColor::curve_9, "curve_9", 0xA5BE78FF, 0x596D34FF},
    {PanelColor::curve_10, "curve_10", 0xCDA582FF, 0x885D37FF},
    {PanelColor::curve_11, "curve_11", 0x5795C6FF, 0x00467EFF},
    {PanelColor::curve_12, "curve_12", 0xC58231FF, 0x693900FF},
    {PanelColor::curve_13, "curve_13", 0x4BA15EFF, 0x184E24FF},
    {PanelColor::curve_14, "curve_14", 0xC87979FF, 0x900000FF},
    {PanelColor::curve_15, "curve_15", 0x9E85BCFF, 0x5900C0FF},
    {PanelColor::curve_16, "curve_16", 0xA09031FF, 0x4E440BFF},
    {PanelColor::curve_17, "curve_17", 0x349F9AFF, 0x134D4BFF},
    {PanelColor::curve_18, "curve_18", 0xBC7D9EFF, 0x8B0048FF},
    {PanelColor::curve_19, "curve_19", 0x849760FF, 0x3C4923FF},
    {PanelColor::curve_20, "curve_20", 0xA58A72FF, 0x5B3E24FF},
    {PanelColor::repeated_part_text, "repeated_part_text", 0x1E1A10FF, 0x1E1A10FF},
    {PanelColor::check_mark, "check_mark", 0xFFA840FF, 0xB85F00FF},
    {PanelColor::slider_track, "slider_track", 0x46525EFF, 0xB4BFC9FF},
    {PanelColor::slider_track_hovered, "slider_track_hovered", 0x607080FF, 0x9AA8B5FF},
    {PanelColor::received_mark, "received_mark", 0x96A5B4FF, 0x5E6B78FF},
    {PanelColor::within_limits, "within_limits", 0x96DCA0FF, 0x2F8A4AFF},
    {PanelColor::near_limit, "near_limit", 0xFFBE46FF, 0xA86C00FF},
    {PanelColor::out_of_limits, "out_of_limits", 0xFF5A46FF, 0xC0301FFF},
    {PanelColor::limit_band, "limit_band", 0xFF503CFF, 0xE0402CFF},
    {PanelColor::loss, "loss", 0xFF503CE6, 0xC83020E6},
    {PanelColor::damage, "damage", 0xFF3C3CFF, 0xD82828FF},
    {PanelColor::packets, "packets", 0x688CACC8, 0x4C7396C8},
    {PanelColor::event_tick, "event_tick", 0x78C8FFFF, 0x0072A6FF},
    {PanelColor::mark_tick, "mark_tick", 0x96E68CFF, 0x2F8A2AFF},
    {PanelColor::beside, "beside", 0x78BEFFFF, 0x1C6FB8FF},
    {PanelColor::repeated_part, "repeated_part", 0xFFCD6EFF, 0xD99A1EFF},
    {PanelColor::played, "played", 0xFFA840FF, 0xC26A00FF},
    {PanelColor::playhead, "playhead", 0xFFFFFFFF, 0x3A434CFF},
    {PanelColor::state_false, "state_false", 0x808892FF, 0x808892FF},
    {PanelColor::graph_target, "graph_target", 0xFFFFFFA0, 0x1A1F24A0},
    {PanelColor::axis_x, "axis_x", 0xD8453BFF, 0xD8453BFF},
    {PanelColor::axis_y, "axis_y", 0x4BA046FF, 0x4BA046FF},
    {PanelColor::axis_z, "axis_z", 0x3F78D0FF, 0x3F78D0FF},
    {PanelColor::drop_place, "drop_place", 0xFFA840FF, 0xD97A0DFF},
    {PanelColor::grip, "grip", 0xFFFFFF6E, 0xFFFFFF6E},
    {PanelColor::grip_held, "grip_held", 0xFFA840FF, 0xFFA840FF},
}};

constexpr bool isInOrder() {
  for (std::size_t i = 0; i < kThemedColors.size(); ++i) {
    if (kThemedColors[i].color != static_cast<PanelColor>(i)) return false;
  }
  return true;
}
static_assert(isInOrder());

constexpr std::uint32_t partOf(std::uint32_t rgba, int part) {
  return rgba >> (24 - 8 * part) & 0xFFU;
}

/// What is seen of a colour over an opaque one.
std::uint32_t blended(std::uint32_t rgba, float opacity, std::uint32_t below) {
  const double seen = partOf(rgba, 3) / 255.0 * static_cast<double>(opacity);
  std::uint32_t result = 0;
  for (int part = 0; part < 3; ++part) {
    const double mixed = seen * partOf(rgba, part) + (1 - seen) * partOf(below, part);
    result = result << 8U | static_cast<std::uint32_t>(std::lround(mixed));
  }
  return result << 8U | 0xFFU;
}

double luminanceOf(std::uint32_t rgba) {
  const auto linear = [rgba](int part) {
    const double value = partOf(rgba, part) / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(0) + 0.7152 * linear(1) + 0.0722 * linear(2);
}

std::vector<ColorPair> allPairs() {
  using enum PanelColor;
  std::vector<ColorPair> pairs;
  const std::vector<std::vector<PanelColor>> plain{{panel}, {popup}};
  const std::vector<std::vector<PanelColor>> lists{{panel, row},         {panel, row_hovered},
                                                   {panel, row_held},    {popup, row},
                                                   {popup, row_hovered}, {popup, row_held}};
  const std::vector<std::vector<PanelColor>> controls{
      {panel, button},     {panel, button_hovered}, {panel, button_held}, {panel, field},
      {panel, field_held}, {panel, field_hovered},  {panel, tab},         {panel, tab_hovered},
      {panel, tab_chosen}, {panel, table_head},     {panel, plot_ground}, {title}};
  const std::vector<std::vector<PanelColor>> under_numbers{{panel, field, slider_thumb},
                                                           {panel, field, slider_thumb_held},
                                                           {panel, field, progress},
                                                           {panel, field, selected_text}};
  const auto add = [&](PanelColor ink, const std::vector<std::vector<PanelColor>>& grounds,
                       float opacity = 1) {
    for (const auto& each : grounds)
      pairs.push_back({ink, each, ColorPair::kTextContrast, opacity});
  };
  for (const auto* grounds : {&plain, &lists, &controls, &under_numbers}) add(text, *grounds);
  add(text, plain, kDisabledOpacity);
  add(text, {{panel, button}, {panel, field}}, kDisabledOpacity);
  // Hints of fields that are empty, folders and explanations in lists, and labels of plots.
  add(dim_text, plain);
  add(dim_text, lists);
  add(dim_text, {{panel, field}, {panel, field_hovered}, {panel, field_held}});
  add(dim_text, {{panel, plot_ground}});
  // Values of the table of sources, whose rows are seen below the mouse.
  add(fault, lists);
  for (const PanelColor ink :
       {heading, fault, error, warning, note, hint, done, others, by_hand, beyond_limit, driving,
        stage_app, stage_cull, stage_draw, stage_ui}) {
    add(ink, plain);
  }
  add(fault, {{panel, plot_ground}});
  add(beyond_limit, {{panel, field}, {panel, field_held}});
  for (std::size_t i = 0; curveColorOf(i) != curve_20; ++i) {
    add(curveColorOf(i), {{panel}, {panel, plot_ground}});
  }
  add(curve_20, {{panel}, {panel, plot_ground}});
  add(repeated_part_text, {{panel, repeated_part}});
  for (const PanelColor mark :
       {received_mark, within_limits, near_limit, out_of_limits, loss, damage, event_tick,
        mark_tick, beside, played, playhead, state_false}) {
    pairs.push_back({mark, {panel}, ColorPair::kMarkContrast});
  }
  pairs.push_back({check_mark, {panel, field}, ColorPair::kMarkContrast});
  for (const PanelColor stage : {stage_app, stage_cull, stage_draw, stage_ui, graph_target}) {
    pairs.push_back({stage, {panel, graph_ground}, ColorPair::kMarkContrast});
  }
  return pairs;
}

}  // namespace

std::uint32_t colorOf(PanelColor color, bool light) {
  const ThemedColor& row = kThemedColors[static_cast<std::size_t>(color)];
  return light ? row.light : row.dark;
}

std::string_view nameOf(PanelColor color) {
  return kThemedColors[static_cast<std::size_t>(color)].name;
}

PanelColor curveColorOf(std::size_t number) {
  constexpr auto kFirst = static_cast<std::size_t>(PanelColor::curve_1);
  constexpr auto kLast = static_cast<std::size_t>(PanelColor::curve_20);
  return static_cast<PanelColor>(kFirst + number % (kLast - kFirst + 1));
}

std::span<const ColorPair> colorPairs() {
  static const std::vector<ColorPair> pairs = allPairs();
  return pairs;
}

double contrastOf(std::uint32_t one, std::uint32_t other) {
  const double first = luminanceOf(one), second = luminanceOf(other);
  return (std::max(first, second) + 0.05) / (std::min(first, second) + 0.05);
}

double leastContrast(const ColorPair& pair, bool light) {
  double least = 21;
  for (const std::uint32_t picture : {0x000000FFU, 0xFFFFFFFFU}) {
    std::uint32_t ground = picture;
    for (const PanelColor each : pair.grounds) ground = blended(colorOf(each, light), 1, ground);
    const std::uint32_t ink = blended(colorOf(pair.ink, light), pair.opacity, ground);
    least = std::min(least, contrastOf(ink, ground));
  }
  return least;
}

std::uint32_t blackOrWhiteOn(std::uint32_t ground) {
  constexpr std::uint32_t kBlack = 0x000000FF, kWhite = 0xFFFFFFFF;
  return contrastOf(kBlack, ground) > contrastOf(kWhite, ground) ? kBlack : kWhite;
}

}  // namespace rocinante
