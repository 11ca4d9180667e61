#include "core/mcap/summary.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "core/mcap/append_record.h"

namespace rocinante::test {
namespace {

/// The room reserved on the disk depends on this bound.
RC_GTEST_PROP(McapSummary, IsNeverLargerThanItSaidAndHardlySmaller, ()) {
  mcap::WriterOptions options;
  options.statistics = *rc::gen::arbitrary<bool>();
  options.repeat_channels = *rc::gen::arbitrary<bool>();
  options.chunk_indexes = *rc::gen::arbitrary<bool>();
  options.summary_offsets = *rc::gen::arbitrary<bool>();
  mcap::Summary summary(options);
  const auto anyText = [] {
    return std::string(static_cast<std::size_t>(*rc::gen::inRange(0, 40)), 'x');
  };
  const auto channels = static_cast<std::uint16_t>(*rc::gen::inRange(1, 30));
  std::vector<std::uint16_t> in_chunk;
  mcap::ChunkIndex last;
  last.compression = "zstd";
  for (std::uint16_t id = 0; id < channels; ++id) {
    Bytes record;
    mcap::append(record, mcap::Channel{id, 0, anyText(), "rk1", {{"source", anyText()}}});
    summary.addChannel(id, record);
    if (*rc::gen::arbitrary<bool>()) summary.addMessages(id, 3);
    if (!*rc::gen::arbitrary<bool>()) continue;
    in_chunk.push_back(id);
    last.message_index_offsets.emplace(id, 1000 + id);
  }
  for (int i = *rc::gen::inRange(0, 5); i > 0; --i) summary.addChunk(last);
  std::uint64_t announced = 0;
  for (int i = *rc::gen::inRange(0, 5); i > 0; --i) {
    const mcap::MetadataIndex index{1, 2, anyText()};
    const std::uint64_t before = summary.bytes({});
    summary.addMetadata(index);
    RC_ASSERT(summary.bytes({}) == before + mcap::Summary::bytesFor(index));
    const mcap::AttachmentIndex attachment{1, 2, 3, 4, 5, anyText(), anyText()};
    summary.addAttachment(attachment);
    RC_ASSERT(summary.bytes({}) ==
              before + mcap::Summary::bytesFor(index) + mcap::Summary::bytesFor(attachment));
  }
  const bool refused = *rc::gen::arbitrary<bool>();
  if (refused) summary.leaveOutUnused();

  announced = summary.bytes(in_chunk);
  // The announced chunk arrives, with a message on each of its channels.
  summary.addChunk(last);
  for (const std::uint16_t id : in_chunk) summary.addMessages(id, 1);
  const std::uint64_t made = summary.build(12345).size();
  RC_ASSERT(made <= announced);
  const bool everything = options.statistics && options.repeat_channels && options.chunk_indexes &&
                          options.summary_offsets;
  // At most: six offsets, and a count for each channel.
  if (everything) RC_ASSERT(announced - made <= 6 * 26 + 10 * std::uint64_t{channels});
}

}  // namespace
}  // namespace rocinante::test
