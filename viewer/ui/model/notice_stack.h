#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "viewer/ui/model/panel_places.h"

namespace rocinante {

/// One of the notices that a window has over the picture.
struct NoticeKey {
  std::string key;     ///< of what it is about: the same notice while that is said
  bool stays = false;  ///< it tells of a mode that is on: it comes first and is not dismissed
};

/// Remembers since when each notice is said, and which were dismissed. Plain values.
class NoticeStack {
 public:
  /// Places in `notices` of what is shown: what stays in its order, then the newest first; of those
  /// that began together the first is the newest. What was dismissed is left out until it was not
  /// said in between.
  std::vector<std::size_t> order(std::span<const NoticeKey> notices);
  /// Away with it, as long as it is said on.
  void dismiss(const std::string& key) { dismissed_[key] = true; }
  /// The same for all that the last order() was given, but for what stays.
  void dismissAll();

  bool shows_all = false;  ///< also those for which there is usually no room

 private:
  std::map<std::string, std::uint64_t> since_;  ///< what is said, by the number of its order()
  std::map<std::string, bool> dismissed_;
  std::uint64_t orders_ = 0;
};

struct NoticeSize {
  float width = 0, height = 0;
};

/// Where notices are drawn.
struct NoticePlaces {
  std::vector<PanelRectangle> places;  ///< of the first ones
  std::size_t more = 0;                ///< those that have none
  PanelRectangle more_place;           ///< of the line that says so, if there are any
};

/// A column in the middle of the `free` rectangle, from its top down, `gap` between two: at most
/// `most`, and no more than it is high, but at least one; the rest is a number in a line of
/// `more` size below. All in pixels. Pure.
NoticePlaces placeNotices(std::span<const NoticeSize> sizes, const PanelRectangle& free,
                          NoticeSize more, float gap, std::size_t most);

}  // namespace rocinante
