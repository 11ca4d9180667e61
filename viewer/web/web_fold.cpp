#include "viewer/web/web_fold.h"

#include "core/base/hash.h"
#include "core/log/log_reader.h"
#include "core/packet/restatement.h"
#include "core/session/message_folder.h"

namespace rocinante {

Result<WholeFold> foldWhole(ByteView log) {
  auto reader = LogReader::openBytes(log, "the log");
  if (!reader) return reader.error();
  WholeFold whole;
  SessionState state;
  MessageFolder folder;
  while (true) {
    const auto message = reader->next();
    if (!message) return message.error();
    if (!*message) break;
    ++whole.messages;
    if (folder.fold(state, **message).applied) ++whole.applied;
  }
  RestatementOptions options;
  options.by = "fold";
  options.part_id = "whole";
  std::string text;
  for (const std::string& datagram : restateAll(state, options)) text += datagram;
  whole.state = hexOf(xxh3(bytesOf(text)));
  return whole;
}

}  // namespace rocinante
