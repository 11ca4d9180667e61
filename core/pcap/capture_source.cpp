#include "core/pcap/capture_source.h"

#include <fmt/format.h>

#include "core/pcap/capture_file.h"
#include "core/pcap/compiled_filter.h"
#include "core/pcap/frame_reader.h"
#include "core/pcap/pcap_filter.h"
#include "core/pcap/seen_batch.h"

namespace rocinante {
namespace {

// Frames of a call without a datagram, so that the caller can be stopped.
constexpr int kMaxFrames = 1 << 14;

class CaptureSource final : public DatagramSource {
 public:
  CaptureSource(const Endpoint& endpoint, CaptureFile file)
      : endpoint_(endpoint), file_(std::move(file)) {}

  /// Reads the first frame: it has the link type that a filter is compiled for.
  Status begin() {
    if (Status read = advance(); !read) return read;
    const int number = frame_ ? frame_->link_type : file_->firstLinkType().value_or(1);
    const auto link = linkTypeOf(number);
    if (!link) {
      return Error{ErrorKind::unsupported, fmt::format("link type {} is not supported", number),
                   endpoint_.text()};
    }
    if (endpoint_.filter.empty()) return {};
    Result<FrameReader::Filter> filter = compiledFilter(endpoint_.filter, *link);
    if (!filter) return Error{filter.error().kind, filter.error().what, endpoint_.text()};
    reader_ =
        FrameReader(std::move(*filter), FrameReader::Filtered::here, namesTags(endpoint_.filter));
    return {};
  }

  Result<std::span<const ReceivedDatagram>> receive() override {
    batch_.clear();
    for (int frames = 0; frames < kMaxFrames && frame_ && !batch_.isFull(); ++frames) {
      if (const auto link = linkTypeOf(frame_->link_type)) {
        const auto seen = reader_.read(*link, frame_->bytes, frame_->wire_bytes, frame_->time);
        if (seen) batch_.add(*seen, frame_->time);
      } else {
        reader_.passOver(frame_->link_type);
      }
      if (Status read = advance(); !read) broken_ = read.error();
    }
    // Datagrams before the break are delivered first.
    if (broken_ && batch_.size() == 0) return *broken_;
    if (!frame_ && !broken_) {
      reader_.finish();
      ended_ = true;
    }
    return batch_.datagrams();
  }

  std::uint64_t dropped() const override { return 0; }
  Result<std::uint64_t> droppedByNow() override { return dropped(); }
  InputCounts counts() const override {
    InputCounts counts = reader_.counts();
    // They break the rules of the file.
    counts.malformed += file_->withoutInterface();
    return counts;
  }
  Account leftOut() const override {
    Account account = reader_.leftOut(true);
    account.add(file_->leftOut());
    return account;
  }
  bool ended() const override { return ended_; }
  const Endpoint& endpoint() const override { return endpoint_; }
  const SocketAddress& boundAddress() const override { return endpoint_.address; }

 private:
  Status advance() {
    auto frame = file_->next();
    frame_.reset();
    if (!frame) return Error{frame.error().kind, frame.error().what, endpoint_.text()};
    frame_ = *frame;
    return {};
  }

  Endpoint endpoint_;
  std::optional<CaptureFile> file_;
  std::optional<CapturedFrame> frame_;  ///< to be read next; empty: none follows
  std::optional<Error> broken_;         ///< where the file breaks off
  FrameReader reader_;
  bool ended_ = false;
  SeenBatch batch_;
};

}  // namespace

Result<std::unique_ptr<DatagramSource>> openCaptureSource(const Endpoint& endpoint) {
  Result<CaptureFile> file = CaptureFile::open(endpoint.file);
  if (!file) return Error{file.error().kind, file.error().what, endpoint.text()};
  auto source = std::make_unique<CaptureSource>(endpoint, std::move(*file));
  if (Status begun = source->begin(); !begun) return begun.error();
  return source;
}

}  // namespace rocinante
