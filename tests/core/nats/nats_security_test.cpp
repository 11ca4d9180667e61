#include <gtest/gtest.h>
#include <poll.h>

#include "core/transport/open_sink.h"
#include "core/transport/open_source.h"
#include "tests/support/nats_keys.h"
#include "tests/support/nats_server.h"

#define ROCINANTE_NEEDS_OPENSSL()                                    \
  if (!std::filesystem::exists(kOpenssl)) {                          \
    GTEST_SKIP() << "this machine has no openssl (package openssl)"; \
  }

namespace rocinante {
namespace {

using test::NatsKey;
using test::NatsServer;

constexpr const char* kOpenssl = "/usr/bin/openssl";
constexpr std::string_view kPacket = "RK1 arm 1 -\njoints arm 1\n";

/// Files that openssl makes: authorities, and certificates that they sign.
class Certificates {
 public:
  /// An authority NAME: NAME.pem and NAME.key.
  void authority(const std::string& name) const {
    make({"req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:P-256", "-nodes", "-days",
          "2", "-subj", "/CN=" + name, "-keyout", at(name + ".key"), "-out", at(name + ".pem")});
  }
  /// NAME.pem and NAME.key, signed by the authority, for `alternative` ("IP:127.0.0.1").
  void signedBy(const std::string& authority, const std::string& name,
                const std::string& alternative) const {
    make({"req", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:P-256", "-nodes", "-subj",
          "/CN=" + name, "-addext", "subjectAltName=" + alternative, "-keyout", at(name + ".key"),
          "-out", at(name + ".request")});
    make({"x509", "-req", "-days", "2", "-copy_extensions", "copy", "-in", at(name + ".request"),
          "-CA", at(authority + ".pem"), "-CAkey", at(authority + ".key"), "-CAcreateserial",
          "-out", at(name + ".pem")});
  }
  std::string at(const std::string& file) const { return (folder_ / file).string(); }
  std::string write(const std::string& file, const std::string& text) const {
    std::ofstream(folder_ / file) << text;
    return at(file);
  }

 private:
  static void make(const std::vector<std::string>& words) {
    const test::ProgramResult made = test::runProgram(kOpenssl, words);
    ASSERT_EQ(made.exit_code, 0) << made.err;
  }
  test::TemporaryFolder folder_;
};

/// What a listener and a sender at this endpoint hear; empty when a datagram passes.
std::string refusalAt(const std::string& text) {
  const Endpoint endpoint = Endpoint::parse(text).value();
  const auto source = openSource(endpoint);
  const auto sink = openSink(endpoint);
  if (!source && !sink) {
    EXPECT_EQ(source.error().what, sink.error().what);
    return sink.error().what;
  }
  if (!source) return "only the listener: " + source.error().what;
  if (!sink) return "only the sender: " + sink.error().what;
  const ByteView payload = bytesOf(kPacket);
  EXPECT_TRUE((*sink)->send({&payload, 1}).ok());
  EXPECT_TRUE((*sink)->flush().ok());
  const auto give_up = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (std::chrono::steady_clock::now() < give_up) {
    pollfd waiting{(*source)->fileDescriptor(), POLLIN, 0};
    ::poll(&waiting, 1, 100);
    const auto batch = (*source)->receive();
    if (!batch) return batch.error().what;
    if (batch->empty()) continue;
    EXPECT_EQ(textOf(batch->front().payload), kPacket);
    return {};
  }
  return "nothing came";
}

std::string nameOf(const NatsServer& server) {
  return "127.0.0.1:" + std::to_string(server.port());
}
std::string wrongWordsAt(const NatsServer& server) {
  return "the NATS server " + nameOf(server) + " refuses this user, token or these credentials";
}
std::string noWordsAt(const NatsServer& server) {
  return "the NATS server " + nameOf(server) +
         " refuses a client without user, token or credentials";
}

class NatsSecurity : public testing::Test {
 protected:
  void SetUp() override { ROCINANTE_NEEDS_NATS_SERVER(); }
  Certificates files_;
};

TEST_F(NatsSecurity, TlsChecksTheServersCertificate) {
  ROCINANTE_NEEDS_OPENSSL();
  files_.authority("ours");
  files_.authority("theirs");
  files_.signedBy("ours", "server", "IP:127.0.0.1");
  files_.signedBy("ours", "other", "DNS:robots.example");
  const auto with = [&](const std::string& name) {
    return std::vector<std::string>{"--tls", "--tlscert", files_.at(name + ".pem"), "--tlskey",
                                    files_.at(name + ".key")};
  };
  const NatsServer server(with("server"));
  const NatsServer other(with("other"));
  const NatsServer plain;
  const std::string ours = "a?ca=" + files_.at("ours.pem");
  EXPECT_EQ(refusalAt(server.at(ours)), "");
  // This server demands TLS, also of a client that was not told to use it.
  const std::vector<std::string> wrong{"a?ca=" + files_.at("theirs.pem"), "a?tls=on", "a"};
  for (const std::string& access : wrong) {
    EXPECT_EQ(refusalAt(server.at(access)),
              "the certificate of the NATS server " + nameOf(server) +
                  " is not accepted: unable to get local issuer certificate; ca= must name the "
                  "file of its authority")
        << access;
  }
  EXPECT_EQ(refusalAt(other.at(ours)), "the certificate of the NATS server " + nameOf(other) +
                                           " is not accepted: IP address mismatch");
  EXPECT_EQ(refusalAt(plain.at(ours)), "the NATS server " + nameOf(plain) + " has no TLS");
}

TEST_F(NatsSecurity, AServerMayWantAClientsCertificate) {
  ROCINANTE_NEEDS_OPENSSL();
  files_.authority("ours");
  files_.authority("theirs");
  files_.signedBy("ours", "server", "IP:127.0.0.1");
  files_.signedBy("ours", "me", "DNS:me");
  files_.signedBy("theirs", "stranger", "DNS:me");
  const NatsServer server({"--tlsverify", "--tlscert", files_.at("server.pem"), "--tlskey",
                           files_.at("server.key"), "--tlscacert", files_.at("ours.pem")});
  const std::string ours = "a?ca=" + files_.at("ours.pem");
  const auto with = [&](const std::string& name) {
    return ours + "&cert=" + files_.at(name + ".pem") + "&key=" + files_.at(name + ".key");
  };
  EXPECT_EQ(refusalAt(server.at(with("me"))), "");
  const std::string refused = "no NATS server answers over TLS at " + nameOf(server) +
                              ", or it wants another client certificate: cert= and key= name its "
                              "files";
  EXPECT_EQ(refusalAt(server.at(with("stranger"))), refused);
  EXPECT_EQ(refusalAt(server.at(ours)), refused);
}

TEST_F(NatsSecurity, AUserWithAPassword) {
  const NatsServer server({"--user", "ada", "--pass", "s3cret"});
  EXPECT_EQ(refusalAt(server.at("a", "ada:s3cret@")), "");
  EXPECT_EQ(refusalAt(server.at("a", "ada:guess@")), wrongWordsAt(server));
  EXPECT_EQ(refusalAt(server.at("a", "eve:s3cret@")), wrongWordsAt(server));
  EXPECT_EQ(refusalAt(server.at("a")), noWordsAt(server));
}

TEST_F(NatsSecurity, AToken) {
  const NatsServer server({"--auth", "s3cret"});
  EXPECT_EQ(refusalAt(server.at("a", "s3cret@")), "");
  EXPECT_EQ(refusalAt(server.at("a", "guess@")), wrongWordsAt(server));
  EXPECT_EQ(refusalAt(server.at("a")), noWordsAt(server));
}

TEST_F(NatsSecurity, AnNkey) {
  const NatsKey ada(NatsKey::kUser, 1);
  const NatsKey eve(NatsKey::kUser, 2);
  const NatsServer server({"-c", files_.write("server.conf", "authorization { users = [ { nkey: " +
                                                                 ada.publicText() + " } ] }\n")});
  const auto as = [&](const NatsKey& key, const std::string& seed) {
    return server.at("a?nkey=" + seed, key.publicText() + "@");
  };
  const std::string adas = files_.write("ada.seed", ada.seedText() + "\n");
  const std::string eves = files_.write("eve.seed", eve.seedText() + "\n");
  EXPECT_EQ(refusalAt(as(ada, adas)), "");
  EXPECT_EQ(refusalAt(as(eve, eves)), wrongWordsAt(server));
  EXPECT_EQ(refusalAt(as(ada, eves)), wrongWordsAt(server));
  EXPECT_EQ(refusalAt(as(ada, "/nowhere/ada.seed")),
            "cannot connect to the NATS server " + nameOf(server) +
                ": error opening file '/nowhere/ada.seed': No such file or directory");
  const std::string text = files_.write("text", "nothing\n");
  EXPECT_EQ(refusalAt(as(ada, text)), "cannot connect to the NATS server " + nameOf(server) +
                                          ": no nkey user seed found in '" + text + "'");
  EXPECT_EQ(refusalAt(server.at("a")), noWordsAt(server));
}

TEST_F(NatsSecurity, ASignatureMayBeginWithAnyByte) {
  const NatsKey ada(NatsKey::kUser, 1);
  const NatsServer server({"-c", files_.write("server.conf", "authorization { users = [ { nkey: " +
                                                                 ada.publicText() + " } ] }\n")});
  const std::string at = server.at("a?nkey=" + files_.write("ada.seed", ada.seedText() + "\n"),
                                   ada.publicText() + "@");
  const Endpoint endpoint = Endpoint::parse(at).value();
  // Of 600 signatures one begins with a zero in nine runs of ten.
  for (int i = 0; i < 600; ++i) {
    const auto sink = openSink(endpoint);
    ASSERT_TRUE(sink.ok()) << "connection " << i << ": " << sink.error().what;
  }
}

TEST_F(NatsSecurity, AFileOfCredentials) {
  const NatsKey owner(NatsKey::kOperator, 1);
  const NatsKey account(NatsKey::kAccount, 2);
  const NatsKey ada(NatsKey::kUser, 3);
  const std::string limits = R"("subs":-1,"data":-1,"payload":-1)";
  const std::string account_claims =
      R"({"type":"account","version":2,"limits":{"imports":-1,"exports":-1,"conn":-1,"leaf":-1,)"
      R"("wildcards":true,)" +
      limits + "}}";
  const NatsServer server(
      {"-c", files_.write("server.conf",
                          "operator: " + owner.token(owner, R"({"type":"operator","version":2})") +
                              "\nresolver: MEMORY\nresolver_preload: { " + account.publicText() +
                              ": " + owner.token(account, account_claims) + " }\n")});
  // Of ada, as the account of `by` says it, with the seed of `key`.
  const auto with = [&](const NatsKey& by, const NatsKey& key) {
    const std::string claims = R"({"type":"user","version":2,"pub":{},"sub":{},)" + limits + "}";
    return server.at(
        "a?creds=" +
        files_.write("ada.creds", "-----BEGIN NATS USER JWT-----\n" + by.token(ada, claims) +
                                      "\n------END NATS USER JWT------\n"
                                      "\n-----BEGIN USER NKEY SEED-----\n" +
                                      key.seedText() + "\n------END USER NKEY SEED------\n"));
  };
  EXPECT_EQ(refusalAt(with(account, ada)), "");
  EXPECT_EQ(refusalAt(with(NatsKey(NatsKey::kAccount, 8), ada)), wrongWordsAt(server));
  EXPECT_EQ(refusalAt(with(account, NatsKey(NatsKey::kUser, 9))), wrongWordsAt(server));
  EXPECT_EQ(refusalAt(server.at("a?creds=/nowhere/ada.creds")),
            "cannot connect to the NATS server " + nameOf(server) +
                ": error opening file '/nowhere/ada.creds': No such file or directory");
  const std::string text = files_.write("text", "nothing\n");
  EXPECT_EQ(refusalAt(server.at("a?creds=" + text)),
            "cannot connect to the NATS server " + nameOf(server) +
                ": no nkey user seed found in '" + text + "'");
  EXPECT_EQ(refusalAt(server.at("a")), noWordsAt(server));
}

}  // namespace
}  // namespace rocinante
