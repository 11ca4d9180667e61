#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "viewer/cull/scene_catalog.h"
#include "viewer/gl/gl_name.h"
#include "viewer/gl/inputs_hash.h"
#include "viewer/gl/renderer_key.h"
#include "viewer/picture/picture.h"

namespace rocinante {

/// The textures of a scene on the GPU, by number. An unreadable picture is a warning, and its
/// surfaces show their plain colour. Its context must be current whenever it is used or destroyed.
class TextureStore {
 public:
  /// Reads and uploads all, with mipmaps of our own; adds the read pictures to `inputs`.
  /// Anisotropic filtering only in the fast profile on a GPU that has it. In a browser only
  /// finish() reads, so that something is drawn before; then both references must hold until then.
  TextureStore(const GlTable& gl, const std::vector<CatalogTexture>& files, Profile profile,
               InputsHash& inputs);
  TextureStore(const TextureStore&) = delete;
  TextureStore& operator=(const TextureStore&) = delete;

  /// Reads one more; false when none is left.
  bool readNext();
  /// Reads what was not read yet.
  void finish() {
    while (readNext()) {
    }
  }

  /// 0 when the picture could not be read.
  GLuint name(std::size_t number) const { return names_[number]; }
  /// Binds a picture that could be read at the active texture unit, with its wrap.
  void bind(std::size_t number) const;
  /// Until endPlainFiltering(), texture unit 0 uses the cheapest filter with mipmaps; only textures
  /// of this store may be bound there, by bind().
  void beginPlainFiltering() const;
  void endPlainFiltering() const;
  /// Non-zero by number: some pixel is not opaque.
  const std::vector<std::uint8_t>& translucent() const { return translucent_; }
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  void read(const CatalogTexture& file, std::size_t number);
  GlTexture upload(Picture picture, const CatalogTexture& use);
  /// That of plain filtering with that wrap, if there is none yet.
  void makePlainSampler(TextureWrap wrap_u, TextureWrap wrap_v);

  const GlTable& gl_;
  const std::vector<CatalogTexture>& files_;
  Profile profile_;
  InputsHash& inputs_;
  std::size_t read_ = 0;  // how many
  static constexpr std::size_t kWraps = 3;
  std::array<GlSampler, kWraps * kWraps> plain_samplers_;  // by wrap_u and wrap_v; 0: not made
  mutable bool is_plain_ = false;
  std::vector<GlTexture> names_;
  std::vector<std::uint8_t> translucent_;
  std::vector<std::string> warnings_;
};

/// Reverses the rows for GL, bottom to top.
void flipRows(Picture& picture);

}  // namespace rocinante
