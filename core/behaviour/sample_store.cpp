#include "core/behaviour/sample_store.h"

#include <filesystem>

namespace rocinante {
namespace {

constexpr std::size_t kInMemory = std::size_t{64} << 20;

}  // namespace

void SampleStore::append(ByteView bytes) {
  if (!done_) return;
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  if (bytes_.size() >= kInMemory) done_ = flush();
}

Status SampleStore::flush() {
  if (!file_) {
    std::error_code fault;
    const std::filesystem::path folder = std::filesystem::temp_directory_path(fault);
    auto made = UnnamedFile::make(fault ? "/tmp" : folder.string());
    if (!made.ok()) return made.error();
    file_.emplace(std::move(*made));
  }
  if (Status written = file_->write(in_file_, bytes_); !written) return written;
  in_file_ += bytes_.size();
  bytes_.clear();
  return {};
}

Result<std::shared_ptr<const SampleBytes>> SampleStore::finish() {
  if (!file_ && done_.has_value()) return std::make_shared<const SampleBytes>(std::move(bytes_));
  if (done_.has_value()) done_ = flush();
  if (!done_) return done_.error();
  auto mapped = MappedFile::open(file_->path());
  if (!mapped.ok()) return mapped.error();
  return std::make_shared<const SampleBytes>(std::move(*mapped), in_file_);
}

}  // namespace rocinante
