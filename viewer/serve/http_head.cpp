#include "viewer/serve/http_head.h"

#include <libwebsockets.h>

#include <algorithm>
#include <array>
#include <optional>

namespace rocinante {
namespace {

/// Longer ones are no header of ours.
constexpr int kMostHeaderBytes = 2048;

/// Empty when it is absent; nothing when it is longer than ours, or cannot be read.
std::optional<std::string> wholeHeaderOf(lws* wsi, lws_token_indexes which) {
  const int length = ::lws_hdr_total_length(wsi, which);
  if (length <= 0) return std::string();
  if (length > kMostHeaderBytes) return std::nullopt;
  std::string text(static_cast<std::size_t>(length) + 1, '\0');
  const int copied = ::lws_hdr_copy(wsi, text.data(), length + 1, which);
  if (copied < 0) return std::nullopt;
  text.resize(static_cast<std::size_t>(copied));
  return text;
}

/// One without which an answer is the same, or less is allowed.
std::string headerOf(lws* wsi, lws_token_indexes which) {
  return wholeHeaderOf(wsi, which).value_or(std::string());
}

std::string tokenOf(lws* wsi) {
  std::array<char, 512> text{};
  const char* const asked =
      ::lws_get_urlarg_by_name(wsi, "token=", text.data(), static_cast<int>(text.size()));
  if (asked != nullptr) return asked;
  constexpr std::string_view kBearer = "Bearer ";
  const std::string header = headerOf(wsi, WSI_TOKEN_HTTP_AUTHORIZATION);
  return header.starts_with(kBearer) ? header.substr(kBearer.size()) : std::string();
}

}  // namespace

bool HttpHead::isGet() const { return ::lws_hdr_total_length(wsi_, WSI_TOKEN_GET_URI) > 0; }

bool HttpHead::isHead() const { return ::lws_hdr_total_length(wsi_, WSI_TOKEN_HEAD_URI) > 0; }

std::string HttpHead::range() const { return headerOf(wsi_, WSI_TOKEN_HTTP_RANGE); }

bool HttpHead::offers(std::string_view protocol) const {
  const std::string list = headerOf(wsi_, WSI_TOKEN_PROTOCOL);
  std::string_view left = list;
  while (!left.empty()) {
    const std::size_t comma = std::min(left.find(','), left.size());
    std::string_view name = left.substr(0, comma);
    while (name.starts_with(' ')) name.remove_prefix(1);
    while (name.ends_with(' ')) name.remove_suffix(1);
    if (name == protocol) return true;
    left.remove_prefix(std::min(comma + 1, left.size()));
  }
  return false;
}

AccessRequest HttpHead::accessRequest() const {
  AccessRequest request;
  const auto host = wholeHeaderOf(wsi_, WSI_TOKEN_HOST);
  const auto origin = wholeHeaderOf(wsi_, WSI_TOKEN_ORIGIN);
  request.is_too_long = !host || !origin;
  request.host = host.value_or(std::string());
  request.origin = origin.value_or(std::string());
  request.token = tokenOf(wsi_);
  return request;
}

bool writeHttpHead(lws* wsi, unsigned status, const std::string& type, std::uint64_t size,
                   const HttpHeaders& headers) {
  std::array<unsigned char, LWS_PRE + 2048> head;
  unsigned char* const start = head.data() + LWS_PRE;
  unsigned char* at = start;
  unsigned char* const end = head.data() + head.size() - 1;
  if (::lws_add_http_common_headers(wsi, status, type.c_str(), size, &at, end) != 0) return false;
  HttpHeaders all = {{"cache-control:", "no-store"},
                     {"x-content-type-options:", "nosniff"},
                     {"referrer-policy:", "no-referrer"},
                     {"x-frame-options:", "DENY"},
                     {"cross-origin-resource-policy:", "same-origin"}};
  all.insert(all.end(), headers.begin(), headers.end());
  for (const auto& [name, value] : all) {
    if (::lws_add_http_header_by_name(wsi, reinterpret_cast<const unsigned char*>(name.c_str()),
                                      reinterpret_cast<const unsigned char*>(value.data()),
                                      static_cast<int>(value.size()), &at, end) != 0) {
      return false;
    }
  }
  return ::lws_finalize_write_http_header(wsi, start, &at, end) == 0;
}

}  // namespace rocinante
