#include "core/mcap/byte_sink.h"

#include <cassert>

namespace rocinante {
namespace {

class MemorySink final : public ByteSink {
 public:
  explicit MemorySink(Bytes& out) : out_(out) {}

  Status append(ByteView bytes) override {
    out_.insert(out_.end(), bytes.begin(), bytes.end());
    return {};
  }
  Status truncate(std::uint64_t size_bytes) override {
    out_.resize(static_cast<std::size_t>(size_bytes));
    return {};
  }
  bool overwritable() const override { return true; }
  Status overwriteAt(std::uint64_t offset, ByteView bytes) override {
    assert(offset <= out_.size() && bytes.size() <= out_.size() - offset);
    std::memcpy(out_.data() + offset, bytes.data(), bytes.size());
    return {};
  }
  Status close() override { return {}; }
  const std::string& name() const override { return name_; }

 private:
  Bytes& out_;
  std::string name_ = "memory";
};

}  // namespace

Status ByteSink::overwriteAt(std::uint64_t, ByteView) {
  return Error{ErrorKind::refused, "only a file can be overwritten", name()};
}

Status ByteSink::reserve(std::uint64_t) { return {}; }

Status ByteSink::startWriteback(std::uint64_t, std::uint64_t) { return {}; }

std::unique_ptr<ByteSink> makeMemorySink(Bytes& out) { return std::make_unique<MemorySink>(out); }

}  // namespace rocinante
