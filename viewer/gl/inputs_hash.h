#pragma once

#include <span>
#include <string>

#include "core/base/bytes.h"
#include "core/base/hash.h"

namespace rocinante {

/// Hash of a picture's inputs (vertex buffers, decoded textures, glyphs), added piece by piece:
/// XXH3-128 of the pieces' XXH3-128, so that pieces need not be contiguous.
class InputsHash {
 public:
  void add(ByteView piece) {
    const auto digest = xxh3(piece);
    digests_.insert(digests_.end(), digest.begin(), digest.end());
  }
  void add(std::uint64_t number) { add(std::as_bytes(std::span(&number, 1))); }
  /// Lower-case hexadecimal.
  std::string text() const { return hexOf(xxh3(digests_)); }

 private:
  Bytes digests_;
};

}  // namespace rocinante
