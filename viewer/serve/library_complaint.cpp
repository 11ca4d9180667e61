#include "viewer/serve/library_complaint.h"

#include <libwebsockets.h>

#include <mutex>
#include <string_view>

#include "core/base/plain_text.h"

namespace rocinante {
namespace {

std::mutex complaint_mutex;
std::string complaint;

void noteComplaint(int, const char* line) {
  std::string_view message(line);
  while (message.ends_with('\n')) message.remove_suffix(1);
  const std::size_t from = message.find(": ");  // behind the function's name
  const std::lock_guard lock(complaint_mutex);
  complaint = plainText(from == std::string_view::npos ? message : message.substr(from + 2));
}

}  // namespace

void collectComplaints() { ::lws_set_log_level(LLL_ERR | LLL_WARN, noteComplaint); }

std::string lastComplaint() {
  const std::lock_guard lock(complaint_mutex);
  return complaint;
}

}  // namespace rocinante
