#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/time.h"
#include "core/foreign/ros/frame_tree.h"
#include "core/foreign/ros/ros_message.h"
#include "core/foreign/ros/ros_translator.h"
#include "core/packet/channel_names.h"
#include "core/packet/packet_text.h"

namespace rocinante::ros {

/// What one topic's messages are turned into; one class for each kind of message.
class TopicTranslation {
 public:
  TopicTranslation(std::string_view topic, const DeviceFinder& devices, FrameTree& frames);
  virtual ~TopicTranslation() = default;
  TopicTranslation(const TopicTranslation&) = delete;
  TopicTranslation& operator=(const TopicTranslation&) = delete;

  virtual RosTranslator::Outcome translate(ByteView message, FieldCursor::Layout layout,
                                           LogTime time, Translated& out) = 0;
  /// Each sentence with its first case in brackets, where that was told.
  TranslationNotes notes() const;
  /// Before the first message: whose its values are, whatever the topic is called.
  virtual void use(const ChannelNames&) {}
  void note(std::string_view sentence, std::string_view first = {});
  /// Adds the fields of messages that no packet says.
  virtual void addLeftOut(Account&) const {}

 protected:
  /// Begins a packet with its header line; TIME is `-` when the stamp is 0 or before 1970.
  void begin(std::int64_t stamp_ns);
  void add(const Statement& statement) { packet_text_.add(statement); }
  void addPose(std::string_view device, const FrameTree::Place& place);
  /// Whether a packet can say a pose of a message. Notes what is wrong with it; `what` are such
  /// poses together: "poses".
  bool isUsable(const Pose& pose, std::string_view what);
  /// Why FrameTree::place() refused a usable pose.
  void noteRefused(std::string_view parent, std::string_view child, std::string_view what);
  /// Ends the packet: nothing when it has no statement.
  RosTranslator::Outcome end(Translated& out);
  /// Values of this topic: nothing when there are none.
  void addValues(Account& account, const char* name, const char* reason, std::uint64_t count) const;

  std::string topic_;
  const DeviceFinder& devices_;
  FrameTree& frames_;
  std::string source_;
  PacketTextWriter packet_text_;

 private:
  TranslationNotes notes_;
  std::map<std::string, std::string, std::less<>> firsts_;  ///< by sentence
};

class SignalNames;

/// Null for a type that is not translated. `names`: of the topics of all translations.
std::unique_ptr<TopicTranslation> makeTranslation(std::string_view type, std::string_view topic,
                                                  const DeviceFinder& devices, FrameTree& frames,
                                                  SignalNames& names);
std::unique_ptr<TopicTranslation> makeJointTranslation(std::string_view topic,
                                                       const DeviceFinder& devices,
                                                       FrameTree& frames);
/// `in_array`: the messages are MarkerArrays.
std::unique_ptr<TopicTranslation> makeMarkerTranslation(std::string_view topic,
                                                        const DeviceFinder& devices,
                                                        FrameTree& frames, bool in_array);

}  // namespace rocinante::ros
