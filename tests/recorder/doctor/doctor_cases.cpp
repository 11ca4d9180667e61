#include "tests/recorder/doctor/doctor_cases.h"

#include "core/log/log_writer.h"
#include "core/mcap/append_record.h"
#include "core/packet/decoder.h"
#include "core/session/keyframe.h"

namespace rocinante::test {
namespace {

using mcap::Opcode;

Bytes record(std::uint8_t opcode, std::uint64_t length, std::size_t there) {
  Bytes out;
  out.push_back(static_cast<std::byte>(opcode));
  for (int i = 0; i < 8; ++i) out.push_back(static_cast<std::byte>(length >> (8 * i)));
  out.resize(out.size() + there);
  return out;
}

template <class T>
Bytes recordOf(const T& what) {
  Bytes out;
  mcap::append(out, what);
  return out;
}

/// The first byte of the file that reads `text`.
std::byte& byteOf(Bytes& file, std::string_view text) {
  const std::size_t at = textOf(file).find(text);
  EXPECT_NE(at, std::string_view::npos);
  return file[at];
}

std::string keyframeOf(const std::vector<std::string>& datagrams) {
  SessionState state;
  const std::unique_ptr<Decoder> decoder = makeDecoder("rk1");
  for (const std::string& datagram : datagrams) {
    state.apply(LogTime(Nanoseconds(1005)), *decoder->decode(bytesOf(datagram)));
  }
  return keyframeText(state);
}

}  // namespace

void addOwnMessage(HandMade& log, const char* topic, const char* encoding, std::uint64_t time,
                   const std::string& payload) {
  const mcap::Channel channel{3, 0, topic, encoding, {}};
  log.chunks[1].channels.push_back(channel);
  log.chunks[1].messages.push_back({3, time, payload});
  log.summary_channels.push_back(channel);
}

const std::vector<DoctorCase>& doctorCases() {
  static const std::vector<DoctorCase> kCases = {
      // The structure of the file.
      {"not-closed", {}, [](Bytes& file) { file.pop_back(); }},
      {"not-closed", {}, [](Bytes& file) { file.resize(file.size() - 100); }},
      {"not-closed", {}, [](Bytes& file) { file.resize(300); }},
      {"magic", {}, [](Bytes& file) { file.back() = std::byte{0}; }},
      {"trailing-bytes", {}, [](Bytes& file) { file.push_back(std::byte{0}); }},
      {"header", [](HandMade& log) { foreign(log); },
       [](Bytes& file) {
         file[8] = std::byte{0x80};
         file = resealed(file);
       }},
      {"record-fields", [](HandMade& log) { log.loose = record(4, 3, 3); }, {}},
      {"record-length", [](HandMade& log) { log.loose = record(0x90, 1 << 20, 0); }, {}},
      {"opcode", [](HandMade& log) { log.loose = record(0, 2, 2); }, {}},
      {"record-place",
       [](HandMade& log) {
         log.loose = recordOf(mcap::Header{"x", "y"});
       },
       {}},
      {"data-end",
       [](HandMade& log) {
         foreign(log);
         log.summary_channels.clear();
         log.change_statistics = [](mcap::Statistics& said) { said.channel_count = 2; };
       },
       [](Bytes& file) {
         std::uint64_t at = 8;
         while (mcap::recordAt(file, at)->opcode != Opcode::data_end) {
           at = mcap::recordAt(file, at)->end();
         }
         file[at] = std::byte{0x90};
       }},
      {"data-crc",
       [](HandMade& log) {
         log.change_data_end = [](mcap::DataEnd& end) { end.data_section_crc ^= 1; };
       },
       {}},
      // Definitions.
      {"utf8", [](HandMade& log) { log.attachments[0].name = "\xff"; }, {}},
      {"map-key",
       [](HandMade& log) {
         // Two keys of one length, made the same afterwards.
         log.metadata_before.push_back({"mine", {{"keyA", "1"}, {"keyB", "2"}}});
       },
       [](Bytes& file) {
         (&byteOf(file, "keyB"))[3] = std::byte{'A'};
         file = resealed(file);
       }},
      {"schema-id",
       [](HandMade& log) {
         foreign(log);
         log.loose = recordOf(mcap::Schema{0, "n", "json", {}});
       },
       {}},
      {"schema-encoding",
       [](HandMade& log) {
         foreign(log);
         log.loose = recordOf(mcap::Schema{1, "n", "", Bytes(3)});
         log.change_statistics = [](mcap::Statistics& said) { said.schema_count = 1; };
       },
       {}},
      {"channel-schema",
       [](HandMade& log) {
         foreign(log);
         log.loose = recordOf(mcap::Channel{3, 9, "/x", "json", {}});
         log.change_statistics = [](mcap::Statistics& said) { said.channel_count = 3; };
       },
       {}},
      {"redefined",
       [](HandMade& log) {
         log.loose = recordOf(mcap::Channel{1, 0, "/other", "rk1", {}});
       },
       {}},
      {"message-channel",
       [](HandMade& log) {
         log.chunks[1].messages.push_back({7, 1006, "RK1 a 1 -"});
       },
       {}},
      // Chunks and their indexes.
      {"chunk-content",
       [](HandMade& log) {
         log.chunks[0].change = [](mcap::Chunk& chunk) { ++chunk.uncompressed_size; };
       },
       {}},
      {"chunk-crc",
       [](HandMade& log) {
         log.chunks[0].change = [](mcap::Chunk& chunk) { chunk.uncompressed_crc ^= 1; };
       },
       {}},
      {"chunk-unread",
       [](HandMade& log) {
         foreign(log);
         log.chunks[0].change = [](mcap::Chunk& chunk) { chunk.compression = "snappy"; };
       },
       {}},
      {"chunk-records",
       [](HandMade& log) {
         log.chunks[0].extra = recordOf(mcap::Metadata{"x", {}});
       },
       {}},
      {"chunk-records", [](HandMade& log) { log.chunks[0].extra = record(5, 1 << 20, 30); }, {}},
      {"chunk-times",
       [](HandMade& log) {
         log.chunks[1].change = [](mcap::Chunk& chunk) { ++chunk.message_end_time; };
       },
       {}},
      {"index-twice",
       [](HandMade& log) {
         log.chunks[0].change_indexes = [](auto& indexes) { indexes.push_back(indexes[0]); };
       },
       {}},
      {"index-empty",
       [](HandMade& log) {
         log.chunks[1].change_indexes = [](auto& indexes) { indexes.push_back({2, {}}); };
       },
       {}},
      {"index-entries",
       [](HandMade& log) {
         log.chunks[0].change_indexes = [](auto& indexes) { ++indexes[0].records[1].first; };
       },
       {}},
      {"index-entries",
       [](HandMade& log) {
         log.chunks[0].change_indexes = [](auto& indexes) {
           indexes[1].records.pop_back(), indexes[1].records.emplace_back(1001, 0);
         };
       },
       {}},
      {"index-entries",
       [](HandMade& log) {
         log.chunks[1].change_indexes = [](auto& indexes) { indexes.push_back({2, {{1002, 0}}}); };
       },
       {}},
      {"index-missing",
       [](HandMade& log) {
         log.chunks[0].change_indexes = [](auto& indexes) { indexes.pop_back(); };
       },
       {}},
      {"attachment-crc",
       {},
       [](Bytes& file) {
         byteOf(file, "the cell") ^= std::byte{1};
         file = resealed(file);
       }},
      // The summary.
      {"summary-crc", [](HandMade& log) { log.summary_crc_xor = 1; }, {}},
      {"footer",
       [](HandMade& log) {
         log.change_footer = [](mcap::Footer& footer) { footer.summary_offset_start = 0; };
       },
       {}},
      {"summary-group",
       [](HandMade& log) {
         foreign(log);
         const Bytes again = recordOf(log.summary_channels[0]);
         log.change_summary = [again](Bytes& summary) {
           summary.insert(summary.end(), again.begin(), again.end());
         };
         log.change_offsets = [](auto& offsets) { offsets.pop_back(); };
       },
       {}},
      {"summary-offset",
       [](HandMade& log) { log.change_offsets = [](auto& offsets) { ++offsets[0].group_length; }; },
       {}},
      {"summary-offset",
       [](HandMade& log) { log.change_offsets = [](auto& offsets) { offsets.pop_back(); }; },
       {}},
      {"summary-channel",
       [](HandMade& log) {
         log.summary_channels.pop_back();
         log.change_statistics = [](mcap::Statistics& said) { said.channel_count = 2; };
       },
       {}},
      {"chunk-index", [](HandMade& log) { log.chunks[0].indexed = false; }, {}},
      {"chunk-index",
       [](HandMade& log) {
         log.chunks[1].change_chunk_index = [](auto& index) { ++index.message_index_offsets[1]; };
       },
       {}},
      {"chunk-index",
       [](HandMade& log) {
         log.chunks[1].change_chunk_index = [](auto& index) { --index.chunk_start_offset; };
         log.chunks[1].indexed = true;
       },
       {}},
      {"attachment-index",
       [](HandMade& log) {
         log.change_attachment_indexes = [](auto& indexes) { indexes[0].name = "other"; };
       },
       {}},
      {"metadata-index",
       [](HandMade& log) {
         log.change_metadata_indexes = [](auto& indexes) { indexes.push_back(indexes[0]); };
       },
       {}},
      {"metadata-index",
       [](HandMade& log) {
         log.change_metadata_indexes = [](auto& indexes) { indexes.pop_back(); };
       },
       {}},
      {"statistics",
       [](HandMade& log) {
         log.change_statistics = [](mcap::Statistics& said) { ++said.channel_message_counts[1]; };
       },
       {}},
      {"statistics", [](HandMade& log) { log.with_statistics = false; }, {}},
      {"statistics", [](HandMade& log) { log.statistics_first = true; }, {}},
      {"loose-message",
       [](HandMade& log) {
         foreign(log);
         log.loose = recordOf(mcap::Message{1, 9, 1006, 0, {}});
         log.change_statistics = [](mcap::Statistics& said) {
           ++said.message_count;
           ++said.channel_message_counts[1];
           said.message_end_time = 1006;
         };
       },
       {}},
      // The profile.
      {"loose-message",
       [](HandMade& log) {
         log.loose = recordOf(mcap::Message{1, 9, 1006, 0, bytesOf("RK1 arm 9 -")});
         log.change_statistics = [](mcap::Statistics& said) {
           ++said.message_count;
           ++said.channel_message_counts[1];
           said.message_end_time = 1006;
         };
       },
       {}},
      {"profile-crc",
       [](HandMade& log) {
         log.change_data_end = [](mcap::DataEnd& end) { end.data_section_crc = 0; };
       },
       {}},
      {"profile-crc",
       [](HandMade& log) {
         log.chunks[0].change = [](mcap::Chunk& chunk) { chunk.uncompressed_crc = 0; };
       },
       {}},
      {"profile-compression",
       [](HandMade& log) {
         log.chunks[0].change = [](mcap::Chunk& chunk) { chunk.compression = "snappy"; };
       },
       {}},
      {"profile-schema",
       [](HandMade& log) {
         log.loose = recordOf(mcap::Schema{1, "n", "json", {}});
         const Bytes channel = recordOf(mcap::Channel{3, 1, "/x", "json", {}});
         log.loose.insert(log.loose.end(), channel.begin(), channel.end());
         log.change_statistics = [](mcap::Statistics& said) {
           said.schema_count = 1;
           said.channel_count = 3;
         };
       },
       {}},
      {"chunk-alone", [](HandMade& log) { log.chunks[1].channels.clear(); }, {}},
      {"topic",
       [](HandMade& log) {
         for (auto* channels : {&log.chunks[0].channels, &log.summary_channels}) {
           channels->at(1).topic = "raw";
         }
       },
       {}},
      {"encoding", [](HandMade& log) { log.chunks[0].messages[0].payload = "no packet"; }, {}},
      {"encoding", [](HandMade& log) { log.chunks[0].messages[1].payload = "RK1 a - -"; }, {}},
      {"encoding",
       [](HandMade& log) {
         addOwnMessage(log, "/rocinante/mark", "text", 1006, R"({"text":"x"})");
       },
       {}},
      {"time-range",
       [](HandMade& log) { log.chunks[1].messages[1].time = std::uint64_t{1} << 63U; },
       {}},
      {"time-order", [](HandMade& log) { log.chunks[1].messages[0].time = 1001; }, {}},
      {"session", [](HandMade& log) { log.metadata_before[0].metadata["format"] = "2"; }, {}},
      {"session", [](HandMade& log) { log.metadata_before.push_back(log.metadata_before[0]); }, {}},
      {"session",
       [](HandMade& log) {
         for (auto* metadata : {&log.metadata_before[0], &log.metadata_behind[0]}) {
           metadata->metadata.erase("origin_ns");
         }
       },
       {}},
      {"session-place",
       [](HandMade& log) {
         log.metadata_behind.insert(log.metadata_behind.begin(), log.metadata_before[0]);
         log.metadata_before.clear();
       },
       {}},
      {"end", [](HandMade& log) { log.metadata_behind.clear(); }, {}},
      {"end", [](HandMade& log) { log.metadata_behind[0].metadata.erase("reason"); }, {}},
      {"end",
       [](HandMade& log) {
         log.metadata_behind.push_back({"mine", {}});
       },
       {}},
      {"origin", [](HandMade& log) { log.metadata_behind[0].metadata["origin_ns"] = "999"; }, {}},
      {"loss",
       [](HandMade& log) { addOwnMessage(log, "/rocinante/loss", "json", 1006, "{}"); },
       {}},
      {"mark", [](HandMade& log) { addOwnMessage(log, "/rocinante/mark", "json", 1006, "x"); }, {}},
      {"restated",
       [](HandMade& log) { log.chunks[0].messages[0].payload = "RK1 arm 0 - by=relay"; },
       {}},
      {"keyframe-content",
       [](HandMade& log) {
         addOwnMessage(log, "/rocinante/keyframe", "rk1-keyframe", 1005, "nonsense");
       },
       {}},
      {"keyframe-state",
       [](HandMade& log) {
         addOwnMessage(log, "/rocinante/keyframe", "rk1-keyframe", 1005,
                       keyframeOf({"RK1 arm 3 -\njoints arm 5"}));
       },
       {}},
      {"keyframe-time",
       [](HandMade& log) {
         addOwnMessage(log, "/rocinante/keyframe", "rk1-keyframe", 1006,
                       keyframeOf({"RK1 arm 3 -\njoints arm 4"}));
       },
       {}},
      {"keyframe-place",
       [](HandMade& log) {
         log.chunks[1].messages[1].payload = "RK1 arm 3 - restated part=a:1/2\njoints arm 4";
         addOwnMessage(log, "/rocinante/keyframe", "rk1-keyframe", 1005,
                       keyframeOf({"RK1 arm 3 -\njoints arm 4"}));
       },
       {}},
  };
  return kCases;
}

}  // namespace rocinante::test
