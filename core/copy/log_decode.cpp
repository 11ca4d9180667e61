#include "core/copy/log_edits.h"
#include "core/foreign/decode/carried_decoders.h"
#include "core/log/log_profile.h"

namespace rocinante {
namespace {

/// Writes each packet behind its octets.
class DecodedAddition final : public CopyAddition {
 public:
  explicit DecodedAddition(decode::DatagramDecoders& decoders) : decoders_(decoders) {}

  bool keeps(const LogAttachment& attachment) const override {
    return !attachment.name.starts_with(profile::kDecodersFolder);
  }

  Status begin(PieceWriter& piece, LogTime start) override {
    for (const decode::CarriedFile& file : decode::carriedFiles(decoders_.set(), start)) {
      if (Status added = piece.addAttachment(file.attachment, file.bytes); !added) return added;
    }
    return {};
  }

  Status follow(const CopyItem& item, PieceWriter& piece) override {
    if (item.kind != CopyItem::Kind::message) return {};
    const LogChannel& channel = *item.message.channel;
    if (!channel.captured() || channel.encoding == "rk1" || channel.imported()) return {};
    ++octets_;
    const decode::DecodedPacket* const packet =
        decoders_.decode(decode::routeOf(channel), item.publish_time_ns, item.message.payload);
    if (packet == nullptr) return {};
    return piece.addDecoded(item, decode::decodedMetadata(decoders_.set(), packet->decoder),
                            packet->text);
  }

  std::uint64_t octets() const { return octets_; }

 private:
  decode::DatagramDecoders& decoders_;
  std::uint64_t octets_ = 0;
};

}  // namespace

Result<DecodeReport> decodeLog(const std::filesystem::path& log, decode::DatagramDecoders& decoders,
                               const MakeOptions& make) {
  if (Status free = checkOutput(make.output, make.overwrite, {{log}}); !free) return free.error();
  Result<OpenedLog> opened = openForCopy(log);
  if (!opened) return opened.error();
  // Packets of an import have no declaration: they stay.
  for (const LogChannel& channel : opened->reader.channels()) {
    const bool made_of_octets = channel.decoded() && !channel.imported();
    const bool orphaned = channel.folded() && !channel.captured() && !channel.received();
    if (!made_of_octets && !orphaned) continue;
    opened->options.selection.not_channels.push_back(channel.topic);
  }
  const Result<std::string> session_id = sessionIdOf(opened->reader);
  if (!session_id) return session_id.error();
  Result<CopySource> source = CopySource::of(std::move(opened->reader), std::move(opened->options),
                                             std::nullopt, make.progress);
  if (!source) return source.error();
  std::vector<CopySource> sources;
  sources.push_back(std::move(*source));
  DecodedAddition addition(decoders);
  Result<CopyReport> copied =
      makeLog(sources, make, {make.log, make.keyframes, *session_id, sources.front().origin()},
              "rocinante log decode", false, &addition);
  if (!copied) return copied.error();
  return DecodeReport{std::move(*copied), decode::accountOf(decoders, addition.octets())};
}

}  // namespace rocinante
