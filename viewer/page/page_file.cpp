#include "viewer/page/page_file.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <limits>

#include "core/base/hash.h"
#include "viewer/page/base64.h"
#include "viewer/page/page_text.h"

namespace rocinante {
namespace {

constexpr std::string_view kFirstLines = "<!DOCTYPE html>\n<!-- rocinante page 1 -->\n";
/// The log is the last of the page's parts, so the last of these is its own.
constexpr std::string_view kLogBegins =
    "\n<script type=\"text/plain\" id=\"rocinante-log\" data-xxh3=\"";
constexpr std::string_view kPartBegins = "<script type=\"text/plain\" id=\"rocinante-";
constexpr std::string_view kPartEnds = "</script>\n";
constexpr std::size_t kHashDigits = 32;

/// A gzip member without a time or a name, so that the same bytes give the same bytes.
Bytes compressed(ByteView bytes) {
  z_stream stream{};
  constexpr int kGzip = 15 + 16;
  ::deflateInit2(&stream, 9, Z_DEFLATED, kGzip, 9, Z_DEFAULT_STRATEGY);
  Bytes out(::deflateBound(&stream, static_cast<uLong>(bytes.size())) + 32);
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  std::size_t left_out = out.size();
  ByteView left = bytes;
  int code = Z_OK;
  while (code == Z_OK) {
    constexpr std::size_t kMost = std::numeric_limits<uInt>::max();
    const std::size_t in = std::min(left.size(), kMost);
    const std::size_t room = std::min(left_out, kMost);
    stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(left.data()));
    stream.avail_in = static_cast<uInt>(in);
    stream.avail_out = static_cast<uInt>(room);
    code = ::deflate(&stream, in == left.size() ? Z_FINISH : Z_NO_FLUSH);
    left = left.subspan(in - stream.avail_in);
    left_out -= room - stream.avail_out;
  }
  ::deflateEnd(&stream);
  out.resize(out.size() - left_out);
  return out;
}

std::string escaped(std::string_view text) {
  std::string safe;
  for (const char each : text) {
    switch (each) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      case '"':
        safe += "&quot;";
        break;
      case '{':  // begins a place to fill
        safe += "&#123;";
        break;
      default:
        safe += each;
    }
  }
  return safe;
}

std::string part(std::string_view name, ByteView bytes) {
  return fmt::format("{}{}\">{}{}", kPartBegins, name, base64Of(compressed(bytes)), kPartEnds);
}

/// Replaces `place`, which the page's text has once.
void fill(std::string& page, std::string_view place, std::string_view content) {
  const std::size_t at = page.find(place);
  page.replace(at, place.size(), content);
}

/// The page with these scripts and parts. The viewer stands before the script, which starts it
/// while a browser still reads what comes after.
std::string filled(const PageParts& parts, const std::string& before_script,
                   const std::string& session) {
  std::string page(kFirstLines);
  page += kPageHtml;
  fill(page, "{{title}}", escaped(parts.title));
  fill(page, "{{left_out}}", escaped(parts.left_out));
  fill(page, "{{style}}", kPageStyle);
  // From the end, so that what stands in a part is not looked at.
  fill(page, "{{session}}", session);
  fill(page, "{{script}}", kPageScript);
  fill(page, "{{plots}}", kPagePlots);
  fill(page, "{{pointers}}", kPagePointers);
  fill(page, "{{panels}}", kPagePanels);
  fill(page, "{{viewer}}",
       part("viewer", parts.viewer) + part("viewer-script", bytesOf(parts.viewer_script)) +
           before_script);
  return page;
}

std::string sessionParts(const PageParts& parts) {
  return part("findings", bytesOf(parts.findings)) + part("cell", parts.cell);
}

}  // namespace

std::string servedPageOf(const PageParts& parts, bool is_live) {
  const std::string served =
      fmt::format("{}served\" data-kind=\"{}\">{}<script>\n{}</script>\n", kPartBegins,
                  is_live ? "live" : "log", kPartEnds, kServedScript);
  std::string page = filled(parts, served, sessionParts(parts));
  // Its own server alone: neither the state nor the token goes anywhere else.
  constexpr std::string_view kPolicy = "img-src data:";
  page.insert(page.find(kPolicy) + kPolicy.size(), "; connect-src 'self'");
  return page;
}

std::string pageOf(const PageParts& parts) {
  std::string session = sessionParts(parts);
  session.pop_back();  // the line end before the log's own
  session += fmt::format("{}{}\">{}{}", kLogBegins, hexOf(xxh3(parts.log)), base64Of(parts.log),
                         kPartEnds);
  return filled(parts, "", session);
}

Result<Bytes> logOfPage(std::string_view page, const std::string& name) {
  if (!page.starts_with(kFirstLines)) {
    return Error{ErrorKind::unsupported, "is not a page of rocinante, or one of another version",
                 name};
  }
  const auto damaged = [&](std::string what) {
    return Error{ErrorKind::damaged, std::move(what), name};
  };
  const std::size_t at = page.rfind(kLogBegins);
  if (at == std::string_view::npos) return damaged("the page has no log: it was cut or changed");
  std::string_view left = page.substr(at + kLogBegins.size());
  const std::string_view hash = left.substr(0, kHashDigits);
  left.remove_prefix(hash.size());
  if (!left.starts_with("\">")) return damaged("the page's log has no checksum: it was changed");
  left.remove_prefix(2);
  const std::size_t end = left.find('<');
  if (end == std::string_view::npos) return damaged("the page ends within its log: it was cut");
  auto log = bytesOfBase64(left.substr(0, end));
  if (!log || hexOf(xxh3(*log)) != hash) {
    return damaged("the page's log fails its checksum: it was changed");
  }
  return std::move(*log);
}

}  // namespace rocinante
