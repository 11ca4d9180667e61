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

/// Before our own topics, which are in no count, hash or time range.
inline constexpr std::string_view kOwnTopics = "/rocinante/";
/// Before the topic of a channel whose messages someone else said again; the fold reads those.
inline constexpr std::string_view kRestatedPrefix = "/rocinante/restated";
/// The opening keyframe of a merged log, said again.
inline constexpr std::string_view kRestatedKeyframeTopic = "/rocinante/restated/keyframe";
/// What the kernel, the queue or the disk lost (loss_message.h).
inline constexpr std::string_view kLossTopic = "/rocinante/loss";
inline constexpr std::string_view kLossEncoding = "json";
/// The recorder's wall clock was set (clock_message.h).
inline constexpr std::string_view kClockTopic = "/rocinante/clock";
inline constexpr std::string_view kClockEncoding = "json";
/// Whole restatements of the session so far; the datagrams are separated by an empty line.
inline constexpr std::string_view kKeyframeTopic = "/rocinante/keyframe";
inline constexpr std::string_view kKeyframeEncoding = "rk1-keyframe";
/// Events that a person put there, baked in from LOG.marks.
inline constexpr std::string_view kMarkTopic = "/rocinante/mark";
inline constexpr std::string_view kMarkEncoding = "json";

/// The cell that the log carries (docs/log-format.md, section "The cell"): metadata, the attachment
/// that lists its files, and how the names of the attachments of those files begin.
inline constexpr std::string_view kCell = "rocinante.cell";
inline constexpr std::string_view kCellMainKey = "main";
inline constexpr std::string_view kCellManifestKey = "manifest";
inline constexpr std::string_view kCellSha256Key = "sha256";
inline constexpr std::string_view kCellManifest = "cell.json";
inline constexpr std::string_view kCellFolder = "cell/";

/// What readers say of a log whose rocinante.session has another format than kFormat.
std::string otherFormatText(std::string_view format);

}  // namespace rocinante::profile
