#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/base/hash.h"
#include "core/base/plain_text.h"
#include "core/copy/log_edits.h"
#include "core/log/log_profile.h"

namespace rocinante {
namespace {

/// The common session id, or one derived from all ids and their order.
std::string mergedSessionId(const std::vector<std::string>& ids) {
  if (std::ranges::all_of(ids, [&](const std::string& id) { return id == ids.front(); })) {
    return ids.front();
  }
  Sha256 hash;
  hash.add(bytesOf("rocinante merge"));
  for (const std::string& id : ids) {
    hash.addU64(id.size());
    hash.add(bytesOf(id));
  }
  return hexOf(hash.finish()).substr(0, 32);
}

/// Orders the pieces of each session by their start: a shared message comes from the earlier piece,
/// which also holds its neighbours.
void sortPieces(std::vector<OpenedLog>& logs) {
  std::map<std::string, std::vector<std::size_t>> places;
  for (std::size_t i = 0; i < logs.size(); ++i) {
    places[logs[i].reader.summary().session_id].push_back(i);
  }
  for (const auto& [id, of_one] : places) {
    if (id.empty() || of_one.size() == 1) continue;
    std::vector<OpenedLog> pieces;
    for (const std::size_t place : of_one) pieces.push_back(std::move(logs[place]));
    std::ranges::stable_sort(pieces, {},
                             [](const OpenedLog& piece) { return piece.reader.summary().start; });
    for (std::size_t i = 0; i < pieces.size(); ++i) logs[of_one[i]] = std::move(pieces[i]);
  }
}

/// Refuses logs in which two decoders made the packets of one topic: one moment would have two
/// meanings.
Status checkDecoders(const std::vector<OpenedLog>& logs) {
  struct First {
    std::string decoder, log;
  };
  std::map<std::string, First> by_topic;
  for (const OpenedLog& opened : logs) {
    for (const LogChannel& channel : opened.reader.channels()) {
      if (!channel.decoded()) continue;
      const auto found = channel.metadata.find(std::string(profile::kDecoderKey));
      const std::string decoder = found == channel.metadata.end() ? "" : found->second;
      const auto [first, is_new] =
          by_topic.try_emplace(channel.topic, First{decoder, opened.reader.name()});
      if (is_new || first->second.decoder == decoder) continue;
      return Error{
          ErrorKind::refused,
          fmt::format("{} has packets of another decoder in {}; use `rocinante log decode` on one "
                      "of them first",
                      plainText(profile::capturedTopic(channel.topic)),
                      plainText(first->second.log)),
          opened.reader.name()};
    }
  }
  return {};
}

}  // namespace

Result<CopyReport> mergeLogs(const std::vector<std::filesystem::path>& logs,
                             const MakeOptions& make) {
  if (Status free = checkOutput(make.output, make.overwrite, logs); !free) return free.error();
  std::vector<OpenedLog> opened_logs;
  for (const std::filesystem::path& log : logs) {
    Result<OpenedLog> opened = openForCopy(log);
    if (!opened) return opened.error();
    opened_logs.push_back(std::move(*opened));
  }
  if (Status same = checkDecoders(opened_logs); !same) return same.error();
  sortPieces(opened_logs);
  std::vector<CopySource> sources;
  std::vector<std::string> ids;
  std::optional<LogTime> origin;
  for (OpenedLog& opened : opened_logs) {
    const Result<std::string> id = sessionIdOf(opened.reader);
    if (!id) return id.error();
    Result<CopySource> source =
        CopySource::of(std::move(opened.reader), std::move(opened.options), std::nullopt, {});
    if (!source) return source.error();
    // A log without captured messages does not count as part of a session.
    if (source->reader().summary().messages > 0) ids.push_back(*id);
    if (const std::optional<LogTime> its = source->origin()) {
      origin = origin ? std::min(*origin, *its) : *its;
    }
    sources.push_back(std::move(*source));
  }
  if (ids.empty()) ids.push_back(sources.front().reader().summary().session_id);
  return makeLog(sources, make, {make.log, make.keyframes, mergedSessionId(ids), origin},
                 "rocinante log merge", true);
}

}  // namespace rocinante
