#include "viewer/passes/texture_store.h"

#include <algorithm>

#include "viewer/picture/mipmaps.h"

#ifndef GL_TEXTURE_MAX_ANISOTROPY
#define GL_TEXTURE_MAX_ANISOTROPY 0x84FE
#endif

namespace rocinante {
namespace {

/// Nearly opaque pixels count as opaque: scaled or compressed pictures have some.
constexpr std::uint8_t kOpaque = 250;

GLint glWrap(TextureWrap wrap) {
  switch (wrap) {
    case TextureWrap::mirrored_repeat:
      return GL_MIRRORED_REPEAT;
    case TextureWrap::clamp_to_edge:
      return GL_CLAMP_TO_EDGE;
    default:
      return GL_REPEAT;
  }
}

bool isTranslucent(const Picture& picture) {
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4) {
    if (picture.rgba[i] < kOpaque) return true;
  }
  return false;
}

}  // namespace

void flipRows(Picture& picture) {
  const auto row = static_cast<std::ptrdiff_t>(picture.width) * 4;
  for (int y = 0; y < picture.height / 2; ++y) {
    auto top = picture.rgba.begin() + row * y;
    std::swap_ranges(top, top + row, picture.rgba.begin() + row * (picture.height - 1 - y));
  }
}

TextureStore::TextureStore(const GlTable& gl, const std::vector<CatalogTexture>& files,
                           Profile profile, InputsHash& inputs)
    : gl_(gl),
      files_(files),
      profile_(profile),
      inputs_(inputs),
      names_(files.size()),
      translucent_(files.size()) {
  makePlainSampler(TextureWrap::repeat, TextureWrap::repeat);
  if (!gl_.is_embedded) finish();
}

void TextureStore::makePlainSampler(TextureWrap wrap_u, TextureWrap wrap_v) {
  GlSampler& sampler =
      plain_samplers_[static_cast<std::size_t>(wrap_u) * kWraps + static_cast<std::size_t>(wrap_v)];
  if (sampler != 0) return;
  sampler = GlSampler(gl_);
  gl_.SamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  gl_.SamplerParameteri(sampler, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl_.SamplerParameteri(sampler, GL_TEXTURE_WRAP_S, glWrap(wrap_u));
  gl_.SamplerParameteri(sampler, GL_TEXTURE_WRAP_T, glWrap(wrap_v));
}

bool TextureStore::readNext() {
  if (read_ == files_.size()) return false;
  read(files_[read_], read_);
  return ++read_ < files_.size();
}

void TextureStore::read(const CatalogTexture& texture, std::size_t number) {
  const std::filesystem::path& file = texture.file;
  Result<Picture> picture = !texture.at_hand.empty() ? decodePicture(texture.at_hand, file.string())
                            : texture.bytes          ? decodePicture(*texture.bytes, file.string())
                                                     : readPicture(file);
  inputs_.add(std::uint64_t{0x74657874});  // "text"
  if (!picture || picture->width < 1 || picture->height < 1) {
    warnings_.push_back(picture ? "an empty picture (" + file.string() + ")"
                                : picture.error().text());
    return;
  }
  inputs_.add(static_cast<std::uint64_t>(picture->width));
  inputs_.add(static_cast<std::uint64_t>(picture->height));
  inputs_.add(picture->bytes());
  if (texture.ignores_alpha) {
    // Before the mipmaps, which weigh colours by opacity.
    for (std::size_t i = 3; i < picture->rgba.size(); i += 4) picture->rgba[i] = 255;
  }
  translucent_[number] = isTranslucent(*picture) ? 1 : 0;
  names_[number] = upload(std::move(*picture), texture);
}

void TextureStore::bind(std::size_t number) const {
  gl_.BindTexture(GL_TEXTURE_2D, names_[number]);
  if (!is_plain_) return;
  const auto u = static_cast<std::size_t>(files_[number].wrap_u);
  const auto v = static_cast<std::size_t>(files_[number].wrap_v);
  gl_.BindSampler(0, plain_samplers_[u * kWraps + v]);
}

void TextureStore::beginPlainFiltering() const { is_plain_ = true; }

void TextureStore::endPlainFiltering() const {
  is_plain_ = false;
  gl_.BindSampler(0, 0);
}

GlTexture TextureStore::upload(Picture picture, const CatalogTexture& use) {
  GLint max_side = 0;
  gl_.GetIntegerv(GL_MAX_TEXTURE_SIZE, &max_side);
  while (picture.width > max_side || picture.height > max_side) picture = halved(picture);
  flipRows(picture);

  GlTexture name(gl_);
  gl_.BindTexture(GL_TEXTURE_2D, name);
  gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  // Before the pixels: a renderer that knows of smaller levels has memory made for all at once.
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  const auto uploadLevel = [&](GLint level, const Picture& pixels) {
    gl_.TexImage2D(GL_TEXTURE_2D, level, GL_RGBA8, pixels.width, pixels.height, 0, GL_RGBA,
                   GL_UNSIGNED_BYTE, pixels.rgba.data());
  };
  uploadLevel(0, picture);
  GLint level = 0;
  for (const Picture& smaller : mipmapsOf(picture)) uploadLevel(++level, smaller);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, level);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, glWrap(use.wrap_u));
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, glWrap(use.wrap_v));
  makePlainSampler(use.wrap_u, use.wrap_v);
  // Browsers' renderers differ most in this filter: without it a page looks as the reproducible
  // profile does. llvmpipe's takes seconds for one frame at some views, or never ends.
  if (profile_ == Profile::fast && !gl_.is_embedded && !gl_.is_software &&
      gl_.hasExtension("GL_EXT_texture_filter_anisotropic")) {
    gl_.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY, 8.0F);
  }
  return name;
}

}  // namespace rocinante
