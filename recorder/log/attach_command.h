#pragma once

#include "recorder/log/log_command.h"

namespace rocinante {

LogCommand addAttachCommand(CLI::App& program);

}  // namespace rocinante
