#pragma once

#include "core/base/bytes.h"
#include "viewer/picture/picture.h"

namespace rocinante {

/// A PNG of the same pixels whose data is not compressed (deflate's stored blocks, RFC 1951,
/// section 3.2.4): written and decoded at a large part of memory's speed. RGB when every pixel is
/// opaque. Empty for a picture without pixels, or of 2 GiB.
Bytes storedPng(const Picture& picture);

}  // namespace rocinante
