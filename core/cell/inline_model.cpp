#include "core/cell/inline_model.h"

#include <fmt/format.h>

#include <array>

#include "core/base/name_hint.h"
#include "core/base/pattern.h"
#include "core/document/fault_list.h"
#include "core/kinematics/kinematics.h"
#include "core/kinematics/model_draft.h"
#include "core/math/transform.h"
#include "core/math/trigonometry.h"

namespace rocinante {
namespace {

struct Unit {
  std::string_view name;
  double metres;
};
constexpr std::array<Unit, 5> kUnits = {
    {{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}, {"ft", 0.3048}}};

std::optional<double> readUnit(TomlTable& table) {
  const TomlNode* given = table.node("unit");
  if (given == nullptr) {
    table.error("cell.missing-key", "unit", fmt::format("{} lacks `unit`", table.what()),
                "OBJ and STL files state none: \"m\", \"cm\", \"mm\", \"in\", \"ft\", or metres");
    return std::nullopt;
  }
  if (given->kind != TomlNode::Kind::text) {
    const auto metres = table.number("unit");
    if (metres && *metres > 0.0 && *metres < 1e9) return metres;
    if (metres) {
      table.error("cell.bad-number", "unit",
                  fmt::format("`unit` of {} must be above 0 and below 1e9", table.what()));
    }
    return std::nullopt;
  }
  for (const Unit& unit : kUnits) {
    if (unit.name == given->text) return unit.metres;
  }
  table.error("cell.unknown-word", "unit",
              fmt::format("{} is not a unit", quotedInFault(given->text)),
              "units are \"m\", \"cm\", \"mm\", \"in\", \"ft\", or a number of metres");
  return std::nullopt;
}

std::optional<UpAxis> readUp(TomlTable& table) {
  if (!table.has("up")) {
    static_cast<void>(table.node("up"));
    table.error("cell.missing-key", "up", fmt::format("{} lacks `up`", table.what()),
                "OBJ and STL do not say which axis points up: \"y\" or \"z\"");
    return std::nullopt;
  }
  const auto up = table.text("up");
  if (!up) return std::nullopt;
  if (*up == "y") return UpAxis::y;
  if (*up == "z") return UpAxis::z;
  table.error("cell.unknown-word", "up", fmt::format("{} is not an up axis", quotedInFault(*up)),
              "\"y\" or \"z\"");
  return std::nullopt;
}

// Comparisons of a group with a pattern, of one model.
constexpr std::size_t kMaxMatches = 100'000'000;

// The parts of the mesh that each link takes.
struct LinkGroups {
  std::string link;
  std::vector<std::string> patterns;
  Place place;
  bool takes_the_rest = false;
};

class InlineModelReader {
 public:
  InlineModelReader(TomlTable& table, const std::string& name, const std::filesystem::path& folder,
                    MeshStore& meshes)
      : table_(table), name_(name), folder_(folder), meshes_(meshes) {}

  std::shared_ptr<const Model> read() {
    const char* kind = table_.has("obj") ? "obj" : table_.has("stl") ? "stl" : "mesh";
    const auto file = table_.requiredText(kind);
    std::optional<double> unit = 1.0;
    std::optional<UpAxis> up = UpAxis::z;
    if (!file || !statesUnit(*file)) {
      unit = readUnit(table_);
      up = readUp(table_);
    } else {
      refuseUnit();
    }
    const bool in_world = readGeometry();
    readLinks();
    table_.finish();
    if (!file) return nullptr;
    std::shared_ptr<const Mesh> mesh;
    if (unit && up) {
      mesh = meshes_.load(*file, folder_, *unit, *up, table_.place(kind), table_.faults());
    }
    draft_.file = *file;
    auto model = finishModel(std::move(draft_), table_.faults());
    if (!model) return nullptr;
    if (mesh) {
      shareOut(*model, mesh, in_world);
    } else {
      model->links[model->root].visuals.emplace_back().name = "missing";
    }
    return std::make_shared<const Model>(std::move(*model));
  }

 private:
  void refuseUnit() {
    for (const char* key : {"unit", "up"}) {
      if (table_.node(key) == nullptr) continue;
      table_.error(
          "cell.useless-unit", key,
          fmt::format("`{}` has no effect: the file states its own unit and up axis", key));
    }
  }

  bool readGeometry() {
    const auto geometry = table_.text("geometry");
    if (!geometry || *geometry == "world") return true;
    if (*geometry == "link") return false;
    table_.error("cell.unknown-word", "geometry",
                 fmt::format("{} is not a kind of geometry", quotedInFault(*geometry)),
                 "\"world\" (as assembled at zero joints) or \"link\" (each in its link's space)");
    return true;
  }

  void readLinks() {
    draft_.name = name_;
    draft_.rules = "cell";
    draft_.place = table_.place();
    std::vector<TomlTable> links = table_.tables("link", "[[model.link]]");
    if (links.size() > kMaxLinks) {
      table_.error("cell.too-many", "link", fmt::format("a model has at most {} links", kMaxLinks));
      links.clear();
    }
    bool root_written = false;
    for (TomlTable& link : links) root_written = root_written || !link.has("parent");
    if (!root_written) {
      LinkDraft base;
      base.link.name = "base";
      base.place = table_.place();
      draft_.links.push_back(std::move(base));
      groups_.push_back({"base", {}, table_.place(), true});
    }
    for (TomlTable& link : links) readLink(link);
  }

  void readLink(TomlTable& link) {
    const auto name = link.requiredText("name");
    const auto parent = link.text("parent");
    const bool has_groups = link.has("groups");
    LinkGroups groups{name.value_or(""), link.texts("groups"), link.place("groups"), false};
    groups.takes_the_rest = !parent && !has_groups;
    auto joint = link.table("joint", "joint");
    if (parent && !link.has("joint")) {
      link.error(
          "cell.missing-key", "joint",
          fmt::format("{} {} has a parent but no `joint`", link.what(), quotedInFault(groups.link)),
          "joint = { name = \"...\", type = \"fixed\" } holds it in place");
    }
    if (joint && !link.has("parent")) {
      link.error(
          "cell.missing-key", "parent",
          fmt::format("{} {} has a joint but no `parent`", link.what(), quotedInFault(groups.link)),
          "the link without a parent is the root and needs no joint");
    }
    if (joint) {
      auto draft = readInlineJoint(*joint, parent.value_or(""), groups.link);
      if (draft && name && parent) {
        draft->parent_place = link.place("parent");
        draft->child_place = link.place("name");
        draft_.joints.push_back(std::move(*draft));
      }
    }
    link.finish();
    if (!name) return;
    LinkDraft draft;
    draft.link.name = *name;
    draft.place = link.place("name");
    draft_.links.push_back(std::move(draft));
    groups_.push_back(std::move(groups));
  }

  // Gives each link its parts of the mesh.
  void shareOut(Model& model, const std::shared_ptr<const Mesh>& mesh, bool in_world) {
    const std::vector<Mat4> zero = linkPoses(model, zeroJoints(model));
    std::vector<std::vector<std::size_t>> taken(groups_.size());
    std::vector<std::size_t> rest;
    std::vector<std::vector<bool>> matched(groups_.size());
    if (mesh->parts.size() * patternCount() > kMaxMatches) {
      table_.error("cell.too-many", "link",
                   fmt::format("{} groups and {} patterns are too many to compare",
                               mesh->parts.size(), patternCount()));
      return;
    }
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      matched[i].resize(groups_[i].patterns.size(), false);
    }
    for (std::size_t part = 0; part < mesh->parts.size(); ++part) {
      std::optional<std::size_t> owner;
      for (std::size_t i = 0; i < groups_.size(); ++i) {
        if (!claims(groups_[i], matched[i], mesh->parts[part].group)) continue;
        if (!owner) {
          owner = i;
          taken[i].push_back(part);
        } else {
          warnOfTwo(mesh->parts[part].group, groups_[*owner], groups_[i]);
        }
      }
      if (!owner) rest.push_back(part);
    }
    reportUnmatched(matched, *mesh);
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      if (groups_[i].takes_the_rest) {
        taken[i] = rest;
        rest.clear();
      }
      addVisual(model, groups_[i], std::move(taken[i]), mesh, in_world, zero);
    }
    if (!rest.empty()) {
      table_.faults().warning(
          "cell.unused-group", table_.place(),
          fmt::format("no link takes group {}, which is not drawn",
                      quotedInFault(mesh->parts[rest.front()].group)),
          "add it to the `groups` of a link, or leave them out of the root, which then takes all");
    }
  }

  std::size_t patternCount() const {
    std::size_t count = 0;
    for (const LinkGroups& groups : groups_) count += groups.patterns.size() + 1;
    return count;
  }

  static bool claims(const LinkGroups& groups, std::vector<bool>& matched, std::string_view group) {
    bool claimed = false;
    for (std::size_t i = 0; i < groups.patterns.size(); ++i) {
      if (!patternMatches(groups.patterns[i], group)) continue;
      matched[i] = true;
      claimed = true;
    }
    return claimed;
  }

  void warnOfTwo(const std::string& group, const LinkGroups& first, const LinkGroups& second) {
    table_.faults().error("cell.group-taken-twice", second.place,
                          fmt::format("group {} belongs to links {} and {}", quotedInFault(group),
                                      quotedInFault(first.link), quotedInFault(second.link)),
                          "the first one keeps it");
  }

  void reportUnmatched(const std::vector<std::vector<bool>>& matched, const Mesh& mesh) {
    std::vector<std::string_view> names;
    for (const MeshPart& part : mesh.parts) names.push_back(part.group);
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      for (std::size_t k = 0; k < matched[i].size(); ++k) {
        if (matched[i][k]) continue;
        const bool listed = table_.faults().lists("cell.unknown-group");
        table_.faults().error(
            "cell.unknown-group", groups_[i].place,
            fmt::format("no group of the file is {}", quotedInFault(groups_[i].patterns[k])),
            listed ? didYouMean(groups_[i].patterns[k], names) : "");
      }
    }
  }

  static void addVisual(Model& model, const LinkGroups& groups, std::vector<std::size_t> parts,
                        const std::shared_ptr<const Mesh>& mesh, bool in_world,
                        const std::vector<Mat4>& zero) {
    const auto link = model.findLink(groups.link);
    if (!link || parts.empty()) return;
    Visual visual;
    visual.name = groups.link;
    visual.mesh = mesh;
    visual.mesh_parts = std::move(parts);
    if (in_world) visual.origin = poseOf(inverseOfRigid(zero[*link]));
    model.links[*link].visuals.push_back(std::move(visual));
  }

  TomlTable& table_;
  const std::string& name_;
  const std::filesystem::path& folder_;
  MeshStore& meshes_;
  ModelDraft draft_;
  std::vector<LinkGroups> groups_;
};

}  // namespace

std::shared_ptr<const Model> readInlineModel(TomlTable& table, const std::string& name,
                                             const std::filesystem::path& folder,
                                             MeshStore& meshes) {
  return InlineModelReader(table, name, folder, meshes).read();
}

std::vector<MeshWanted> meshesOfInlineModels(const TomlNode& document,
                                             const std::filesystem::path& folder) {
  std::vector<MeshWanted> wanted;
  for (const TomlNode::Entry& models : document.entries) {
    if (models.key != "model") continue;
    for (const TomlNode& model : models.value.items) {
      MeshWanted mesh;
      mesh.beside = folder;
      for (const TomlNode::Entry& entry : model.entries) {
        if (entry.key == "obj" || entry.key == "stl" || entry.key == "mesh")
          mesh.name = entry.value.text;
        if (entry.key == "up" && entry.value.text == "y") mesh.up = UpAxis::y;
        if (entry.key != "unit") continue;
        mesh.unit_m = entry.value.number;
        for (const Unit& unit : kUnits) {
          if (unit.name == entry.value.text) mesh.unit_m = unit.metres;
        }
      }
      if (!mesh.name.empty() && mesh.unit_m > 0) wanted.push_back(std::move(mesh));
    }
  }
  return wanted;
}

Model rigidModel(std::string name, std::string file, std::shared_ptr<const Mesh> mesh) {
  Model model;
  model.name = std::move(name);
  model.file = std::move(file);
  Link base;
  base.name = "base";
  if (mesh) {
    Visual visual;
    visual.name = "base";
    visual.mesh = std::move(mesh);
    base.visuals.push_back(std::move(visual));
  }
  model.links.push_back(std::move(base));
  model.link_by_name.emplace("base", 0);
  return model;
}

}  // namespace rocinante
