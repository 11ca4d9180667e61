// A .glb by Khronos' own validator, and its animation against `model fk`.
// usage: check_gltf.mjs FILE [FACTS DEVICE...]; the file has a key at each second of FACTS.
import assert from "node:assert";
import fs from "node:fs";
import validator from "gltf-validator";

const [file, facts, ...devices] = process.argv.slice(2);
const glb = fs.readFileSync(file);
const report = await validator.validateBytes(new Uint8Array(glb), { maxIssues: 100 });
for (const issue of report.issues.messages) {
  if (issue.severity < 2) console.error(`${issue.code} ${issue.pointer}: ${issue.message}`);
}
assert.equal(report.issues.numErrors, 0, "errors of the validator");
assert.equal(report.issues.numWarnings, 0, "warnings of the validator");
const { drawCallCount, totalTriangleCount, animationCount } = report.info;
console.log(`valid: ${animationCount} animation, ${drawCallCount} draw calls, ${totalTriangleCount} triangles`);
assert.ok(totalTriangleCount > 0);
if (facts === undefined) process.exit(0);

const text = glb.subarray(20, 20 + glb.readUInt32LE(12));
const json = JSON.parse(text.toString());
const bin = glb.subarray(20 + text.length + 8);
const floats = (accessor) => {
  const of = json.accessors[accessor];
  const width = { SCALAR: 1, VEC3: 3, VEC4: 4 }[of.type];
  const from = json.bufferViews[of.bufferView].byteOffset + (of.byteOffset ?? 0);
  return Array.from({ length: of.count * width }, (_, i) => bin.readFloatLE(from + 4 * i));
};
const channels = json.animations[0].channels.map(({ sampler, target }) => {
  const { input, output, interpolation } = json.animations[0].samplers[sampler];
  return { ...target, interpolation, times: floats(input), values: floats(output) };
});
/** A node's value at a time, as the specification blends it. */
const valueAt = (node, path, usual, time) => {
  const channel = channels.find((one) => one.node === node && one.path === path);
  if (!channel) return json.nodes[node][path] ?? usual;
  const width = usual.length;
  const key = (i) => channel.values.slice(i * width, (i + 1) * width);
  let after = channel.times.findIndex((one) => one > time);
  if (after === 0) return key(0);
  if (after < 0) return key(channel.times.length - 1);
  if (channel.interpolation === "STEP") return key(after - 1);
  const part = (time - channel.times[after - 1]) / (channel.times[after] - channel.times[after - 1]);
  const mixed = key(after - 1).map((a, i) => a + (key(after)[i] - a) * part);
  if (width === 3) return mixed;
  const length = Math.hypot(...mixed);
  return mixed.map((one) => one / length);
};
const matrixOf = ([x, y, z], [qx, qy, qz, qw], [sx, sy, sz]) => [
  [(1 - 2 * (qy * qy + qz * qz)) * sx, 2 * (qx * qy - qz * qw) * sy, 2 * (qx * qz + qy * qw) * sz, x],
  [2 * (qx * qy + qz * qw) * sx, (1 - 2 * (qx * qx + qz * qz)) * sy, 2 * (qy * qz - qx * qw) * sz, y],
  [2 * (qx * qz - qy * qw) * sx, 2 * (qy * qz + qx * qw) * sy, (1 - 2 * (qx * qx + qy * qy)) * sz, z],
  [0, 0, 0, 1],
];
const times = (a, b) => a.map((row) => [0, 1, 2, 3].map((c) => row.reduce((sum, one, i) => sum + one * b[i][c], 0)));
const parents = new Map();
json.nodes.forEach((node, i) => (node.children ?? []).forEach((child) => parents.set(child, i)));
/** In the session's own space: z up, without the node that turns it. */
const worldOf = (node, time) => {
  const own = matrixOf(
    valueAt(node, "translation", [0, 0, 0], time),
    valueAt(node, "rotation", [0, 0, 0, 1], time),
    valueAt(node, "scale", [1, 1, 1], time),
  );
  const parent = parents.get(node);
  return parent === undefined || json.nodes[parent].name === "world" ? own : times(worldOf(parent, time), own);
};
let compared = 0;
for (const device of devices) {
  for (const seconds of [0, 5, 11, 19]) {
    const fk = JSON.parse(fs.readFileSync(`${facts}/${device}.${seconds}.fk.json`));
    for (const [link, { xyz }] of Object.entries(fk)) {
      if (link === "format") continue;
      const node = json.nodes.findIndex((one) => one.name === `${device}/${link}`);
      assert.ok(node >= 0, `no node ${device}/${link}`);
      const world = worldOf(node, seconds);
      xyz.forEach((one, i) => assert.ok(Math.abs(world[i][3] - one) < 2e-6,
        `${device}/${link} at ${seconds} s is at ${world[i][3]}, not ${one}`));
      compared += 1;
    }
  }
}
assert.ok(compared > 20, `only ${compared} links were compared`);
console.log(`${compared} places of links are those of model fk`);
