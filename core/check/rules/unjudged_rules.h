#pragma once

#include <map>
#include <string>

#include "core/cell/cell.h"

namespace rocinante {

/// Which rules have nothing to judge in this cell, without or with a session, and why: as
/// CheckReport::unjudged.
std::map<std::string, std::string, std::less<>> unjudgedRules(const Cell& cell, bool has_session);

}  // namespace rocinante
