#include "core/log/log_types.h"

namespace rocinante {

LossCounts& LossCounts::operator+=(const LossCounts& other) {
  kernel += other.kernel;
  queue += other.queue;
  disk += other.disk;
  truncated += other.truncated;
  return *this;
}

}  // namespace rocinante
