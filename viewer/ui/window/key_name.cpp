#include "viewer/ui/window/key_name.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>

namespace rocinante {
namespace {

struct NamedKey {
  std::string_view name;
  int key;
};

constexpr std::array kNamedKeys{NamedKey{"space", GLFW_KEY_SPACE},
                                NamedKey{"left", GLFW_KEY_LEFT},
                                NamedKey{"right", GLFW_KEY_RIGHT},
                                NamedKey{"home", GLFW_KEY_HOME},
                                NamedKey{"end", GLFW_KEY_END},
                                NamedKey{"tab", GLFW_KEY_TAB},
                                NamedKey{"escape", GLFW_KEY_ESCAPE},
                                NamedKey{"backspace", GLFW_KEY_BACKSPACE},
                                NamedKey{"F1", GLFW_KEY_F1},
                                NamedKey{",", GLFW_KEY_COMMA},
                                NamedKey{".", GLFW_KEY_PERIOD},
                                NamedKey{"up", GLFW_KEY_UP},
                                NamedKey{"down", GLFW_KEY_DOWN},
                                NamedKey{"enter", GLFW_KEY_ENTER},
                                NamedKey{"delete", GLFW_KEY_DELETE},
                                NamedKey{"insert", GLFW_KEY_INSERT},
                                NamedKey{"page-up", GLFW_KEY_PAGE_UP},
                                NamedKey{"page-down", GLFW_KEY_PAGE_DOWN},
                                NamedKey{"keypad-enter", GLFW_KEY_KP_ENTER},
                                NamedKey{"shift", GLFW_KEY_LEFT_SHIFT},
                                NamedKey{"ctrl", GLFW_KEY_LEFT_CONTROL},
                                NamedKey{"alt", GLFW_KEY_LEFT_ALT},
                                NamedKey{"super", GLFW_KEY_LEFT_SUPER}};

bool takePrefix(std::string_view& text, std::string_view prefix) {
  if (!text.starts_with(prefix)) return false;
  text.remove_prefix(prefix.size());
  return true;
}

}  // namespace

std::optional<KeyPress> parseKey(std::string_view text) {
  KeyPress press;
  press.control = takePrefix(text, "ctrl+");
  press.shift = takePrefix(text, "shift+");
  const auto* named = std::ranges::find(kNamedKeys, text, &NamedKey::name);
  if (named != kNamedKeys.end()) {
    press.key = named->key;
    return press;
  }
  // GLFW's key codes of letters and digits are ASCII.
  const bool known = text.size() == 1 &&
                     ((text[0] >= 'A' && text[0] <= 'Z') || (text[0] >= '0' && text[0] <= '9'));
  if (!known) return std::nullopt;
  press.key = text[0];
  return press;
}

std::optional<std::string> keyName(const KeyPress& press) {
  const auto* named = std::ranges::find(kNamedKeys, press.key, &NamedKey::key);
  std::string name;
  if (named != kNamedKeys.end()) {
    name = named->name;
  } else if ((press.key >= 'A' && press.key <= 'Z') || (press.key >= '0' && press.key <= '9')) {
    name = static_cast<char>(press.key);
  } else {
    return std::nullopt;
  }
  return (press.control ? "ctrl+" : "") + std::string(press.shift ? "shift+" : "") + name;
}

}  // namespace rocinante
