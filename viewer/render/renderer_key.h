#pragma once

#include <string>

#include "core/result.h"
#include "viewer/render/gl_table.h"

namespace rocinante {

/// reproducible: the same bits on every x86-64 processor with SSSE3 and one version of Mesa and
/// LLVM (docs/rendering.md). fast: the driver as it is.
enum class Profile { fast, reproducible };

/// Sets the environment that makes Mesa draw the same bits everywhere (docs/rendering.md): pins
/// what must be, and clears every other variable by which Mesa's renderers, compilers and state
/// tracker are told something, but LP_NUM_THREADS. Call it first thing in main, before any thread
/// or context; reproducible profile only. `caps` is sse4.1, or sse2 for machines older than 2008.
void pinRendererEnvironment(const std::string& caps = "sse4.1");

/// Which renderer made a frame: goldens are kept per key.
struct RendererKey {
  std::string renderer;      ///< "llvmpipe"
  std::string mesa;          ///< "22.3.6"; empty when it is not Mesa
  std::string llvm;          ///< "15.0.6"; empty when it uses none
  std::string architecture;  ///< "x86_64"
  std::string caps;          ///< "sse4.1"; "native" without the pin

  /// "llvmpipe-mesa22.3.6-llvm15.0.6-x86_64-sse4.1"
  std::string text() const;
  bool operator==(const RendererKey&) const = default;
};

/// From the GL strings of the current context and the environment.
RendererKey rendererKey(const GlTable& gl);
/// The same from GL_RENDERER and GL_VERSION as text.
RendererKey parseRendererKey(const std::string& renderer, const std::string& version,
                             const std::string& caps);

/// refused, naming the renderer, unless it is llvmpipe with pinned caps.
Status requireReproducible(const RendererKey& key);

}  // namespace rocinante
