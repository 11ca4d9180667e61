// Any bytes as a page, and any bytes where a page has its log's checksum and text. A log that comes
// out must go in and come out the same again.

#include <cstdlib>
#include <string>

#include "viewer/page/page_file.h"

using namespace rocinante;

namespace {

void require(bool sound) {
  if (!sound) std::abort();
}

void extract(const std::string& page) {
  const auto log = logOfPage(page, "fuzz");
  if (!log) {
    require(!log.error().what.empty());
    return;
  }
  require(log->size() <= page.size());
  PageParts parts;
  parts.log = *log;
  const auto again = logOfPage(pageOf(parts), "again");
  require(again.has_value() && *again == *log);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  extract(text);
  static const std::string kPage = pageOf({});
  const std::size_t hash = kPage.find("data-xxh3=\"") + 11;
  extract(kPage.substr(0, hash) + text);
  std::string of_1 = kPage.substr(0, hash);
  of_1[of_1.find("page 2") + 5] = '1';
  extract(of_1 + text);
  extract(kPage.substr(0, hash) + text + kPage.substr(hash + 32));
  return 0;
}
