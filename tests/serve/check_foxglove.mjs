// Foxglove's own client subscribes to every channel of a live session; its transforms, composed, are
// the poses of `rocinante model fk`, and every message decodes by the schema that was advertised.
// usage: node check_foxglove.mjs PORT FK.json
import assert from "node:assert/strict";
import fs from "node:fs";
import protocol from "@foxglove/ws-protocol";
import { protobufFromBinaryDescriptor } from "@mcap/support";
import WebSocket from "ws";

const { FoxgloveClient } = protocol;

const [, , port, fk_file] = process.argv;
const fk = JSON.parse(fs.readFileSync(fk_file, "utf8"));
delete fk.format;

const client = new FoxgloveClient({
  ws: new WebSocket(`ws://127.0.0.1:${port}/`, [FoxgloveClient.SUPPORTED_SUBPROTOCOL]),
});
const channels = new Map();  // by subscription
const newest = new Map();    // by topic: the decoded message
const frames = new Map();    // by child: {parent, translation, rotation}
const said = [];
client.on("serverInfo", (info) => said.push(info.name));
client.on("status", (status) => said.push(status.message));
client.on("advertise", (list) => {
  for (const channel of list) {
    if (channel.encoding === "json") {
      assert.equal(channel.schemaEncoding, "jsonschema");
      assert.equal(JSON.parse(channel.schema).type, "object");
      const type = { decode: (bytes) => JSON.parse(new TextDecoder().decode(bytes)) };
      channels.set(client.subscribe(channel.id), { id: channel.id, topic: channel.topic, type });
      continue;
    }
    assert.equal(channel.encoding, "protobuf");
    const schema = protobufFromBinaryDescriptor(Buffer.from(channel.schema, "base64"));
    channels.set(client.subscribe(channel.id), { id: channel.id, topic: channel.topic, type: schema.lookupType(channel.schemaName) });
  }
});

// A channel of signals has another one's topic when there are more of them.
client.on("unadvertise", (ids) => {
  for (const [subscription, { id }] of channels) {
    if (!ids.includes(id)) continue;
    client.unsubscribe(subscription);
    channels.delete(subscription);
  }
});

// Quaternions as [x, y, z, w].
const times = (a, b) => [
  a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
  a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2]];
const turned = (q, v) => times(times(q, [...v, 0]), [-q[0], -q[1], -q[2], q[3]]).slice(0, 3);
function inWorld(name) {
  if (name === "world") return { xyz: [0, 0, 0], quaternion: [0, 0, 0, 1] };
  const frame = frames.get(name);
  assert.ok(frame, "there is no frame " + name);
  const parent = inWorld(frame.parent);
  return {
    xyz: turned(parent.quaternion, frame.xyz).map((each, i) => each + parent.xyz[i]),
    quaternion: times(parent.quaternion, frame.quaternion),
  };
}
// The largest difference of a number; q and -q are the same turn.
function difference(a, b) {
  const far = (x, y, sign) => Math.max(...x.map((each, i) => Math.abs(each - sign * y[i])));
  return Math.max(far(a.xyz, b.xyz, 1), Math.min(far(a.quaternion, b.quaternion, 1), far(a.quaternion, b.quaternion, -1)));
}
function worst() {
  return Math.max(...Object.keys(fk).map((name) => frames.has(name) ? difference(inWorld(name), fk[name]) : Infinity));
}

const done = new Promise((resolve, reject) => {
  client.on("error", reject);
  client.on("close", () => reject(new Error("the server has closed: " + said.join("; "))));
  client.on("message", ({ subscriptionId, data }) => {
    const { topic, type } = channels.get(subscriptionId);
    const message = type.decode(new Uint8Array(data.buffer, data.byteOffset, data.byteLength));
    newest.set(topic, message);
    if (topic.startsWith("/tf/")) {
      for (const each of message.transforms) {
        const { x, y, z } = each.translation, r = each.rotation;
        frames.set(each.child_frame_id, { parent: each.parent_frame_id, xyz: [x, y, z], quaternion: [r.x, r.y, r.z, r.w] });
      }
    }
    if (newest.size === channels.size && worst() <= 1e-9) resolve();
  });
  setTimeout(() => reject(new Error(`the transforms are not those of fk after 30 s: ${worst()}`)), 30000).unref();
});
await done;
assert.deepEqual(said.length, 1, said.join("; "));
assert.equal(newest.get("/signals/arm").load, 2.5);
console.log(`serve: ${channels.size} channels of ${said[0]}, ${Object.keys(fk).length} links, largest difference ${worst().toExponential(1)}`);
process.exit(0);
