// The engine in a worker: { id, call, values } in, { id, value } or { id, error } and { event, values } out.

import { Engine } from "./engine.js";

const engine = new Engine((event, values) => postMessage({ event, values }));

onmessage = async ({ data: { id, call, values } }) => {
  try {
    const value = await engine[call](...values);
    if (id !== undefined) postMessage({ id, value });
  } catch (error) {
    postMessage(id === undefined ? { event: "failed", values: { message: error.message } } : { id, error: error.message });
  }
};
