#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace rocinante {

/// Lower-case hexadecimal of that many bytes of the system's generator: two of 16 bytes are never
/// equal, two of 5 in a million once in a million times. Only a system that has just booted waits.
std::string randomId(std::size_t bytes);
/// The same as a number.
std::uint64_t randomNumber();

}  // namespace rocinante
