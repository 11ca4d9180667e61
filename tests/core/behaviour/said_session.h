#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "core/log/log_reader.h"
#include "core/log/log_writer.h"

namespace rocinante::test {

/// A session as packet text, which tests change before they write it again.
class SaidSession {
 public:
  struct Said {
    double at_s = 0;                   ///< since the origin
    std::string source, header, body;  ///< the first line without its LF, and the rest
  };
  std::vector<Said> packets;

  static SaidSession read(const std::filesystem::path& path) {
    SaidSession session;
    auto reader = LogReader::open(path);
    EXPECT_TRUE(reader.ok());
    if (!reader.ok()) return session;
    while (true) {
      const auto message = reader->next();
      if (!message.ok() || !*message) break;
      if (!(*message)->channel->captured()) continue;
      const std::string text(
          (*message)->payload.size() == 0 ? "" : std::string(textOf((*message)->payload)));
      const std::size_t line = text.find('\n');
      session.packets.push_back({secondsOf((*message)->log_time - reader->summary().origin),
                                 (*message)->channel->metadata.at("source"), text.substr(0, line),
                                 text.substr(line + 1)});
    }
    return session;
  }

  void write(const std::filesystem::path& path) const {
    LogWriterOptions options;
    options.overwrite = true;
    auto writer = LogWriter::create(path, options, "0123456789abcdef0123456789abcdef");
    ASSERT_TRUE(writer.ok()) << writer.error().text();
    std::map<std::string, ChannelId> channels;
    std::map<std::string, std::uint32_t> counts;
    std::vector<const Said*> order;
    for (const Said& said : packets) order.push_back(&said);
    std::ranges::stable_sort(order, {}, &Said::at_s);
    for (const Said* said : order) {
      if (!channels.contains(said->source)) {
        const auto made =
            writer->addChannel("/udp/19960/" + said->source, "rk1", {{"source", said->source}});
        ASSERT_TRUE(made.ok());
        channels[said->source] = *made;
      }
      // The run's own count: packets that are left out are no losses, and moved ones are not late.
      const std::uint32_t count = counts[said->source]++;
      std::istringstream words(said->header);
      std::string magic, source, sequence, time, rest;
      words >> magic >> source >> sequence >> time;
      std::getline(words, rest);
      const std::string text =
          fmt::format("{} {} {} -{}\n{}", magic, source, count, rest, said->body);
      const LogTime at(std::chrono::seconds(1'700'000'000) +
                       Nanoseconds(std::llround(said->at_s * 1e9)));
      ASSERT_TRUE(writer
                      ->write(channels[said->source], count, at, at.time_since_epoch().count(),
                              bytesOf(text))
                      .ok());
    }
    ASSERT_TRUE(writer->close("test").ok());
  }

  /// Changes a value of `joints DEVICE ...` from `from` on, until `until`.
  SaidSession& joint(const std::string& device, std::size_t number, double from, double until,
                     const std::function<double(double, double)>& change) {
    for (Said& said : packets) {
      if (said.at_s < from || said.at_s >= until) continue;
      said.body = changedJoints(said.body, device, [&](double value, std::size_t i) {
        return i == number ? change(value, said.at_s) : value;
      });
    }
    return *this;
  }

  static std::string changedJoints(const std::string& body, const std::string& device,
                                   const std::function<double(double, std::size_t)>& change) {
    std::istringstream lines(body);
    std::string line, changed;
    while (std::getline(lines, line)) {
      std::istringstream words(line);
      std::string verb, name;
      words >> verb >> name;
      if (verb == "joints" && name == device) {
        line = verb + " " + name;
        double value = 0;
        for (std::size_t i = 0; words >> value; ++i)
          line += fmt::format(" {:.9f}", change(value, i));
      }
      changed += line + "\n";
    }
    return changed;
  }

  /// Replaces text in the bodies of [from, until).
  SaidSession& replace(const std::string& what, const std::string& by, double from = 0,
                       double until = 1e9) {
    bool is_there = false;
    for (Said& said : packets) {
      if (said.at_s < from || said.at_s >= until) continue;
      for (std::size_t at = said.body.find(what); at != std::string::npos;
           at = said.body.find(what, at + by.size())) {
        said.body.replace(at, what.size(), by);
        is_there = true;
      }
    }
    EXPECT_TRUE(is_there) << what;
    return *this;
  }

  SaidSession& erase(const std::string& source, double from, double until) {
    std::erase_if(packets, [&](const Said& said) {
      return said.source == source && said.at_s >= from && said.at_s < until;
    });
    return *this;
  }

  SaidSession& say(const std::string& source, double at_s, const std::string& statement) {
    packets.push_back({at_s, source, "RK1 " + source + "-extra 0 -", statement + "\n"});
    return *this;
  }

  /// Moves what a source says; `source` empty: everything.
  SaidSession& times(const std::string& source, const std::function<double(double)>& change) {
    for (Said& said : packets) {
      if (source.empty() || said.source == source) said.at_s = change(said.at_s);
    }
    std::ranges::stable_sort(packets, {}, &Said::at_s);
    return *this;
  }
};

}  // namespace rocinante::test
