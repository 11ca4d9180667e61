#pragma once

#include <string>

namespace rocinante {

/// Signs of ours, drawn as lines: the font has none for them.
enum class Icon { reset, copy, drive, stop, packet };

/// A button with a sign. `words`: what it does, on hover. `chosen`: drawn as held down, for what
/// stays on. True when it is pressed. Within ImGui::BeginDisabled() it tells its words still.
bool drawIconButton(const char* id, Icon icon, const char* words, bool chosen = false);

/// The same with a short text in place of the sign.
bool drawTextButton(const char* id, const std::string& text, const char* words);

}  // namespace rocinante
