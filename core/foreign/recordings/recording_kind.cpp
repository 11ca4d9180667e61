#include "core/foreign/recordings/recording_kind.h"

#include <algorithm>
#include <array>

#include "core/foreign/recordings/bag_folder.h"
#include "core/foreign/recordings/json_lines.h"
#include "core/foreign/recordings/lcm_log.h"
#include "core/foreign/recordings/recording_bytes.h"
#include "core/foreign/recordings/table_recording.h"
#include "core/foreign/recordings/text_refusal.h"
#include "core/foreign/table/table_header.h"
#include "core/log/foreign_file.h"
#include "core/log/log_profile.h"
#include "core/log/log_reader.h"
#include "core/log/mapped_file.h"
#include "core/mcap/byte_cursor.h"
#include "core/mcap/records.h"

namespace rocinante {
namespace {

using namespace std::string_view_literals;

constexpr std::size_t kSniffedBytes = std::size_t{64} << 10;
/// Of a text whose first line is longer than that: the header of a table may be.
constexpr std::size_t kSniffedLine = RecordingLines::kMaxBytes;
constexpr std::array kCaptureMagics{"\xd4\xc3\xb2\xa1"sv, "\xa1\xb2\xc3\xd4"sv,
                                    "\x4d\x3c\xb2\xa1"sv, "\xa1\xb2\x3c\x4d"sv,
                                    "\x0a\x0d\x0d\x0a"sv};

/// Neither a table nor JSON lines have control characters.
bool isText(std::string_view text) { return text.substr(0, 512).find('\0') == text.npos; }

Result<Bytes> firstBytesOf(const std::filesystem::path& path) {
  const Result<MappedFile> file = MappedFile::open(path);
  if (!file) return file.error();
  Bytes first;
  for (const std::size_t most : {kSniffedBytes, kSniffedLine}) {
    first.resize(std::min(file->bytes().size(), most));
    if (!file->read(0, first)) {
      return Error{ErrorKind::unreadable, "the file cannot be read", path.string()};
    }
    const std::string_view text = textOf(first);
    if (!isText(text) || text.find('\n') != text.npos) break;
  }
  return first;
}

/// The profile in the header of an MCAP file.
std::string_view profileIn(ByteView first_bytes) {
  mcap::ByteCursor cursor(first_bytes.subspan(mcap::magic().size()));
  if (cursor.number<std::uint8_t>() != static_cast<std::uint8_t>(mcap::Opcode::header)) return {};
  mcap::ByteCursor header(cursor.bytes64());
  const std::string_view profile = header.string();
  return header.ok() ? profile : std::string_view();
}

/// Other programs' MCAP files have neither our profile nor a channel that only we write.
bool isOurs(const std::filesystem::path& path, ByteView first_bytes) {
  if (profileIn(first_bytes) == profile::kName) return true;
  const Result<LogReader> log = LogReader::open(path);
  // What cannot be read is left to the reader of logs, which says why.
  if (!log || log->summary().profile == profile::kName) return true;
  return std::ranges::any_of(log->channels(), [](const LogChannel& channel) {
    return channel.encoding == "rk1" || channel.encoding == "octets";
  });
}

}  // namespace

RecordingKind recordingKindOf(ByteView first_bytes) {
  if (ros::bagKindOf(first_bytes) != ros::BagKind::none) return RecordingKind::bag;
  const std::string_view text = textOf(first_bytes);
  if (std::ranges::any_of(kCaptureMagics,
                          [&](std::string_view magic) { return text.starts_with(magic); })) {
    return RecordingKind::capture;
  }
  if (looksLikeLcm(first_bytes)) return RecordingKind::lcm;
  if (looksLikeJsonLines(text)) return RecordingKind::json_lines;
  if (looksLikeTable(text)) return RecordingKind::table;
  return RecordingKind::none;
}

RecordingKind recordingKindOf(const std::filesystem::path& path) {
  std::error_code fault;
  if (!filesOfBagFolder(path).empty()) return RecordingKind::bag;
  if (!std::filesystem::is_regular_file(path, fault)) return RecordingKind::none;
  const Result<Bytes> first = firstBytesOf(path);
  if (!first) return RecordingKind::none;
  const RecordingKind kind = recordingKindOf(*first);
  const bool is_mcap = kind == RecordingKind::bag && ros::bagKindOf(*first) == ros::BagKind::mcap;
  return is_mcap && isOurs(path, *first) ? RecordingKind::log : kind;
}

namespace {

std::optional<std::string> refusalOf(ByteView first_bytes) {
  const std::string_view text = textOf(first_bytes);
  if (auto refusal = textRefusal(text)) return refusal;
  if (!isText(text)) return std::nullopt;
  if (auto refusal = jsonLinesRefusal(text)) return refusal;
  if (text.size() == kSniffedLine && text.find('\n') == text.npos) {
    return "its first line is longer than 1 MiB, which neither the header of a table nor a line of "
           "JSON lines may be";
  }
  return tableRefusal(text);
}

std::optional<std::string> folderRefusal(const std::filesystem::path& folder) {
  if (!filesOfBagFolder(folder).empty()) return std::nullopt;
  std::error_code fault;
  if (std::filesystem::exists(folder / "metadata.yaml", fault)) {
    return "a ROS 2 bag without a .db3 or .mcap file; files compressed as .zstd are unpacked "
           "first: zstd -d FILE";
  }
  return "a folder is read only if it is a ROS 2 bag, with metadata.yaml and its .db3 or .mcap "
         "files; any other recording is a file: name that";
}

}  // namespace

std::optional<std::string> refusalOf(const std::filesystem::path& path) {
  std::error_code fault;
  if (std::filesystem::is_directory(path, fault)) return folderRefusal(path);
  const Result<Bytes> first = firstBytesOf(path);
  return first ? refusalOf(*first) : std::nullopt;
}

bool isForeign(RecordingKind kind) {
  return kind != RecordingKind::none && kind != RecordingKind::log;
}

Result<std::unique_ptr<ros::BagReader>> openRecording(const std::filesystem::path& path,
                                                      const std::string& device) {
  std::error_code fault;
  if (std::filesystem::is_directory(path, fault)) {
    return Error{ErrorKind::unsupported, *folderRefusal(path), path.string()};
  }
  const Result<Bytes> first = firstBytesOf(path);
  if (!first) return first.error();
  switch (recordingKindOf(*first)) {
    case RecordingKind::lcm:
      return openLcmLog(path);
    case RecordingKind::table:
      return openTable(path, device);
    case RecordingKind::json_lines:
      return openJsonLines(path, device);
    case RecordingKind::bag:
    case RecordingKind::log:
      return ros::openBag(path);
    case RecordingKind::capture:
    case RecordingKind::none:
      break;
  }
  return Error{ErrorKind::unsupported, refusalOf(ByteView(*first)).value_or(notImportable(*first)),
               path.string()};
}

}  // namespace rocinante
