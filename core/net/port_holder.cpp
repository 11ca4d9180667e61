#include "core/net/port_holder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace rocinante {
namespace {

std::string_view takeField(std::string_view& line) {
  const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
  const std::size_t end = std::min(line.find(' ', begin), line.size());
  const std::string_view field = line.substr(begin, end - begin);
  line.remove_prefix(end);
  return field;
}

template <class Number>
std::optional<Number> numberOf(std::string_view text, int base) {
  Number number{};
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number, base);
  if (fault != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// "0100007F:4DF8": 32-bit words as this machine reads them from memory, then the port.
std::optional<SocketAddress> tableAddress(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon != 8 && colon != 32) return std::nullopt;
  SocketAddress address;
  address.is_ipv6 = colon == 32;
  for (std::size_t word = 0; word < colon / 8; ++word) {
    const auto value = numberOf<std::uint32_t>(text.substr(word * 8, 8), 16);
    if (!value) return std::nullopt;
    std::memcpy(address.address.data() + word * 4, &*value, 4);
  }
  const auto port = numberOf<std::uint16_t>(text.substr(colon + 1), 16);
  if (!port) return std::nullopt;
  address.port = *port;
  return address;
}

bool excludes(const SocketAddress& held, const SocketAddress& wanted) {
  if (held.port != wanted.port) return false;
  // [::] may or may not take IPv4 too; the kernel has already reported a conflict.
  if (held.isAny() && (held.is_ipv6 || !wanted.is_ipv6)) return true;
  if (held.is_ipv6 != wanted.is_ipv6) return false;
  return wanted.isAny() || held.address == wanted.address;
}

std::string readSmallFile(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

bool holdsSocket(const std::filesystem::path& process, const std::vector<std::string>& links) {
  std::error_code ignored;
  // Without permission the folder reads as empty.
  std::filesystem::directory_iterator files(process / "fd", ignored);
  for (; files != std::filesystem::directory_iterator(); files.increment(ignored)) {
    const std::string target = std::filesystem::read_symlink(files->path(), ignored).string();
    if (std::find(links.begin(), links.end(), target) != links.end()) return true;
    if (ignored) ignored.clear();
  }
  return false;
}

/// "rocinante-record": the kernel keeps 15 characters of a name; the full name is in the command
/// line.
std::string processName(const std::filesystem::path& process) {
  std::string name = readSmallFile(process / "comm");
  while (!name.empty() && name.back() == '\n') name.pop_back();
  std::error_code ignored;
  const std::string program =
      std::filesystem::read_symlink(process / "exe", ignored).filename().string();
  return !name.empty() && program.starts_with(name) ? program : name;
}

}  // namespace

std::vector<std::uint64_t> excludingSocketInodes(std::string_view table,
                                                 const SocketAddress& address) {
  std::vector<std::uint64_t> inodes;
  while (!table.empty()) {
    const std::size_t end = std::min(table.find('\n'), table.size());
    std::string_view line = table.substr(0, end);
    table.remove_prefix(std::min(end + 1, table.size()));

    // sl local_address rem_address st tx_queue:rx_queue tr:tm->when retrnsmt uid timeout inode
    takeField(line);
    const std::optional<SocketAddress> local = tableAddress(takeField(line));
    if (!local || !excludes(*local, address)) continue;
    for (int skipped = 0; skipped < 7; ++skipped) takeField(line);
    const auto inode = numberOf<std::uint64_t>(takeField(line), 10);
    if (inode && *inode != 0) inodes.push_back(*inode);
  }
  return inodes;
}

std::optional<PortHolder> portHolder(const SocketAddress& address) {
  std::vector<std::string> links;
  for (const char* table : {"/proc/net/udp", "/proc/net/udp6"}) {
    for (const std::uint64_t inode : excludingSocketInodes(readSmallFile(table), address)) {
      links.push_back(fmt::format("socket:[{}]", inode));
    }
  }
  if (links.empty()) return std::nullopt;

  std::error_code ignored;
  std::filesystem::directory_iterator processes("/proc", ignored);
  for (; processes != std::filesystem::directory_iterator(); processes.increment(ignored)) {
    const auto pid = numberOf<int>(processes->path().filename().string(), 10);
    if (!pid || !holdsSocket(processes->path(), links)) continue;
    return PortHolder{processName(processes->path()), *pid};
  }
  return std::nullopt;
}

}  // namespace rocinante
