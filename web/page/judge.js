// The judge in a worker of its own: { rays } in, as Engine.rays() gives them; { certificate, heat } out while it measures, the last with `whole`.
// Of rays without pixels it measures some of the picture, to tell how long all would take: { certificate } out, once.

import { Module } from "./module.js";

const SAY_MS = 400, TRY_MS = 500, LEAST_TILES = 3;

onmessage = async ({ data: { base, rays } }) => {
  try {
    const reference = await Module.load(new URL("reference.wasm", base));
    const judge = () => reference.call("judge", rays.line, rays.width, rays.height, rays.pixels);
    while (!judge()) {
      const why = reference.answer(), missed = reference.json("missed_files");
      if (missed.length === 0) throw new Error(why);
      for (const path of missed) reference.call("put_file", path, await content(path, base));
    }
    const began = performance.now();
    if (rays.pixels.length === 0) return postMessage({ certificate: pace(reference, rays) });
    let said = 0;
    for (let more = true; more;) {
      more = Boolean(reference.exports.judge_next());
      if (more && performance.now() - said < SAY_MS) continue;
      said = performance.now();
      const at = reference.exports.heat(), heat = reference.bytes.slice(at, at + 4 * rays.width * rays.height);
      const certificate = { ...reference.json("certificate"), seconds: (said - began) / 1000 };
      postMessage({ certificate, heat, width: rays.width, height: rays.height, whole: !more });
    }
  } catch (error) {
    postMessage({ error: error.message });
  }
  return undefined;
};

// By some tiles; the first one is not counted, in which the browser still compiles. The median: a device that does something else for a moment makes
// a tile slow.
function pace(reference, { width, height }) {
  const { judge_trial: measure } = reference.exports, paces = [];
  measure(0);
  for (const began = performance.now(); paces.length < LEAST_TILES || performance.now() - began < TRY_MS;) {
    const at = performance.now(), pixels = measure(paces.length + 1);
    paces.push((performance.now() - at) / 1000 / pixels);
  }
  paces.sort((a, b) => a - b);
  return { pixels: width * height, measured: 1, seconds: paces[Math.floor((paces.length - 1) / 2)] };
}

// Rays are not traced by pictures: that there is one is enough. A mesh for the picture is another matter.
async function content(path, base) {
  if (/\.(png|jpe?g|hdr)$/i.test(path)) return new Uint8Array(1);
  const response = await fetch(new URL(path.slice(1), base));
  if (!response.ok) throw new Error(`${path}: ${response.status} ${response.statusText}`);
  return new Uint8Array(await response.arrayBuffer());
}
