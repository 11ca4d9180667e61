#include "viewer/shown/short_names.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace rocinante {
namespace {

constexpr std::string_view kCut = "…";
constexpr std::string_view kBetweenWords = "_-./:# ";

bool isInsideCharacter(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

/// Where the characters of a text begin, and its end.
std::vector<std::size_t> charactersOf(std::string_view text) {
  std::vector<std::size_t> starts;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (i == 0 || !isInsideCharacter(text[i])) starts.push_back(i);
  }
  starts.push_back(text.size());
  return starts;
}

bool hasRoom(std::string_view text, float room, const TextWidth& width) {
  return width(text) <= room;
}

/// How many bytes all of them begin with, or end with, beyond the first `skipped`.
std::size_t commonBytes(const std::vector<std::string_view>& names, bool at_end,
                        std::size_t skipped) {
  const auto at = [&](std::string_view name, std::size_t i) {
    return at_end ? name[name.size() - 1 - i] : name[i];
  };
  std::size_t common = names.front().size() - skipped;
  for (const std::string_view name : names) {
    common = std::min(common, name.size() - skipped);
    std::size_t same = 0;
    while (same < common && at(name, same) == at(names.front(), same)) ++same;
    common = same;
  }
  return common;
}

/// What all names begin and end with, in bytes.
struct Affixes {
  std::size_t prefix = 0, suffix = 0;
};

/// Whole words; something is left of each name.
Affixes commonWords(const std::vector<std::string_view>& names) {
  Affixes common;
  if (names.size() < 2) return common;
  const auto isBetween = [](char c) { return kBetweenWords.find(c) != std::string_view::npos; };
  const std::string_view first = names.front();
  const auto shortest = std::ranges::min(names, {}, &std::string_view::size).size();
  common.prefix =
      std::min(commonBytes(names, false, 0), shortest - std::min<std::size_t>(shortest, 1));
  while (common.prefix > 0 && !isBetween(first[common.prefix - 1])) --common.prefix;
  const std::size_t left = shortest - common.prefix;
  common.suffix =
      std::min(commonBytes(names, true, common.prefix), left - std::min<std::size_t>(left, 1));
  while (common.suffix > 0 && !isBetween(first[first.size() - common.suffix])) --common.suffix;
  return common;
}

std::vector<std::string_view> withoutWords(const std::vector<std::string_view>& names,
                                           const Affixes& affixes) {
  std::vector<std::string_view> rest;
  for (const std::string_view name : names) {
    rest.push_back(name.substr(affixes.prefix, name.size() - affixes.prefix - affixes.suffix));
  }
  return rest;
}

/// A part of the name, from `first` to `last`, and as much around it as there is room for.
std::string cutAround(std::string_view name, std::size_t first, std::size_t last, float room,
                      const TextWidth& width) {
  const std::vector<std::size_t> starts = charactersOf(name);
  const auto characterAt = [&](std::size_t byte) {
    return static_cast<std::size_t>(std::ranges::upper_bound(starts, byte) - starts.begin()) - 1;
  };
  const std::size_t count = starts.size() - 1;
  std::size_t from = characterAt(first);
  std::size_t until = characterAt(last) + (starts[characterAt(last)] < last ? 1 : 0);
  const auto text = [&](std::size_t begin, std::size_t end) {
    return std::string(begin > 0 ? kCut : "") +
           std::string(name.substr(starts[begin], starts[end] - starts[begin])) +
           std::string(end < count ? kCut : "");
  };
  while (until > from && !hasRoom(text(from, until), room, width)) --until;
  // To both sides in turn, while there is room.
  bool before = true, after = true;
  while (before || after) {
    before = before && from > 0 && hasRoom(text(from - 1, until), room, width);
    if (before) --from;
    after = after && until < count && hasRoom(text(from, until + 1), room, width);
    if (after) ++until;
  }
  return until > from ? text(from, until) : cutInMiddle(name, room, width);
}

/// Those of different names that are shown alike.
std::map<std::string, std::vector<std::size_t>> shownAlike(const std::vector<std::string>& shown) {
  std::map<std::string, std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < shown.size(); ++i) groups[shown[i]].push_back(i);
  std::erase_if(groups, [](const auto& group) { return group.second.size() < 2; });
  return groups;
}

/// Shows what differs between names whose middles were cut to the same.
void showDifferences(const std::vector<std::string_view>& names, std::vector<std::string>& shown,
                     float room, const TextWidth& width) {
  for (const auto& [text, group] : shownAlike(shown)) {
    std::vector<std::string_view> same;
    for (const std::size_t i : group) same.push_back(names[i]);
    const std::size_t prefix = commonBytes(same, false, 0);
    const std::size_t suffix = commonBytes(same, true, prefix);
    for (const std::size_t i : group) {
      shown[i] = cutAround(names[i], prefix, names[i].size() - suffix, room, width);
    }
  }
}

/// Numbers what is still alike: "universal…2".
void numberThoseAlike(const std::vector<std::string_view>& names, std::vector<std::string>& shown,
                      float room, const TextWidth& width) {
  std::set<std::string> taken(shown.begin(), shown.end());
  for (const auto& [text, group] : shownAlike(shown)) {
    std::size_t next = 2;
    for (auto i = std::next(group.begin()); i != group.end(); ++i) {
      std::string numbered;
      do {
        const std::string end = std::string(kCut) + std::to_string(next++);
        if (!hasRoom(end, room, width)) return;
        const std::vector<std::size_t> starts = charactersOf(names[*i]);
        std::size_t kept = starts.size() - 1;
        const auto begun = [&] { return std::string(names[*i].substr(0, starts[kept])) + end; };
        while (kept > 0 && !hasRoom(begun(), room, width)) --kept;
        numbered = begun();
      } while (!taken.insert(numbered).second);
      shown[*i] = numbered;
    }
  }
}

/// Of different names.
std::vector<std::string> shortened(const std::vector<std::string_view>& names, float room,
                                   const TextWidth& width) {
  const Affixes common = commonWords(names);
  const auto allHaveRoom = [&](const std::vector<std::string_view>& texts) {
    return std::ranges::all_of(texts,
                               [&](std::string_view text) { return hasRoom(text, room, width); });
  };
  const Affixes choices[] = {{}, {0, common.suffix}, {common.prefix, 0}, common};
  for (const Affixes& choice : choices) {
    const std::vector<std::string_view> rest = withoutWords(names, choice);
    if (allHaveRoom(rest)) return {rest.begin(), rest.end()};
  }
  const std::vector<std::string_view> rest = withoutWords(names, common);
  std::vector<std::string> shown;
  for (const std::string_view text : rest) shown.push_back(cutInMiddle(text, room, width));
  showDifferences(rest, shown, room, width);
  numberThoseAlike(rest, shown, room, width);
  return shown;
}

}  // namespace

std::string cutInMiddle(std::string_view text, float room, const TextWidth& width) {
  if (hasRoom(text, room, width)) return std::string(text);
  const std::vector<std::size_t> starts = charactersOf(text);
  const std::size_t count = starts.size() - 1;
  // About as many characters as have room, and fewer until they do.
  const float wide = width(text);
  const auto about = static_cast<std::size_t>(
      wide > 0 && room > 0 ? std::min(room / wide, 1.0F) * static_cast<float>(count) + 4 : 0);
  for (std::size_t kept = std::min(about, count); kept-- > 0;) {
    const std::size_t tail = kept / 2;
    const std::string cut = std::string(text.substr(0, starts[kept - tail])) + std::string(kCut) +
                            std::string(text.substr(starts[count - tail]));
    if (hasRoom(cut, room, width)) return cut;
  }
  return hasRoom(kCut, room, width) ? std::string(kCut) : std::string();
}

std::string cutPath(std::string_view device, std::string_view link, float room,
                    const TextWidth& width) {
  if (link.empty()) return cutInMiddle(device, room, width);
  const std::string end = "/" + std::string(link);
  const std::string whole = std::string(device) + end;
  if (hasRoom(whole, room, width)) return whole;
  const std::string cut = cutInMiddle(device, room - width(end), width);
  return cut.empty() ? cutInMiddle(whole, room, width) : cut + end;
}

std::vector<std::string> shortNames(std::span<const std::string> names, float room,
                                    const TextWidth& width) {
  std::map<std::string_view, std::string> shown_as;
  for (const std::string& name : names) shown_as.emplace(name, std::string());
  std::vector<std::string_view> different;
  for (const auto& entry : shown_as) different.push_back(entry.first);
  std::vector<std::string> texts = shortened(different, room, width);
  auto text = texts.begin();
  for (auto& entry : shown_as) entry.second = std::move(*text++);
  std::vector<std::string> shown;
  for (const std::string& name : names) shown.push_back(shown_as.at(name));
  return shown;
}

const std::vector<std::string>& ShortNameLists::of(const std::string& id,
                                                   std::vector<std::string> names, float room,
                                                   const TextWidth& width) {
  List& list = lists_[id];
  // Of another text size all is as much wider as the sign is.
  const float cut_width = width(kCut);
  if (list.names == names && list.room == room && list.cut_width == cut_width) return list.shown;
  list.shown = shortNames(names, room, width);
  list.names = std::move(names);
  list.room = room;
  list.cut_width = cut_width;
  return list.shown;
}

}  // namespace rocinante
