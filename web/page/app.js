// The page: the view, its panel and its address.

import { Controls, make, unquoted, words } from "./controls.js";
import { entries, linkOf, partsOf, sceneOf } from "./line.js";
import { Proof } from "./proof.js";
import { Telescope } from "./telescope.js";
import { plain } from "./view.js";

const FIRST_SCENE = "first-light";
const CLOCK = 5;            // r_s/c a second
const TOAST_MS = 4000;
const get = (id) => document.getElementById(id);
const view = get("view"), phone = matchMedia("(max-width: 720px)");

// ---- words over the picture

let toasting;
function toast(text) {
  get("toast").textContent = text;
  clearTimeout(toasting);
  if (text !== "") toasting = setTimeout(() => toast(""), TOAST_MS);
}
const refuse = (error) => toast(plain(error.message));
const act = (work) => async (event) => {
  try {
    await work(event);
  } catch (error) {
    refuse(error);
  }
};
view.addEventListener("refused", ({ detail }) => toast(detail.message));

// ---- panel

const TABS = ["scenes", "settings", "telescope", "proof"];
function show(which) {
  document.body.classList.toggle("folded", which === null);
  for (const name of TABS) {
    get(name).hidden = name !== which;
    get(`tab-${name}`).setAttribute("aria-selected", String(name === which));
    get(`tab-${name}`).tabIndex = name === (which ?? TABS[0]) ? 0 : -1;
  }
  get("fold").title = which === null ? "Show the panel" : "Hide the panel";
  get("fold").setAttribute("aria-label", get("fold").title);
  shown = which;
  if (which === "proof") showPlan();
  if (which === "settings") controls.refresh();
  telescope.show(which === "telescope").catch(refuse);
}
let shown, last = "settings";
for (const name of TABS)
  get(`tab-${name}`).addEventListener("click", () => show(shown === name && phone.matches ? null : (last = name)));
get("fold").addEventListener("click", () => show(shown === null ? last : null));
get("panel").querySelector("nav").addEventListener("keydown", (event) => {
  const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
  if (!step || !TABS.includes(event.target.getAttribute("aria-controls"))) return;
  const next = TABS[(TABS.indexOf(event.target.getAttribute("aria-controls")) + step + TABS.length) % TABS.length];
  show((last = next));
  get(`tab-${next}`).focus();
});
// Keys that nobody has the focus for are the picture's; Escape leaves the panel.
addEventListener("keydown", (event) => {
  if (event.key === "Escape") view.focus({ preventScroll: true });
  if (document.activeElement !== document.body || event.key === "Tab") return;
  view.focus({ preventScroll: true });
  view.dispatchEvent(new KeyboardEvent("keydown", event));
});

// ---- scenes

let scenes = [];
async function showScenes() {
  scenes = await view.ask("gallery");
  const groups = new Map();
  for (const scene of scenes) groups.set(scene.group, [...(groups.get(scene.group) ?? []), scene]);
  get("scenes").replaceChildren(...[...groups].flatMap(([group, list]) => [
    make("h2", { textContent: group }),
    make("div", { className: "cards" }, ...list.map(({ name, title, description }) => {
      const picture = make("img", { loading: "lazy", decoding: "async", width: 320, height: 180, alt: "", src: `assets/gallery/${name}.jpg` });
      return make("a", { href: `#${name}`, title: description, dataset: { name } }, picture, make("span", { textContent: title }));
    })),
  ]));
  markScene();
}
get("scenes").addEventListener("click", (event) => {
  const card = event.target.closest("a");
  if (!card || event.ctrlKey || event.metaKey || event.shiftKey) return;
  event.preventDefault();
  history.pushState(null, "", `#${card.dataset.name}`);
  open(card.dataset.name);
  if (phone.matches) show(null);
});
function markScene() {
  for (const card of get("scenes").querySelectorAll("a"))
    if (card.dataset.name === opened.name) card.setAttribute("aria-current", "true");
    else card.removeAttribute("aria-current");
}

// ---- what is shown, and the address, which is a link to it

const opened = { name: null, link: null };  // the name of a scene that ships, and its link before the user changed it
async function open(what) {
  get("heat").hidden = true;
  setClock(0);
  await view.open(what);
  opened.name = /^[\w-]+$/.test(what) ? what : null;
  opened.link = opened.name === null ? null : linkOf(view.line);
  markScene();
  await news();
  get("title").classList.remove("gone");
}
// Before the first picture the view says by itself what is wrong.
async function openSafely(what) {
  try {
    await open(what);
  } catch (error) {
    if (view.drawn) refuse(error);
    else if (!phone.matches) show((last = "scenes"));
  }
}
async function link() {
  const now = linkOf(await view.ask("sceneLine"));
  return now === opened.link ? opened.name : now;
}
async function keepAddress() {
  const now = `#${await link()}`;
  if (now !== location.hash) history.replaceState(null, "", now);
}
async function follow() {
  const what = sceneOf(location.hash) ?? FIRST_SCENE;
  if (location.hash !== `#${await link().catch(() => "")}`) openSafely(what);
}
addEventListener("popstate", follow);

// Title, split view and controls, after the scene changed.
let parts = new Map();
async function news() {
  parts = partsOf(await view.ask("sceneLine"));
  const scene = scenes.find(({ name }) => name === opened.name);
  const title = scene?.title ?? unquoted(parts.get("name")) ?? "A view";
  get("title").querySelector("h1").textContent = title;
  get("title").querySelector("p").textContent = scene?.description ?? unquoted(parts.get("description")) ?? "";
  document.title = `${title} \u2013 nullscope`;
  const divider = get("divider"), split = parts.has("split");
  divider.hidden = !split;
  get("split").setAttribute("aria-pressed", String(split));
  ["spacetime", "split"].forEach((section, i) => {
    const metric = unquoted(entries(parts.get(section) ?? "{}").get("metric")) ?? "schwarzschild";
    divider.children[i].textContent = words(metric, metric);
  });
  if (shown === "settings") await controls.refresh();
  if (shown === "proof") await showPlan();
}
let late;
const soon = () => {
  clearTimeout(late);
  late = setTimeout(() => news().catch(() => {}), 150);
};
view.addEventListener("scene", soon);
view.addEventListener("rest", () => {
  keepAddress().catch(() => {});
  if (shown === "settings") controls.refresh();
});
view.addEventListener("hand", () => {
  get("heat").hidden = true;
  get("title").classList.add("gone");
});

const controls = new Controls(view, get("settings"), toast);
const proof = new Proof(view, get("proof"), get("heat"), async () => ({
  title: get("title").querySelector("h1").textContent, link: new URL(`#${await link()}`, location.href).href,
}));
const telescope = new Telescope(view, get("telescope"), get("beam"));
async function showPlan() {
  proof.plan(await view.ask("plan"));
  await proof.estimate();
}

// ---- the bar

function icon(button, name) {
  button.querySelector("use").setAttribute("href", `#i-${name}`);
}
let falls = false;
view.addEventListener("drawn", ({ detail }) => {
  const [r, theta, , time, tau] = detail.place;
  const place = [`r = ${r.toPrecision(4)} r\u209b`, `\u03b8 = ${(theta * 180 / Math.PI).toFixed(1)}\u00b0`];
  if (time !== 0) place.push(`t = ${time.toFixed(1)}`);
  if (tau !== 0) place.push(`\u03c4 = ${tau.toFixed(2)}`);
  get("place").textContent = place.join("   ");
  if (detail.falls === falls) return;
  falls = detail.falls;
  const words = falls ? "Stop" : "Let go";
  icon(get("fall"), falls ? "stop" : "fall");
  get("fall").querySelector("b").textContent = words;
  get("fall").setAttribute("aria-label", falls ? "Stop the fall" : "Let go and fall");
});
get("fall").addEventListener("click", act(() => view.letGo()));
get("home").addEventListener("click", act(() => view.home()));
let clock = 0;
function setClock(rate) {
  if (rate === clock) return;
  clock = rate;
  icon(get("clock"), clock === 0 ? "play" : "pause");
  get("clock").setAttribute("aria-pressed", String(clock !== 0));
  view.ask("setClock", clock).catch(() => {});
}
get("clock").addEventListener("click", () => setClock(clock === 0 ? CLOCK : 0));
get("split").addEventListener("click", act(async () => {
  if (parts.has("split")) return view.change((now) => now.delete("split"));
  const flat = /minkowski/.test(parts.get("spacetime") ?? "");
  await view.change((now) => now.set("split", `{ metric = "${flat ? "schwarzschild" : "minkowski"}" }`));
  if (!phone.matches) show((last = "settings"));
  return undefined;
}));
get("link").addEventListener("click", act(async () => {
  await keepAddress();
  await navigator.clipboard.writeText(location.href);
  toast("The link is copied. It opens this very view.");
}));
get("png").addEventListener("click", act(async () => {
  const url = URL.createObjectURL(await view.png());
  make("a", { href: url, download: `nullscope-${opened.name ?? "view"}.png` }).click();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}));
get("full").hidden = !document.documentElement.requestFullscreen;
get("full").addEventListener("click", act(() =>
  document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen()));
document.addEventListener("fullscreenchange", () => show(document.fullscreenElement || phone.matches ? null : last));

// ---- the beginning

show(phone.matches ? null : last);
view.addEventListener("drawn", () => "serviceWorker" in navigator && !navigator.connection?.saveData
  && navigator.serviceWorker.register("sw.js").catch(() => {}), { once: true });
view.ready.then(async () => {
  await openSafely(sceneOf(location.hash) ?? FIRST_SCENE);
  await showScenes();
  await news();
}, () => {});
