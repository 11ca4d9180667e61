#include "golden/why/pixel_blame.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstring>
#include <functional>
#include <map>
#include <optional>

#include "golden/why/registration.h"

namespace rocinante {
namespace {

/// A shift explains a change when it removes this share of the cost.
constexpr double kExplains = 0.7;
/// Stricter when guessing: plain surfaces look alike everywhere.
constexpr double kGuessExplains = 0.65;
/// Edge samples reach half a pixel, so neighbouring pixels are searched.
constexpr int kReach = 1;
/// Share of changed outline pixels above which a link moved; edges of other links cause less.
constexpr double kMovedOutline = 0.2;

/// Registration is slow, so it is limited to this many links.
constexpr std::size_t kMaxRegistered = 48;

bool samePixel(const Picture& a, const Picture& b, std::size_t i) {
  return std::memcmp(a.rgba.data() + i * 4, b.rgba.data() + i * 4, 4) == 0;
}

struct LinkPixels {
  std::int64_t golden = 0, frame = 0;  ///< pixels that show it
  std::int64_t gained = 0, lost = 0;   ///< that show it only in the frame, only in the golden
  std::int64_t outline = 0;            ///< of both pictures
  std::int64_t owned = 0;              ///< differing pixels attributed to it
  std::array<double, 3> color_shift{};
  std::int64_t in_place = 0;  ///< of those, pixels that show it in both

  /// Share of its outline that changed; 1 when only one picture shows it.
  double change() const {
    if (golden == 0 || frame == 0) return 1e9;
    return static_cast<double>(gained + lost) /
           static_cast<double>(std::max<std::int64_t>(1, outline));
  }
};

/// The links of both frames as numbers: 0 is the background, others are 1 + an index into names.
class LinkNumbers {
 public:
  LinkNumbers() { names_.emplace_back(); }

  /// The frame's pixels by these numbers; links that are new get one.
  std::vector<std::uint32_t> adopt(const IdentityFrame& identity) {
    std::vector<std::uint32_t> numbers(identity.names.size() + 1);
    for (std::size_t i = 0; i < identity.names.size(); ++i) {
      const IdentityName& name = identity.names[i];
      const auto [found, is_new] = number_.try_emplace({name.device, name.link}, names_.size());
      if (is_new) names_.push_back(name);
      numbers[i + 1] = static_cast<std::uint32_t>(found->second);
    }
    std::vector<std::uint32_t> ids(identity.ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) {
      // A number without a name is background.
      if (identity.ids[i] < numbers.size()) ids[i] = numbers[identity.ids[i]];
    }
    return ids;
  }

  std::size_t size() const { return names_.size(); }
  const IdentityName& name(std::size_t link) const { return names_[link]; }

 private:
  std::map<std::pair<std::string, std::string>, std::size_t> number_;
  std::vector<IdentityName> names_;
};

/// The links of a golden and of its frame, pixel by pixel, and what is known of their movement.
struct LinksOfPixels {
  LinkNumbers numbers;
  std::vector<std::uint32_t> golden, frame;
  MovedLinks moved;
  /// By link: for one whose pixels in the golden are estimated, how far it went.
  std::map<std::uint32_t, std::array<double, 2>> shifts;
};

/// Who is to blame for each pixel that differs. Borrows all that it is made of.
class PixelOwners {
 public:
  PixelOwners(const Picture& golden, const Picture& frame, const LinksOfPixels& links)
      : golden_(golden),
        frame_(frame),
        numbers_(links.numbers),
        shifts_(links.shifts),
        golden_ids_(links.golden),
        frame_ids_(links.frame),
        pixels_(links.frame.size()),
        links_(links.numbers.size()),
        moved_(links.numbers.size()) {
    countOutlines();
    for (std::size_t link = 1; link < moved_.size(); ++link) {
      const IdentityName& name = numbers_.name(link);
      moved_[link] = links.moved.contains({name.device, name.link});
    }
    knows_movers_ = std::ranges::find(moved_, true) != moved_.end();
    attributePixels();
  }

  Blame blame() const {
    Blame made;
    made.differing = differing_;
    std::vector<std::uint32_t> order;
    for (std::uint32_t link = 0; link < links_.size(); ++link) {
      if (links_[link].owned > 0) order.push_back(link);
    }
    std::ranges::stable_sort(
        order, [&](std::uint32_t a, std::uint32_t b) { return links_[a].owned > links_[b].owned; });
    std::vector<std::uint8_t> row(links_.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      made.changes.push_back(changeOf(order[i], i < kMaxRegistered));
      row[order[i]] = static_cast<std::uint8_t>(std::min(i + 1, Blame::kMaxRows + 1));
    }
    made.mask = {frame_.width, frame_.height, std::vector<std::uint8_t>(pixels_ * 4, 255)};
    for (std::size_t i = 0; i < pixels_; ++i) {
      made.mask.rgba[i * 4] = owner_[i] == kNobody ? std::uint8_t{0} : row[owner_[i]];
      // The background has no outline.
      made.mask.rgba[i * 4 + 1] = frame_ids_[i] == 0 ? std::uint8_t{0} : row[frame_ids_[i]];
      made.mask.rgba[i * 4 + 2] = golden_ids_[i] == 0 ? std::uint8_t{0} : row[golden_ids_[i]];
    }
    return made;
  }

 private:
  static constexpr std::uint32_t kNobody = 0xFFFFFFFF;

  void countOutlines() {
    for (std::size_t i = 0; i < pixels_; ++i) {
      const std::uint32_t g = golden_ids_[i];
      const std::uint32_t f = frame_ids_[i];
      ++links_[g].golden;
      ++links_[f].frame;
      if (g != f) {
        ++links_[g].lost;
        ++links_[f].gained;
      }
      countOutline(golden_ids_, i);
      countOutline(frame_ids_, i);
    }
  }

  void attributePixels() {
    owner_.assign(pixels_, kNobody);
    for (std::size_t i = 0; i < pixels_; ++i) {
      if (samePixel(golden_, frame_, i)) continue;
      ++differing_;
      const std::uint32_t owner = ownerOf(i);
      owner_[i] = owner;
      LinkPixels& link = links_[owner];
      ++link.owned;
      if (golden_ids_[i] != owner || frame_ids_[i] != owner) continue;
      ++link.in_place;
      for (std::size_t component = 0; component < 3; ++component) {
        link.color_shift[component] +=
            frame_.rgba[i * 4 + component] - golden_.rgba[i * 4 + component];
      }
    }
  }

  /// Whether it is known to have moved or, if no movement is known, looks so.
  bool hasMoved(std::uint32_t link) const {
    if (link == 0) return false;
    const LinkPixels& its = links_[link];
    if (its.golden == 0 || its.frame == 0) return true;
    return knows_movers_ ? moved_[link] : its.change() > kMovedOutline;
  }

  void countOutline(const std::vector<std::uint32_t>& ids, std::size_t i) {
    const std::size_t width = static_cast<std::size_t>(frame_.width);
    const bool last_column = i % width == width - 1;
    const bool last_row = i + width >= pixels_;
    const bool is_edge =
        (!last_column && ids[i + 1] != ids[i]) || (!last_row && ids[i + width] != ids[i]);
    if (is_edge) ++links_[ids[i]].outline;
  }

  /// The more responsible of two links that share a pixel.
  std::uint32_t moreResponsible(std::uint32_t a, std::uint32_t b) const {
    if (a == b || b == 0) return a;
    if (a == 0) return b;
    if (hasMoved(a) != hasMoved(b)) return hasMoved(a) ? a : b;
    return links_[b].change() > links_[a].change() ? b : a;
  }

  std::uint32_t ownerOf(std::size_t i) const {
    const std::uint32_t f = frame_ids_[i];
    const std::uint32_t g = golden_ids_[i];
    std::uint32_t owner = moreResponsible(f, g);
    if (hasMoved(owner)) return owner;
    // The pixel's centre shows no cause: look for a neighbouring link that moved, appeared or
    // vanished.
    const auto width = static_cast<std::ptrdiff_t>(frame_.width);
    const auto x = static_cast<std::ptrdiff_t>(i) % width;
    const auto y = static_cast<std::ptrdiff_t>(i) / width;
    std::optional<std::uint32_t> mover;
    for (std::ptrdiff_t down = -kReach; down <= kReach; ++down) {
      for (std::ptrdiff_t right = -kReach; right <= kReach; ++right) {
        if (x + right < 0 || x + right >= width || y + down < 0 || y + down >= frame_.height)
          continue;
        const auto at = static_cast<std::size_t>((y + down) * width + x + right);
        for (const std::uint32_t link : {frame_ids_[at], golden_ids_[at]}) {
          if (hasMoved(link)) mover = mover ? moreResponsible(*mover, link) : link;
        }
      }
    }
    return mover.value_or(owner);
  }

  LinkChange changeOf(std::uint32_t number, bool may_register) const {
    const LinkPixels& link = links_[number];
    LinkChange change;
    change.name = numbers_.name(number);
    change.pixels = link.owned;
    if (link.in_place > 0) {
      for (std::size_t i = 0; i < 3; ++i) {
        change.color_shift[i] = link.color_shift[i] / static_cast<double>(link.in_place);
      }
    }
    if (number == 0) return change;
    if (change.name.device == "drawing") {
      change.kind = ChangeKind::drawing;
    } else if (link.golden == 0 || link.frame == 0) {
      change.kind = link.golden == 0 ? ChangeKind::appeared : ChangeKind::vanished;
    } else if (const auto known = shifts_.find(number); known != shifts_.end()) {
      change.kind = ChangeKind::moved;
      change.moved_px = known->second;
    } else if (may_register) {
      followOutline(number, change);
    }
    return change;
  }

  void followOutline(std::uint32_t number, LinkChange& change) const {
    const LinkPixels& link = links_[number];
    const bool known_mover = moved_[number];
    if (!known_mover && link.gained + link.lost == 0) return;
    const auto regionIn = [&](const std::vector<std::uint32_t>& ids) {
      return regionOf(ids, frame_.width, frame_.height, number);
    };
    const auto shift =
        registerRegions(golden_, regionIn(golden_ids_), frame_, regionIn(frame_ids_));
    if (known_mover || (shift && shift->cost <= kExplains * shift->cost_unmoved)) {
      change.kind = ChangeKind::moved;
      if (shift) change.moved_px = {shift->right, shift->down};
    } else if (link.change() > kMovedOutline) {
      change.kind = ChangeKind::shape;
    }
  }

  const Picture& golden_;
  const Picture& frame_;
  const LinkNumbers& numbers_;
  const std::map<std::uint32_t, std::array<double, 2>>& shifts_;
  const std::vector<std::uint32_t>& golden_ids_;
  const std::vector<std::uint32_t>& frame_ids_;
  std::size_t pixels_;
  std::vector<LinkPixels> links_;
  std::vector<bool> moved_;
  bool knows_movers_ = false;
  std::vector<std::uint32_t> owner_;
  std::int64_t differing_ = 0;
};

/// Links with differing pixels, most first, limited to kMaxRegistered.
std::vector<std::uint32_t> linksToFind(const Picture& golden, const Picture& frame,
                                       const std::vector<std::uint32_t>& ids, std::size_t links) {
  std::vector<std::int64_t> differing(links);
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (!samePixel(golden, frame, i)) ++differing[ids[i]];
  }
  std::vector<std::uint32_t> found;
  for (std::uint32_t link = 1; link < links; ++link) {
    if (differing[link] > 0) found.push_back(link);
  }
  std::ranges::stable_sort(found, std::greater<>(),
                           [&](std::uint32_t link) { return differing[link]; });
  found.resize(std::min(found.size(), kMaxRegistered));
  return found;
}

/// Writes the link's estimated pixels in the golden: its region moved back by the shift.
void undoShift(const Region& region, const Shift& shift, int width, int height, std::uint32_t link,
               std::vector<std::uint32_t>& ids) {
  for (std::uint32_t& id : ids) {
    if (id == link) id = 0;
  }
  const auto right = static_cast<int>(std::lround(shift.right));
  const auto down = static_cast<int>(std::lround(shift.down));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto at = [&](int column, int line) {
        return static_cast<std::size_t>(line) * static_cast<std::size_t>(width) +
               static_cast<std::size_t>(column);
      };
      if (region.inside[at(x, y)] == 0) continue;
      if (x + right < 0 || y + down < 0 || x + right >= width || y + down >= height) continue;
      ids[at(x + right, y + down)] = link;
    }
  }
}

}  // namespace

Blame blameLinks(const BlameSide& golden, const BlameSide& frame, const MovedLinks& moved) {
  assert(golden.picture.rgba.size() == frame.picture.rgba.size());
  assert(golden.identity.ids.size() * 4 == golden.picture.rgba.size());
  assert(frame.identity.ids.size() * 4 == frame.picture.rgba.size());
  LinksOfPixels links;
  links.golden = links.numbers.adopt(golden.identity);
  links.frame = links.numbers.adopt(frame.identity);
  links.moved = moved;
  return PixelOwners(golden.picture, frame.picture, links).blame();
}

Blame guessBlame(const Picture& golden, const BlameSide& frame) {
  assert(golden.rgba.size() == frame.picture.rgba.size());
  LinksOfPixels links;
  links.frame = links.numbers.adopt(frame.identity);
  links.golden = links.frame;
  const auto to_find = linksToFind(golden, frame.picture, links.frame, links.numbers.size());
  const Picture smooth_golden = smoothed(golden);
  const Picture smooth_frame = smoothed(frame.picture);
  for (const std::uint32_t link : to_find) {
    const Region region = regionOf(links.frame, golden.width, golden.height, link);
    const auto shift = findRegion(smooth_frame, region, smooth_golden, kGuessWindow);
    if (!shift || shift->cost > kGuessExplains * shift->cost_unmoved) continue;
    if (shift->right * shift->right + shift->down * shift->down < 0.01) continue;
    undoShift(region, *shift, golden.width, golden.height, link, links.golden);
    const IdentityName& name = links.numbers.name(link);
    links.moved.emplace(name.device, name.link);
    links.shifts[link] = {-shift->right, -shift->down};
  }
  return PixelOwners(golden, frame.picture, links).blame();
}

}  // namespace rocinante
