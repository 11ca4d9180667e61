#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace rocinante {

/// Lower-case hexadecimal of that many bytes of the system's generator: two of 5 bytes are equal
/// once in 10^12 times, two of 16 never. Waits only on a system that has just booted.
std::string randomId(std::size_t bytes);
/// The same as a number.
std::uint64_t randomNumber();

}  // namespace rocinante
