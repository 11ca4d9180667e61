// mcap_conformance_indexed FILE.mcap: what the summary says, and the messages in time order, as
// JSON.

#include <algorithm>
#include <cstdio>

#include "core/log/log_reader.h"
#include "core/mcap/parse_record.h"
#include "tests/core/mcap/conformance/record_json.h"

int main(int argc, char** argv) {
  using namespace rocinante;
  using mcap::Opcode;
  if (argc != 2) return 2;
  const std::string file = test::readWhole(argv[1]);
  const ByteView bytes = bytesOf(file);
  mcap::Footer footer;
  if (bytes.size() < mcap::kFileEndBytes) return 1;
  const auto end = mcap::recordAt(bytes, bytes.size() - mcap::kFileEndBytes);
  if (!end || end->opcode != Opcode::footer || !mcap::parse(end->content, footer)) return 1;

  test::Json out = {{"schemas", test::Json::array()},
                    {"channels", test::Json::array()},
                    {"messages", test::Json::array()},
                    {"statistics", test::Json::array()}};
  for (std::uint64_t position = footer.summary_start; position < end->offset;) {
    const std::optional<mcap::Record> record = mcap::recordAt(bytes, position);
    if (!record) return 1;
    if (record->opcode == Opcode::schema) out["schemas"].push_back(*test::recordJson(*record));
    if (record->opcode == Opcode::channel) out["channels"].push_back(*test::recordJson(*record));
    if (record->opcode == Opcode::statistics) {
      out["statistics"].push_back(*test::recordJson(*record));
    }
    position = record->end();
  }

  Result<LogReader> reader = LogReader::openBytes(bytes, argv[1]);
  if (!reader) return 1;
  while (true) {
    const Result<std::optional<LogMessage>> message = reader->next();
    if (!message) return 1;
    if (!*message) break;
    mcap::Message record;
    record.channel_id = (*message)->channel->id;
    record.sequence = (*message)->sequence;
    record.log_time = static_cast<std::uint64_t>((*message)->log_time.time_since_epoch().count());
    record.publish_time = static_cast<std::uint64_t>((*message)->publish_time_ns);
    record.data = (*message)->payload;
    out["messages"].push_back(test::messageJson(record));
  }
  if (!reader->damage().empty()) {
    std::fprintf(stderr, "%s\n", reader->damage()[0].cause.c_str());
    return 1;
  }
  std::printf("%s\n", out.dump().c_str());
  return 0;
}
