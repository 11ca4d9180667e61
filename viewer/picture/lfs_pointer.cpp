#include "viewer/picture/lfs_pointer.h"

namespace rocinante {

bool isLfsPointer(ByteView bytes) {
  return bytes.size() < 1024 &&
         textOf(bytes).starts_with("version https://git-lfs.github.com/spec/v1");
}

}  // namespace rocinante
