// Reads logs that Rocinante wrote with @mcap/core and compares every message.
// usage: node read_ours.mjs FOLDER NAME...     NAME.mcap and NAME.jsonl; NAME+ may hold less
import {
  byTime, demand, demandEqual, indexedMessages, isCaptured, notedMessages, streamedRecords,
  withIndexedReader,
} from "./messages.mjs";

const [folder, ...names] = process.argv.slice(2);

for (const word of names) {
  const name = word.replace("+", "");
  const path = `${folder}/${name}.mcap`;
  let noted = notedMessages(`${folder}/${name}.jsonl`);
  const streamed = streamedRecords(path);
  const captured = streamed.messages.filter(isCaptured);
  if (word.endsWith("+")) {
    // Of a file that was cut: what stands in it are the first messages that were written.
    demand(captured.length > noted.length / 4 && captured.length < noted.length,
      `${name}: ${captured.length} of ${noted.length} messages came back`);
    const place = new Map(noted.map((message, i) => [JSON.stringify(message), i]));
    const places = captured.map((message) => place.get(JSON.stringify(message)));
    demand(Math.max(...places) === captured.length - 1 && new Set(places).size === places.length,
      `${name}: the messages are not the first that were written`);
    noted = captured;
  } else {
    demandEqual(captured, noted, `${name}, streamed`);
  }

  await withIndexedReader(path, async (reader) => {
    demand(reader.header.profile === "rocinante", `${name}: another profile`);
    const all = await indexedMessages(reader);
    const sorted = byTime(noted);
    for (let i = 1; i < all.length; ++i) {
      demand(BigInt(all[i - 1].log_time) <= BigInt(all[i].log_time), `${name}: not in time order`);
    }
    demandEqual(byTime(all.filter(isCaptured)), sorted, `${name}, by index`);
    demandEqual(byTime(all), byTime(streamed.messages), `${name}, both readers`);
    demandEqual(byTime(await indexedMessages(reader, { reverse: true })), byTime(all),
      `${name}, backwards`);
    if (sorted.length > 0) {
      const startTime = BigInt(sorted[Math.floor(sorted.length / 3)].log_time);
      const endTime = BigInt(sorted[Math.floor(sorted.length / 2)].log_time);
      const within = byTime(all).filter((message) => {
        const time = BigInt(message.log_time);
        return time >= startTime && time <= endTime;
      });
      demandEqual(byTime(await indexedMessages(reader, { startTime, endTime })), within,
        `${name}, a range`);
    }
    demand(reader.statistics.messageCount === BigInt(all.length), `${name}: statistics`);
    demand(reader.statistics.chunkCount === reader.chunkIndexes.length, `${name}: chunk indexes`);

    const attachments = [];
    for await (const each of reader.readAttachments()) attachments.push(each);
    demand(attachments.length === streamed.attachments.length, `${name}: attachments`);
    attachments.filter((each) => each.name.startsWith("files/")).forEach((each) => {
      const number = Number(each.name.slice("files/".length, -".bin".length));
      demand(each.data.length === number * 70_000 && each.data.every((byte) => byte === number),
        `${name}: attachment ${each.name}`);
    });
    const metadata = [];
    for await (const each of reader.readMetadata()) metadata.push(each);
    demand(metadata.some((each) => each.name === "rocinante.session"), `${name}: session`);
    demand(metadata.some((each) => each.name === "rocinante.end"), `${name}: end`);
    metadata.filter((each) => each.name.startsWith("note-")).forEach((each) => {
      demand(`note-${each.metadata.get("number")}` === each.name, `${name}: ${each.name}`);
    });
    const own = all.length - noted.length;
    console.log(`${name}: ${noted.length} messages and ${own} of our own in ` +
      `${reader.chunkIndexes.length} chunks, ${reader.channelsById.size} channels, ` +
      `${attachments.length} attachments, ${metadata.length} metadata records`);
  });
}
