// node decode.mjs PACKAGES FILE: prints all that is in a recording, one JSON object a line: metadata, attachments, the
// number of messages, then each message with its decoded value, by log time. PACKAGES is the folder of the packages.
import { open } from "node:fs/promises";
import { hexOf, packagesIn, printLine } from "./packages.mjs";

const [packages, file] = process.argv.slice(2);
const { mcap, parseDefinition, MessageReader, decompressHandlers, isLoaded } = packagesIn(packages);
await isLoaded;

const handle = await open(file);
const readable = {
  size: async () => BigInt((await handle.stat()).size),
  read: async (offset, length) => {
    const bytes = new Uint8Array(Number(length));
    const { bytesRead } = await handle.read(bytes, 0, bytes.length, Number(offset));
    if (bytesRead !== bytes.length) throw new Error(`${file} ends within ${length} bytes at ${offset}`);
    return bytes;
  },
};

const reader = await mcap.McapIndexedReader.Initialize({ readable, decompressHandlers });
for await (const { name, metadata } of reader.readMetadata()) {
  printLine({ kind: "metadata", name, metadata: Object.fromEntries(metadata) });
}
for await (const { name, mediaType, logTime, createTime, data } of reader.readAttachments({ validateCrcs: true })) {
  printLine({ kind: "attachment", name, media_type: mediaType, log_time: logTime, create_time: createTime,
              data: hexOf(data) });
}
printLine({ kind: "statistics", messages: reader.statistics.messageCount, channels: reader.channelsById.size });

const decoders = new Map();
function decoderOf(schema) {
  if (!decoders.has(schema.id)) {
    const text = new TextDecoder().decode(schema.data);
    decoders.set(schema.id, new MessageReader(parseDefinition(text, { ros2: true })));
  }
  return decoders.get(schema.id);
}
for await (const message of reader.readMessages({ validateCrcs: true })) {
  const channel = reader.channelsById.get(message.channelId);
  const schema = reader.schemasById.get(channel.schemaId);
  if (channel.messageEncoding !== "cdr" || schema.encoding !== "ros2msg") {
    throw new Error(`cannot read ${channel.topic}`);
  }
  printLine({ kind: "message", topic: channel.topic, schema: schema.name, sequence: message.sequence,
              log_time: message.logTime, publish_time: message.publishTime,
              value: decoderOf(schema).readMessage(message.data) });
}
await handle.close();
