#pragma once

#include <stdlib.h>

#include <optional>
#include <string>
#include <string_view>

namespace rocinante {

/// What the pinned environment (renderer_key.h) calls Mesa's folder of drirc files: there is none.
inline constexpr const char* kNoDrircFolder = "/nonexistent";

/// Mesa reads ~/.drirc too, whatever DRIRC_CONFIGDIR names. While this lives, HOME is nowhere, if
/// the environment is pinned; Mesa's cache of shaders stays where XDG_CACHE_HOME, pinned too, says.
/// Replaces a variable that is there already, so that threads which read the environment meanwhile
/// read one of both values.
class HiddenDrirc {
 public:
  HiddenDrirc() {
    const char* const folder = ::getenv("DRIRC_CONFIGDIR");
    const char* const home = ::getenv("HOME");
    if (folder == nullptr || home == nullptr || std::string_view(folder) != kNoDrircFolder) return;
    home_ = home;
    ::setenv("HOME", kNoDrircFolder, 1);
  }
  ~HiddenDrirc() {
    if (home_) ::setenv("HOME", home_->c_str(), 1);
  }
  HiddenDrirc(const HiddenDrirc&) = delete;
  HiddenDrirc& operator=(const HiddenDrirc&) = delete;

 private:
  std::optional<std::string> home_;
};

}  // namespace rocinante
