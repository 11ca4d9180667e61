#include "core/base/version.h"

namespace rocinante {

const char* version() { return ROCINANTE_VERSION; }

}  // namespace rocinante
