#pragma once

namespace rocinante {

/// As `--version` prints it and as log headers name the library: "rocinante 0.1.0".
const char* version();

}  // namespace rocinante
