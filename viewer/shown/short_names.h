#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rocinante {

/// How wide a text is drawn, in the unit of its room.
using TextWidth = std::function<float(std::string_view)>;

/// The text where there is room for it; else with as much of its middle cut out as must be:
/// "univer…_left". Whole characters of UTF-8. The sign of the cut alone, or nothing, where there is
/// no room for more. A room that is not a number is none.
std::string cutInMiddle(std::string_view text, float room, const TextWidth& width);

/// "DEVICE/LINK", or "DEVICE" when `link` is empty, in that room: of the device less is left first,
/// since links are chosen within it.
std::string cutPath(std::string_view device, std::string_view link, float room,
                    const TextWidth& width);

/// What the names of one list are shown as, each in `room`, in their order: whole where all of them
/// have room; else without the words with which all of them end, or begin, or both
/// ("shoulder_pan", "elbow" of "shoulder_pan_joint", "elbow_joint"); else cut, so that what differs
/// stays. Equal names are shown alike. Different ones are not while there is room for the sign of a
/// cut and a number.
std::vector<std::string> shortNames(std::span<const std::string> names, float room,
                                    const TextWidth& width);

/// shortNames() of several lists by their ids, computed anew only when a list, its room or the text
/// size changed. Not thread-safe.
class ShortNameLists {
 public:
  /// Valid until the next call with this id.
  const std::vector<std::string>& of(const std::string& id, std::vector<std::string> names,
                                     float room, const TextWidth& width);

 private:
  struct List {
    std::vector<std::string> names;
    float room = 0, cut_width = 0;
    std::vector<std::string> shown;
  };
  std::map<std::string, List> lists_;
};

}  // namespace rocinante
