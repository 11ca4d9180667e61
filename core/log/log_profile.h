#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/base/time.h"

/// The names of the MCAP profile `rocinante` (docs/log-format.md).
namespace rocinante::profile {

inline constexpr std::string_view kName = "rocinante";
inline constexpr std::string_view kSession = "rocinante.session";  ///< metadata
inline constexpr std::string_view kEnd = "rocinante.end";          ///< metadata
inline constexpr std::string_view kFormatKey = "format";
inline constexpr std::string_view kFormat = "1";
inline constexpr std::string_view kSessionIdKey = "session_id";
inline constexpr std::string_view kOriginKey = "origin_ns";
inline constexpr std::string_view kReasonKey = "reason";
inline constexpr std::string_view kSplitReason = "split";  ///< another piece of the session follows

/// The prefix of our own topics, which are excluded from counts, hashes and time ranges.
inline constexpr std::string_view kOwnTopics = "/rocinante/";
/// The prefix of channels restated by another program; the fold reads those.
inline constexpr std::string_view kRestatedPrefix = "/rocinante/restated";
/// The opening keyframe of a merged log, restated.
inline constexpr std::string_view kRestatedKeyframeTopic = "/rocinante/restated/keyframe";
/// The packets that a decoder made of a channel's messages: this prefix and the channel's topic.
inline constexpr std::string_view kDecodedPrefix = "/rocinante/decoded";
/// Metadata of such a channel: the SHA-256 of the declaration that made its packets.
inline constexpr std::string_view kDecoderKey = "decoder";
/// Folder of attachments: the declarations of decoders, each HASH.toml.
inline constexpr std::string_view kDecodersFolder = "decoders/";
/// The SOURCE of decoded packets: this and the decoder's name.
inline constexpr std::string_view kDecodedSource = "decoded:";
/// Metadata of a channel that was translated from another format's recording: what format.
inline constexpr std::string_view kImportedKey = "imported";
/// Losses in the kernel, the queue or the disk (loss_message.h).
inline constexpr std::string_view kLossTopic = "/rocinante/loss";
inline constexpr std::string_view kLossEncoding = "json";
/// Steps of the recorder's wall clock (clock_message.h).
inline constexpr std::string_view kClockTopic = "/rocinante/clock";
inline constexpr std::string_view kClockEncoding = "json";
/// Keyframes: whole restatements of the session so far; an empty line separates the datagrams.
inline constexpr std::string_view kKeyframeTopic = "/rocinante/keyframe";
inline constexpr std::string_view kKeyframeEncoding = "rk1-keyframe";
/// Events set by a person, copied into the log from LOG.marks.
inline constexpr std::string_view kMarkTopic = "/rocinante/mark";
inline constexpr std::string_view kMarkEncoding = "json";

/// The cell carried by the log (docs/log-format.md, section "The cell"): metadata, the attachment
/// that lists its files, and the prefix of the names of those files' attachments.
inline constexpr std::string_view kCell = "rocinante.cell";
inline constexpr std::string_view kCellMainKey = "main";
inline constexpr std::string_view kCellManifestKey = "manifest";
inline constexpr std::string_view kCellSha256Key = "sha256";
inline constexpr std::string_view kCellManifest = "cell.json";
inline constexpr std::string_view kCellFolder = "cell/";

/// The topic without kRestatedPrefix or kDecodedPrefix: that of the captured channel, if there is
/// one.
std::string_view capturedTopic(std::string_view topic);
/// True for the SOURCE of packets that a decoder made.
bool isDecodedSource(std::string_view source);

/// The value of kOriginKey: whole nanoseconds since the epoch; empty when it is none.
std::optional<LogTime> parseOrigin(std::string_view text);

/// The message for a log whose rocinante.session gives another format than kFormat.
std::string otherFormatText(std::string_view format);

}  // namespace rocinante::profile
