// Writes logs with @mcap/core for Rocinante to read, each with what stands in it.
// usage: node write_theirs.mjs FOLDER
import { appendFileSync, copyFileSync, writeFileSync } from "node:fs";
import { open } from "node:fs/promises";
import { createRequire } from "node:module";
import { McapWriter } from "@mcap/core";
import nodejs from "@mcap/nodejs";
import { notedMessages } from "./messages.mjs";

const zstd = createRequire(import.meta.url)("@foxglove/wasm-zstd");
await zstd.isLoaded;

const folder = process.argv[2];
const start = 1_770_000_000_000_000_000n;
const compressChunk = (data) => ({ compression: "zstd", compressedData: zstd.compress(data, 1) });

// The same numbers every time.
let state = 7;
const random = (below) => {
  state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
  return state % below;
};

async function addMessages(writer, channels, count, from, jitter, notes) {
  const sequences = channels.map(() => 0);
  for (let i = 0; i < count; ++i) {
    const which = random(channels.length);
    const logTime = from + BigInt(i % 10 === 9 ? i - 1 : i) * 1_000_000n +
      (jitter === 0 ? 0n : BigInt(random(2 * jitter) - jitter));
    const text = i % 997 === 0 ? "" : `{"joints":[${random(1000)},${random(1000)},"µ"]}`;
    const data = i % 499 === 1 ? new Uint8Array(random(30_000)).map(() => random(256))
      : new TextEncoder().encode(text);
    const sequence = sequences[which]++;
    const publishTime = logTime - 1000n;
    await writer.addMessage({ channelId: channels[which].id, sequence, logTime, publishTime, data });
    notes.push(JSON.stringify({
      topic: channels[which].topic, sequence, log_time: logTime.toString(),
      publish_time: publishTime.toString(), payload: Buffer.from(data).toString("base64"),
    }));
  }
}

async function registered(writer, count, encoding) {
  const schemaId = encoding !== "json" ? 0 : await writer.registerSchema({
    name: "state", encoding: "jsonschema", data: new TextEncoder().encode("{}"),
  });
  const channels = [];
  for (let i = 0; i < count; ++i) {
    const topic = `/theirs/${i}`;
    const id = await writer.registerChannel({
      schemaId, topic, messageEncoding: encoding, metadata: new Map([["number", String(i)]]),
    });
    channels.push({ id, topic });
  }
  return channels;
}

async function write(name, count, { channels, jitter = 0, encoding, options = {}, extras = 0 }) {
  const file = await open(`${folder}/${name}.mcap`, "w");
  const writer = new McapWriter({
    writable: new nodejs.FileHandleWritable(file), chunkSize: 1 << 16, compressChunk, ...options,
  });
  await writer.start({ profile: "", library: "interop" });
  const notes = [];
  const made = await registered(writer, channels, encoding);
  await addMessages(writer, made, count / 2, start, jitter, notes);
  for (let i = 0; i < extras; ++i) {
    await writer.addAttachment({
      name: `files/${i}.bin`, mediaType: "application/octet-stream", logTime: start,
      createTime: 0n, data: new Uint8Array(i * 70_000).fill(i),
    });
    await writer.addMetadata({ name: `note-${i}`, metadata: new Map([["number", String(i)]]) });
  }
  await addMessages(writer, made, count / 2, start + BigInt(count / 2) * 1_000_000n, jitter, notes);
  await writer.end();
  await file.close();
  writeFileSync(`${folder}/${name}.jsonl`, notes.map((line) => line + "\n").join(""));
}

// A log of ours that another program goes on with.
async function appendTo(ours, name) {
  copyFileSync(`${folder}/${ours}.mcap`, `${folder}/${name}.mcap`);
  copyFileSync(`${folder}/${ours}.jsonl`, `${folder}/${name}.jsonl`);
  const file = await open(`${folder}/${name}.mcap`, "r+");
  const writer = await McapWriter.InitializeForAppending(new ReadWrite(file), { compressChunk });
  const id = await writer.registerChannel({
    schemaId: 0, topic: "/theirs/appended", messageEncoding: "octets", metadata: new Map(),
  });
  const last = notedMessages(`${folder}/${ours}.jsonl`).at(-1);
  const notes = [];
  await addMessages(writer, [{ id, topic: "/theirs/appended" }], 2000,
    BigInt(last.log_time) + 1_000_000n, 0, notes);
  await writer.end();
  await file.close();
  appendFileSync(`${folder}/${name}.jsonl`, notes.map((line) => line + "\n").join(""));
}

class ReadWrite {
  #file;
  #position = 0n;
  constructor(file) { this.#file = file; }
  async size() { return BigInt((await this.#file.stat()).size); }
  async read(offset, length) {
    const buffer = new Uint8Array(Number(length));
    await this.#file.read(buffer, 0, buffer.length, Number(offset));
    return buffer;
  }
  position() { return this.#position; }
  async seek(position) { this.#position = position; }
  async truncate() { await this.#file.truncate(Number(this.#position)); }
  async write(buffer) {
    await this.#file.write(buffer, 0, buffer.length, Number(this.#position));
    this.#position += BigInt(buffer.length);
  }
}

const plain = { compressChunk: undefined };
const octets = { encoding: "octets" };
await write("theirs_one", 10_000, { channels: 1, ...octets });
await write("theirs_fifty", 10_000, { channels: 50, encoding: "json", extras: 4 });
await write("theirs_out_of_order", 10_000, { channels: 50, jitter: 2_000_000_000, ...octets });
await write("theirs_plain", 10_000, { channels: 5, options: plain, ...octets });
await write("theirs_bare", 10_000, {
  channels: 5, ...octets,
  options: { useStatistics: false, useSummaryOffsets: false, useMessageIndex: false },
});
await write("theirs_unchunked", 2_000, { channels: 5, options: { useChunks: false }, ...octets });
await appendTo("fifty_channels", "theirs_appended");
