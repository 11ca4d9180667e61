#include "player/playhead/restatement_schedule.h"

namespace rocinante {

void RestatementSchedule::begin(const SessionState& state, const std::set<std::string>& sources,
                                std::string_view part_id, SteadyTime now) {
  clear(now);
  block_ = restatedBlock(state, sources, *routes_, part_id, datagram_bytes_);
  restamp(now);
}

void RestatementSchedule::clear(SteadyTime now) {
  block_.clear();
  taken_ = 0;
  postpone(now);
}

ByteView RestatementSchedule::take(SteadyTime now) {
  postpone(now);
  return bytesOf(block_[taken_++].text);
}

}  // namespace rocinante
