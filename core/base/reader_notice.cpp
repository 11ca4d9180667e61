#include "core/base/reader_notice.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <utility>

namespace rocinante {
namespace {

constexpr std::size_t kMaxNotices = 16;

std::mutex notices_mutex;
std::vector<ReaderNotice> notices;
std::atomic<bool> has_notices{false};

}  // namespace

void addReaderNotice(ReaderNotice notice) {
  const std::lock_guard lock(notices_mutex);
  const bool is_known = std::ranges::any_of(
      notices, [&](const ReaderNotice& each) { return each.text == notice.text; });
  if (is_known || notices.size() == kMaxNotices) return;
  notices.push_back(std::move(notice));
  has_notices = true;
}

bool hasReaderNotices() { return has_notices; }

std::vector<ReaderNotice> readerNotices() {
  const std::lock_guard lock(notices_mutex);
  return notices;
}

}  // namespace rocinante
