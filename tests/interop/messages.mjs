// Messages as every script here compares them: topic, sequence, times, payload.
import { readFileSync } from "node:fs";
import { open } from "node:fs/promises";
import { McapIndexedReader, McapStreamReader } from "@mcap/core";
import nodejs from "@mcap/nodejs";
import { loadDecompressHandlers } from "@mcap/support";

export const handlers = await loadDecompressHandlers();

export class Failure extends Error {}

export function demand(holds, sentence) {
  if (!holds) throw new Failure(sentence);
}

export function messageOf(record, channel) {
  return {
    topic: channel.topic,
    sequence: record.sequence,
    log_time: record.logTime.toString(),
    publish_time: record.publishTime.toString(),
    payload: Buffer.from(record.data).toString("base64"),
  };
}

// What a writer noted: NAME.jsonl, in the order of writing.
export function notedMessages(path) {
  const lines = readFileSync(path, "utf8").split("\n");
  return lines.filter((line) => line !== "").map((line) => JSON.parse(line));
}

const key = (message) => JSON.stringify(message);

// In order of time, those of equal times in an order of their own.
export function byTime(messages) {
  return [...messages].sort((a, b) => {
    const [x, y] = [BigInt(a.log_time), BigInt(b.log_time)];
    if (x !== y) return x < y ? -1 : 1;
    return key(a) < key(b) ? -1 : key(a) > key(b) ? 1 : 0;
  });
}

export function demandEqual(came, wanted, what) {
  const shorter = Math.min(came.length, wanted.length);
  for (let i = 0; i < shorter; ++i) {
    demand(key(came[i]) === key(wanted[i]),
      `${what}: message ${i} is ${key(came[i]).slice(0, 200)}, not ${key(wanted[i]).slice(0, 200)}`);
  }
  demand(came.length === wanted.length, `${what}: ${came.length} messages, not ${wanted.length}`);
}

export const isCaptured = (message) => !message.topic.startsWith("/rocinante/");

// `use(reader)` on a file opened by its summary.
export async function withIndexedReader(path, use) {
  const file = await open(path, "r");
  try {
    const readable = new nodejs.FileHandleReadable(file);
    return await use(await McapIndexedReader.Initialize({ readable, decompressHandlers: handlers }));
  } finally {
    await file.close();
  }
}

export async function indexedMessages(reader, range = {}) {
  const messages = [];
  for await (const record of reader.readMessages({ validateCrcs: true, ...range })) {
    messages.push(messageOf(record, reader.channelsById.get(record.channelId)));
  }
  return messages;
}

// Every message, attachment and metadata record in the order of the file, read piece by piece.
export function streamedRecords(path) {
  const reader = new McapStreamReader({ decompressHandlers: handlers, validateCrcs: true });
  const bytes = readFileSync(path);
  const channels = new Map();
  const found = { messages: [], attachments: [], metadata: [] };
  const take = () => {
    for (let record; (record = reader.nextRecord()) != undefined;) {
      if (record.type === "Channel") channels.set(record.id, record);
      if (record.type === "Message") {
        found.messages.push(messageOf(record, channels.get(record.channelId)));
      }
      if (record.type === "Attachment") found.attachments.push(record);
      if (record.type === "Metadata") found.metadata.push(record);
    }
  };
  for (let at = 0; at < bytes.length; at += 50_021) {
    reader.append(bytes.subarray(at, at + 50_021));
    take();
  }
  demand(reader.done(), `${path}: the stream does not end`);
  return found;
}
