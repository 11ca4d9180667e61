// mcap_conformance_streamed FILE.mcap: every record in the file's order, chunks expanded, as JSON.

#include <cstdio>

#include "tests/core/mcap/conformance/record_json.h"
#include "tests/support/stream_reader.h"

int main(int argc, char** argv) {
  using namespace rocinante;
  if (argc != 2) return 2;
  const std::string file = test::readWhole(argv[1]);
  Result<test::StreamReader> reader = test::StreamReader::open(bytesOf(file));
  test::Json records = test::Json::array();
  while (reader.ok()) {
    const Result<std::optional<mcap::Record>> record = reader->next();
    if (!record) {
      std::fprintf(stderr, "%s\n", record.error().text().c_str());
      return 1;
    }
    if (!*record) {
      std::printf("%s\n", test::Json{{"records", records}}.dump().c_str());
      return 0;
    }
    if (std::optional<test::Json> json = test::recordJson(**record)) records.push_back(*json);
  }
  std::fprintf(stderr, "%s\n", reader.error().text().c_str());
  return 1;
}
