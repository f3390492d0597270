// The packages of package.json, which `tools/setup --oracles` installs elsewhere, and the compressions of chunks.
import { createRequire } from "node:module";
import { join } from "node:path";

export function packagesIn(folder) {
  const require = createRequire(join(folder, "package.json"));
  const zstd = require("@foxglove/wasm-zstd");
  const decompressLz4 = require("@foxglove/wasm-lz4");
  const compressLz4 = require("lz4js").compress;
  return {
    mcap: require("@mcap/core"),
    parseDefinition: require("@foxglove/rosmsg").parse,
    MessageReader: require("@foxglove/rosmsg2-serialization").MessageReader,
    decompressHandlers: {
      lz4: (bytes, size) => decompressLz4(bytes, Number(size)),
      zstd: (bytes, size) => zstd.decompress(bytes, Number(size)),
    },
    compressChunk: {
      none: undefined,
      lz4: (bytes) => ({ compression: "lz4", compressedData: Uint8Array.from(compressLz4(bytes)) }),
      zstd: (bytes) => ({ compression: "zstd", compressedData: zstd.compress(bytes) }),
    },
    isLoaded: Promise.all([zstd.isLoaded, decompressLz4.isLoaded]),
  };
}

export function hexOf(bytes) {
  return Buffer.from(bytes).toString("hex");
}

// Prints one JSON object a line. 64-bit integers, and numbers that JSON cannot hold, become strings.
export function printLine(object) {
  console.log(JSON.stringify(object, (_, value) => {
    if (typeof value === "bigint") return String(value);
    if (typeof value === "number" && !Number.isFinite(value)) return String(value);
    if (Object.is(value, -0)) return "-0";
    if (ArrayBuffer.isView(value)) return Array.from(value);
    return value;
  }));
}
