#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/model_search.h"
#include "core/base/result.h"
#include "core/bundle/cell_bundle.h"
#include "core/cell/cell.h"
#include "core/foreign/ros/bag_reader.h"
#include "core/foreign/ros/ros_translator.h"
#include "core/log/log_writer.h"
#include "core/mcap/byte_sink.h"
#include "core/recording/session_writer.h"
#include "core/report/account.h"

/// Makes a log of other programs' recordings (docs/other-formats.md):
///
///   BagReader -+
///   BagReader -+-> by time -> the message, verbatim    -> SessionWriter
///                          -> RosTranslator: its packet -> SessionWriter
///
/// Memory does not grow with the recordings.
namespace rocinante::ros {

struct ImportOptions {
  const Cell* cell = nullptr;          ///< names the devices; null: the bag does, or none
  const CellBundle* bundle = nullptr;  ///< attached when given
  /// With a cell and no bundle: attach the robot that a bag describes, so that the cell can be
  /// compared with it.
  bool describe = false;
  std::string device;               ///< for joints and frames that name none; empty: none
  std::vector<std::string> damage;  ///< known before: of a folder that lacks a file
  /// What the inputs should have; where they have another number, that is damage.
  std::vector<StatedMessages> stated;
  ModelSearch search;  ///< for the meshes of a robot description
  LogWriterOptions log;
  KeyframeOptions keyframes;
  /// Called now and then with the part that is done, 0 to 1; an error ends the import.
  std::function<Status(double)> progress;
};

/// The type of a capture's topics.
inline constexpr const char* kDatagrams = "datagrams";

struct ImportedTopic {
  std::string name;  ///< in the log
  std::string type;
  std::string encoding;
  std::uint64_t messages = 0;
  std::uint64_t packets = 0;
  std::uint64_t malformed = 0;  ///< kept, but not of the type that they claim
  std::string fault;            ///< where and why the first of them is; empty: nobody says
  bool translated = false;      ///< its type is one that becomes packets
  bool described = false;       ///< the robot description that is the log's cell
  TranslationNotes notes;
};

struct ImportReport {
  std::vector<ImportedTopic> topics;  ///< those with messages, in the order of the first
  std::uint64_t messages = 0;
  std::uint64_t packets = 0;
  std::uint64_t malformed = 0;
  std::uint64_t dropped = 0;  ///< messages that a log cannot hold: before 1970, or over 128 MiB
  std::uint64_t lost = 0;     ///< datagrams of a capture whose frames are malformed, cut or missing
  LogTime start{}, end{};
  std::uint64_t bytes = 0;          ///< of the log
  std::string robot;                ///< whose description is the log's cell; empty: none
  std::vector<std::string> damage;  ///< of the recordings
  std::vector<std::string> notes;
  Account account;  ///< what became no packet, or no message either

  bool lostNothing() const { return damage.empty() && malformed == 0 && dropped == 0 && lost == 0; }
};

/// Imports the recordings as one, in order of time; for equal times the first named comes first.
/// Closes the sink. not_found when they have no message.
Result<ImportReport> importBags(std::vector<std::unique_ptr<BagReader>> bags,
                                std::unique_ptr<ByteSink> sink, std::string session_id,
                                const ImportOptions& options);

/// What was not kept or not translated, as sentences without a full stop, for a terminal; without
/// the account.
std::vector<std::string> importWarnings(const ImportReport& report);
/// The same with the account as a metadata record of the log: `rocinante.import`.
LogMetadata warningsRecord(const ImportReport& report);

/// A session id that depends on the recordings alone: their sizes, first and last bytes.
Result<std::string> importedSessionId(const std::vector<std::filesystem::path>& inputs);

}  // namespace rocinante::ros
