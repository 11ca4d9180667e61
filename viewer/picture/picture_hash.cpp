#include <xxhash.h>

#include <array>
#include <memory>

#include "core/hash.h"
#include "viewer/picture/picture.h"

namespace rocinante {

std::string pictureSha256(const Picture& picture) {
  Sha256 hash;
  hash.add(picture.bytes());
  return hexOf(hash.finish());
}

std::string pictureXxh3(const Picture& picture) {
  std::array<std::uint8_t, 8> size{};
  const auto width = static_cast<std::uint32_t>(picture.width);
  const auto height = static_cast<std::uint32_t>(picture.height);
  for (unsigned i = 0; i < 4; ++i) {
    size[i] = static_cast<std::uint8_t>(width >> (8 * i));
    size[4 + i] = static_cast<std::uint8_t>(height >> (8 * i));
  }
  const std::unique_ptr<XXH3_state_t, XXH_errorcode (*)(XXH3_state_t*)> state(XXH3_createState(),
                                                                              XXH3_freeState);
  XXH3_128bits_reset(state.get());
  XXH3_128bits_update(state.get(), size.data(), size.size());
  XXH3_128bits_update(state.get(), picture.rgba.data(), picture.rgba.size());
  XXH128_canonical_t canonical;
  XXH128_canonicalFromHash(&canonical, XXH3_128bits_digest(state.get()));
  return hexOf(std::as_bytes(std::span(canonical.digest)));
}

}  // namespace rocinante
