#pragma once

#include <optional>

#include "core/base/result.h"
#include "viewer/ui/panels/panels.h"
#include "viewer/ui/program/frame_journal.h"
#include "viewer/ui/window/imgui_painter.h"
#include "viewer/ui/window/interface_context.h"
#include "viewer/ui/window/window.h"

namespace rocinante {

/// Looks of the window's first frames.
struct FirstPanelLook {
  std::optional<double> scale;  ///< of text and panels; empty: the screen's
  bool light = false;
};

/// The window's first frames: the panel of what is being read, drawn by nothing but the interface's
/// own shader. A renderer takes longer to make than all before it, and a cell may take minutes.
/// One at a time, and no other InterfaceContext beside it. Main thread; borrows all.
class FirstPanel {
 public:
  FirstPanel(Window& window, const FirstPanelLook& look, FrameJournal& journal);

  /// Draws and shows it. refused when the window's GL is not enough.
  Status show(const LoadingStatus& loading);
  /// For what follows in the window: the driver has compiled its shader. Empty before show().
  std::optional<ImguiPainter> takePainter() { return std::move(painter_); }

 private:
  Window& window_;
  FrameJournal& journal_;
  InterfaceContext interface_;
  std::optional<ImguiPainter> painter_;
};

}  // namespace rocinante
