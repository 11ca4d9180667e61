#include "viewer/ui/model/notice_stack.h"

#include <algorithm>

namespace rocinante {

std::vector<std::size_t> NoticeStack::order(std::span<const NoticeKey> notices) {
  ++orders_;
  std::map<std::string, std::uint64_t> since;
  std::map<std::string, bool> dismissed;
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < notices.size(); ++i) {
    const NoticeKey& one = notices[i];
    const auto known = since_.find(one.key);
    since.emplace(one.key, known == since_.end() ? orders_ : known->second);
    if (!one.stays && dismissed_.contains(one.key)) {
      dismissed.emplace(one.key, true);
    } else {
      shown.push_back(i);
    }
  }
  since_ = std::move(since);
  dismissed_ = std::move(dismissed);
  std::ranges::stable_sort(shown, [&](std::size_t a, std::size_t b) {
    if (notices[a].stays != notices[b].stays) return notices[a].stays;
    return !notices[a].stays && since_.at(notices[a].key) > since_.at(notices[b].key);
  });
  return shown;
}

void NoticeStack::dismissAll() {
  for (const auto& [key, since] : since_) dismissed_.emplace(key, true);
}

NoticePlaces placeNotices(std::span<const NoticeSize> sizes, const PanelRectangle& free,
                          NoticeSize more, float gap, std::size_t most) {
  const auto placed = [&](const NoticeSize& size, float top) {
    const float left = free.x + std::max(0.0F, (free.width - size.width) / 2);
    return PanelRectangle{left, top, size.width, size.height};
  };
  NoticePlaces result;
  const float bottom = free.y + free.height;
  float top = free.y;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const bool is_last = i + 1 == sizes.size();
    const float needed = sizes[i].height + (is_last ? 0 : gap + more.height);
    const bool fits = i < most && top + needed <= bottom;
    if (i > 0 && !fits) break;
    result.places.push_back(placed(sizes[i], top));
    top += sizes[i].height + gap;
  }
  result.more = sizes.size() - result.places.size();
  if (result.more > 0) result.more_place = placed(more, top);
  return result;
}

}  // namespace rocinante
