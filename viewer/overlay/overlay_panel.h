#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/cell/posed_scene.h"
#include "viewer/overlay/text_atlas.h"
#include "viewer/picture/picture.h"

namespace rocinante {

/// A line of the panel: a name and what it has.
struct PanelRow {
  std::string name, value;
  bool heading = false;
};

/// What the panel says: the time, each visible device that has joints or was spoken of, with its
/// joints (degrees for what turns, metres for what slides), each source's datagrams in the last
/// second. `time` empty: the cell at rest. Pure.
std::vector<PanelRow> panelRows(const std::string& time, const PosedScene& scene,
                                const SessionState& state,
                                const std::map<std::string, std::uint64_t>& rates);

/// Draws them on a plate in the picture's upper left; rows that find no room are counted on the
/// last one.
void drawPanel(Picture& picture, const std::vector<PanelRow>& rows, const TextAtlas& atlas,
               double scale = 1);

}  // namespace rocinante
