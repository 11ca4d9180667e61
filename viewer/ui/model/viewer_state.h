#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/cell/cell.h"
#include "viewer/ui/model/device_gizmo.h"
#include "viewer/ui/model/fly_mode.h"
#include "viewer/ui/model/inspection.h"
#include "viewer/ui/model/packet_search.h"
#include "viewer/ui/model/panel_state.h"
#include "viewer/ui/model/plot_board.h"
#include "viewer/ui/model/selection.h"
#include "viewer/ui/model/time_view.h"
#include "viewer/ui/study/log_study.h"
#include "viewer/view/inset_layout.h"

namespace rocinante {

/// Range of ViewerState::made_width.
constexpr int kLeastMadeWidth = 64, kMostMadeWidth = 8192;

/// An inset and whether it is shown.
struct InsetChoice {
  CellInset inset;
  bool shown = true;
  std::uint64_t opened = 0;  ///< from its tab; the latest has the largest number
};

/// Where the last frame shows an inset.
struct InsetPlace {
  std::size_t number = 0;  ///< of ViewerState::insets
  PixelRectangle part;
  CameraView camera;
};

/// Where an inset that has no room is a tab.
struct InsetTab {
  std::size_t number = 0;  ///< of ViewerState::insets
  PixelRectangle place;
};

/// An inset that the mouse holds.
struct InsetDrag {
  std::size_t number = 0;  ///< of ViewerState::insets
  bool sizes = false;      ///< else it moves to another corner
  PixelRectangle part;     ///< where it was when it was grabbed
};

/// What whoever looks at a window has chosen in its panels, and what those have shown: panels and
/// commands change it, the ViewModel beside it reads it. Plain values. Not thread-safe.
struct ViewerState {
  std::vector<InsetChoice> insets;
  std::vector<InsetPlace> inset_places;  ///< of the last frame, in the picture's pixels
  PixelRectangle picture_part;           ///< what the picture has of the window, in its pixels
  std::optional<InsetDrag> inset_drag;
  std::optional<int> made_width;  ///< of pictures made of the window, in pixels; empty: as seen
  FlyMode fly;
  GizmoState gizmo;
  PanelState panels;
  TimeView time_view;  ///< what the time line shows
  MomentHover hover;
  PlotBoard plots;
  std::shared_ptr<const StudyPicture> picture;         ///< of the log, as far as known; may be null
  std::shared_ptr<const StudyPicture> picture_beside;  ///< the same of the log beside
  bool findings_wanted = true;                         ///< judge the log in the background
  std::size_t finding_shown = 0;                       ///< number in the report, from 1; 0: none
  Selection reference;      ///< in whose space poses are shown; empty: the world
  DistancePicking picking;  ///< of a distance
  PacketLookup packet;
  bool nearest_wanted = false;  ///< measure how near the selection is to others
  bool outline_selected = true;
  /// A built-in camera for the coming frame to fit, unless another is used before; empty: none.
  std::string built_in_wanted;
  bool is_empty = false;   ///< nothing is shown yet: an empty cell stands for it
  bool was_shown = false;  ///< it comes back to the window, and is as it was
};

}  // namespace rocinante
