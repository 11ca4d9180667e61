#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace rocinante {

/// Every colour of the panels, by what it is for. panel_colors.cpp says how each looks in the dark
/// and in the light theme.
enum class PanelColor : std::uint8_t {
  // What text stands on.
  panel,
  popup,
  title,
  table_head,
  row,
  row_hovered,
  row_held,
  button,
  button_hovered,
  button_held,
  field,
  field_hovered,
  field_held,
  tab,
  tab_hovered,
  tab_chosen,
  slider_thumb,
  slider_thumb_held,
  progress,
  selected_text,
  plot_ground,
  graph_ground,
  // Text.
  text,
  dim_text,
  heading,
  fault,
  error,
  warning,
  note,
  hint,
  done,
  others,
  by_hand,
  beyond_limit,
  driving,
  stage_app,
  stage_cull,
  stage_draw,
  stage_ui,
  curve_1,
  curve_2,
  curve_3,
  curve_4,
  curve_5,
  curve_6,
  curve_7,
  curve_8,
  curve_9,
  curve_10,
  curve_11,
  curve_12,
  curve_13,
  curve_14,
  curve_15,
  curve_16,
  curve_17,
  curve_18,
  curve_19,
  curve_20,
  repeated_part_text,
  // Marks: what is drawn beside text or over the picture.
  check_mark,
  slider_track,
  slider_track_hovered,
  received_mark,
  within_limits,
  near_limit,
  out_of_limits,
  limit_band,
  loss,
  damage,
  packets,
  event_tick,
  mark_tick,
  beside,
  repeated_part,
  played,
  playhead,
  state_false,
  graph_target,
  axis_x,
  axis_y,
  axis_z,
  drop_place,
  grip,
  grip_held,
};
constexpr std::size_t kPanelColors = static_cast<std::size_t>(PanelColor::grip_held) + 1;

/// Text and marks of something that cannot be used are drawn with this part of themselves.
constexpr float kDisabledOpacity = 0.7F;

/// 0xRRGGBBAA.
std::uint32_t colorOf(PanelColor color, bool light);
/// As in the enumeration.
std::string_view nameOf(PanelColor color);
/// That of a curve by its number: as many as there are, then again.
PanelColor curveColorOf(std::size_t number);

/// A colour that is drawn on others. Whoever draws text on a ground that no row has, adds one.
struct ColorPair {
  PanelColor ink;
  std::vector<PanelColor> grounds;  ///< each over the one before it, the first over the picture
  double least = kTextContrast;
  float opacity = 1;  ///< of the ink

  /// WCAG 2.1 (success criterion 1.4.3) for text, and (1.4.11) for marks that say something.
  static constexpr double kTextContrast = 4.5, kMarkContrast = 3;
};
std::span<const ColorPair> colorPairs();

/// The contrast of two opaque colours by WCAG 2.1: 1 for equal ones, 21 for black and white.
double contrastOf(std::uint32_t one, std::uint32_t other);
/// The contrast of a pair over the picture that hides it most: a black or a white one.
double leastContrast(const ColorPair& pair, bool light);
/// Black or white, whichever is read more easily on that opaque colour.
std::uint32_t blackOrWhiteOn(std::uint32_t ground);

}  // namespace rocinante
