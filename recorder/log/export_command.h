#pragma once

#include "recorder/log/log_command.h"

namespace rocinante {

LogCommand addExportCommand(CLI::App& program);

}  // namespace rocinante
