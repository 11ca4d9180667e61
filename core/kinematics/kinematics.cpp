#include "core/kinematics/kinematics.h"

#include <bit>
#include <cmath>

#include "core/base/hash.h"
#include "core/math/transform.h"

namespace rocinante {
namespace {

// x and y of a plane with normal n: right-handed, and the world's own for the three axes
// (n = z: x y; n = x: y z; n = y: z x).
struct Plane {
  Vec3 x, y;
};

Plane planeOf(const Vec3& n) {
  const Vec3 size{std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)};
  Vec3 beside{0, 1, 0};
  if (size.x > size.z && size.x >= size.y) beside = {0, 0, 1};
  if (size.y > size.z && size.y > size.x) beside = {1, 0, 0};
  const Vec3 x = normalized(crossOf(beside, n)).value_or(Vec3{1, 0, 0});
  return {x, crossOf(n, x)};
}

Mat4 motionOf(const Joint& joint, const double* q) {
  switch (joint.type) {
    case JointType::fixed:
      return Mat4{1.0};
    case JointType::revolute:
    case JointType::continuous:
      return rotationMatrix(quaternionAbout(joint.axis, q[0]));
    case JointType::prismatic:
      return translationMatrix({joint.axis.x * q[0], joint.axis.y * q[0], joint.axis.z * q[0]});
    case JointType::planar: {
      const Plane plane = planeOf(joint.axis);
      Mat4 motion = rotationMatrix(quaternionAbout(joint.axis, q[2]));
      motion[3] = Vec4(plane.x * q[0] + plane.y * q[1], 1.0);
      return motion;
    }
    case JointType::floating: {
      const Quat given{q[6], q[3], q[4], q[5]};
      return matrixOf({{q[0], q[1], q[2]}, normalized(given).value_or(Quat{1, 0, 0, 0})});
    }
  }
  return Mat4{1.0};
}

void addText(std::string& text, std::string_view word) {
  text += std::to_string(word.size());
  text += ':';
  text += word;
}

void addNumber(std::string& text, double number) {
  const auto bits = std::bit_cast<std::uint64_t>(number == 0.0 ? 0.0 : number);
  for (int shift = 56; shift >= 0; shift -= 8) text += static_cast<char>(bits >> shift & 0xFF);
}

void addNumber(std::string& text, const std::optional<double>& number) {
  text += number ? 'n' : '-';
  if (number) addNumber(text, *number);
}

}  // namespace

JointVector zeroJoints(const Model& model) {
  JointVector zero;
  zero.first_value.reserve(model.joints.size());
  zero.values.reserve(model.joints.size());
  for (const Joint& joint : model.joints) {
    zero.first_value.push_back(zero.values.size());
    zero.values.resize(zero.values.size() + valueCount(joint.type), 0.0);
    if (joint.type == JointType::floating) zero.values.back() = 1.0;
  }
  applyMimics(model, zero);
  return zero;
}

void applyMimics(const Model& model, JointVector& joints) {
  // A joint may follow one that follows another: each chain is walked to its driven joint once,
  // then back. Readers leave no loops.
  std::vector<bool> done(model.joints.size(), false);
  std::vector<std::size_t> chain;
  for (std::size_t first = 0; first < model.joints.size(); ++first) {
    std::size_t at = first;
    while (model.joints[at].mimic && !done[at] && chain.size() < model.joints.size()) {
      chain.push_back(at);
      at = model.joints[at].mimic->joint;
    }
    for (; !chain.empty(); chain.pop_back()) {
      const std::size_t follower = chain.back();
      const Mimic& mimic = *model.joints[follower].mimic;
      joints.values[joints.first_value[follower]] =
          mimic.multiplier * joints.values[joints.first_value[mimic.joint]] + mimic.offset;
      done[follower] = true;
    }
  }
}

std::vector<Mat4> linkPoses(const Model& model, const JointVector& joints) {
  std::vector<Mat4> poses(model.links.size(), Mat4{1.0});
  for (const std::size_t i : model.update_order) {
    const Joint& joint = model.joints[i];
    const double* values = joints.values.data() + joints.first_value[i];
    poses[joint.child] = poses[joint.parent] * matrixOf(joint.origin) * motionOf(joint, values);
  }
  return poses;
}

std::uint64_t kinematicsHash(const Model& model) {
  std::string text = "rocinante kinematics 1\n";
  for (const Joint& joint : model.joints) {
    addText(text, joint.name);
    addText(text, nameOf(joint.type));
    addText(text, model.links[joint.parent].name);
    addText(text, model.links[joint.child].name);
    const Vec3& at = joint.origin.position;
    const Quat& turn = joint.origin.orientation;
    for (const double number : {at.x, at.y, at.z, turn.x, turn.y, turn.z, turn.w}) {
      addNumber(text, number);
    }
    if (joint.type != JointType::fixed && joint.type != JointType::floating) {
      for (const double number : {joint.axis.x, joint.axis.y, joint.axis.z}) {
        addNumber(text, number);
      }
    }
    text += joint.limits ? 'l' : '-';
    if (joint.limits) {
      addNumber(text, joint.limits->lower);
      addNumber(text, joint.limits->upper);
      addNumber(text, joint.limits->velocity);
      addNumber(text, joint.limits->effort);
    }
    text += joint.mimic ? 'm' : '-';
    if (joint.mimic) {
      addText(text, model.joints[joint.mimic->joint].name);
      addNumber(text, joint.mimic->multiplier);
      addNumber(text, joint.mimic->offset);
    }
  }
  std::uint64_t hash = 0;
  const auto digest = xxh3(bytesOf(text));
  for (std::size_t i = 0; i < 8; ++i) {
    hash = hash << 8 | static_cast<std::uint64_t>(digest[i]);
  }
  return hash;
}

}  // namespace rocinante
