#include "core/foreign/ros/ros_translator.h"

#include "core/foreign/ros/signal_names.h"
#include "core/foreign/ros/topic_translation.h"
#include "core/packet/channel_names.h"

namespace rocinante::ros {

struct RosTranslator::State {
  explicit State(const DeviceFinder& finder) : devices(finder), frames(finder) {}

  struct Topic {
    std::unique_ptr<TopicTranslation> translation;
    FieldCursor::Layout layout;
  };

  const DeviceFinder& devices;
  FrameTree frames;
  SignalNames names;
  std::vector<Topic> topics;
};

RosTranslator::RosTranslator(const DeviceFinder& devices)
    : state_(std::make_unique<State>(devices)) {}
RosTranslator::~RosTranslator() = default;

std::optional<std::size_t> RosTranslator::addTopic(std::string_view topic, std::string_view type,
                                                   FieldCursor::Layout layout,
                                                   const ChannelMetadata& metadata) {
  State& state = *state_;
  auto made = makeTranslation(type, topic, state.devices, state.frames, state.names);
  if (!made) return std::nullopt;
  if (const auto stated = channelNamesIn(metadata)) {
    made->use(*stated);
  } else if (hasChannelNames(metadata)) {
    made->note("a channel whose metadata names what no packet can say");
  }
  state.topics.push_back({std::move(made), layout});
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

TranslationNotes RosTranslator::notes(std::size_t topic) const {
  return state_->topics[topic].translation->notes();
}

}  // namespace rocinante::ros
