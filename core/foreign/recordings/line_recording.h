#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/foreign/recordings/recording_bytes.h"
#include "core/foreign/recordings/row_translation.h"
#include "core/foreign/ros/bag_reader.h"

namespace rocinante {

/// A fault of a row.
inline constexpr const char* kPartOfPoseAlone = "it has a part of a pose alone";

/// A text of lines with a time each, as a recording with one topic: what tables and JSON lines have
/// in common (docs/other-formats.md, "Tables and JSON lines").
class LineRecording : public ros::BagReader {
 public:
  std::string_view kind() const final { return decoder_; }
  const std::vector<ros::BagTopic>& topics() const final { return topics_; }
  Result<std::optional<Bytes>> lastOf(std::size_t) final { return std::optional<Bytes>(); }
  double part() const final { return lines_.part(); }
  void useDevices(const ros::DeviceFinder& devices) final { rows_.useDevices(devices); }
  Account account() const override;
  /// Times are shown as the text has them, unless they are dates.
  std::optional<LogTime> origin() const final;
  std::vector<std::string> damage() const final;
  Result<std::optional<ros::BagMessage>> next() final;

 protected:
  /// What a line says.
  struct Row {
    Nanoseconds time{};
    std::string_view packet;  ///< borrowed until the next line; empty: nothing to say
    std::string fault = {};   ///< why it has not the form of the others; empty: it has
  };

  /// `unit` is what a line is called: "row".
  LineRecording(RecordingBytes bytes, std::string name, const char* topic, const char* decoder,
                const char* unit);

  /// Of a line that is no remark. Empty when it has no time.
  virtual std::optional<Row> rowOf(std::string_view line) = 0;

  /// Of a line: whether it is neither a row nor something that is missing.
  virtual bool isRemark(std::string_view line) const;

  std::string head() const { return lines_.head(); }
  bool isHeadWhole() const { return lines_.isHeadWhole(); }
  void skipLines(std::size_t count);
  const std::string& name() const { return name_; }
  ros::BagTopic& topic() { return topics_.front(); }
  RowTranslation& rows() { return rows_; }

 private:
  RecordingLines lines_;
  std::string name_;
  const char* decoder_;
  const char* unit_;
  std::vector<ros::BagTopic> topics_;
  RowTranslation rows_;
  std::optional<LogTime> first_;
  std::string fault_;  ///< of the last line
  std::uint32_t sequence_ = 0;
  std::uint64_t timeless_ = 0, too_long_ = 0;
  std::size_t first_timeless_ = 0, first_too_long_ = 0;
};

}  // namespace rocinante
