// A WebAssembly module of ours: its memory, text in and out, and what it asks of the system, which is next to nothing.

const decoder = new TextDecoder();
const encoder = new TextEncoder();

// A failure that ends the module's work; the page says it and starts anew.
export class Failure extends Error {}

export class Module {
  // imports: functions beside those of the system, by module and name.
  static async load(url, imports = {}) {
    const made = new Module();
    const all = { wasi_snapshot_preview1: made.#system(), page: made.#page(), ...imports };
    const { instance } = await WebAssembly.instantiate(await fetched(url), all);
    made.exports = instance.exports;
    made.exports._initialize();
    return made;
  }

  get bytes() {
    return new Uint8Array(this.exports.memory.buffer);
  }
  text(at, size) {
    return decoder.decode(this.bytes.slice(at, at + size));
  }
  answer() {
    return this.text(this.exports.answer_data(), this.exports.answer_size());
  }

  // Calls with texts or bytes (each becomes a place and a size) and numbers.
  call(name, ...values) {
    const given = [], places = [];
    for (const value of values) {
      if (typeof value === "number") {
        given.push(value);
        continue;
      }
      const bytes = typeof value === "string" ? encoder.encode(value) : value;
      const at = this.exports.allocate(Math.max(bytes.length, 1));
      if (at === 0) throw new Failure("there is no more memory");
      this.bytes.set(bytes, at);
      places.push(at);
      given.push(at, bytes.length);
    }
    const result = this.exports[name](...given);
    for (const at of places) this.exports.release(at);
    return result;
  }
  // Of a call whose answer is JSON.
  json(name, ...values) {
    if (!this.call(name, ...values)) throw new Failure(this.answer());
    return JSON.parse(this.answer());
  }

  #page() {
    return {
      fail: (at, size) => {
        throw new Failure(this.text(at, size));
      },
    };
  }

  #system() {
    const none = () => 0, bad = () => 8;
    const view = () => new DataView(this.exports.memory.buffer);
    let line = "";
    return {
      args_get: none,
      args_sizes_get: (count, size) => (view().setUint32(count, 0, true), view().setUint32(size, 0, true), 0),
      environ_get: none,
      environ_sizes_get: (count, size) => (view().setUint32(count, 0, true), view().setUint32(size, 0, true), 0),
      clock_time_get: (id, precision, at) =>
        (view().setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true), 0),
      fd_close: bad,
      fd_fdstat_get: bad,
      fd_fdstat_set_flags: bad,
      fd_filestat_get: bad,
      fd_prestat_get: bad,
      fd_prestat_dir_name: bad,
      fd_read: bad,
      fd_readdir: bad,
      fd_seek: bad,
      path_filestat_get: bad,
      path_open: bad,
      poll_oneoff: bad,
      sched_yield: none,
      random_get: (at, size) => (crypto.getRandomValues(this.bytes.subarray(at, at + size)), 0),
      proc_exit: (status) => {
        throw new Failure(`the module ended with status ${status}`);
      },
      // What is printed goes to the console, line by line.
      fd_write: (fd, vectors, count, written) => {
        let total = 0;
        for (let i = 0; i < count; ++i) {
          const at = view().getUint32(vectors + 8 * i, true), size = view().getUint32(vectors + 8 * i + 4, true);
          line += this.text(at, size);
          total += size;
        }
        view().setUint32(written, total, true);
        const lines = line.split("\n");
        line = lines.pop();
        for (const whole of lines) console.log(whole);
        return 0;
      },
    };
  }
}

// The bytes of a file that is there packed.
export async function fetched(url) {
  const response = await fetch(`${url}.gz`);
  if (!response.ok) throw new Failure(`${url}.gz: ${response.status} ${response.statusText}`);
  return unpacked(response);
}

// A server may have unpacked it already, and say so or not.
async function unpacked(response) {
  const bytes = await response.arrayBuffer();
  const [first, second] = new Uint8Array(bytes, 0, 2);
  if (first !== 0x1f || second !== 0x8b) return bytes;
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}
