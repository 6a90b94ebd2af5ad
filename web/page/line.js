// A scene as one line, scene = { camera = { ... }, disc = { ... } }: its parts, and the link that it becomes.

const TOKEN = /"(?:\\.|[^"\\])*"|'[^']*'|[[\]{},]|[^"'[\]{},]+/g;

// The entries of an inline table "{ a = 1, b = { ... } }": Map of name and text, in order.
export function entries(table) {
  const found = new Map(), inner = table.trim().slice(1, -1);
  let text = "", depth = 0;
  const end = () => {
    const at = text.indexOf("=");
    if (at > 0) found.set(text.slice(0, at).trim(), text.slice(at + 1).trim());
    text = "";
  };
  for (const [token] of inner.matchAll(TOKEN)) {
    if (token === "{" || token === "[") ++depth;
    if (token === "}" || token === "]") --depth;
    if (token === "," && depth === 0) end();
    else text += token;
  }
  end();
  return found;
}
export const table = (found) => `{ ${[...found].map(([name, text]) => `${name} = ${text}`).join(", ")} }`;

export const partsOf = (line) => entries(line.slice(line.indexOf("=") + 1));
export const lineOf = (parts) => `scene = ${table(parts)}`;

// What a link needs of a line: not the size of this window, nor the sentence about the scene.
export function linkOf(line) {
  const parts = partsOf(line);
  parts.delete("description");
  const camera = entries(parts.get("camera") ?? "{}");
  camera.delete("size");
  if (camera.size > 0) parts.set("camera", table(camera));
  else parts.delete("camera");
  const short = [...parts].map(([name, text]) => `${name}=${text}`).join(",");
  const packed = short.replace(/"(?:\\.|[^"\\])*"|'[^']*'|\s+/g, (found) => (/^\s/.test(found) ? "" : found));
  return encodeURIComponent(packed).replaceAll("%3D", "=").replaceAll("%2C", ",").replaceAll("'", "%27");
}
// The name or the line that a link, location.hash, stands for; null: none.
export function sceneOf(hash) {
  let text;
  try {
    text = decodeURIComponent(hash.replace(/^#/, ""));
  } catch {
    return null;
  }
  if (text === "") return null;
  return text.includes("=") ? `scene = { ${text} }` : text;
}
