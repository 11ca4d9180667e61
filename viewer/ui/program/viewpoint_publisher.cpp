#include "viewer/ui/program/viewpoint_publisher.h"

#include <chrono>
#include <optional>

#include "viewer/ui/program/user_input.h"

namespace rocinante {

Status ViewpointPublisher::tell(SteadyTime now) {
  Publishing& publishing = model_.publishing;
  if (publishing.active() == nullptr) return {};
  if (publishing.points()) {
    const auto place = mouseOnPicture(model_);
    if (pace_.due(place, now)) {
      if (!place) {
        publishing.point(std::nullopt);
      } else if (auto pointed = picture_.point({place->first, place->second, false}); !pointed) {
        return pointed;
      }
    }
  }
  // Who watches another says nothing of it: two who watch each other would hand each other's old
  // view to and fro.
  const bool watches = !model_.watched().empty();
  publishing.sendDue(watches ? std::nullopt : std::optional(model_.cameraView()), now,
                     std::chrono::system_clock::now());
  return {};
}

}  // namespace rocinante
