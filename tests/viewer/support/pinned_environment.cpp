// Linked into tests that draw: Mesa reads its environment when the first context is made.
#include "viewer/gl/renderer_key.h"

namespace {
[[maybe_unused]] const bool pinned = [] {
  rocinante::pinRendererEnvironment();
  return true;
}();
}  // namespace
