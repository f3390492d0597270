// node write_ros.mjs PACKAGES FILE: writes messages of ROS 2 types as other programs do, and prints the value of each,
// one JSON object a line, in the order of the file. A time is printed as its seconds.
import { open } from "node:fs/promises";
import { createRequire } from "node:module";
import { join } from "node:path";
import { packagesIn, printLine } from "./packages.mjs";

const [packages, file] = process.argv.slice(2);
const { mcap, parseDefinition } = packagesIn(packages);
const { MessageWriter } = createRequire(join(packages, "package.json"))("@foxglove/rosmsg2-serialization");

const rule = "=".repeat(80);
const pose = `# A pose in a frame
std_msgs/Header header
Pose pose
${rule}
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
${rule}
MSG: geometry_msgs/Pose
Point position
geometry_msgs/Quaternion orientation
${rule}
MSG: geometry_msgs/Point
float64 x
float64 y
float64 z
${rule}
MSG: geometry_msgs/Quaternion
float64 x 0
float64 y 0
float64 z 0
float64 w 1
`;
const mix = `byte OLD=1
string GREETING="hello # there"
bool flag
int8 small
uint8[3] rgb
char letter
uint16 port 8080
int64 large
float32[] samples
float64[<=4] few
string<=20 name "unknown"
string[] words
Item[2] pair
Item[] items
duration[] spans
${rule}
MSG: test_msgs/Item
int16 id
string text
bool[] bits
`;

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
});
await writer.start({ profile: "ros2", library: "oracle" });

async function topicOf(topic, name, definition) {
  const data = new TextEncoder().encode(definition);
  const schemaId = await writer.registerSchema({ name, encoding: "ros2msg", data });
  const channelId = await writer.registerChannel({ schemaId, topic, messageEncoding: "cdr", metadata: new Map() });
  return { topic, channelId, encoder: new MessageWriter(parseDefinition(definition, { ros2: true })) };
}

let count = 0;
// A time is {sec, nsec} for the encoder, and its seconds for the test.
function forTest(value) {
  if (typeof value === "bigint") return Number(value);
  if (ArrayBuffer.isView(value) || Array.isArray(value)) return Array.from(value, forTest);
  if (value === null || typeof value !== "object") return value;
  if ("nsec" in value) return value.sec + value.nsec / 1e9;
  return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, forTest(inner)]));
}
async function write({ topic, channelId, encoder }, value) {
  const time = BigInt(1000 + count);
  await writer.addMessage({ channelId, sequence: count++, logTime: time, publishTime: time,
                            data: encoder.writeMessage(value) });
  printLine({ topic, value: forTest(value) });
}

const poses = await topicOf("/arm/pose", "geometry_msgs/msg/PoseStamped", pose);
const mixed = await topicOf("/mix", "test_msgs/msg/Mix", mix);
for (let i = 0; i < 50; ++i) {
  await write(poses, {
    header: { stamp: { sec: 1_700_000_000 + i, nsec: 500_000_000 * (i % 2) }, frame_id: "base".slice(0, i % 5) },
    pose: { position: { x: i / 8, y: 1 - i, z: 0.1 }, orientation: { x: 0, y: 0.5, z: -0.5, w: 1 } },
  });
  await write(mixed, {
    flag: i % 3 === 0, small: 1 - i, rgb: Uint8Array.of(i, 2, 255), letter: 65 + (i % 20), port: 60000 + i,
    large: BigInt(i) - 9_000_000_000_000n, samples: Float32Array.from({ length: i % 4 }, (_, k) => k / 4),
    few: Float64Array.from({ length: i % 5 }, (_, k) => k + 0.1), name: "large".slice(0, i % 7),
    words: Array.from({ length: i % 3 }, (_, k) => "w".repeat(k + i % 4)),
    pair: [{ id: i, text: "a", bits: [] }, { id: 1 - i, text: "", bits: [true] }],
    items: Array.from({ length: i % 3 }, (_, k) => ({ id: k, text: "x".repeat(k), bits: [k === 0, i % 2 === 0] })),
    spans: Array.from({ length: i % 3 }, (_, k) => ({ sec: 1 - k, nsec: 250_000_000 })),
  });
}
await writer.end();
await handle.close();
