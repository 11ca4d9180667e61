#include "core/foreign/ros/ros_translator.h"

#include "core/foreign/ros/topic_translation.h"

namespace rocinante::ros {

struct RosTranslator::State {
  explicit State(const DeviceFinder& finder) : devices(finder), frames(finder) {}

  struct Topic {
    std::unique_ptr<TopicTranslation> translation;
    FieldCursor::Layout layout;
  };

  const DeviceFinder& devices;
  FrameTree frames;
  std::vector<Topic> topics;
};

RosTranslator::RosTranslator(const DeviceFinder& devices)
    : state_(std::make_unique<State>(devices)) {}
RosTranslator::~RosTranslator() = default;

std::size_t RosTranslator::addTopic(std::string_view topic, MessageType type,
                                    FieldCursor::Layout layout) {
  State& state = *state_;
  state.topics.push_back({makeTranslation(type, topic, state.devices, state.frames), layout});
  return state.topics.size() - 1;
}

RosTranslator::Outcome RosTranslator::translate(std::size_t topic, LogTime time, ByteView message,
                                                Translated& out) {
  const State::Topic& mine = state_->topics[topic];
  return mine.translation->translate(message, mine.layout, time, out);
}

Account RosTranslator::account() const {
  Account account;
  for (const State::Topic& topic : state_->topics) topic.translation->addLeftOut(account);
  account.add(state_->frames.account());
  return account;
}

const TranslationNotes& RosTranslator::notes(std::size_t topic) const {
  return state_->topics[topic].translation->notes();
}

}  // namespace rocinante::ros
