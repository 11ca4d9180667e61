#include "core/version.h"

namespace rocinante {

const char* version() { return ROCINANTE_VERSION; }

}  // namespace rocinante
