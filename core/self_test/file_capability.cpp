#include "core/self_test/file_capability.h"

#include <sys/xattr.h>

#include <array>
#include <cstdint>
#include <span>

namespace rocinante {
namespace {

// linux/capability.h: a word of revision and flags, then permitted and inheritable of the lower 32
// capabilities, and from revision 2 on of the upper ones; little-endian.
constexpr std::uint32_t kEffective = 1;
constexpr std::uint32_t kRevisionMask = 0xFF000000;
constexpr std::uint32_t kRevision1 = 0x01000000;

std::uint32_t wordAt(ByteView bytes, std::size_t index) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    word |= std::to_integer<std::uint32_t>(bytes[index * 4 + i]) << (8 * i);
  }
  return word;
}

}  // namespace

bool givesCapability(ByteView attribute, int capability) {
  if (attribute.size() < 12 || capability < 0 || capability > 63) return false;
  const std::uint32_t head = wordAt(attribute, 0);
  const std::size_t words = (head & kRevisionMask) == kRevision1 ? 1 : 2;
  const auto bit = static_cast<std::size_t>(capability);
  if (bit / 32 >= words || attribute.size() < 4 + words * 8) return false;
  const std::uint32_t permitted = wordAt(attribute, 1 + 2 * (bit / 32));
  return (head & kEffective) != 0 && (permitted >> (bit % 32) & 1U) != 0;
}

bool fileHasCapability(const std::filesystem::path& program, int capability) {
  std::array<std::byte, 64> attribute{};
  const ssize_t size =
      ::getxattr(program.c_str(), "security.capability", attribute.data(), attribute.size());
  if (size <= 0) return false;
  return givesCapability(std::span(attribute).first(static_cast<std::size_t>(size)), capability);
}

}  // namespace rocinante
