#pragma once

#include "recorder/log/log_command.h"

namespace rocinante {

LogCommand addImportCommand(CLI::App& program);

}  // namespace rocinante
