// An MCAP file with every message decoded by the schema that the file has, as Foxglove, Lichtblick
// and others do it: protobufjs on the descriptors, @foxglove/rosmsg on the definitions.
import { open } from "node:fs/promises";
import { McapIndexedReader } from "@mcap/core";
import nodejs from "@mcap/nodejs";
import { loadDecompressHandlers } from "@mcap/support";
import protobuf from "protobufjs";
import descriptor from "protobufjs/ext/descriptor/index.js";
import rosmsg from "@foxglove/rosmsg";
import cdr from "@foxglove/rosmsg2-serialization";

export function demand(holds, sentence) {
  if (!holds) throw new Error(sentence);
}

// Protobuf's numbers are exact, and so are the strings in place of 64-bit integers.
const kPlain = { longs: String, enums: String, defaults: true, arrays: true };

function protobufReader(schema) {
  const set = descriptor.FileDescriptorSet.decode(schema.data);
  const root = protobuf.Root.fromDescriptor(set);
  root.resolveAll();
  const type = root.lookupType(schema.name);
  return { root, read: (data) => type.toObject(type.decode(data), kPlain) };
}

function cdrReader(schema) {
  const definitions = rosmsg.parse(new TextDecoder().decode(schema.data), { ros2: true });
  const reader = new cdr.MessageReader(definitions);
  return { definitions, read: (data) => reader.readMessage(data) };
}

// A message has what its schema names, of the type that it names.
function jsonReader(schema) {
  demand(schema.encoding === "jsonschema", `${schema.name} is ${schema.encoding}`);
  const root = JSON.parse(new TextDecoder().decode(schema.data));
  const hold = (value, type, place) => {
    demand(type !== undefined && typeof value === type.type, `${place} is ${typeof value}, not ${type?.type}`);
    if (type.type !== "object") return;
    for (const [key, each] of Object.entries(value)) hold(each, type.properties[key], `${place}.${key}`);
  };
  return {
    root: { lookupType: () => { throw new Error("no protobuf"); } },
    read: (data) => {
      const value = JSON.parse(new TextDecoder().decode(data));
      hold(value, root, schema.name);
      return value;
    },
  };
}

// { profile, topics: Map(topic -> { schema, messages: [{ logTime, value }] }), attachments, raw }
export async function decodedMcap(path) {
  const file = await open(path, "r");
  try {
    const reader = await McapIndexedReader.Initialize({
      readable: new nodejs.FileHandleReadable(file),
      decompressHandlers: await loadDecompressHandlers(),
    });
    const readers = new Map();
    const topics = new Map();
    const raw = [];
    let last = 0n;
    for await (const message of reader.readMessages()) {
      demand(message.logTime >= last, `${path}: not in order of time`);
      last = message.logTime;
      const channel = reader.channelsById.get(message.channelId);
      if (channel.schemaId === 0) {
        raw.push({ topic: channel.topic, encoding: channel.messageEncoding, logTime: message.logTime });
        continue;
      }
      const schema = reader.schemasById.get(channel.schemaId);
      if (!readers.has(schema.id)) {
        const make = { protobuf: protobufReader, cdr: cdrReader, json: jsonReader }[channel.messageEncoding];
        demand(make !== undefined, `unknown ${channel.messageEncoding}`);
        readers.set(schema.id, make(schema));
      }
      if (!topics.has(channel.topic)) {
        topics.set(channel.topic, { schema, reader: readers.get(schema.id), messages: [] });
      }
      const value = readers.get(schema.id).read(message.data);
      topics.get(channel.topic).messages.push({ logTime: message.logTime, value });
    }
    const attachments = [];
    for await (const each of reader.readAttachments()) attachments.push(each);
    return { profile: reader.header.profile, topics, attachments, raw };
  } finally {
    await file.close();
  }
}

// The last message of a topic at or before a moment; undefined: none.
export function lastAt(topic, moment) {
  return topic.messages.findLast((message) => message.logTime <= moment);
}

const times = (a, b) => ({
  x: a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
  y: a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x,
  z: a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w,
  w: a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z,
});

function turned(q, v) {
  const t = times(times(q, { ...v, w: 0 }), { x: -q.x, y: -q.y, z: -q.z, w: q.w });
  return { x: t.x, y: t.y, z: t.z };
}

// The pose of a space in `world`, from {child: {parent, translation, rotation}}.
export function inWorld(frames, name) {
  let pose = { position: { x: 0, y: 0, z: 0 }, rotation: { x: 0, y: 0, z: 0, w: 1 } };
  for (let steps = 0; name !== "world"; ++steps) {
    const frame = frames.get(name);
    demand(frame !== undefined && steps < 1000, `no way from ${name} to the world`);
    const moved = turned(frame.rotation, pose.position);
    pose = {
      position: {
        x: moved.x + frame.translation.x,
        y: moved.y + frame.translation.y,
        z: moved.z + frame.translation.z,
      },
      rotation: times(frame.rotation, pose.rotation),
    };
    name = frame.parent;
  }
  return pose;
}

// The largest difference of a pose and what `model fk --json` says of the link.
export function differenceTo(pose, fk) {
  const q = [pose.rotation.x, pose.rotation.y, pose.rotation.z, pose.rotation.w];
  const sign = q.reduce((sum, part, i) => sum + part * fk.quaternion[i], 0) < 0 ? -1 : 1;
  const parts = [
    pose.position.x - fk.xyz[0], pose.position.y - fk.xyz[1], pose.position.z - fk.xyz[2],
    ...q.map((part, i) => sign * part - fk.quaternion[i]),
  ];
  return Math.max(...parts.map(Math.abs));
}
