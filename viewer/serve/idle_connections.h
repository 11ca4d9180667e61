#pragma once

#include <algorithm>
#include <cstddef>
#include <list>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace rocinante {

/// Connections that ask for nothing right now. They are few, so that nobody who opens many keeps
/// others out: one more ends the oldest of the address that has most. One thread.
template <class Connection>
class IdleConnections {
 public:
  explicit IdleConnections(std::size_t most) : most_(most) {}

  /// A new connection, or one whose answer is sent. What it returns is to be closed, and is no
  /// longer among them; never `connection` itself.
  std::optional<Connection> add(Connection connection, std::string address) {
    remove(connection);
    std::optional<Connection> closed;
    if (connections_.size() >= most_) closed = takeOldest();
    ++by_address_[address];
    connections_.emplace_back(connection, std::move(address));
    return closed;
  }

  void remove(Connection connection) {
    const auto found = std::find_if(connections_.begin(), connections_.end(),
                                    [&](const auto& each) { return each.first == connection; });
    if (found != connections_.end()) erase(found);
  }

  std::size_t size() const { return connections_.size(); }

 private:
  using List = std::list<std::pair<Connection, std::string>>;

  std::optional<Connection> takeOldest() {
    std::size_t most = 0;
    for (const auto& each : by_address_) most = std::max(most, each.second);
    const auto oldest = std::find_if(
        connections_.begin(), connections_.end(),
        [&](const auto& each) { return by_address_.find(each.second)->second == most; });
    if (oldest == connections_.end()) return std::nullopt;
    const Connection connection = oldest->first;
    erase(oldest);
    return connection;
  }

  void erase(typename List::iterator at) {
    const auto count = by_address_.find(at->second);
    if (--count->second == 0) by_address_.erase(count);
    connections_.erase(at);
  }

  std::size_t most_;
  List connections_;  ///< the oldest first
  std::map<std::string, std::size_t> by_address_;
};

}  // namespace rocinante
