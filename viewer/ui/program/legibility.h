#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "viewer/picture/pixel_rectangle.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/ui/window/panel_texts.h"

namespace rocinante {

/// Something of the window, in pixels from its top left.
struct NamedPlace {
  std::string name;
  PixelRectangle place;
};

/// How a frame's panels can be read, as CSV with a row for each text and for each part of an inset
/// that a panel lies on. The first column is the fault, or `-`: `faint` and `cut` as PanelText has
/// them, `over inset`. Pure.
std::string legibilityTable(std::span<const PanelText> texts, std::span<const NamedPlace> panels,
                            std::span<const NamedPlace> insets);

/// Writes that of the frame that Dear ImGui drew last. bad_argument when there was none, refused
/// when the file cannot be written.
Status writeLegibility(const std::filesystem::path& file, const ViewModel& model);

}  // namespace rocinante
