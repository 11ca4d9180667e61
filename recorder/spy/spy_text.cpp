#include "recorder/spy/spy_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/base/plain_text.h"
#include "core/cli/text_table.h"

namespace rocinante {
namespace {

using cli::counted;
using cli::grouped;
using cli::TextTable;

std::string secondsCell(Nanoseconds time) {
  return fmt::format("{:.1f} s", std::chrono::duration<double>(time).count());
}

std::string rateCell(double rate_hz) { return fmt::format("{:.1f}", rate_hz); }

std::string namesCell(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + plainText(name);
  return text.empty() ? "-" : text;
}

std::string numberText(double number) { return fmt::format("{:.4g}", number == 0 ? 0 : number); }

std::string valuesCell(const SpyDevice& device) {
  std::vector<std::string> parts;
  for (const double value : device.joints) parts.push_back(numberText(value));
  for (const auto& [joint, value] : device.named_joints) {
    parts.push_back(plainText(joint) + "=" + numberText(value));
  }
  std::string text = fmt::format("{}", fmt::join(parts, " "));
  if (device.pose) {
    const auto& [at, turn] = *device.pose;
    text += text.empty() ? "pose" : "; pose";
    for (const double value : {at.x, at.y, at.z, turn.x, turn.y, turn.z, turn.w}) {
      text += " " + numberText(value);
    }
    if (!device.carrier.empty()) text += " in " + device.carrier;
  }
  if (!device.presence.empty()) text += (text.empty() ? "" : "; ") + device.presence;
  return text;
}

/// Writes the sections of a report one below the other, none longer than `rows` lines.
class Page {
 public:
  Page(const SpyReport& report, std::size_t rows, std::size_t columns)
      : report_(report), rows_(rows), columns_(columns) {}

  std::string text() {
    const std::string decoded =
        report_.decoders.empty() ? "" : ", " + grouped(report_.decoded) + " decoded";
    out_ = line(fmt::format("{}: {}, {} in packet text{}", secondsCell(report_.watched),
                            counted(report_.datagrams, "datagram"),
                            grouped(report_.packets - report_.decoded), decoded));
    const bool is_terminal = columns_ > 0;
    if (is_terminal) addReasons();
    addEndpoints();
    addSenders();
    addDecoders();
    addFields();
    addSources();
    addDevices();
    addSignals();
    addDrawings();
    addEvents();
    if (!is_terminal) addReasons();
    return std::move(out_);
  }

 private:
  std::string line(std::string_view text) const {
    const std::size_t indent = text.find_first_not_of(' ');
    std::string lines = cli::wrapped(text, columns_, (indent == text.npos ? 0 : indent) + 2) + "\n";
    if (rows_ == 0 || columns_ == 0) return lines;
    // A screen has no room for words that are longer than a line.
    std::string cut;
    for (std::string_view rest = lines; !rest.empty(); rest.remove_prefix(rest.find('\n') + 1)) {
      cut += std::string(cli::firstPlaces(rest.substr(0, rest.find('\n')), columns_)) + "\n";
    }
    return cut;
  }

  /// Appends an empty line and at most rows_ rows of the table.
  void add(TextTable table, std::string_view what) {
    if (table.rows.size() == 1) return;
    const std::size_t count = table.rows.size() - 1;
    const bool cut = rows_ > 0 && count > rows_;
    if (cut) table.rows.resize(rows_ + 1);
    out_ += "\n" + table.text(columns_);
    if (cut) out_ += line(fmt::format("  ... and {} more {}", grouped(count - rows_), what));
  }

  void addEndpoints() {
    TextTable table;
    table.is_number = {false, true, true, true, true, true};
    table.rows.push_back({"endpoint", "datagrams", "bytes", "senders", "dropped", "silent"});
    for (const SpyEndpoint& each : report_.endpoints) {
      table.rows.push_back({each.endpoint, grouped(each.datagrams), grouped(each.bytes),
                            grouped(each.senders), grouped(each.dropped),
                            each.silent ? secondsCell(*each.silent) : "-"});
    }
    add(std::move(table), "endpoints");
  }

  void addSenders() {
    TextTable table;
    table.is_number = {false, true, true, true, true, true, false};
    table.rows.push_back({"sender", "rate/s", "datagrams", "packets", "bytes", "silent", "what"});
    for (const SpySender& each : report_.senders) {
      const std::string sender = each.to.empty() ? each.address : each.address + " > " + each.to;
      const std::string bytes = each.smallest_bytes == each.largest_bytes
                                    ? fmt::format("{}", each.largest_bytes)
                                    : fmt::format("{}-{}", each.smallest_bytes, each.largest_bytes);
      table.rows.push_back({sender, rateCell(each.rate_hz), grouped(each.datagrams),
                            grouped(each.packets), bytes, secondsCell(each.silent),
                            each.first_bytes.empty() ? "" : "no packet: " + each.first_bytes});
    }
    add(std::move(table), "senders");
    if (report_.more_senders > 0) {
      out_ += line(
          fmt::format("  ... and {} from further ones", counted(report_.more_senders, "datagram")));
    }
  }

  void addDecoders() {
    TextTable table;
    table.is_number = {false, false, true, true, true, false};
    table.rows.push_back({"decoder", "kind", "packets", "refused", "no field", "last refusal"});
    for (const SpyDecoder& each : report_.decoders) {
      table.rows.push_back({each.name, each.kind, grouped(each.packets), grouped(each.refused),
                            grouped(each.empty), each.reason});
    }
    add(std::move(table), "decoders");
  }

  void addFields() {
    TextTable table;
    table.is_number = {false, false, false, false};
    table.rows.push_back({"decoder", "field", "value", ""});
    for (const SpyDecoder& decoder : report_.decoders) {
      for (const SpyField& each : decoder.fields) {
        const std::string_view use = each.used       ? ""
                                     : each.declared ? "no line uses it"
                                                     : "not declared";
        table.rows.push_back({decoder.name, each.name, each.value.value_or("-"), std::string(use)});
      }
    }
    add(std::move(table), "fields");
  }

  void addSources() {
    TextTable table;
    table.is_number = {false, true, true, true, true, true, true, true, true, false};
    table.expendable = {6, 5};
    table.rows.push_back({"source", "rate/s", "packets", "gap", "late", "restarts", "restated",
                          "faults", "silent", "sender"});
    for (const SpySource& each : report_.sources) {
      const std::string name =
          plainText(each.name) + (each.run.empty() ? "" : "@") + plainText(each.run);
      table.rows.push_back({name, rateCell(each.rate_hz), grouped(each.packets), grouped(each.gap),
                            grouped(each.late), grouped(each.restarts), grouped(each.restated),
                            grouped(each.faults), secondsCell(each.silent),
                            namesCell(each.senders)});
    }
    add(std::move(table), "sources");
  }

  void addDevices() {
    TextTable table;
    table.is_number = {false, true, true, true, false, false};
    table.rows.push_back({"device", "rate/s", "changes", "silent", "source", "values"});
    for (const SpyDevice& each : report_.devices) {
      table.rows.push_back({plainText(each.name), rateCell(each.rate_hz), grouped(each.changes),
                            secondsCell(each.silent), namesCell(each.sources), valuesCell(each)});
    }
    add(std::move(table), "devices");
  }

  void addSignals() {
    TextTable table;
    table.is_number = {false, false, false};
    table.rows.push_back({"signal", "source", "value"});
    for (const SpySignal& each : report_.signals) {
      const std::string name = each.name.substr(each.name.find(' ') + 1);
      table.rows.push_back({plainText(name), plainText(each.source), each.value});
    }
    add(std::move(table), "signals");
  }

  void addDrawings() {
    TextTable table;
    table.is_number = {false, false, true, false};
    table.rows.push_back({"drawing", "source", "parts", "statement"});
    for (const SpyDrawing& each : report_.drawings) {
      table.rows.push_back(
          {plainText(each.name), plainText(each.source), grouped(each.parts), each.text});
    }
    add(std::move(table), "drawings");
  }

  void addEvents() {
    TextTable table;
    table.is_number = {true, true, false, false};
    table.rows.push_back({"times", "silent", "source", "event"});
    for (const SpyEvent& each : report_.events) {
      table.rows.push_back(
          {grouped(each.count), secondsCell(each.silent), plainText(each.source), each.text});
    }
    add(std::move(table), "events");
    if (report_.more_events > 0) {
      out_ += line(fmt::format("  ... and {} further ones", grouped(report_.more_events)));
    }
  }

  void addReasons() {
    if (report_.reasons.empty()) return;
    out_ += "\n";
    std::size_t shown = 0;
    for (const Finding& each : report_.reasons) {
      if (rows_ > 0 && shown++ == rows_) {
        out_ += line(fmt::format("... and {} more", report_.reasons.size() - rows_));
        return;
      }
      // Judges name sources and devices as their senders do.
      out_ += line(fmt::format("{} [{}]", plainText(each.text), each.rule));
      if (each.first) {
        out_ += line(fmt::format("  {}{}{}", counted(each.count, "time"),
                                 each.example.empty() ? "" : ", such as: ", each.example));
      }
      if (!each.hint.empty()) out_ += line("  " + each.hint);
    }
  }

  const SpyReport& report_;
  std::size_t rows_;
  std::size_t columns_;
  std::string out_;
};

}  // namespace

std::string spyText(const SpyReport& report, std::size_t rows, std::size_t columns) {
  return Page(report, rows, columns).text();
}

}  // namespace rocinante
