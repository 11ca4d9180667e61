#include "core/foreign/recordings/recording_bytes.h"

#include <algorithm>

namespace rocinante {
namespace {

constexpr std::size_t kWindowBytes = std::size_t{256} << 10;
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

}  // namespace

RecordingBytes::RecordingBytes(MappedFile file)
    : file_(std::move(file)), is_file_(true), size_(file_.bytes().size()) {}

bool RecordingBytes::read(std::size_t from, std::span<std::byte> out) const {
  if (out.size() > size_ || from > size_ - out.size()) return false;
  if (is_file_) return file_.read(from, out);
  std::ranges::copy(memory_.subspan(from, out.size()), out.begin());
  return true;
}

bool RecordingLines::fill() {
  const std::size_t more = std::min(kWindowBytes, bytes_.size() - begins_);
  if (more == 0 || is_cut_) return false;
  window_.erase(0, at_);
  at_ = 0;
  const std::size_t before = window_.size();
  window_.resize(before + more);
  if (!bytes_.read(begins_, std::as_writable_bytes(std::span(window_).subspan(before)))) {
    window_.resize(before);
    is_cut_ = true;
    return false;
  }
  if (begins_ == 0 && window_.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
  begins_ += more;
  return true;
}

std::optional<std::string_view> RecordingLines::next() {
  was_too_long_ = false;
  std::size_t searched = 0;
  while (true) {
    const std::size_t end = window_.find('\n', at_ + searched);
    if (end != window_.npos) {
      std::string_view line = std::string_view(window_).substr(at_, end - at_);
      at_ = end + 1;
      ++number_;
      if (was_too_long_) return std::string_view();
      if (line.ends_with('\r')) line.remove_suffix(1);
      return line;
    }
    searched = window_.size() - at_;
    if (searched > kMaxBytes) {
      was_too_long_ = true;
      at_ = window_.size();
      searched = 0;
    }
    if (fill()) continue;
    if (at_ == window_.size() && !was_too_long_) return std::nullopt;
    std::string_view line = std::string_view(window_).substr(at_);
    at_ = window_.size();
    ++number_;
    if (was_too_long_) return std::string_view();
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
  }
}

std::string RecordingLines::head() const {
  std::string text(std::min(bytes_.size(), kMaxBytes), '\0');
  if (!bytes_.read(0, std::as_writable_bytes(std::span(text)))) text.clear();
  return text;
}

double RecordingLines::part() const {
  if (bytes_.size() == 0) return 1;
  const std::size_t waiting = window_.size() - at_;
  return static_cast<double>(begins_ - waiting) / static_cast<double>(bytes_.size());
}

}  // namespace rocinante
