#include "recorder/doctor/log_doctor.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/figure_text.h"
#include "core/base/plain_text.h"
#include "core/log/foreign_file.h"
#include "core/log/mapped_file.h"
#include "core/report/json_text.h"
#include "recorder/doctor/data_walk.h"
#include "recorder/doctor/summary_rules.h"

namespace rocinante {
namespace {

constexpr std::string_view kNotClosed = "not-closed";

std::string hintFor(const DoctorReport& report) {
  if (!report.broke(kNotClosed)) return {};
  return fmt::format("rocinante log recover {}", plainText(report.name));
}

}  // namespace

Result<DoctorReport> examineBytes(ByteView file, std::string name,
                                  const std::function<void(double)>& progress) {
  const ByteView magic = mcap::magic();
  if (file.size() < magic.size() || !std::ranges::equal(file.first(magic.size()), magic)) {
    return Error{ErrorKind::damaged, notALog(file), name};
  }
  DoctorReport report;
  report.name = std::move(name);
  report.file_bytes = file.size();
  DoctorFacts facts;
  Definitions definitions(report);
  DataWalk walk(file, report, facts, definitions);
  const auto size = static_cast<double>(file.size());
  const std::optional<std::uint64_t> summary = walk.run([&](std::uint64_t position) {
    if (progress) progress(static_cast<double>(position) / size);
  });
  if (summary) SummaryRules(file, report, facts, definitions).run(*summary);
  return report;
}

Result<DoctorReport> examineLog(const std::filesystem::path& path,
                                const std::function<void(double)>& progress) {
  const Result<MappedFile> file = MappedFile::open(path);
  if (!file) return file.error();
  return examineBytes(file->bytes(), path.string(), progress);
}

std::string doctorText(const DoctorReport& report) {
  if (report.clean()) {
    return fmt::format("{}: sound ({} in {}, {} bytes)\n", plainText(report.name),
                       countText(report.messages, "message"), countText(report.chunks, "chunk"),
                       report.file_bytes);
  }
  std::uint64_t total = 0;
  for (const auto& [rule, count] : report.counts()) total += count;
  std::string out =
      fmt::format("{}: {} {} of {}\n", plainText(report.name), total,
                  total == 1 ? "breach" : "breaches", countText(report.counts().size(), "rule"));
  for (const Finding& breach : report.breaches()) {
    out += fmt::format("  byte {:<10}  {:<18}  {}\n", *breach.byte, breach.rule, breach.text);
  }
  for (const auto& [rule, count] : report.counts()) {
    if (count > DoctorReport::kMaxListed) {
      out +=
          fmt::format("  {:15}  {:<18}  and {} more\n", "", rule, count - DoctorReport::kMaxListed);
    }
  }
  if (const std::string hint = hintFor(report); !hint.empty()) {
    out += fmt::format("  `{}` makes a whole file from it\n", hint);
  }
  return out;
}

std::string doctorJson(const DoctorReport& report, bool indented) {
  Json out;
  out["format"] = 1;
  out["log"] = report.name;
  out["profile"] = report.profile;
  out["file_bytes"] = report.file_bytes;
  out["chunks"] = report.chunks;
  out["messages"] = report.messages;
  out["breaches"] = Json::array();
  for (const Finding& breach : report.breaches()) {
    out["breaches"].push_back(
        {{"rule", breach.rule}, {"offset", *breach.byte}, {"what", breach.text}});
  }
  out["counts"] = Json::object();
  for (const auto& [rule, count] : report.counts()) out["counts"][rule] = count;
  if (const std::string hint = hintFor(report); !hint.empty()) out["hint"] = hint;
  return jsonText(out, indented ? 2 : -1);
}

}  // namespace rocinante
