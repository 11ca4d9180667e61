#include "core/net/drop_counter.h"

namespace rocinante {

void DropCounter::update(std::uint32_t reading) {
  const std::uint32_t ahead = reading - static_cast<std::uint32_t>(total_);
  if (ahead < (std::uint32_t{1} << 31)) total_ += ahead;
}

}  // namespace rocinante
