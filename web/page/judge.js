// The judge in a worker of its own: { rays } in, as Engine.rays() gives them; { certificate, heat } out while it measures, the last with `whole`.

import { Module } from "./module.js";

const SAY_MS = 400;

onmessage = async ({ data: { base, rays } }) => {
  try {
    const reference = await Module.load(new URL("reference.wasm", base));
    if (!reference.call("judge", rays.line, rays.width, rays.height, rays.pixels)) throw new Error(reference.answer());
    const began = performance.now();
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
};
