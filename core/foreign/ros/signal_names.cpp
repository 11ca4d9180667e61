#include "core/foreign/ros/signal_names.h"

#include "core/base/bytes.h"
#include "core/base/hash.h"
#include "core/packet/text_name.h"

namespace rocinante::ros {
namespace {

/// Leaves room for fields, keys and numbers in a name of 255 bytes.
constexpr std::size_t kMaxBytes = 75;

std::string plainName(std::string_view text) {
  std::string name;
  if (text.starts_with('/')) text.remove_prefix(1);
  for (const char byte : text) {
    name += byte == '/' ? ':' : byte != '.' && isNameByte(byte) ? byte : '_';
  }
  if (name.empty()) name = "_";
  return name.size() <= kMaxBytes ? name : name.substr(0, 40) + "_" + hexOf(xxh3(bytesOf(text)));
}

}  // namespace

const std::string& SignalNames::of(std::string_view what, std::string_view text) {
  if (const auto known = names_.find(what); known != names_.end()) return known->second;
  const std::string plain = plainName(text);
  std::string name = plain;
  for (int number = 2; !taken_.insert(name).second; ++number) {
    name = plain + ":" + std::to_string(number);
  }
  if (name != plain) numbered_.insert(std::string(what));
  return names_.emplace(std::string(what), std::move(name)).first->second;
}

}  // namespace rocinante::ros
