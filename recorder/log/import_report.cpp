#include "recorder/log/import_report.h"

#include <fmt/format.h>

#include "core/base/duration_text.h"
#include "core/base/plain_text.h"
#include "core/cli/text_table.h"
#include "core/report/json_text.h"

namespace rocinante {
namespace {

std::string becameText(const ros::ImportedTopic& topic) {
  if (!topic.translated) return "kept as they are";
  return cli::counted(topic.packets, "packet");
}

}  // namespace

std::string importReportText(const std::string& output, const ros::ImportReport& report) {
  std::string text = fmt::format(
      "{}: {} of {}, {} s; {} became packets\n", plainText(output),
      cli::counted(report.messages, "message"), cli::counted(report.topics.size(), "topic"),
      secondsText(report.end - report.start, 3), cli::grouped(report.packets));
  cli::TextTable table;
  table.is_number = {false, false, true, false};
  for (const ros::ImportedTopic& topic : report.topics) {
    table.rows.push_back({plainText(topic.name), plainText(topic.type.empty() ? "-" : topic.type),
                          cli::counted(topic.messages, "message"), becameText(topic)});
  }
  text += table.text();
  if (!report.robot.empty()) {
    text += fmt::format("  the robot description is the log's cell: device {}\n",
                        plainText(report.robot));
  }
  return text;
}

std::string importReportJson(const std::string& output, const ros::ImportReport& report) {
  Json topics = Json::array();
  for (const ros::ImportedTopic& topic : report.topics) {
    Json notes = Json::object();
    for (const auto& [sentence, count] : topic.notes) notes[sentence] = count;
    topics.push_back({{"topic", topic.name},
                      {"type", topic.type},
                      {"messages", topic.messages},
                      {"translated", topic.translated},
                      {"packets", topic.packets},
                      {"malformed", topic.malformed},
                      {"fault", topic.fault.empty() ? Json(nullptr) : Json(topic.fault)},
                      {"notes", std::move(notes)}});
  }
  const Json out{{"format", 1},
                 {"output", output},
                 {"messages", report.messages},
                 {"packets", report.packets},
                 {"malformed", report.malformed},
                 {"dropped", report.dropped},
                 {"lost", report.lost},
                 {"start_ns", nanosecondsOf(report.start)},
                 {"end_ns", nanosecondsOf(report.end)},
                 {"bytes", report.bytes},
                 {"robot", report.robot.empty() ? Json(nullptr) : Json(report.robot)},
                 {"topics", std::move(topics)},
                 {"damage", report.damage},
                 {"notes", report.notes},
                 {"left_out", leftOutJson(report.account)}};
  return jsonText(out);
}

}  // namespace rocinante
