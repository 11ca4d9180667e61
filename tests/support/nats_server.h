#pragma once

#include <nats/nats.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tests/support/programs.h"

namespace rocinante::test {

/// Debian's nats-server on loopback, at a port of the system's choice; ends with this object.
class NatsServer {
 public:
  /// Whether this machine has the program; tests skip without it.
  static std::optional<std::string> program() {
    for (const char* const path : {"/usr/sbin/nats-server", "/usr/bin/nats-server"}) {
      if (std::filesystem::exists(path)) return path;
    }
    return std::nullopt;
  }

  /// `options` are its own, beside those of address, port and store.
  explicit NatsServer(std::vector<std::string> options = {}) : options_(std::move(options)) {
    start();
  }

  int port() const { return port_; }
  /// nats://127.0.0.1:PORT/SUBJECT
  std::string at(const std::string& subject, const std::string& user = "") const {
    return "nats://" + user + "127.0.0.1:" + std::to_string(port_) + "/" + subject;
  }
  std::string streamAt(const std::string& stream) const {
    return "jetstream://127.0.0.1:" + std::to_string(port_) + "/" + stream;
  }

  /// Kills it, as a power cut would.
  void kill() { server_.reset(); }
  /// Starts it again at the same port, with what it had stored.
  void start() {
    std::vector<std::string> words{
        "-a", "127.0.0.1", "-p", std::to_string(port_), "-sd", (folder_ / "store").string()};
    words.insert(words.end(), options_.begin(), options_.end());
    server_ = std::make_unique<Program>(Program::start(*program(), words));
    const std::string line = server_->waitForLine("Listening for client connections on");
    const std::size_t colon = line.rfind(':');
    ASSERT_NE(colon, std::string::npos) << line;
    port_ = std::stoi(line.substr(colon + 1));
    server_->waitForLine("Server is ready");
  }

  const TemporaryFolder& folder() const { return folder_; }

 private:
  TemporaryFolder folder_;
  std::vector<std::string> options_;
  int port_ = -1;  ///< the server's word for any free one
  std::unique_ptr<Program> server_;
};

/// An administrator of streams: what users do with the `nats` program.
class StreamAdministrator {
 public:
  explicit StreamAdministrator(const NatsServer& server) {
    const std::string url = "nats://127.0.0.1:" + std::to_string(server.port());
    EXPECT_EQ(natsConnection_ConnectTo(&connection_, url.c_str()), NATS_OK);
    EXPECT_EQ(natsConnection_JetStream(&context_, connection_, nullptr), NATS_OK);
  }
  ~StreamAdministrator() {
    jsCtx_Destroy(context_);
    natsConnection_Destroy(connection_);
  }
  StreamAdministrator(const StreamAdministrator&) = delete;
  StreamAdministrator& operator=(const StreamAdministrator&) = delete;

  void add(const char* stream, const char* subject) {
    jsStreamConfig config;
    jsStreamConfig_Init(&config);
    config.Name = stream;
    const char* subjects[] = {subject};
    config.Subjects = subjects;
    config.SubjectsLen = 1;
    EXPECT_EQ(js_AddStream(nullptr, context_, &config, nullptr, nullptr), NATS_OK);
  }
  void erase(const char* stream, std::uint64_t sequence) {
    EXPECT_EQ(js_DeleteMsg(context_, stream, sequence, nullptr, nullptr), NATS_OK);
  }
  /// Removes all messages before `sequence`.
  void purgeBefore(const char* stream, std::uint64_t sequence) {
    jsOptions options;
    jsOptions_Init(&options);
    options.Stream.Purge.Sequence = sequence;
    EXPECT_EQ(js_PurgeStream(context_, stream, &options, nullptr), NATS_OK);
  }
  std::uint64_t messages(const char* stream) {
    jsStreamInfo* info = nullptr;
    EXPECT_EQ(js_GetStreamInfo(&info, context_, stream, nullptr, nullptr), NATS_OK);
    const std::uint64_t count = info == nullptr ? 0 : info->State.Msgs;
    jsStreamInfo_Destroy(info);
    return count;
  }
  void publish(const std::string& subject, const std::string& text) {
    EXPECT_EQ(js_Publish(nullptr, context_, subject.c_str(), text.data(),
                         static_cast<int>(text.size()), nullptr, nullptr),
              NATS_OK);
  }
  /// A consumer that is not ours.
  void addPullConsumer(const char* stream, const char* durable) {
    jsConsumerConfig config;
    jsConsumerConfig_Init(&config);
    config.Durable = durable;
    config.AckPolicy = js_AckExplicit;
    EXPECT_EQ(js_AddConsumer(nullptr, context_, stream, &config, nullptr, nullptr), NATS_OK);
  }

 private:
  natsConnection* connection_ = nullptr;
  jsCtx* context_ = nullptr;
};

}  // namespace rocinante::test

/// At the start of a test that needs the server.
#define ROCINANTE_NEEDS_NATS_SERVER()                                        \
  if (!rocinante::test::NatsServer::program()) {                             \
    GTEST_SKIP() << "this machine has no nats-server (package nats-server)"; \
  }
