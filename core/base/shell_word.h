#pragma once

#include <string>
#include <string_view>

namespace rocinante {

/// `word` written so that a POSIX shell takes it for one argument: as it is where that is safe, in
/// single quotes otherwise. Any bytes but NUL.
std::string shellWord(std::string_view word);

}  // namespace rocinante
