#include "core/check/log_account.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "core/base/plain_text.h"
#include "core/log/import_record.h"
#include "core/log/log_profile.h"

namespace rocinante {
namespace {

/// Most devices that the sentence names.
constexpr std::size_t kMostNamed = 3;
/// Most kinds of things that note() names.
constexpr std::size_t kMostInNote = 2;

bool isDriven(const Joint& joint) { return joint.type != JointType::fixed && !joint.mimic; }

bool isMoved(const Model& model, const DeviceState* stated) {
  if (stated == nullptr) return false;
  if (stated->pose || stated->joints) return true;
  return std::ranges::any_of(stated->named_joints, [&](const auto& named) {
    // A joint of several values is stated as NAME.x and so on.
    const std::string_view name = named.first;
    return std::ranges::any_of(model.joints, [&](const Joint& joint) {
      return isDriven(joint) && name.starts_with(joint.name) &&
             (name.size() == joint.name.size() ||
              (valueCount(joint.type) > 1 && name[joint.name.size()] == '.'));
    });
  });
}

/// Of a recorder's log: topics of octets that no decoder made packets of. Of an import: its record.
Account leftOutOf(const LogReader& log) {
  Account account = accountOfLines(importLeftOutOf(log.metadata()));
  // Another program's file is no log yet: an import would make packets.
  if (log.summary().profile != profile::kName) return account;
  std::set<std::string, std::less<>> decoded;
  for (const LogChannel& channel : log.channels()) {
    if (channel.decoded()) decoded.emplace(profile::capturedTopic(channel.topic));
  }
  for (const LogChannel& channel : log.channels()) {
    if (!channel.captured() || channel.imported() || channel.encoding == "rk1") continue;
    if (decoded.contains(channel.topic)) continue;
    const bool is_octets = channel.encoding == "octets";
    account.leaveOut({.kind = "topic",
                      .name = channel.topic,
                      .reason = is_octets ? "octets, and no decoder made packets of them"
                                          : channel.encoding + ", which does not become packets"});
  }
  return account;
}

/// "a, b, c and 4 more"
std::string namesText(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kMostNamed); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " and " : ", ";
    text += plainText(names[i]);
  }
  if (names.size() > kMostNamed) {
    text += " and " + std::to_string(names.size() - kMostNamed) + " more";
  }
  return text;
}

/// Those of the state that nothing can draw.
std::vector<std::string> devicesBeyond(const Cell& cell, const SessionState& last) {
  std::set<std::string, std::less<>> ghosts;
  for (const CellSource& source : cell.sources) {
    for (const auto& [ghost, original] : source.ghost_of) ghosts.insert(ghost);
  }
  std::vector<std::string> names;
  for (const auto& [name, stated] : last.devices()) {
    const bool is_moved = stated.pose || stated.joints || !stated.named_joints.empty();
    if (is_moved && !stated.presence && cell.findDevice(name) == nullptr &&
        !ghosts.contains(name)) {
      names.push_back(name);
    }
  }
  return names;
}

}  // namespace

std::string LogAccount::sentence(std::size_t most_listed) const {
  std::string text;
  if (!not_in_cell.empty()) {
    text = fmt::format("the cell has no device {}, which the log moves", namesText(not_in_cell));
  }
  if (no_packets) {
    text = "no message of the log is a packet: nothing moves";
  } else if (!at_rest.empty()) {
    if (!text.empty()) text += "; ";
    text += "no packet of the log moves " + namesText(at_rest);
    if (movable > at_rest.size()) {
      text += " (" + std::to_string(at_rest.size()) + " of " + std::to_string(movable) +
              " devices with joints)";
    }
  }
  if (!text.empty() && !left_out.empty()) text += "; ";
  return text + accountSentence(left_out, most_listed);
}

std::string LogAccount::note() const {
  const bool all_at_rest = movable > 0 && at_rest.size() == movable;
  const bool is_reported = no_packets || all_at_rest || !not_in_cell.empty();
  if (!is_reported && (!imported || empty())) return {};
  const bool is_whole = left_out.leftOut().size() <= kMostInNote && left_out.unlisted() == 0;
  return sentence(kMostInNote) + (is_whole ? "" : "; rocinante check lists all");
}

LogAccount logAccount(const LogReader& log, const SessionState& last, const Cell* cell) {
  LogAccount account;
  account.left_out = leftOutOf(log);
  // A capture becomes channels like those of a recorder.
  account.imported = log.summary().end_reason == kImportedEnd || hasImportRecord(log.metadata()) ||
                     std::ranges::any_of(log.channels(), &LogChannel::imported);
  account.no_packets = log.summary().profile == profile::kName && log.summary().messages > 0 &&
                       last.sources().empty() && last.devices().empty();
  if (cell == nullptr) return account;
  account.not_in_cell = devicesBeyond(*cell, last);
  for (const CellDevice& device : cell->devices) {
    const Model* const model = cell->modelOf(device);
    if (model == nullptr || std::ranges::none_of(model->joints, isDriven)) continue;
    const DeviceState* const stated = last.findDevice(device.name);
    if (device.optional && (stated == nullptr || !stated->presence)) continue;
    ++account.movable;
    if (!isMoved(*model, stated)) account.at_rest.push_back(device.name);
  }
  return account;
}

LogAccount logAccount(Timeline& session, const Cell* cell) {
  StateDamage damage;
  const auto last = session.stateAt(session.end(), &damage);
  return logAccount(session.log(), last ? **last : SessionState(), cell);
}

Result<LogAccount> logAccount(const std::filesystem::path& log, const Cell* cell) {
  auto session = Timeline::open(log);
  if (!session) return session.error();
  return logAccount(*session, cell);
}

}  // namespace rocinante
