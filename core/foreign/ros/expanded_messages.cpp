#include "core/foreign/ros/expanded_messages.h"

#include <utility>

#include "core/base/figure_text.h"
#include "core/mcap/chunk_expander.h"

namespace rocinante::ros {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kZstdMagic = "\x28\xb5\x2f\xfd"sv;
/// The largest payload that a log takes.
constexpr std::uint64_t kMaxMessageBytes = mcap::kMaxChunkBytes / 2;

class ExpandedMessages final : public BagReader {
 public:
  ExpandedMessages(std::unique_ptr<BagReader> bag, std::uint64_t file_bytes)
      : bag_(std::move(bag)), budget_(file_bytes), budget_of_last_(file_bytes) {}

  std::string_view kind() const override { return bag_->kind(); }
  const std::vector<BagTopic>& topics() const override { return bag_->topics(); }
  double part() const override { return bag_->part(); }
  Account account() const override { return bag_->account(); }
  Status copyExtras(LogWriter& log) override { return bag_->copyExtras(log); }
  void useDevices(const DeviceFinder& devices) override { bag_->useDevices(devices); }
  TranslationNotes notesOf(std::size_t topic) const override { return bag_->notesOf(topic); }
  std::optional<LogTime> origin() const override { return bag_->origin(); }

  Result<std::optional<BagMessage>> next() override {
    Result<std::optional<BagMessage>> message = bag_->next();
    if (!message || !*message || !isCompressed((*message)->topic, (*message)->payload)) {
      return message;
    }
    const Result<ByteView> expanded = expand((*message)->payload, budget_);
    if (expanded) {
      (*message)->payload = *expanded;
    } else if (lost_++ == 0) {
      first_ = topics()[(*message)->topic].name + ": " + expanded.error().what;
    }
    return message;
  }

  Result<std::optional<Bytes>> lastOf(std::size_t topic) override {
    Result<std::optional<Bytes>> message = bag_->lastOf(topic);
    if (!message || !*message || !isCompressed(topic, **message)) return message;
    const Result<ByteView> expanded = expand(**message, budget_of_last_);
    if (!expanded) return expanded.error();
    return std::optional(Bytes(expanded->begin(), expanded->end()));
  }

  std::vector<std::string> damage() const override {
    std::vector<std::string> all = bag_->damage();
    if (lost_ > 0) {
      all.push_back(countText(lost_, "message") +
                    " compressed with zstd not expanded, and kept as stored; the first: " + first_);
    }
    return all;
  }

 private:
  bool isCompressed(std::size_t topic, ByteView payload) const {
    return textOf(payload).starts_with(kZstdMagic) && topics()[topic].encoding == "cdr";
  }

  /// Borrowed until the next call.
  Result<ByteView> expand(ByteView stored, mcap::ExpansionBudget& budget) {
    const std::optional<std::uint64_t> size = mcap::zstdContentBytes(stored);
    if (!size) return mcap::damagedChunk("its size is not in the zstd frame");
    if (*size > kMaxMessageBytes) {
      return mcap::damagedChunk("it claims " + std::to_string(*size) + " bytes; at most " +
                                std::to_string(kMaxMessageBytes) + " are expanded");
    }
    mcap::Chunk frame;
    frame.compression = "zstd";
    frame.uncompressed_size = *size;
    frame.records = stored;
    if (!budget.take(frame)) return mcap::damagedChunk(mcap::ExpansionBudget::refusal());
    return expander_.expand(frame, scratch_);
  }

  std::unique_ptr<BagReader> bag_;
  mcap::ExpansionBudget budget_, budget_of_last_;
  mcap::ChunkExpander expander_;
  mcap::Scratch scratch_;
  std::uint64_t lost_ = 0;
  std::string first_;  ///< why the first of those is lost
};

}  // namespace

std::unique_ptr<BagReader> withExpandedMessages(std::unique_ptr<BagReader> bag,
                                                std::uint64_t file_bytes) {
  return std::make_unique<ExpandedMessages>(std::move(bag), file_bytes);
}

}  // namespace rocinante::ros
