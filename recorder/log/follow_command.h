#pragma once

#include "recorder/log/log_command.h"

namespace rocinante {

LogCommand addFollowCommand(CLI::App& program);

}  // namespace rocinante
