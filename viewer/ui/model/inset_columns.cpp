#include "viewer/ui/model/inset_columns.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "viewer/view/inset_layout.h"

namespace rocinante {
namespace {

/// What a column is fitted into, in pixels.
struct Room {
  int width = 0, height = 0;  ///< of the picture
  int widest = 0;             ///< of an inset with its margins
  double scale = 1;
};

/// An inset of a column, with the part of its size that it gets.
struct Member {
  std::size_t number = 0;
  InsetSize size;
  double part = 1;
};

/// The members' sizes, and false when one is too small.
bool shrink(std::vector<Member>& members, const Room& room, int taken) {
  double high = 0;
  int margins = taken;
  for (Member& one : members) {
    one.part = std::min(
        1.0, static_cast<double>(room.widest - 2 * one.size.margin) / std::max(one.size.width, 1));
    high += one.part * one.size.height;
    margins += one.size.margin;
  }
  // The last one has another below it.
  margins += members.back().size.margin;
  const double factor = std::min(1.0, (room.height - margins) / std::max(high, 1.0));
  for (Member& one : members) {
    one.part *= factor;
    if (one.part >= 1) continue;
    if (one.part * one.size.width < kLeastInsetWidth * room.scale ||
        one.part * one.size.height < kLeastInsetHeight * room.scale) {
      return false;
    }
  }
  return true;
}

/// The one that folds next: the longest unopened, of those the last.
std::size_t nextToFold(const std::vector<Member>& members, const std::vector<WantedInset>& wanted) {
  std::size_t next = 0;
  for (std::size_t i = 1; i < members.size(); ++i) {
    if (wanted[members[i].number].opened <= wanted[members[next].number].opened) next = i;
  }
  return next;
}

/// The inset of a size with which it is placed as `member` says.
CellInset resized(const CellInset& inset, const Member& member, double scale) {
  if (member.part >= 1) return inset;
  CellInset smaller = inset;
  smaller.in_pixels = true;
  smaller.width = std::floor(member.part * member.size.width / scale);
  smaller.height = std::floor(member.part * member.size.height / scale);
  return smaller;
}

/// The members that stay, and the numbers of those that fold.
std::vector<std::size_t> foldColumn(std::vector<Member>& members,
                                    const std::vector<WantedInset>& wanted, const Room& room) {
  std::vector<std::size_t> folded;
  const int margin = members.empty() ? 0 : members.front().size.margin;
  const int tab = static_cast<int>(std::ceil(kInsetTabHeight * room.scale));
  std::erase_if(members, [&](const Member& one) {
    const bool is_speck = std::min(one.size.width, one.size.height) < kLeastInsetSidePx;
    if (is_speck) folded.push_back(one.number);
    return is_speck;
  });
  while (!members.empty()) {
    const int taken = static_cast<int>(folded.size()) * (tab + margin / 2);
    if (shrink(members, room, taken)) break;
    const std::size_t next = nextToFold(members, wanted);
    folded.push_back(members[next].number);
    members.erase(members.begin() + static_cast<std::ptrdiff_t>(next));
  }
  std::ranges::sort(folded);
  return folded;
}

/// Below the upper insets of a column, and above its lower ones.
void placeTabs(const std::vector<std::size_t>& folded, const std::vector<Member>& members,
               const std::vector<WantedInset>& wanted, bool left, const Room& room,
               std::vector<InsetColumns::Tab>& tabs) {
  if (folded.empty()) return;
  const int margin =
      insetSize(wanted[folded.front()].inset, room.width, room.height, room.scale).margin;
  const int high = static_cast<int>(std::ceil(kInsetTabHeight * room.scale));
  const int wide =
      std::min(static_cast<int>(kLeastInsetWidth * room.scale), room.widest - 2 * margin);
  int top = 0;
  for (const Member& one : members) {
    if (!isTop(wanted[one.number].inset.corner)) continue;
    top += one.size.margin + static_cast<int>(std::ceil(one.part * one.size.height));
  }
  top += margin;
  for (const std::size_t number : folded) {
    if (wide < high || top + high > room.height) return;
    const int x = left ? margin : room.width - margin - wide;
    tabs.push_back({number, {x, top, wide, high}});
    top += high + margin / 2;
  }
}

}  // namespace

InsetColumns fitInsets(const std::vector<WantedInset>& wanted, int width, int height,
                       double scale) {
  InsetColumns result;
  std::vector<std::optional<CellInset>> fitted(wanted.size());
  const auto is_left = [](const WantedInset& one) { return isLeft(one.inset.corner); };
  const bool both = std::ranges::any_of(wanted, is_left) && !std::ranges::all_of(wanted, is_left);
  const Room room{width, height, both ? width / 2 : width, scale};
  for (const bool left : {true, false}) {
    std::vector<Member> members;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (is_left(wanted[i]) != left) continue;
      members.push_back({i, insetSize(wanted[i].inset, width, height, scale)});
    }
    const std::vector<std::size_t> folded = foldColumn(members, wanted, room);
    for (const Member& one : members)
      fitted[one.number] = resized(wanted[one.number].inset, one, scale);
    placeTabs(folded, members, wanted, left, room, result.tabs);
  }
  for (std::size_t i = 0; i < fitted.size(); ++i) {
    if (!fitted[i]) continue;
    result.insets.push_back(*fitted[i]);
    result.shown.push_back(i);
  }
  return result;
}

}  // namespace rocinante
