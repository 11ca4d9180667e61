#pragma once

#include <string>
#include <vector>

#include "viewer/ui/model/view_model.h"
#include "viewer/view/view_layout.h"

namespace rocinante {

/// What the window shows now, and where.
ViewLayout layoutOf(const ViewModel& model);
/// Returns what of it this window does not have, a sentence each. A built-in camera is only wanted
/// then (ViewerState::built_in_wanted): its view needs the renderer.
std::vector<std::string> applyLayout(const ViewLayout& layout, ViewModel& model);
/// Says these over the picture, each after `name` and a colon, in place of those of a layout
/// before.
void noteLeftOut(const std::string& name, const std::vector<std::string>& left_out,
                 ViewModel& model);

/// The signals that are plotted, or of which what is plotted is derived, and that no packet of the
/// log states, each once; none while the log is not read, or goes on.
std::vector<SeriesKey> unstatedSignals(const ViewModel& model);

}  // namespace rocinante
