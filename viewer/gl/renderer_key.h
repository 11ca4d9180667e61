#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "viewer/gl/gl_table.h"

namespace rocinante {

/// reproducible: with one version of Mesa and LLVM, the same bits on every x86-64 processor with
/// SSSE3, and the same (different) bits on every arm64 processor (docs/rendering.md). fast: the
/// driver as it is.
enum class Profile { fast, reproducible };

/// The CPU features to which the reproducible profile can pin this machine, the default first:
/// sse4.1, and sse2 for machines older than 2008. Only "none" on other architectures than x86-64,
/// where Mesa has no choice.
const std::vector<std::string>& pinnableCaps();

/// Sets the environment that makes Mesa draw the same bits everywhere (docs/rendering.md): pins CPU
/// features and vector width, and clears all other variables of Mesa's renderers, compilers and
/// state tracker except LP_NUM_THREADS. Call it first in main, before any thread or context;
/// reproducible profile only. `caps` is one of pinnableCaps().
void pinRendererEnvironment(const std::string& caps = pinnableCaps().front());

/// The renderer of a frame: goldens are kept per key.
struct RendererKey {
  std::string renderer;      ///< "llvmpipe"
  std::string mesa;          ///< upstream's version, "22.3.6"; empty when not Mesa
  std::string llvm;          ///< "15.0.6"; empty without LLVM
  std::string architecture;  ///< "x86_64", "aarch64"
  std::string caps;          ///< "sse4.1"; "none" pinned off x86-64; "native" without the pin

  /// "llvmpipe-mesa22.3.6-llvm15.0.6-x86_64-sse4.1", "llvmpipe-mesa22.3.6-llvm15.0.6-aarch64"
  std::string text() const;
  bool operator==(const RendererKey&) const = default;
};

/// From the GL strings of the current context and the environment.
RendererKey rendererKey(const GlTable& gl);
/// The same from GL_RENDERER and GL_VERSION as text.
RendererKey parseRendererKey(const std::string& renderer, const std::string& version,
                             const std::string& caps);

/// A version or a key's text without a distribution's revision: "25.0.7-2+deb13u1" is "25.0.7",
/// since packaging changes no pixel. "25.1.0-rc1" and "-devel" are upstream's and stay.
std::string withoutPackageRevisions(std::string_view text);

/// refused, naming the renderer, unless it is llvmpipe, pinned, on an architecture known to draw
/// the same bits on all its processors.
Status requireReproducible(const RendererKey& key);

}  // namespace rocinante
