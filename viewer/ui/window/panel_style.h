#pragma once

namespace rocinante {

/// Colours and spacing of all panels; once, after the ImGui context was made.
void stylePanels();

}  // namespace rocinante
