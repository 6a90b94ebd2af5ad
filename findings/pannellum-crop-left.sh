#!/usr/bin/env bash
# pannellum 2.5.7, a picture of part of the sphere that says by XMP (GPano) which: against Photo Sphere Viewer 5.15.1, in Chromium.
#
# Guessed: CroppedAreaLeftPixels and CroppedAreaTopPixels put the picture on the sphere, to the side and in height.
# Seen: without a word, pannellum honours the height and not the side: the picture's middle is at yaw 0, wherever it belongs. A picture of the
# right half of the sphere (0 to 180 degrees to the right of ahead) is shown from -90 to 90; what is 30 degrees to the right is at yaw -60. Photo
# Sphere Viewer has it at 30.
# Who writes such a picture for pannellum gives it equal margins left and right, or the page subtracts the middle's direction from yaw.
#
# Needs npm, python3 and a Chromium (chromium-headless-shell, chromium or google-chrome).
# Exit status: 0 as described, 1 something has changed, 2 no browser.
set -euo pipefail
for name in chromium-headless-shell chromium google-chrome ""; do browser=$(command -v "$name") && break; done
[[ -n $browser ]] || { echo "no Chromium here" >&2; exit 2; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
npm install --silent --prefix . pannellum@2.5.7 @photo-sphere-viewer/core@5.15.1 three@0.185.1 puppeteer-core@25.16.0 >/dev/null

# 512x512 px, a panorama's right half: a column's red is its number of degrees to the right of ahead, a row's green its height, 90 at the horizon.
python3 - <<'PYTHON'
import struct
import zlib

SIZE = 512
words = {"ProjectionType": "equirectangular", "FullPanoWidthPixels": 2 * SIZE, "FullPanoHeightPixels": SIZE, "CroppedAreaImageWidthPixels": SIZE,
         "CroppedAreaImageHeightPixels": SIZE, "CroppedAreaLeftPixels": SIZE, "CroppedAreaTopPixels": 0}
xmp = ('<x:xmpmeta xmlns:x="adobe:ns:meta/"><rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#"><rdf:Description rdf:about="" '
       'xmlns:GPano="http://ns.google.com/photos/1.0/panorama/" ' + " ".join(f'GPano:{key}="{value}"' for key, value in words.items()) +
       "/></rdf:RDF></x:xmpmeta>")
chunk = lambda kind, body: struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
degrees = [round(180 * (i + 0.5) / SIZE) for i in range(SIZE)]
rows = b"".join(b"\0" + b"".join(bytes((right, 180 - down, 200)) for right in degrees) for down in degrees)
with open("half.png", "wb") as file:
    file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", SIZE, SIZE, 8, 2, 0, 0, 0)) +
               chunk(b"iTXt", b"XML:com.adobe.xmp\0\0\0\0\0" + xmp.encode()) + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b""))
PYTHON

cat >pannellum.html <<'END'
<!doctype html><link rel=stylesheet href="node_modules/pannellum/build/pannellum.css"><script src="node_modules/pannellum/build/pannellum.js"></script>
<div id=view style="width: 400px; height: 300px"></div><script>
const viewer = pannellum.viewer("view", {type: "equirectangular", panorama: "half.png", autoLoad: true, showControls: false, hfov: 60});
viewer.on("load", () => window.look = (yaw) => viewer.lookAt(0, yaw, 60, false));
</script>
END
cat >sphere.html <<'END'
<!doctype html><link rel=stylesheet href="node_modules/@photo-sphere-viewer/core/index.css">
<script type=importmap>{"imports": {"three": "./node_modules/three/build/three.module.js", "viewer": "./node_modules/@photo-sphere-viewer/core/index.module.js"}}</script>
<div id=view style="width: 400px; height: 300px"></div><script type=module>
import { Viewer } from "viewer";
const viewer = new Viewer({container: "view", panorama: "half.png", navbar: false});
viewer.addEventListener("ready", () => window.look = (yaw) => viewer.rotate({yaw: yaw + "deg", pitch: 0}));
</script>
END
cat >look.mjs <<'END'
import puppeteer from "puppeteer-core";
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
const kinds = { html: "text/html", js: "text/javascript", css: "text/css", png: "image/png" };
const server = createServer(async (asked, answer) => {
  const path = "." + new URL(asked.url, "http://x").pathname;
  try {
    answer.setHeader("Content-Type", kinds[path.split(".").pop()] ?? "application/octet-stream");
    answer.end(await readFile(path));
  } catch { answer.writeHead(404).end(); }
}).listen(0, "127.0.0.1");
await new Promise((there) => server.once("listening", there));
const browser = await puppeteer.launch({ executablePath: process.argv[2],
  args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"] });
const changed = [];
for (const [name, file, degrees] of [["pannellum", "pannellum.html", (yaw) => yaw + 90], ["Photo Sphere Viewer", "sphere.html", (yaw) => yaw]]) {
  const page = await browser.newPage();
  await page.goto(`http://127.0.0.1:${server.address().port}/${file}`);
  await page.waitForFunction("window.look");
  for (const yaw of [-60, 30, 60]) {
    await page.evaluate(`look(${yaw})`);
    await new Promise((later) => setTimeout(later, 2000));
    const shot = await page.screenshot({ clip: { x: 200, y: 150, width: 1, height: 1 } });
    const [red, green, blue] = await page.evaluate(async (base64) => {
      const image = await createImageBitmap(await (await fetch("data:image/png;base64," + base64)).blob());
      const canvas = new OffscreenCanvas(1, 1).getContext("2d");
      canvas.drawImage(image, 0, 0);
      return [...canvas.getImageData(0, 0, 1, 1).data];
    }, Buffer.from(shot).toString("base64"));
    const there = blue > 150, meant = degrees(yaw);
    console.log(`${name}, yaw ${yaw}: ${there ? `what is ${red} degrees to the right, ${green - 90} up` : "no picture"}; described ${meant < 0 || meant > 180 ? "no picture" : meant}`);
    if (meant < 0 || meant > 180 ? there : !there || Math.abs(red - meant) > 2 || Math.abs(green - 90) > 2) changed.push(`${name} at ${yaw}`);
  }
}
await browser.close();
server.close();
if (changed.length) { console.error(`changed: ${changed.join(", ")}`); process.exit(1); }
END
node look.mjs "$browser"
