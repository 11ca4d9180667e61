#pragma once

#include <gmock/gmock.h>

#include <cstring>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "core/foreign/ros/ros_translator.h"
#include "core/packet/packet_text.h"
#include "tests/core/foreign/ros/message_maker.h"

namespace rocinante::ros::test {

inline constexpr Kind kKinds[] = {Kind::cdr_little, Kind::cdr_big, Kind::cdr2_little, Kind::ros1};

inline constexpr const char* kArm =
    "<robot name=\"arm\"><link name=\"base\"/><link name=\"upper\"/><link name=\"tool\"/>"
    "<joint name=\"a\" type=\"continuous\"><parent link=\"base\"/><child link=\"upper\"/></joint>"
    "<joint name=\"b\" type=\"continuous\"><parent link=\"upper\"/><child link=\"tool\"/>"
    "<mimic joint=\"a\"/></joint></robot>";

/// What one message became; "" when nothing, "malformed" when it is.
class Translation {
 public:
  explicit Translation(const Cell* cell = nullptr, std::string device = "")
      : devices_(cell, std::move(device)), translator_(devices_) {}

  std::string of(std::string_view topic, std::string_view type, const Bytes& message,
                 FieldCursor::Layout layout = FieldCursor::Layout::cdr, std::int64_t time_s = 0) {
    const auto key = std::pair(std::string(topic), layout);
    if (!topics_.contains(key)) topics_[key] = *translator_.addTopic(topic, type, layout);
    Translated made;
    const LogTime time{std::chrono::seconds(time_s)};
    switch (translator_.translate(topics_[key], time, message, made)) {
      case RosTranslator::Outcome::malformed:
        return "malformed";
      case RosTranslator::Outcome::nothing:
        return "";
      case RosTranslator::Outcome::packet:
        break;
    }
    if (made.packet != nullptr) expectSame(made);
    PacketTextDecoder decoder;
    const Packet* const packet = decoder.decode(bytesOf(made.text));
    EXPECT_TRUE(packet != nullptr && packet->faults.empty()) << made.text;
    return std::string(made.text);
  }

  TranslationNotes notes(std::string_view topic, FieldCursor::Layout layout) {
    return translator_.notes(topics_[std::pair(std::string(topic), layout)]);
  }

  std::vector<std::string> accountTexts() const {
    std::vector<std::string> texts;
    const Account account = translator_.account();
    for (const LeftOut& one : account.leftOut()) texts.push_back(one.text());
    return texts;
  }

 private:
  /// A packet that was made beside the text is what decoding the text gives.
  static void expectSame(const Translated& made) {
    PacketTextWriter again(made.packet->header);
    for (const Statement& statement : made.packet->statements) again.add(statement);
    EXPECT_EQ(again.text(), made.text);
    PacketTextDecoder decoder;
    const Packet* const decoded = decoder.decode(bytesOf(made.text));
    ASSERT_NE(decoded, nullptr);
    ASSERT_EQ(decoded->statements.size(), made.packet->statements.size());
    for (std::size_t i = 0; i < decoded->statements.size(); ++i) {
      const Statement& a = decoded->statements[i];
      const Statement& b = made.packet->statements[i];
      EXPECT_EQ(a.line, b.line);
      EXPECT_TRUE(std::ranges::equal(a.names, b.names));
      EXPECT_EQ(0, std::memcmp(a.numbers.data(), b.numbers.data(), a.numbers.size_bytes()));
    }
  }

  DeviceFinder devices_;
  RosTranslator translator_;
  std::map<std::pair<std::string, FieldCursor::Layout>, std::size_t> topics_;
};

inline FieldCursor::Layout layoutOf(Kind kind) { return MessageMaker(kind).layout(); }

}  // namespace rocinante::ros::test
