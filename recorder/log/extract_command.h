#pragma once

#include "recorder/log/log_command.h"

namespace rocinante {

LogCommand addExtractCommand(CLI::App& program);

}  // namespace rocinante
