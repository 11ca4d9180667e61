#include "viewer/model/convert.h"

#include <fmt/format.h>

#include "core/base/atomic_file.h"
#include "core/base/plain_text.h"
#include "core/cell/cell_files.h"
#include "core/kinematics/kinematics.h"
#include "viewer/model/model_writers.h"

namespace rocinante {
namespace {

namespace fs = std::filesystem;

struct OutputFile {
  fs::path path;
  std::string bytes;
};

constexpr std::uint64_t kMaxTextureBytes = std::uint64_t{1} << 30;
constexpr std::uint64_t kMaxStlTriangles = 0xFFFFFFFF;

enum class Form : std::uint8_t { obj, stl, cell };

Result<Form> formOf(const fs::path& output) {
  const std::string name = output.filename().string();
  if (name.ends_with(".cell.toml")) return Form::cell;
  if (output.extension() == ".obj") return Form::obj;
  if (output.extension() == ".stl") return Form::stl;
  return Error{ErrorKind::bad_argument, "the output must end in .obj, .stl or .cell.toml",
               output.string()};
}

// "arm" of "out/arm.cell.toml" and of "out/arm.obj".
std::string stemOf(const fs::path& output) {
  std::string name = output.stem().string();
  if (name.ends_with(".cell")) name.resize(name.size() - 5);
  return name;
}

// Writes all files or none; on an error existing files are kept.
Status writeAll(const std::vector<OutputFile>& files, bool overwrite) {
  for (const OutputFile& file : files) {
    if (!overwrite && fs::exists(fs::symlink_status(file.path))) {
      return Error{ErrorKind::refused, "the file exists; --force overwrites it",
                   file.path.string()};
    }
  }
  std::vector<fs::path> added;
  const auto undo = [&](const Status& failed) {
    std::error_code ignored;
    for (auto path = added.rbegin(); path != added.rend(); ++path) fs::remove(*path, ignored);
    return failed;
  };
  for (const OutputFile& file : files) {
    std::error_code fault;
    const fs::path folder = file.path.parent_path();
    if (!folder.empty() && fs::create_directory(folder, fault)) added.push_back(folder);
    if (fault) return undo(Error{ErrorKind::refused, fault.message(), folder.string()});
    const bool is_new = !fs::exists(fs::symlink_status(file.path, fault));
    Status written = writeFileWhole(file.path, bytesOf(file.bytes), overwrite);
    if (!written.ok()) return undo(written);
    if (is_new) added.push_back(file.path);
  }
  return Status{};
}

// A device at zero joints and the identity pose.
PosedDevice modelAlone(const CellDevice& device, const Model& model) {
  PosedDevice posed;
  posed.name = device.name;
  posed.model = &model;
  posed.link_world = linkPoses(model, zeroJoints(model));
  posed.link_visible.assign(model.links.size(), true);
  posed.link_color.resize(model.links.size());
  return posed;
}

class Conversion {
 public:
  Conversion(const Cell& cell, const ConvertJob& job)
      : cell_(cell),
        job_(job),
        folder_(job.output.parent_path()),
        stem_(stemOf(job.output)),
        // Names of our files in OBJ, MTL and cell.
        obj_(plain(stem_) + ".mtl", plain(stem_) + ".textures") {}

  Result<ConvertReport> run(Form form) {
    Status made = form == Form::cell ? makeCell() : makePosed(form);
    if (!made) return made.error();
    if (Status written = writeAll(files_, job_.overwrite); !written) return written.error();
    for (const OutputFile& file : files_) report_.files.push_back(file.path);
    return std::move(report_);
  }

 private:
  static std::string plain(const std::string& name) { return PlainNames().of(name); }

  Status makePosed(Form form) {
    const Result<SessionState> state = posedState(cell_, job_.pose);
    if (!state) return state.error();
    const PosedScene scene = poseScene(cell_, *state);
    StlWriter stl;
    for (const PosedDevice& device : scene.devices) {
      if (!job_.pose.device.empty() && device.name != job_.pose.device) continue;
      if (form == Form::obj) {
        addGroups(device,
                  scene.devices.size() == 1 || !job_.pose.device.empty() ? "" : device.name + ".",
                  true);
      } else {
        forEachPart(device, true, [&](const PosedPart& part) {
          stl.add(part);
          nameLossesOfStl(part);
        });
      }
    }
    if (form == Form::obj) return addObj(job_.output);
    if (stl.triangles() == 0) return nothing();
    if (stl.triangles() > kMaxStlTriangles) {
      return Error{ErrorKind::unsupported, "STL holds at most 4,294,967,295 triangles",
                   job_.output.string()};
    }
    report_.triangles = stl.triangles();
    files_.push_back({job_.output, stl.finish()});
    return Status{};
  }

  Status makeCell() {
    if (job_.pose.joints || !job_.pose.named.empty() || job_.pose.base || !job_.pose.log.empty()) {
      return Error{ErrorKind::bad_argument,
                   "a cell keeps its joints, so joint values have no effect here",
                   job_.output.string()};
    }
    const CellDevice* device = nullptr;
    if (!job_.pose.device.empty()) {
      device = cell_.findDevice(job_.pose.device);
    } else if (cell_.devices.size() == 1) {
      device = &cell_.devices.front();
    }
    if (device == nullptr || cell_.modelOf(*device) == nullptr) {
      return Error{
          ErrorKind::bad_argument,
          fmt::format("--device must name one of the {} devices to write", cell_.devices.size()),
          cell_.shown(cell_.file)};
    }
    const Model& model = *cell_.modelOf(*device);
    const std::vector<std::string> groups = addGroups(modelAlone(*device, model), "", false);
    for (const Link& link : model.links) {
      if (link.collisions.empty()) continue;
      report_.left_out.leaveOut({.kind = "collision",
                                 .reason = "a cell has only visual shapes",
                                 .count = link.collisions.size(),
                                 .severity = Severity::warning});
    }
    const std::string obj_name = plain(stem_) + ".obj";
    if (Status added = addObj(folder_ / obj_name); !added) return added;
    std::string text = cellText(*device, model, obj_name, groups);
    if (text.size() > kMaxCellBytes) {
      return Error{ErrorKind::unsupported,
                   fmt::format("{} links make a cell file larger than {} MiB, the limit",
                               model.links.size(), kMaxCellBytes >> 20),
                   job_.output.string()};
    }
    files_.push_back({job_.output, std::move(text)});
    return Status{};
  }

  void nameLossesOfStl(const PosedPart& part) {
    const bool is_pictured = !part.material.diffuse_map.empty();
    if (is_pictured) loseInStl("texture");
    if (part.tinted) loseInStl("vertex colour");
    if (!is_pictured && !part.tinted && part.material.diffuse != Material().diffuse) {
      loseInStl("colour");
    }
  }
  void loseInStl(std::string_view kind) {
    report_.left_out.leaveOut({.kind = std::string(kind), .reason = "STL has only triangles"});
  }

  // The group of each link, empty without geometry.
  std::vector<std::string> addGroups(const PosedDevice& device, const std::string& before,
                                     bool shown_only) {
    std::vector<std::string> groups(device.model->links.size());
    forEachPart(device, shown_only, [&](const PosedPart& part) {
      std::string& group = groups[part.link];
      if (group.empty()) {
        group = groups_.of(before + device.model->links[part.link].name);
        obj_.beginGroup(group);
      }
      obj_.add(part);
    });
    return groups;
  }

  Status addObj(const fs::path& path) {
    if (obj_.triangles() == 0) return nothing();
    report_.triangles = obj_.triangles();
    report_.left_out.add(obj_.leftOut());
    for (const ObjWriter::Picture& picture : obj_.textures()) {
      if (picture.bytes) {
        files_.push_back({folder_ / picture.name, std::string(textOf(*picture.bytes))});
        continue;
      }
      auto bytes = readFile(picture.file, kMaxTextureBytes);
      if (!bytes.ok()) return bytes.error();
      files_.push_back({folder_ / picture.name, std::move(*bytes)});
    }
    files_.push_back({folder_ / (plain(stem_) + ".mtl"), obj_.mtlText()});
    files_.push_back({path, obj_.objText()});
    return Status{};
  }

  Error nothing() const {
    return {ErrorKind::unsupported, "no geometry to write", cell_.shown(cell_.file)};
  }

  const Cell& cell_;
  const ConvertJob& job_;
  fs::path folder_;
  std::string stem_;
  ObjWriter obj_;
  PlainNames groups_;
  std::vector<OutputFile> files_;
  ConvertReport report_;
};

}  // namespace

Result<ConvertReport> convertModel(const Cell& cell, const ConvertJob& job) {
  const Result<Form> form = formOf(job.output);
  if (!form) return form.error();
  return Conversion(cell, job).run(*form);
}

}  // namespace rocinante
