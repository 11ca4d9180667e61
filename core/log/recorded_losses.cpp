#include "core/log/recorded_losses.h"

#include <algorithm>

#include "core/log/log_profile.h"
#include "core/log/loss_message.h"

namespace rocinante {
namespace {

void readLosses(SpanCache& cache, ChannelId id, std::vector<LossSpan>& losses) {
  for (std::uint32_t i = 0; i < cache.spans().size(); ++i) {
    const MessageSpan& span = cache.spans()[i];
    if (!span.mayHold(id)) continue;
    const std::shared_ptr<const SpanMessages> messages = cache.get(i);
    for (const SpanMessages::Place& place : messages->places) {
      if (place.channel != id) continue;
      const LogMessage message = messageAt(*messages, place, i, cache.channels());
      if (std::optional<LossSpan> loss = parseLoss(message.payload)) {
        losses.push_back(std::move(*loss));
      } else {
        cache.addDamage(
            {span.offset, span.end, "a message on /rocinante/loss is malformed", std::uint64_t{0}});
      }
    }
  }
}

}  // namespace

std::vector<LossSpan> recordedLosses(SpanCache& cache,
                                     const std::map<ChannelId, std::uint64_t>& message_counts) {
  std::vector<LossSpan> losses;
  for (const LogChannel* const channel : cache.channels()) {
    if (channel == nullptr || channel->topic != profile::kLossTopic) continue;
    const auto count = message_counts.find(channel->id);
    if (count != message_counts.end() && count->second > 0) readLosses(cache, channel->id, losses);
  }
  std::ranges::stable_sort(losses, {}, &LossSpan::from);
  return losses;
}

}  // namespace rocinante
