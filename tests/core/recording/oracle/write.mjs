// node write.mjs PACKAGES FILE OPTIONS: writes a recording, and prints what is in it, one JSON object a line, messages
// in the order of the file. PACKAGES is the folder of the packages; OPTIONS are those of McapWriter as JSON, plus
// `compression`: none, lz4 or zstd.
import { open } from "node:fs/promises";
import { hexOf, packagesIn, printLine } from "./packages.mjs";

const [packages, file, options] = process.argv.slice(2);
const { mcap, compressChunk, isLoaded } = packagesIn(packages);
await isLoaded;
const { compression = "none", ...writerOptions } = JSON.parse(options);

const handle = await open(file, "wx");
let position = 0n;
const writer = new mcap.McapWriter({
  writable: {
    position: () => position,
    write: async (bytes) => {
      await handle.write(bytes);
      position += BigInt(bytes.byteLength);
    },
  },
  chunkSize: 2000,
  compressChunk: compressChunk[compression],
  ...writerOptions,
});

await writer.start({ profile: "ros2", library: "oracle" });
const definition = new TextEncoder().encode("float64 angle  # °\n");
const schema = { name: "arm/msg/Reading", encoding: "ros2msg", data: definition };
const schemaId = await writer.registerSchema(schema);
const channels = [
  { schemaId, topic: "robot/arm/état", messageEncoding: "cdr", metadata: new Map([["unit", "°"], ["empty", ""]]) },
  { schemaId: 0, topic: "text", messageEncoding: "json", metadata: new Map() },
];
const ids = [];
for (const channel of channels) {
  ids.push(await writer.registerChannel(channel));
  printLine({ kind: "channel", topic: channel.topic, encoding: channel.messageEncoding,
              metadata: Object.fromEntries(channel.metadata), schema: channel.schemaId === 0 ? "" : schema.name,
              definition: channel.schemaId === 0 ? "" : hexOf(definition) });
}

async function writeExtras() {
  const attachment = { name: "photo.bin", mediaType: "application/octet-stream", logTime: 12n, createTime: 11n,
                       data: Uint8Array.from({ length: 3000 }, (_, i) => i % 251) };
  await writer.addAttachment(attachment);
  printLine({ kind: "attachment", name: attachment.name, media_type: attachment.mediaType, log_time: 12n,
              create_time: 11n, data: hexOf(attachment.data) });
  const metadata = { name: "who", metadata: new Map([["operator", "Zoë"], ["shift", "2"]]) };
  await writer.addMetadata(metadata);
  printLine({ kind: "metadata", name: metadata.name, metadata: Object.fromEntries(metadata.metadata) });
}

// Every second message is 120 ms older, so the times of neighbouring chunks overlap.
for (let i = 0; i < 500; ++i) {
  if (i === 250) await writeExtras();
  const which = i % 3 === 2 ? 1 : 0;
  const time = 1_700_000_000_000_000_000n + BigInt(i % 2 === 0 ? i : i - 120) * 1_000_000n;
  const data = Uint8Array.from({ length: (i * 7) % 90 }, (_, byte) => (i + byte * byte) % 256);
  const message = { channelId: ids[which], sequence: i, logTime: time, publishTime: time - 5n, data };
  await writer.addMessage(message);
  printLine({ kind: "message", topic: channels[which].topic, sequence: i, log_time: time, publish_time: time - 5n,
              data: hexOf(data) });
}
await writer.end();
await handle.close();
