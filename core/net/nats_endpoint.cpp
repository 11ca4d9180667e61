#include "core/net/nats_endpoint.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "core/base/duration_text.h"
#include "core/net/endpoint_text.h"

namespace rocinante {
namespace {

constexpr std::size_t kMaxNameBytes = 128;
constexpr std::string_view kOptions = "tls=, ca=, cert=, key=, creds= and nkey=";

bool isAlphanumeric(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// A word of a subject as endpoints have them: NATS allows more, but no other program's
/// configuration needs it, and `?`, `&`, `@` and `/` have a meaning here.
bool isWord(std::string_view word) {
  return !word.empty() && std::all_of(word.begin(), word.end(), [](char c) {
    return isAlphanumeric(c) || std::string_view("-_$%:=+").find(c) != std::string_view::npos;
  });
}

/// Takes the text before the next dot.
std::string_view takeWord(std::string_view& subject) {
  const std::size_t dot = std::min(subject.find('.'), subject.size());
  const std::string_view word = subject.substr(0, dot);
  subject.remove_prefix(std::min(dot + 1, subject.size()));
  return word;
}

bool isSubject(std::string_view subject) {
  if (subject.empty() || subject.size() > kMaxSubjectBytes || subject.back() == '.') return false;
  while (!subject.empty()) {
    const std::string_view word = takeWord(subject);
    if (word == ">") return subject.empty();
    if (word != "*" && !isWord(word)) return false;
  }
  return true;
}

/// Of a stream or a durable.
bool isName(std::string_view name) {
  return !name.empty() && name.size() <= kMaxNameBytes &&
         std::all_of(name.begin(), name.end(),
                     [](char c) { return isAlphanumeric(c) || c == '-' || c == '_'; });
}

template <class Number>
std::optional<Number> wholeNumber(std::string_view text) {
  if (text.empty() || (text.size() > 1 && text[0] == '0')) return std::nullopt;
  Number number{};
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (fault != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// Reads the parts of one endpoint; `text` is the whole, for messages.
class Reader {
 public:
  Reader(std::string_view text, bool jetstream) : text_(text), jetstream_(jetstream) {}

  Result<NatsEndpoint> read(std::string_view rest) {
    const std::size_t question = std::min(rest.find('?'), rest.size());
    std::string_view place = rest.substr(0, question);
    const std::size_t slash = place.find('/');
    if (slash == place.npos) {
      return bad(jetstream_ ? "jetstream:// needs a stream, as in jetstream://HOST/STREAM"
                            : "nats:// needs a subject, as in nats://HOST/cell1");
    }
    std::string_view server = place.substr(0, slash);
    place.remove_prefix(slash + 1);
    if (const std::size_t at = server.rfind('@'); at != server.npos) {
      if (Status read = readUser(server.substr(0, at)); !read) return read.error();
      server.remove_prefix(at + 1);
    }
    if (Status read = readServer(server); !read) return read.error();
    if (jetstream_ ? !isName(place) : !isSubject(place)) {
      return bad(jetstream_ ? "a stream's name has letters, digits, - and _, at most 128"
                            : "a subject is words of letters, digits and -_$%:=+ with dots "
                              "between them; to listen also * and a last >");
    }
    (jetstream_ ? made_.stream : made_.subject) = place;
    while (rest.find_first_of("?&") != rest.npos) {
      rest.remove_prefix(rest.find_first_of("?&") + 1);
      const std::string_view option = rest.substr(0, rest.find('&'));
      if (Status read = readOption(option); !read) return read.error();
    }
    if (Status whole = check(); !whole) return whole.error();
    return std::move(made_);
  }

 private:
  Error bad(std::string_view reason) const { return badEndpoint(text_, reason); }

  Status readUser(std::string_view user) {
    const std::size_t colon = std::min(user.find(':'), user.size());
    const auto name = decodePercent(user.substr(0, colon));
    const auto password = decodePercent(user.substr(std::min(colon + 1, user.size())));
    const bool lacks = colon < user.size() && password && password->empty();
    if (!name || !password || name->empty() || lacks) {
      return bad("before the @ there is USER:PASSWORD or a token, with @ / : ? and % as %XX");
    }
    made_.user = *name;
    made_.password = *password;
    return {};
  }

  Status readServer(std::string_view server) {
    std::size_t host_end = server.find(':');
    if (server.starts_with('[')) {
      const std::size_t close = server.find(']');
      if (close == server.npos) return bad("the bracket of an IPv6 address is not closed");
      const auto address = SocketAddress::parse(server.substr(1, close - 1), 0);
      if (!address || !address->is_ipv6) return bad("brackets are for IPv6 addresses");
      made_.host = server.substr(1, close - 1);
      host_end = close + 1;
    } else {
      made_.host = server.substr(0, host_end);
      if (!isHostName(made_.host)) return bad("the host is neither an address nor a name");
    }
    if (host_end >= server.size()) return {};
    const auto port = wholeNumber<std::uint16_t>(server.substr(host_end + 1));
    if (server[host_end] != ':' || !port || *port == 0) {
      return bad("a server's port is a whole number from 1 to 65535");
    }
    made_.port = *port;
    return {};
  }

  Status readOption(std::string_view option) {
    const std::size_t equals = std::min(option.find('='), option.size());
    const std::string name(option.substr(0, equals));
    if (seen_.find("?" + name + "=") != seen_.npos) return bad(name + "= is given twice");
    seen_ += "?" + name + "=";
    const auto value = decodePercent(option.substr(std::min(equals + 1, option.size())));
    if (!value) return bad("a % in " + name + "= is written %25, as in URLs");
    if (name == "tls") {
      made_.tls = *value == "on";
      return made_.tls || *value == "off" ? Status() : bad("tls= is on or off");
    }
    if (jetstream_ && name == "from") return readFrom(*value);
    if (jetstream_ && name == "durable") {
      if (!isName(*value)) return bad("durable= takes letters, digits, - and _, at most 128");
      made_.durable = *value;
      return {};
    }
    for (auto [known, file] :
         {std::pair("ca", &NatsEndpoint::authorities),
          std::pair("cert", &NatsEndpoint::certificate), std::pair("key", &NatsEndpoint::key),
          std::pair("creds", &NatsEndpoint::credentials), std::pair("nkey", &NatsEndpoint::seed)}) {
      if (name != known) continue;
      if (value->empty()) return bad(name + "= takes the name of a file");
      made_.*file = *value;
      return {};
    }
    return bad(jetstream_ ? "the options of a jetstream:// endpoint are from=, durable=, " +
                                std::string(kOptions)
                          : "the options of a nats:// endpoint are " + std::string(kOptions));
  }

  Status readFrom(const std::string& value) {
    if (const auto number = wholeNumber<std::uint64_t>(value); number && *number > 0) {
      made_.from_sequence = *number;
      return {};
    }
    const auto time = parseRfc3339(value);
    if (!time) return bad("from= takes a sequence from 1 on, or a time as in 2026-01-31T08:00:00Z");
    made_.from_time = *time;
    return {};
  }

  Status check() {
    if (made_.certificate.empty() != made_.key.empty()) {
      return bad("cert= and key= belong together");
    }
    if (!made_.seed.empty() && (made_.user.empty() || !made_.password.empty())) {
      return bad("nkey= needs the public key before the @, as in nats://UABC...@HOST/cell1");
    }
    if (!made_.credentials.empty() && !(made_.user + made_.seed).empty()) {
      return bad("creds= says who asks: no user, token or nkey= beside it");
    }
    if (seen_.find("?tls=") == seen_.npos) {
      made_.tls = !made_.authorities.empty() || !made_.certificate.empty();
    }
    return {};
  }

  std::string_view text_;
  bool jetstream_;
  NatsEndpoint made_;
  std::string seen_;  ///< the options so far, each as ?NAME=
};

}  // namespace

std::string NatsEndpoint::server() const {
  const bool is_ipv6 = host.find(':') != host.npos;
  return (is_ipv6 ? "[" + host + "]" : host) + ":" + std::to_string(port);
}

bool NatsEndpoint::hasWildcard() const { return subject.find_first_of("*>") != subject.npos; }

std::string NatsEndpoint::listenedSubject() const {
  return hasWildcard() ? subject : subject + ".>";
}

bool subjectMatches(std::string_view pattern, std::string_view subject) {
  while (!pattern.empty() && !subject.empty()) {
    const std::string_view wanted = takeWord(pattern);
    if (wanted == ">") return true;
    const std::string_view word = takeWord(subject);
    if (wanted != "*" && wanted != word) return false;
  }
  return pattern.empty() && subject.empty();
}

Result<Endpoint> parseNats(std::string_view text) {
  Endpoint endpoint;
  const bool jetstream = text.starts_with(kJetStreamScheme);
  endpoint.scheme = jetstream ? Endpoint::Scheme::jetstream : Endpoint::Scheme::nats;
  const std::size_t scheme = (jetstream ? kJetStreamScheme : kNatsScheme).size();
  auto read = Reader(text, jetstream).read(text.substr(scheme));
  if (!read) return read.error();
  endpoint.nats = std::move(*read);
  return endpoint;
}

std::string natsText(const Endpoint& endpoint) {
  const NatsEndpoint& nats = endpoint.nats;
  const bool jetstream = endpoint.scheme == Endpoint::Scheme::jetstream;
  std::string text(jetstream ? kJetStreamScheme : kNatsScheme);
  text += nats.server() + "/" + nats.subject + nats.stream;
  char mark = '?';
  const auto add = [&](std::string_view name, std::string_view value) {
    if (value.empty()) return;
    text += std::exchange(mark, '&');
    text += name;
    text += encodePercent(value, "&?");
  };
  if (nats.from_sequence) add("from=", std::to_string(*nats.from_sequence));
  if (nats.from_time) add("from=", rfc3339Text(*nats.from_time));
  if (nats.durable != NatsEndpoint().durable) add("durable=", nats.durable);
  const bool implied = !nats.authorities.empty() || !nats.certificate.empty();
  if (nats.tls != implied) add("tls=", nats.tls ? "on" : "off");
  add("ca=", nats.authorities);
  add("cert=", nats.certificate);
  add("key=", nats.key);
  add("creds=", nats.credentials);
  add("nkey=", nats.seed);
  return text;
}

}  // namespace rocinante
