#include "golden/judge/stability.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

namespace rocinante {
namespace {

using NamePair = std::pair<std::uint32_t, std::uint32_t>;

std::string nameText(const IdentityFrame& frame, std::uint32_t id) {
  const IdentityName& name = frame.names[id - 1];
  return name.link.empty() ? name.device : name.device + "/" + name.link;
}

/// Two names within two pixels of (x, y), the lower one first; zeros when there are fewer.
NamePair namesAround(const IdentityFrame& frame, int x, int y) {
  constexpr int kReach = 2;
  NamePair found{};
  for (int row = std::max(0, y - kReach); row <= std::min(frame.height - 1, y + kReach); ++row) {
    for (int column = std::max(0, x - kReach); column <= std::min(frame.width - 1, x + kReach);
         ++column) {
      const std::uint32_t id =
          frame.ids[static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.width) +
                    static_cast<std::size_t>(column)];
      if (id == 0 || id == found.first) continue;
      if (found.first == 0) {
        found.first = id;
      } else {
        return std::minmax(found.first, id);
      }
    }
  }
  return {};
}

/// The two names at whose border most of the unstable pixels lie, if there are such names.
std::optional<std::string> meetingNames(const Instability& found, const IdentityFrame& frame) {
  if (frame.ids.size() != found.unstable.size()) return std::nullopt;
  std::map<NamePair, std::int64_t> counts;
  for (int y = found.where.y; y < found.where.y + found.where.height; ++y) {
    for (int x = found.where.x; x < found.where.x + found.where.width; ++x) {
      const std::size_t pixel =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.width) +
          static_cast<std::size_t>(x);
      if (found.unstable[pixel] == 0) continue;
      const NamePair pair = namesAround(frame, x, y);
      if (pair.second != 0) ++counts[pair];
    }
  }
  const auto most =
      std::ranges::max_element(counts, {}, [](const auto& counted) { return counted.second; });
  if (most == counts.end() || most->second * 2 < found.pixels) return std::nullopt;
  return fmt::format("{} of them at the border of {} and {}", most->second,
                     nameText(frame, most->first.first), nameText(frame, most->first.second));
}

void addDifference(const Picture& a, const Picture& b, PixelSet& set) {
  for (std::size_t pixel = 0; pixel < set.size(); ++pixel) {
    if (!std::equal(&a.rgba[pixel * 4], &a.rgba[pixel * 4] + 4, &b.rgba[pixel * 4])) {
      set[pixel] = 1;
    }
  }
}

}  // namespace

std::optional<Instability> findInstability(const Picture& first, const Picture& after_another,
                                           const Picture& fresh) {
  Instability found;
  found.after_another = first != after_another;
  found.in_fresh_context = first != fresh;
  if (!found.after_another && !found.in_fresh_context) return std::nullopt;
  found.unstable.resize(first.rgba.size() / 4);
  for (const Picture* again : {&after_another, &fresh}) {
    if (again->rgba.size() == first.rgba.size()) addDifference(first, *again, found.unstable);
  }
  int left = first.width, top = first.height, right = 0, bottom = 0;
  for (int y = 0; y < first.height; ++y) {
    for (int x = 0; x < first.width; ++x) {
      if (found.unstable[static_cast<std::size_t>(y) * static_cast<std::size_t>(first.width) +
                         static_cast<std::size_t>(x)] == 0) {
        continue;
      }
      ++found.pixels;
      left = std::min(left, x);
      top = std::min(top, y);
      right = std::max(right, x + 1);
      bottom = std::max(bottom, y + 1);
    }
  }
  if (found.pixels > 0) found.where = {left, top, right - left, bottom - top};
  return found;
}

std::string instabilityRule(const Instability& found, const SceneIdentity* identity) {
  std::string rule =
      fmt::format("drawn again, {} {} at {}", found.pixels,
                  found.pixels == 1 ? "pixel differs" : "pixels differ", found.where.text());
  std::optional<std::string> meeting;
  if (identity != nullptr) meeting = meetingNames(found, identity->frame);
  if (meeting) rule += ", " + *meeting;
  rule += found.after_another && found.in_fresh_context
              ? "; both after another frame and in a fresh context"
          : found.after_another ? "; after another frame, not in a fresh context"
                                : "; in a fresh context, not after another frame";
  rule += "; likely cause: ";
  if (meeting) {
    rule += "coplanar surfaces";
  } else if (found.after_another && !found.in_fresh_context) {
    rule += "state left by another frame";
  } else {
    rule += "uninitialised state";
  }
  return rule;
}

}  // namespace rocinante
