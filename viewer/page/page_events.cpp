#include "viewer/page/page_events.h"

#include <utility>

#include "core/report/json_text.h"

namespace rocinante {

std::string pageEvents(const std::vector<Event>& events, LogTime origin) {
  Json list = Json::array();
  for (const Event& event : events) {
    Json one;
    one["ns"] = (event.time - origin).count();
    one["text"] = event.text;
    list.push_back(std::move(one));
  }
  return list.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace rocinante
