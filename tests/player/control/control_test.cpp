// Inputs of a running player: addresses, keys, sockets.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <fstream>
#include <thread>

#include "core/net/system_socket.h"
#include "core/net/udp_socket.h"
#include "player/control/command_slot.h"
#include "player/control/control_socket.h"
#include "player/control/control_thread.h"
#include "player/control/terminal_keys.h"
#include "tests/support/temporary_folder.h"

namespace rocinante {
namespace {

TEST(KeyReader, KnowsArrowsInPiecesAndPassesOverTheRest) {
  KeyReader keys;
  EXPECT_EQ(keys.take(' '), "toggle");
  EXPECT_EQ(keys.take('\x1b'), "");
  EXPECT_EQ(keys.take('['), "");
  EXPECT_EQ(keys.take('C'), "step 1");
  for (const char key : std::string("\x1b[15~")) EXPECT_EQ(keys.take(key), "");
  EXPECT_EQ(keys.take('q'), "quit");
  for (const char key : std::string("\x1b\x1b[")) EXPECT_EQ(keys.take(key), "");
  EXPECT_EQ(keys.take('D'), "back 1");
  for (const char key : std::string("\x1b[999999999999999999999999")) keys.take(key);
  EXPECT_EQ(keys.take('+'), "faster");
  EXPECT_EQ(keys.take('z'), "");
}

/// A sender that answers "ok LINE" until a quit command.
void answerUntilQuit(CommandSlot& slot) {
  while (true) {
    const auto line = slot.asked();
    if (!line) {
      std::this_thread::yield();
      continue;
    }
    const bool over = *line == "quit";
    slot.answer("ok " + std::string(*line));
    if (over) return;
  }
}

TEST(CommandSlot, AWakeThatComesAfterItsCommandWasAnsweredKeepsNobodyAwake) {
  const auto slot = CommandSlot::make().value();
  std::thread hearer([&] { EXPECT_EQ(slot->ask("status"), "ok"); });
  pollfd wake{slot->wake(), POLLIN, 0};
  ASSERT_EQ(::poll(&wake, 1, 10'000), 1);
  // As if the listening thread had been delayed between handing over and waking.
  std::uint64_t late = 0;
  ASSERT_EQ(::read(slot->wake(), &late, sizeof late), static_cast<ssize_t>(sizeof late));
  ASSERT_TRUE(slot->asked());
  slot->answer("ok");
  hearer.join();
  EXPECT_FALSE(slot->asked());
  ASSERT_EQ(::write(slot->wake(), &late, sizeof late), static_cast<ssize_t>(sizeof late));
  EXPECT_FALSE(slot->asked());
  EXPECT_EQ(::poll(&wake, 1, 0), 0);
}

class UnixClient {
 public:
  explicit UnixClient(const std::filesystem::path& path)
      : socket_(::socket(AF_UNIX, SOCK_STREAM, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.native().copy(address.sun_path, sizeof address.sun_path - 1);
    connected_ =
        ::connect(socket_.descriptor(), reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
  }
  bool connected() const { return connected_; }
  void say(const std::string& text) {
    EXPECT_EQ(::send(socket_.descriptor(), text.data(), text.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(text.size()));
  }
  /// One line; empty when the other side has closed.
  std::string hear() {
    std::string line;
    char each = 0;
    while (::recv(socket_.descriptor(), &each, 1, 0) == 1 && each != '\n') line += each;
    return line;
  }

 private:
  SystemSocket socket_;
  bool connected_ = false;
};

TEST(ControlSocket, AUnixSocketTakesLinesInAnyPieces) {
  const test::TemporaryFolder folder;
  const auto path = folder / "control";
  const auto slot = CommandSlot::make().value();
  {
    auto control = ControlSocket::open(ControlAddress::parse("unix:" + path.string()).value(), {});
    ASSERT_TRUE(control.ok());
    EXPECT_EQ(std::filesystem::status(path).permissions(),
              std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
    // A second player does not replace the first one's socket.
    EXPECT_FALSE(
        ControlSocket::open(ControlAddress::parse("unix:" + path.string()).value(), {}).ok());
    std::vector<std::unique_ptr<ControlInput>> inputs;
    inputs.push_back(std::move(control->input));
    const ControlThread thread(*slot, std::move(inputs));
    std::thread sender([&] { answerUntilQuit(*slot); });
    UnixClient client(path);
    ASSERT_TRUE(client.connected());
    for (const char* piece : {"sta", "tus\nstep", " 1\npl"}) client.say(piece);
    client.say("ay\n");
    EXPECT_EQ(client.hear(), "ok status");
    EXPECT_EQ(client.hear(), "ok step 1");
    EXPECT_EQ(client.hear(), "ok play");
    UnixClient endless(path);
    endless.say(std::string(300, 'x'));
    EXPECT_EQ(endless.hear(), "error a command has at most 256 bytes");
    EXPECT_EQ(endless.hear(), "");
    { UnixClient(path).say("gone before the answer\n"); }
    client.say("quit\n");
    EXPECT_EQ(client.hear(), "ok quit");
    sender.join();
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(ControlSocket, ADeadPlayersSocketIsReplacedAndNothingElseIs) {
  const test::TemporaryFolder folder;
  const auto path = folder / "control";
  {
    const SystemSocket dead(::socket(AF_UNIX, SOCK_STREAM, 0));
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.native().copy(address.sun_path, sizeof address.sun_path - 1);
    ASSERT_EQ(::bind(dead.descriptor(), reinterpret_cast<sockaddr*>(&address), sizeof address), 0);
  }
  ASSERT_TRUE(std::filesystem::exists(path));
  const auto address = ControlAddress::parse("unix:" + path.string()).value();
  EXPECT_TRUE(ControlSocket::open(address, {}).ok());
  std::ofstream(path) << "precious";
  EXPECT_FALSE(ControlSocket::open(address, {}).ok());
  EXPECT_EQ(std::filesystem::file_size(path), 8U);
}

TEST(ControlSocket, AFloodOfDatagramsIsAnsweredOrDroppedAndThePlayerEnds) {
  const auto slot = CommandSlot::make().value();
  auto control = ControlSocket::open(ControlAddress::parse("127.0.0.1:0").value(), {}).value();
  const Endpoint to = Endpoint::parse(control.where).value();
  std::vector<std::unique_ptr<ControlInput>> inputs;
  inputs.push_back(std::move(control.input));
  const ControlThread thread(*slot, std::move(inputs));
  std::thread sender([&] {
    for (int answered = 0; answered < 500;) {
      if (const auto line = slot->asked()) {
        slot->answer("ok");
        ++answered;
      } else {
        std::this_thread::yield();
      }
    }
    slot->close();
  });
  UdpSender flood = UdpSender::open(to).value();
  std::string many;
  for (int i = 0; i < 40; ++i) many += "status\n";
  for (std::size_t i = 0; !slot->closed(); ++i) {
    ASSERT_TRUE(flood.send(bytesOf(i % 3 == 0 ? many : std::string(i % 200, '\xff'))).ok());
  }
  sender.join();
}

}  // namespace
}  // namespace rocinante
