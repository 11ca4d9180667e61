#include "core/relay/restating.h"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>

#include "core/packet/packet_limits.h"
#include "core/relay/device_values.h"

namespace rocinante {
namespace {

/// Statements that delete items of other sources come first (docs/packet-format.md, "Writing a
/// restatement").
enum Stage : std::size_t { removals, positions, items, stage_count };

Stage stageOf(const SessionState& state, const ItemKey& key) {
  if (key.kind == ItemKind::positions) return positions;
  if (key.kind != ItemKind::presence) return items;
  const PresenceValue& value = state.findDevice(key.name)->presence->value;
  return value.presence == Presence::removed ? removals : items;
}

bool isStatedWithValues(const SessionState& state, const ItemKey& key, const ItemStyle& style) {
  return key.kind == ItemKind::order &&
         !orderOfValues(*state.findDevice(key.name), key.second, style).empty();
}

/// One item, or the values of one device that one SOURCE owns: they are said together.
struct Planned {
  std::vector<ItemKey> keys;
  std::size_t bytes = 0;
};

}  // namespace

Restating::Restating(const SessionState& state, Options options) : options_(std::move(options)) {
  std::map<std::string, std::array<std::vector<Planned>, stage_count>> plans;
  std::map<std::string, const std::string*, std::less<>> owners;  // of each device's items
  bool by_stage = false;
  for (const auto& source : state.sources()) {
    const bool passes =
        std::all_of(options_.filters.begin(), options_.filters.end(),
                    [&](const RelayFilter& filter) { return filter.passesSource(source.first); });
    if (passes) plans[source.first];
  }
  const auto plan = [&](const std::string& owner, std::vector<ItemKey> keys) {
    SentOrders ignored;
    std::size_t bytes = 0;
    for (const std::string& text : DeviceValues(state, keys, options_.style).texts(true, ignored)) {
      bytes += text.size();
    }
    plans[owner][stageOf(state, keys[0])].push_back({std::move(keys), bytes});
  };
  std::string device;
  std::map<std::string, std::vector<ItemKey>> values;  // of this device, by owner
  const auto planValues = [&] {
    for (auto& [owner, keys] : values) plan(owner, std::move(keys));
    values.clear();
  };
  forEachItem(state, [&](ItemKey&& key) {
    if (key.kind == ItemKind::visibility || key.name != device) {
      planValues();
      device = key.name;
    }
    if (!passes(options_.filters, state, key)) return;
    const std::string* const owner = ownerOf(state, key);
    if (isOfDevice(key)) {
      const auto first = owners.emplace(key.name, owner).first;
      by_stage = by_stage || *first->second != *owner;
    }
    if (isDeviceValue(key)) {
      values[*owner].push_back(std::move(key));
    } else if (!isStatedWithValues(state, key, options_.style)) {
      plan(*owner, {std::move(key)});
    }
  });
  planValues();

  for (auto& [source, stages] : plans) {
    const std::size_t first = parts_.size();
    std::size_t filled = 0;
    for (std::size_t stage = 0; stage < stage_count; ++stage) {
      if (by_stage) filled = 0;
      for (Planned& each : stages[stage]) {
        const bool is_removal = stage == removals;
        const bool is_new = filled == 0 || filled + each.bytes > options_.text_bytes ||
                            parts_.back().removals != is_removal;
        if (is_new) {
          parts_.push_back({source, {}, 1, 1, is_removal});
          filled = 0;
        }
        for (ItemKey& key : each.keys) parts_.back().items.push_back(std::move(key));
        filled += each.bytes;
      }
    }
    if (parts_.size() == first) parts_.push_back({source, {}, 1, 1, false});
    const std::size_t count = parts_.size() - first;
    if (count > limits::kRestatementParts) options_.with_parts = false;
    for (std::size_t i = 0; i < count; ++i) {
      parts_[first + i].index = static_cast<std::uint32_t>(i + 1);
      parts_[first + i].count = static_cast<std::uint32_t>(count);
    }
  }
  if (!by_stage) return;
  const auto stageOfPart = [&](const Part& part) -> std::size_t {
    return part.removals                                                      ? removals
           : !part.items.empty() && part.items[0].kind == ItemKind::positions ? positions
                                                                              : items;
  };
  std::stable_sort(parts_.begin(), parts_.end(),
                   [&](const Part& a, const Part& b) { return stageOfPart(a) < stageOfPart(b); });
}

std::vector<RelayDraft> Restating::next(const SessionState& state, std::vector<ItemKey>* restated,
                                        SentOrders& sent_orders) {
  const Part& part = parts_[next_++];
  std::vector<RelayDraft> drafts(1);
  drafts[0].source = part.source;
  std::vector<ItemKey> together;
  const auto say = [&] {
    if (together.empty()) return;
    for (std::string& lines :
         DeviceValues(state, together, options_.style).texts(true, sent_orders)) {
      const std::string& text = drafts.back().text;
      if (!text.empty() && text.size() + lines.size() > options_.text_bytes) {
        drafts.push_back({part.source, {}, {}});
      }
      drafts.back().text += lines;
    }
    if (restated != nullptr) restated->insert(restated->end(), together.begin(), together.end());
    together.clear();
  };
  for (const ItemKey& key : part.items) {
    const bool goes_on = !together.empty() && isDeviceValue(key) && isDeviceValue(together[0]) &&
                         key.name == together[0].name;
    if (!goes_on) say();
    const std::string* const owner = ownerOf(state, key);
    // What another source has written meanwhile has passed already, and so has a new `remove`.
    if (owner == nullptr || *owner != part.source) continue;
    if (!part.removals && stageOf(state, key) == removals) continue;
    if (!passes(options_.filters, state, key)) continue;
    if (isStatedWithValues(state, key, options_.style)) continue;
    together.push_back(key);
  }
  say();
  // A part that no longer fits: the rest goes without part=, inside the restatement.
  const bool fits = drafts.size() == 1 || part.count > 1;
  if (!options_.with_parts || !fits) return drafts;
  RelayDraft& marked = part.index == 1 ? drafts.front() : drafts.back();
  marked.part = RestatementPart{options_.id, part.index, part.count};
  return drafts;
}

}  // namespace rocinante
