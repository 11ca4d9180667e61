#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/cell/posed_scene.h"
#include "viewer/overlay/text_atlas.h"
#include "viewer/picture/picture.h"

namespace rocinante {

/// A line of the panel: a name and its values.
struct PanelRow {
  std::string name, value;
  bool heading = false;
};

/// Content of the panel: the time, each visible device that has joints or received packets, with
/// its joint values (degrees or metres), each source's datagrams in the last second. `time` empty:
/// the cell at rest. Pure.
std::vector<PanelRow> panelRows(const std::string& time, const PosedScene& scene,
                                const SessionState& state,
                                const std::map<std::string, std::uint64_t>& rates);

/// Draws the rows on a plate in the picture's upper left; the last row counts rows without room.
void drawPanel(Picture& picture, const std::vector<PanelRow>& rows, const TextAtlas& atlas,
               double scale = 1);

}  // namespace rocinante
