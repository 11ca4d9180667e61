#pragma once

namespace rocinante {

/// Sets colours and spacing of all panels; call once, after making the ImGui context.
void stylePanels(bool light);

}  // namespace rocinante
