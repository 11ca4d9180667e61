#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/model/cell.h"
#include "core/session/timeline.h"
#include "viewer/picture/picture.h"

namespace rocinante {

enum class Profile { fast, reproducible };

/// Sets the environment that makes Mesa draw the same bits everywhere (DESIGN: pictures). Call it
/// first thing in main, before any thread or context; `reproducible` only.
void pinRendererEnvironment();

/// What to draw besides time and place.
struct FrameRequest {
  LogTime time{};
  std::string camera;  ///< of the cell or a `view` of the session; empty: the first, or a fitted one
  int width = 640;
  int height = 480;
  int samples = 4;                 ///< MSAA: 1, 2, 4, 8
  std::vector<std::string> hide;   ///< PATHs: outrank packets and the cell
  std::vector<std::string> show;
};

/// Which renderer made a frame: goldens are kept per key.
struct RendererKey {
  std::string renderer;      ///< "llvmpipe"
  std::string mesa;          ///< "22.3.6"
  std::string llvm;          ///< "15.0.6"
  std::string architecture;  ///< "x86_64"
  std::string caps;          ///< "sse4.1"; "native" without the pin
  /// "llvmpipe-mesa22.3.6-llvm15.0.6-x86_64-sse4.1"
  std::string text() const;
};

/// frame = render(cell, log, t, camera, options, size): a pure function behind one object that
/// holds the context, the uploaded geometry and the session. One thread.
class FrameMaker {
 public:
  /// The headless context (OSMesa). `log` empty: the cell alone, as nothing was ever said.
  /// Reproducible profile: refused when the renderer is not llvmpipe.
  static Result<FrameMaker> open(Cell cell, std::optional<Timeline> session, Profile profile);

  ~FrameMaker();
  FrameMaker(FrameMaker&&) noexcept;
  FrameMaker& operator=(FrameMaker&&) noexcept;

  Result<Picture> frame(const FrameRequest& request);

  const RendererKey& key() const;
  /// XXH3 of decoded textures, glyphs and vertex buffers: tells "the inputs differ" from "the
  /// renderer differs".
  const std::string& inputsHash() const;
  const Cell& cell() const;
  Timeline* session();

 private:
  struct Impl;
  explicit FrameMaker(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace rocinante
