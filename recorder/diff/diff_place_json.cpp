#include "recorder/diff/diff_place_json.h"

namespace rocinante {

Json placeJson(const std::optional<DiffPlace>& place) {
  if (!place) return nullptr;
  return {{"number", place->number},
          {"log_time_ns", place->time.time_since_epoch().count()},
          {"channel", place->topic},
          {"payload_begins", place->payload}};
}

}  // namespace rocinante
