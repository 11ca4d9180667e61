#pragma once

#include <imgui.h>

#include <optional>
#include <string>
#include <vector>

#include "core/base/parallel_for.h"
#include "core/base/time.h"
#include "viewer/detail/detail_level.h"
#include "viewer/ui/commands/viewer_requests.h"
#include "viewer/ui/model/dock_layout.h"
#include "viewer/ui/model/timeline_cursor.h"
#include "viewer/ui/model/view_model.h"
#include "viewer/ui/panels/frame_times.h"
#include "viewer/ui/panels/time_axis.h"
#include "viewer/ui/window/panel_colors.h"

namespace rocinante {

/// What is being read.
struct LoadingStatus {
  std::string name;
  LoadProgress progress;
  std::string waits_for{};  ///< a sentence; empty: for nothing else
};

/// The program's status for the panels.
struct ViewerStatus {
  FrameHistory times;
  std::uint64_t triangles = 0;
  std::uint64_t draws = 0;
  std::string renderer;
  int rung = 0;             ///< of kDetailRungs
  bool rung_fixed = false;  ///< chosen by the user, not by the governor
  bool may_govern = false;  ///< fast profile with a user
  bool refined = false;     ///< at rest: everything is drawn, whatever the rung
  bool refining = false;    ///< that is being done
  bool still = false;       ///< the scene was not drawn for a while
  double target_fps = 30;
  bool coarse_ready = true;  ///< coarser meshes are ready
  bool drops_looks = false;  ///< shadows and contact are left out to be drawn in time
  bool tells_times = true;   ///< off under a script, for identical screenshots
  std::string notice;        ///< last action, such as a written picture; may be empty
  bool notice_is_fault = false;
  std::optional<LoadingStatus> loading;
};

/// Draws the panels round the picture and applies the input to `model`: scene, looks and events on
/// the left, figures and the selected device on the right, plots and time below. Input for the
/// program goes to the requests. Returns the part of the window that the picture gets.
PixelRectangle drawPanels(ViewModel& model, const ViewerStatus& status, SteadyTime now,
                          ViewerRequests& requests);

/// Draws the inspected device (ViewModel::inspected) with its joints, in the right edge's `room` or
/// where the user put it.
void drawDevicePanel(ViewModel& model, const PanelRectangle& room, SteadyTime now);

/// Draws the signals of a device, or of one of its links when `link` is not empty; of no device
/// when `device` is empty. At most a few rows high; nothing when there are none.
void drawSignals(ViewModel& model, const std::string& device, const std::string& link,
                 const Signals& signals);

/// Draws the tab of the left panel with the amount drawn and the frame's cost by stage.
void drawFrameTab(const ViewerStatus& status, ViewerRequests& requests);

/// What must be known of what is shown, as that it is not now; the figures say it, or else a line
/// over the picture.
struct Caveat {
  std::string what, hint;
  PanelColor color = PanelColor::fault;
  bool stays = false;  ///< as NoticeKey has it
};
std::vector<Caveat> caveatsOf(const ViewModel& model);

/// Draws the session's figures at the top of the right edge's `room` or where the user put them;
/// returns where the rest of the room begins.
float drawFigures(ViewModel& model, const ViewerStatus& status, SteadyTime now,
                  const PanelRectangle& room);

/// Draws the tab of the left panel with what `rocinante check` finds in the log: a click goes to a
/// finding's first moment, selects its device and explains it.
void drawFindingsTab(ViewModel& model, SteadyTime now);

void drawHelp(ViewModel& model);

/// Draws a small round button with a question mark at the cursor of the present window: it shows
/// mouse and keyboard, or hides them.
void drawHelpButton(ViewModel& model);

/// Shows how the mouse can change the inset that it is over, or that it holds: a frame and the
/// corner that changes its size. Draws nothing while the mouse is elsewhere.
void drawInsetGrip(const ViewModel& model);

/// Draws the tabs of the insets that have no room in the picture; a click opens one.
void drawInsetTabs(ViewModel& model);

/// Draws where the device or link is, in the world or in the chosen reference, and lets choose it.
void drawPose(ViewModel& model, const Selection& shown);

/// Draws how near the device is to the reference, or to the nearest other one, and the switch for
/// it.
void drawNearest(ViewModel& model, const Selection& shown);

/// Draws the packet behind what is shown, if it is wanted (drawDeviceTools has the switch). Needs a
/// log. Above `bottom`.
void drawPacketBehind(ViewModel& model, const PosedDevice& device, const Selection& shown,
                      float bottom);

/// Draws the joint values of a device, or of `link` alone if it has a joint: each with a slider
/// that moves it (HandControl), and its value, which a double click lets type. Above `bottom`, the
/// lowest pixel for the panel. Scrolls when there are more.
void drawJointSliders(ViewModel& model, const PosedDevice& device, const std::string& link,
                      float bottom, SteadyTime now);

/// Draws a tab of the left panel.
void drawLookTab(ViewModel& model);

/// Asks for the text of a mark at the shown moment, while model.viewer.panels.mark.shown: Enter
/// keeps it ("mark" when nothing was typed), Esc does not.
void drawMarkPrompt(ViewModel& model, ViewerRequests& requests);

/// The command palette: a line to type in, and the matching commands with their keys. Runs the one
/// that is chosen; what it cannot do is a fault of the requests.
void drawPalette(ViewModel& model, SteadyTime now, ViewerRequests& requests);

// Tabs of the left panel.
/// `bottom`: lowest pixel of the window that its panel may use.
void drawSceneTab(ViewModel& model, float bottom, ViewerRequests& requests);
void drawEventsTab(ViewModel& model, SteadyTime now, ViewerRequests& requests);

/// Draws a tab of the left panel.
void drawSourcesTab(ViewModel& model, SteadyTime now);

/// Draws the time line in its place: buttons, and the track below them.
void drawTimeBar(ViewModel& model, TimelineCursor& cursor, const TimeAxis& axis,
                 const PanelRectangle& place, SteadyTime now);

/// The list of files to open: type a part of a name or a path, choose with arrow keys and Enter, or
/// click; what was shown before comes first.
void drawOpenList(ViewModel& model, ViewerRequests& requests);

/// Endpoints to listen at, with blanks between, and what is known of them.
struct EndpointLine {
  std::string endpoints;
  std::string note;
};
/// Live sessions behind what is shown, then what was heard at the usual endpoints.
std::vector<EndpointLine> endpointLines(const ViewModel& model);
/// A line for endpoints; true when it is clicked.
bool drawEndpoint(const EndpointLine& line, bool chosen);

/// A line for something that was shown before; true when it is clicked.
bool drawRecent(const RecentContent& recent, bool chosen);
void openRecent(const RecentContent& recent, ViewerRequests& requests);

/// What a window says that shows nothing yet: how to open something, and what was shown before.
/// `loading`: something comes, and only that is said.
void drawWelcome(ViewModel& model, bool loading, ViewerRequests& requests);

/// What is being read, and how far; in the middle of an empty window, else above the picture.
void drawLoading(const LoadingStatus& loading, bool is_empty);

/// A line over the picture about what is published or watched.
struct OthersBanner {
  std::string what;  ///< empty: none
  std::string hint;
  bool is_fault = false;
};
OthersBanner othersBanner(const ViewModel& model);

/// The viewpoints of others, and what they see of this window. Nothing outside a live session
/// unless something is published.
void drawOthers(ViewModel& model);

/// Draws the plots in their place above the time line, on its axis: a lane for each unit, names and
/// values at the right. Applies the mouse.
void drawPlots(ViewModel& model, TimelineCursor& cursor, const TimeAxis& axis,
               const PanelRectangle& place, SteadyTime now);

/// Draws what is dragged and where it can be dropped: onto plots and time line, whose upper edge is
/// `top`, and a band above it while there are no plots. Plots it when it is dropped there.
void drawPlotDrag(ViewModel& model, float top);

/// Height of the track, in interface units.
constexpr float kTrackHeight = 48;

/// Draws the time line on its axis, from `top` on: packets and losses by source, the shown moment,
/// events, marks, findings, the part that is repeated, and a ruler. Applies the mouse.
void drawTrack(ViewModel& model, TimelineCursor& cursor, const TimeAxis& axis, float top,
               SteadyTime now);

/// Red, amber or grey.
ImU32 severityColor(Severity severity);

}  // namespace rocinante
