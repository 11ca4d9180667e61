#pragma once

#include "recorder/log/log_command.h"

namespace rocinante {

/// `rocinante log decode` (docs/programs/log.md).
LogCommand addDecodeCommand(CLI::App& program);

}  // namespace rocinante
