// Runs the examples of docs/subscriptions.md, so that the normative text stays true.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "core/subscription/subscription_desk.h"

namespace rocinante {
namespace {

struct Block {
  std::string kind;  ///< after the opening fence
  std::vector<std::string> lines;
};

std::vector<Block> blocksOfDocument() {
  std::ifstream file(std::filesystem::path(ROCINANTE_SOURCE_DIR) / "docs" / "subscriptions.md");
  std::vector<Block> blocks;
  bool is_inside = false;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("```")) {
      is_inside = !is_inside;
      if (is_inside) blocks.push_back({line.substr(3), {}});
    } else if (is_inside) {
      blocks.back().lines.push_back(line);
    }
  }
  return blocks;
}

SocketAddress addressOf(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  std::string host = text.substr(0, colon);
  if (host.starts_with('[')) host = host.substr(1, host.size() - 2);
  const auto port = static_cast<std::uint16_t>(std::stoi(text.substr(colon + 1)));
  return SocketAddress::parse(host, port).value();
}

/// `SECONDS ADDRESS > REQUEST` and `SECONDS ADDRESS < ANSWER`, where COOKIE is the last one that
/// the address was given.
void runExchange(const std::vector<std::string>& lines) {
  SubscriptionDesk::Options options;
  options.relay = "site";
  options.run = "7f3a";
  SubscriptionDesk desk(options);
  std::string cookie = "COOKIE";
  std::string answer;
  for (const std::string& line : lines) {
    SCOPED_TRACE(line);
    std::istringstream fields(line);
    double seconds = 0;
    std::string address, direction, text;
    fields >> seconds >> address >> direction >> std::ws;
    std::getline(fields, text);
    const SteadyTime now(Nanoseconds(static_cast<std::int64_t>(seconds * 1e9)));
    desk.expire(now);
    if (direction == ">") {
      EXPECT_EQ(answer, "");
      if (const auto at = text.find("COOKIE"); at != std::string::npos) text.replace(at, 6, cookie);
      const std::string request =
          subscriptionText(readSubscription(bytesOf(text)).value(), kSubscribeBytes);
      answer = desk.handle(bytesOf(request), addressOf(address), now).answer;
    } else {
      const auto said = readSubscription(bytesOf(answer));
      ASSERT_TRUE(said.ok());
      if (!said->cookie.empty()) {
        cookie = said->cookie;
        answer.replace(answer.find(cookie), cookie.size(), "COOKIE");
      }
      EXPECT_EQ(answer, text + "\n");
      answer.clear();
    }
  }
  EXPECT_EQ(answer, "");
}

TEST(SubscriptionsDocument, ItsExamplesAreTrue) {
  std::map<std::string, int> seen;
  for (const Block& block : blocksOfDocument()) {
    ++seen[block.kind];
    if (block.kind == "exchange") {
      runExchange(block.lines);
      continue;
    }
    for (const std::string& line : block.lines) {
      SCOPED_TRACE(line);
      const auto read = readSubscription(bytesOf(line));
      ASSERT_EQ(read.ok(), block.kind == "rks1");
      if (read) {
        EXPECT_EQ(subscriptionText(*read), line + "\n");
      }
    }
  }
  EXPECT_EQ(seen, (std::map<std::string, int>{{"exchange", 2}, {"malformed", 1}, {"rks1", 1}}));
}

}  // namespace
}  // namespace rocinante
