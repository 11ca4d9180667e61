#include "core/kinematics/model_draft.h"

#include <fmt/format.h>

#include <numeric>
#include <string_view>

#include "core/base/figure_text.h"
#include "core/base/name_hint.h"
#include "core/document/fault_list.h"

namespace rocinante {
namespace {

using Index = std::map<std::string, std::size_t, std::less<>>;

std::string hintFrom(std::string_view name, const Index& known, const FaultList& faults,
                     std::string_view rule) {
  if (!faults.lists(rule)) return {};
  std::vector<std::string_view> names;
  names.reserve(known.size());
  for (const auto& [key, place] : known) names.push_back(key);
  return didYouMean(name, names);
}

// Sets of links that joints have joined so far.
class JoinedLinks {
 public:
  explicit JoinedLinks(std::size_t count) : above_(count) {
    std::iota(above_.begin(), above_.end(), std::size_t{0});
  }
  std::size_t setOf(std::size_t link) {
    while (above_[link] != link) {
      above_[link] = above_[above_[link]];
      link = above_[link];
    }
    return link;
  }
  void join(std::size_t a, std::size_t b) { above_[setOf(b)] = setOf(a); }

 private:
  std::vector<std::size_t> above_;
};

class TreeBuilder {
 public:
  TreeBuilder(ModelDraft&& draft, FaultList& faults) : draft_(std::move(draft)), faults_(faults) {}

  std::optional<Model> build() {
    model_.name = std::move(draft_.name);
    model_.file = std::move(draft_.file);
    addLinks();
    if (model_.links.empty()) {
      faults_.error(rule("no-link"), draft_.place, "the model has no link");
      return std::nullopt;
    }
    addJoints();
    addMimics();
    orderFromRoots();
    return std::move(model_);
  }

 private:
  std::string rule(std::string_view name) const { return fmt::format("{}.{}", draft_.rules, name); }

  void addLinks() {
    for (LinkDraft& link : draft_.links) {
      if (!model_.link_by_name.emplace(link.link.name, model_.links.size()).second) {
        faults_.error(rule("duplicate-link"), link.place,
                      fmt::format("a second link is named {}", quotedInFault(link.link.name)),
                      "the first one is used");
        continue;
      }
      model_.links.push_back(std::move(link.link));
      link_places_.push_back(link.place);
    }
  }

  std::optional<std::size_t> linkNamed(const std::string& name, Place place,
                                       const JointDraft& joint, std::string_view role) {
    if (const auto found = model_.findLink(name)) return found;
    faults_.error(rule("unknown-link"), place,
                  fmt::format("the {} of joint {} is {}, which is not a link", role,
                              quotedInFault(joint.joint.name), quotedInFault(name)),
                  hintFrom(name, model_.link_by_name, faults_, rule("unknown-link")));
    return std::nullopt;
  }

  void addJoints() {
    JoinedLinks joined(model_.links.size());
    for (std::size_t i = 0; i < draft_.joints.size(); ++i) {
      JointDraft& joint = draft_.joints[i];
      const auto parent = linkNamed(joint.parent, joint.parent_place, joint, "parent");
      const auto child = linkNamed(joint.child, joint.child_place, joint, "child");
      if (!parent || !child) continue;
      const std::string name = quotedInFault(joint.joint.name);
      if (model_.joint_by_name.contains(joint.joint.name)) {
        faults_.error(rule("duplicate-joint"), joint.place,
                      fmt::format("a second joint is named {}", name), "the first one is used");
        continue;
      }
      if (const auto other = model_.links[*child].parent_joint) {
        faults_.error(
            rule("two-parents"), joint.place,
            fmt::format("joint {} gives link {} a second parent; joint {} is its first", name,
                        quotedInFault(joint.child), quotedInFault(model_.joints[*other].name)),
            "a link has one parent joint");
        continue;
      }
      if (joined.setOf(*parent) == joined.setOf(*child)) {
        faults_.error(rule("joint-loop"), joint.place, fmt::format("joint {} closes a loop", name),
                      "links must form a tree");
        continue;
      }
      joined.join(*parent, *child);
      joint.joint.parent = *parent;
      joint.joint.child = *child;
      model_.links[*child].parent_joint = model_.joints.size();
      model_.joint_by_name.emplace(joint.joint.name, model_.joints.size());
      draft_of_.push_back(i);
      model_.joints.push_back(std::move(joint.joint));
    }
  }

  void addMimics() {
    for (std::size_t i = 0; i < model_.joints.size(); ++i) {
      const auto& draft = draft_.joints[draft_of_[i]].mimic;
      if (!draft) continue;
      const std::string name = quotedInFault(model_.joints[i].name);
      const auto followed = model_.findJoint(draft->joint);
      if (!followed) {
        faults_.error(rule("unknown-mimic"), draft->place,
                      fmt::format("joint {} mimics {}, which is not a joint", name,
                                  quotedInFault(draft->joint)),
                      hintFrom(draft->joint, model_.joint_by_name, faults_, rule("unknown-mimic")));
      } else if (valueCount(model_.joints[i].type) != 1 ||
                 valueCount(model_.joints[*followed].type) != 1) {
        faults_.error(
            rule("bad-mimic"), draft->place,
            fmt::format("joint {} ({}) cannot mimic {} ({})", name, nameOf(model_.joints[i].type),
                        quotedInFault(draft->joint), nameOf(model_.joints[*followed].type)),
            "both must have one value: revolute, continuous or prismatic");
      } else {
        model_.joints[i].mimic = Mimic{*followed, draft->multiplier, draft->offset};
      }
    }
    breakMimicLoops();
  }

  // Follows each chain once; `turn` marks what this walk has passed.
  void breakMimicLoops() {
    std::vector<std::size_t> turn(model_.joints.size(), 0);
    for (std::size_t first = 0; first < model_.joints.size(); ++first) {
      std::size_t at = first;
      while (model_.joints[at].mimic && turn[at] == 0) {
        turn[at] = first + 1;
        at = model_.joints[at].mimic->joint;
      }
      if (!model_.joints[at].mimic || turn[at] != first + 1) continue;
      faults_.error(rule("mimic-loop"), draft_.joints[draft_of_[at]].mimic->place,
                    fmt::format("joint {} mimics itself, directly or through others",
                                quotedInFault(model_.joints[at].name)),
                    "it is taken as driven");
      model_.joints[at].mimic.reset();
    }
  }

  void orderFromRoots() {
    std::vector<std::vector<std::size_t>> below(model_.links.size());
    for (std::size_t i = 0; i < model_.joints.size(); ++i) {
      below[model_.joints[i].parent].push_back(i);
    }
    std::optional<std::size_t> root;
    std::vector<std::size_t> reached;
    for (std::size_t i = 0; i < model_.links.size(); ++i) {
      if (model_.links[i].parent_joint) continue;
      reached.push_back(i);
      if (!root) {
        root = i;
        continue;
      }
      if (draft_.several_roots) continue;
      faults_.error(
          rule("two-roots"), link_places_[i],
          fmt::format("link {} has no parent joint, and neither has {}",
                      quotedInFault(model_.links[i].name), quotedInFault(model_.links[*root].name)),
          "connect it with a joint; it is drawn at the model's origin");
    }
    model_.root = root.value_or(0);
    for (std::size_t next = 0; next < reached.size(); ++next) {
      for (const std::size_t joint : below[reached[next]]) {
        model_.update_order.push_back(joint);
        reached.push_back(model_.joints[joint].child);
      }
    }
  }

  ModelDraft draft_;
  FaultList& faults_;
  Model model_;
  std::vector<Place> link_places_;
  std::vector<std::size_t> draft_of_;  // by joint of the model
};

}  // namespace

void judgeVisibility(const Model& model, Place place, FaultList& faults) {
  std::uint64_t with_collisions = 0;
  for (const Link& link : model.links) {
    if (!link.visuals.empty()) return;
    with_collisions += link.collisions.empty() ? 0 : 1;
  }
  if (with_collisions == 0) return;
  faults.warning("model.no-visual", place,
                 fmt::format("nothing of the model is drawn: {} collision geometry, and none has a "
                             "<visual>",
                             with_collisions == 1 ? std::string("1 link has")
                                                  : countText(with_collisions, "link") + " have"),
                 "to see it: render --collision '*', C in the window, or collision = \"only\" in a "
                 "[[layer]] of a cell");
}

std::optional<Model> finishModel(ModelDraft&& draft, FaultList& faults) {
  return TreeBuilder(std::move(draft), faults).build();
}

}  // namespace rocinante
