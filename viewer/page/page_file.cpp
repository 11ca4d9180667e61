#include "viewer/page/page_file.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <limits>

#include "core/base/base64.h"
#include "core/base/hash.h"
#include "viewer/page/page_text.h"

namespace rocinante {
namespace {

constexpr std::string_view kFirstLines = "<!DOCTYPE html>\n<!-- rocinante page 2 -->\n";
/// Its log is one piece, without its size.
constexpr std::string_view kFirstLinesOf1 = "<!DOCTYPE html>\n<!-- rocinante page 1 -->\n";
/// The log is the last of the page's parts, so the last of these is its own.
constexpr std::string_view kLogBegins =
    "\n<script type=\"text/plain\" id=\"rocinante-log\" data-xxh3=\"";
constexpr std::string_view kPartBegins = "<script type=\"text/plain\" id=\"rocinante-";
constexpr std::string_view kPartEnds = "</script>\n";
constexpr std::size_t kHashDigits = 32;
constexpr std::string_view kSizeBegins = "\" data-bytes=\"";
/// A browser reads a page in pieces of 64 KiB, and a text within a piece several times as fast as
/// one of many pieces.
constexpr std::size_t kPieceBytes = 48U << 10U;
constexpr std::string_view kNextPieceBegins = "<script type=\"text/plain\" data-more>";

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

/// The text of a part, to its end.
std::string inPieces(ByteView bytes) {
  std::string text;
  text.reserve(bytes.size() / 3 * 4 + bytes.size() / kPieceBytes * 64 + 64);
  while (bytes.size() > kPieceBytes) {
    text.append(base64Of(bytes.first(kPieceBytes))).append(kPartEnds).append(kNextPieceBegins);
    bytes = bytes.subspan(kPieceBytes);
  }
  return text.append(base64Of(bytes)).append(kPartEnds);
}

std::string part(std::string_view name, ByteView bytes) {
  return fmt::format("{}{}\">{}", kPartBegins, name, inPieces(compressed(bytes)));
}

/// Replaces `place`, which the page's text has once.
void fill(std::string& page, std::string_view place, std::string_view content) {
  const std::size_t at = page.find(place);
  page.replace(at, place.size(), content);
}

/// The page's style, in the theme that is asked for.
std::string styleOf(const PageParts& parts) {
  std::string style = std::string(kPageFamily).append(kPageStyle);
  if (!parts.is_light) return style;
  fill(style, "color-scheme: light dark",
       *parts.is_light ? "color-scheme: light" : "color-scheme: dark");
  fill(style, "(prefers-color-scheme: dark)", *parts.is_light ? "not all" : "all");
  return style;
}

/// The page with these scripts and parts. The viewer stands before the script, which starts it
/// while a browser still reads what comes after.
std::string filled(const PageParts& parts, const std::string& before_script,
                   const std::string& session) {
  std::string page(kFirstLines);
  page += kPageHtml;
  fill(page, "{{title}}", escaped(parts.title));
  fill(page, "{{left_out}}", escaped(parts.left_out));
  fill(page, "{{style}}", styleOf(parts));
  // From the end, so that what stands in a part is not looked at.
  fill(page, "{{session}}", session);
  fill(page, "{{script}}", kPageScript);
  fill(page, "{{plots}}", kPagePlots);
  fill(page, "{{pointers}}", kPagePointers);
  fill(page, "{{panels}}", kPagePanels);
  fill(page, "{{calls}}", kPageCalls);
  fill(page, "{{parts}}", kPageParts);
  fill(page, "{{viewer}}",
       part("viewer", parts.viewer) + part("viewer-script", bytesOf(parts.viewer_script)) +
           before_script);
  return page;
}

/// The log, which a browser decodes while it reads on.
std::string logPart(ByteView log) {
  return fmt::format("{}{}{}{}\">{}", kLogBegins, hexOf(xxh3(log)), kSizeBegins, log.size(),
                     inPieces(log));
}

/// Appends the pieces that `left` begins with; why it cannot otherwise.
std::optional<std::string_view> appendPieces(std::string_view left, Bytes& log) {
  while (true) {
    const std::size_t end = left.find('<');
    if (end == std::string_view::npos) return "the page ends within its log: it was cut";
    const auto piece = bytesOfBase64(left.substr(0, end));
    if (!piece) return "the page's log is not base64: it was changed";
    log.insert(log.end(), piece->begin(), piece->end());
    left.remove_prefix(end);
    if (!left.starts_with(kPartEnds))
      return "the page's log does not end as one does: it was changed";
    left.remove_prefix(kPartEnds.size());
    if (!left.starts_with(kNextPieceBegins)) return std::nullopt;
    left.remove_prefix(kNextPieceBegins.size());
  }
}

std::string sessionParts(const PageParts& parts) {
  return part("findings", bytesOf(parts.findings)) + part("events", bytesOf(parts.events)) +
         (parts.layout.empty() ? std::string() : part("layout", bytesOf(parts.layout))) +
         part("cell", parts.cell);
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
  session += logPart(parts.log);
  return filled(parts, "", session);
}

Result<Bytes> logOfPage(std::string_view page, const std::string& name) {
  const bool is_of_1 = page.starts_with(kFirstLinesOf1);
  if (!is_of_1 && !page.starts_with(kFirstLines)) {
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
  const std::size_t text = left.find("\">");
  std::string stated_size(left.substr(0, std::min(text, left.size())));
  if (text == std::string_view::npos || stated_size.starts_with(kSizeBegins) == is_of_1) {
    return damaged("the page's log has no checksum: it was changed");
  }
  left.remove_prefix(text + 2);
  Bytes log;
  log.reserve(left.size() / 4 * 3);
  if (const auto fault = appendPieces(left, log)) return damaged(std::string(*fault));
  if (hexOf(xxh3(log)) != hash) {
    return damaged("the page's log fails its checksum: it was changed");
  }
  if (!is_of_1 && stated_size != fmt::format("{}{}", kSizeBegins, log.size())) {
    return damaged("the page's log has another size than it says: it was changed");
  }
  return log;
}

}  // namespace rocinante
