#pragma once

#include <string>
#include <string_view>

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

/// The prefix of our own topics, which are excluded from counts, hashes and time ranges.
inline constexpr std::string_view kOwnTopics = "/rocinante/";
/// The prefix of channels restated by another program; the fold reads those.
inline constexpr std::string_view kRestatedPrefix = "/rocinante/restated";
/// The opening keyframe of a merged log, restated.
inline constexpr std::string_view kRestatedKeyframeTopic = "/rocinante/restated/keyframe";
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

/// The message for a log whose rocinante.session gives another format than kFormat.
std::string otherFormatText(std::string_view format);

}  // namespace rocinante::profile
