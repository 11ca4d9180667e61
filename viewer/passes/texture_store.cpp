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
  gl_.GenSamplers(1, &plain_sampler_);
  gl_.SamplerParameteri(plain_sampler_, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  gl_.SamplerParameteri(plain_sampler_, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl_.SamplerParameteri(plain_sampler_, GL_TEXTURE_WRAP_S, GL_REPEAT);
  gl_.SamplerParameteri(plain_sampler_, GL_TEXTURE_WRAP_T, GL_REPEAT);
  if (!gl_.is_embedded) finish();
}

bool TextureStore::readNext() {
  if (read_ == files_.size()) return false;
  read(files_[read_], read_);
  return ++read_ < files_.size();
}

void TextureStore::read(const CatalogTexture& texture, std::size_t number) {
  const auto& [file, bytes, at_hand] = texture;
  Result<Picture> picture = !at_hand.empty() ? decodePicture(at_hand, file.string())
                            : bytes          ? decodePicture(*bytes, file.string())
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
  translucent_[number] = isTranslucent(*picture) ? 1 : 0;
  names_[number] = upload(std::move(*picture));
}

TextureStore::~TextureStore() {
  gl_.DeleteSamplers(1, &plain_sampler_);
  for (const GLuint name : names_) {
    if (name != 0) gl_.DeleteTextures(1, &name);
  }
}

void TextureStore::beginPlainFiltering() const { gl_.BindSampler(0, plain_sampler_); }
void TextureStore::endPlainFiltering() const { gl_.BindSampler(0, 0); }

GLuint TextureStore::upload(Picture picture) {
  GLint max_side = 0;
  gl_.GetIntegerv(GL_MAX_TEXTURE_SIZE, &max_side);
  while (picture.width > max_side || picture.height > max_side) picture = halved(picture);
  flipRows(picture);

  GLuint name = 0;
  gl_.GenTextures(1, &name);
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
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
  gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
  // Browsers' renderers differ most in this filter: without it a page looks as the reproducible
  // profile does. llvmpipe's takes seconds for one frame at some views, or never ends.
  if (profile_ == Profile::fast && !gl_.is_embedded && !gl_.is_software &&
      gl_.hasExtension("GL_EXT_texture_filter_anisotropic")) {
    gl_.TexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY, 8.0F);
  }
  return name;
}

}  // namespace rocinante
