#!/usr/bin/env python3
"""The page, by real mouse, touch and key events, on SwiftShader: test_page.py PAGE PROGRAMS [CASE...] (support.py)."""
import functools
import http.server
import json
import math
import sys
import threading
import tomllib
import unittest

from browser import Browser, PageError, Quiet, Server
from support import ROOT, begin

PAGE = None
GRID = "#sky-grid"  # needs no sky from the network
VIEW = "document.querySelector('nullscope-view')"
WIDE, PHONE = (800, 320), (360, 640)
# WebGL in the page itself, where a script of the test can change it.
IN_PAGE = "delete HTMLCanvasElement.prototype.transferControlToOffscreen;"
NO_WEBGL = IN_PAGE + "HTMLCanvasElement.prototype.getContext = () => null;"
WITHOUT = IN_PAGE + """
  const real = WebGL2RenderingContext.prototype.getExtension;
  WebGL2RenderingContext.prototype.getExtension = function (name) { return /%s/.test(name) ? null : real.call(this, name); };"""
TICKED = """[camera]
r = 30
theta = 60
fov = 40
[sky]
kind = "black"
[disc]
emission = "thermal"
polarisation = "scattering"
[picture]
ticks = "on"
"""
# A uniform disc as seen: of 8 r_s in flat space, where a r_s of M87* is 7.638 microarcseconds.
BALL = """[spacetime]
metric = "minkowski"
[camera]
r = 20
fov = 70
[sky]
kind = "black"
[object]
name = "m87"
[sphere]
radius = 8
texture = "plain"
colour = [1, 1, 1]
"""
DIGEST = """.then(async ({ width, height, pixels }) => [width, height,
  ...new Uint8Array(await crypto.subtle.digest("SHA-256", pixels))])"""


class Page(Browser):
    """A browser with the page open and its first picture drawn."""

    def __init__(self, url, size=WIDE, script="", drawn=True):
        super().__init__("swiftshader", *size)
        if size == PHONE:
            self.resize(*PHONE, phone=True)
        if script:
            self.page("Page.addScriptToEvaluateOnNewDocument", source=script)
        self.open(url)
        if drawn:
            self.until_drawn()

    def until_drawn(self):
        self.wait(f"Boolean({VIEW}?.drawn) && document.querySelectorAll('#scenes a').length > 0")

    def ask(self, call, *values):
        return self.run(f"{VIEW}.ask({', '.join(map(json.dumps, (call, *values)))})")

    def values(self):
        return {key["name"]: key["value"] for key in self.ask("keys")}

    def camera(self):
        known = self.values()
        return {name: float(known[f"camera.{name}"]) for name in ("r", "theta", "phi", "yaw", "pitch", "roll", "fov")}

    def centre(self, selector=None):
        """Of an element, in px of the window; scrolled to."""
        box = self.run(f"""(() => {{ const e = document.querySelector({json.dumps(selector or 'nullscope-view')});
            e.scrollIntoView({{ block: "center" }}); const b = e.getBoundingClientRect();
            return [b.x + b.width / 2, b.y + b.height / 2, b.width, b.height]; }})()""")
        if box[2] == 0:
            raise PageError(f"{selector} is not to be seen")
        return box[0], box[1]

    def click(self, selector):
        x, y = self.centre(selector)
        self.drag([(x, y), (x, y)])

    def tap(self, selector):
        at = self.centre(selector)
        self.touch("touchStart", [at])
        self.touch("touchEnd", [])

    def press(self, code, **more):
        self.key(code, **more)
        self.key(code, down=False, **more)

    def shown(self, selector):
        return self.run(f"document.querySelector({json.dumps(selector)})?.checkVisibility() ?? false")

    def text(self, selector):
        return self.run(f"document.querySelector({json.dumps(selector)})?.textContent ?? ''")

    def picture(self):
        return self.run(f"{VIEW}.ask('picture'){DIGEST}")

    def fresh(self):
        """The grid scene again, as it ships; and no element has the focus."""
        self.run("if (!document.querySelector('#settings').checkVisibility()) document.querySelector('#tab-settings').click()")
        self.run(f"document.activeElement.blur(); history.pushState(null, '', '{GRID}'); dispatchEvent(new PopStateEvent('popstate'))")
        self.wait("document.querySelector('h1').textContent === 'Sky grid'")
        self.run(f"{VIEW}.open('sky-grid')")


class Wide(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.page = Page(SERVER.url + GRID)

    @classmethod
    def tearDownClass(cls):
        console = [line for line in cls.page.console if "GPU stall" not in line]
        cls.page.close()
        assert not console, console

    def setUp(self):
        self.page.fresh()
        self.page.wait("document.querySelectorAll('#settings .row').length > 60")
        self.before = self.page.camera()

    def changed(self):
        now = self.page.camera()
        return {name for name, value in now.items() if abs(value - self.before[name]) > 1e-6}

    def test_mouse_drag_looks(self):
        page, (x, y) = self.page, self.page.centre()
        page.drag([(x, y), (x + 30, y), (x + 60, y)])
        self.assertEqual(self.changed() & {"yaw", "r", "theta", "phi"}, {"yaw"})
        # What was grabbed is seen where the mouse let it go: the view turned left.
        self.assertLess(page.camera()["yaw"], self.before["yaw"])

    def test_mouse_orbits_and_rolls(self):
        page, (x, y) = self.page, self.page.centre()
        page.drag([(x, y), (x + 40, y)], button="middle")
        self.assertIn("phi", self.changed())
        self.before = page.camera()
        page.drag([(x + 60, y), (x, y - 60)], button="right")
        self.assertEqual(self.changed(), {"roll"})

    def test_wheel(self):
        page, (x, y) = self.page, self.page.centre()
        page.mouse("mouseWheel", x, y, deltaX=0, deltaY=-100)
        page.wait(f"{VIEW}.left !== 0 || {VIEW}.drawn.place[0] < 12")
        page.wait(f"{VIEW}.left === 0 && {VIEW}.gliding === undefined")
        distance = (page.camera()["r"] - 1) / (self.before["r"] - 1)
        self.assertAlmostEqual(distance, 2.718281828 ** -0.15, delta=1e-6)
        page.mouse("mouseWheel", x, y, deltaX=0, deltaY=-100, modifiers=8)
        page.wait(f"{VIEW}.ask('sceneLine').then((line) => !line.includes('fov = 75'))")
        self.assertLess(page.camera()["fov"], 75)

    def test_keys_fly(self):
        page = self.page
        page.key("KeyW")
        page.wait(f"{VIEW}.drawn.place[0] < {self.before['r'] - 0.5}")
        page.key("KeyW", down=False)
        self.assertLess(page.camera()["r"], self.before["r"] - 0.5)
        page.press("ArrowLeft")
        self.assertIn("yaw", self.changed())
        page.press("KeyR")
        page.wait(f"{VIEW}.ask('sceneLine').then((line) => line.includes('r = 12,'))")
        self.assertEqual(self.changed(), set())

    def test_keys_of_a_field_do_not_fly(self):
        page = self.page
        page.click("[data-key='camera.exposure'] input[type=number]")
        page.press("KeyW")
        page.press("KeyF")
        self.assertEqual(self.changed(), set())

    def test_let_go(self):
        page = self.page
        page.press("KeyF")
        page.wait("document.querySelector('#fall b').textContent === 'Stop'")
        page.wait(f"{VIEW}.drawn.place[4] > 0.2")
        page.click("#fall")
        page.wait("document.querySelector('#fall b').textContent === 'Let go'")
        self.assertLess(page.camera()["r"], self.before["r"])

    def test_clock_runs(self):
        self.page.click("#clock")
        self.page.wait(f"{VIEW}.drawn.place[3] > 1")
        self.page.click("#clock")
        self.assertEqual(self.page.run("document.querySelector('#clock').ariaPressed"), "false")

    def test_every_control_is_of_the_table(self):
        page = self.page
        page.wait("document.querySelectorAll('#settings .row').length > 60")
        keys = {key["name"]: key for key in page.ask("keys")}
        rows = page.run("""[...document.querySelectorAll('#settings .row')].map((row) =>
            [row.dataset.key, row.querySelector('.name').title, row.querySelector('.value i')?.textContent ?? '', row.hidden])""")
        for name, help_, unit, hidden in rows:
            if name not in ("spacetime.metric", "split.metric"):
                self.assertEqual((help_, unit, hidden), (keys[name]["help"], keys[name]["unit"], not keys[name]["meant"]), name)

    def test_metric_and_its_parameter(self):
        page = self.page
        page.run("""(() => { const list = document.querySelector("[data-key='spacetime.metric'] select");
            list.value = "janis-newman-winicour"; list.dispatchEvent(new Event("change")); })()""")
        page.wait("Boolean(document.querySelector(\"[data-key='spacetime.gamma'] input[type=range]\"))")
        page.click("[data-key='spacetime.gamma'] input[type=range]")
        page.press("ArrowLeft")
        page.wait(f"{VIEW}.ask('sceneLine').then((line) => /gamma = 0.79/.test(line))")
        self.assertEqual(self.changed(), set())
        self.assertEqual(page.text("[data-section=spacetime] .note"), "A mass with a scalar field: a photon sphere about a singular surface.")

    def test_number_that_is_refused(self):
        page = self.page
        page.click("[data-key='camera.fov'] input[type=number]")
        page.run("document.activeElement.select()")
        page.page("Input.insertText", text="200")
        page.press("Enter", key="Enter", text="\r")
        page.wait("document.querySelector('#toast').textContent !== ''")
        self.assertRegex(page.text("#toast"), r"^camera.fov: .*180")
        self.assertEqual(page.values()["camera.fov"], "75")

    def test_disc_switch(self):
        page = self.page
        page.run("document.querySelector('[data-section=disc]').open = true")
        self.assertFalse(page.shown("[data-key='disc.inner']"))
        page.click("[data-section=disc] .has")
        page.wait("document.querySelector(\"[data-key='disc.inner']\").checkVisibility()", 300)
        self.assertIn("disc = ", page.ask("sceneLine"))
        page.click("[data-section=disc] .has")
        page.wait("!document.querySelector(\"[data-key='disc.inner']\").checkVisibility()")
        self.assertNotIn("disc = ", page.ask("sceneLine"))

    def test_split_view(self):
        page = self.page
        page.click("#split")
        page.wait("document.querySelector('#divider').checkVisibility()")
        self.assertEqual(page.text("#divider span:last-child"), "Flat")
        self.assertIn("minkowski", page.ask("sceneLine"))
        page.wait("location.hash.includes('split')")
        page.click("#split")
        page.wait("!document.querySelector('#divider').checkVisibility()")

    def test_a_view_is_a_link(self):
        page, (x, y) = self.page, self.page.centre()
        page.drag([(x, y), (x + 33, y + 21)])
        page.mouse("mouseWheel", x, y, deltaX=0, deltaY=-130)
        page.wait("location.hash.includes('camera') && !location.hash.includes('size')")
        page.wait(f"{VIEW}.gliding === undefined")
        page.wait(f"import('./line.js').then(({{ linkOf }}) => {VIEW}.ask('sceneLine').then(linkOf)).then((link) => location.hash === `#${{link}}`)")
        link, picture = page.run("location.href"), page.picture()
        with Page(link) as other:
            self.assertEqual(other.picture(), picture)
            self.assertEqual(other.run("location.href"), link)

    def test_gallery_and_back(self):
        page = self.page
        page.click("#tab-scenes")
        groups = len(page.ask("gallery"))
        self.assertEqual(page.run("document.querySelectorAll('#scenes a').length"), groups)
        page.click("#scenes a[data-name=flat]")
        page.wait("location.hash === '#flat' && document.querySelector('h1').textContent === 'Flat'")
        page.run("history.back()")
        page.wait(f"location.hash === '{GRID}' && document.querySelector('h1').textContent === 'Sky grid'")
        page.click("#tab-settings")

    def test_png(self):
        size = self.page.run(f"{VIEW}.png().then((png) => createImageBitmap(png)).then((image) => [image.width, image.height])")
        self.assertEqual(size, self.page.run(f"[{VIEW}.clientWidth, {VIEW}.clientHeight]"))

    def test_polarised_light(self):
        """Ticks over the picture, along a polariser's axis behind one, in the PNG too; streamlines in the picture itself."""
        page = self.page
        page.run(f"{VIEW}.open({json.dumps(TICKED)})")
        page.wait(f"{VIEW}.ticks?.lines.length > 0", 300)
        page.run("document.querySelector('[data-section=picture]').open = true")
        page.wait("document.querySelector(\"[data-key='picture.ticks']\").checkVisibility()")
        slider = "document.querySelector(\"[data-key='picture.polariser'] input[type=range]\")"
        self.assertEqual(page.run(f"[{slider}.value, {slider}.ariaValueText]"), ["0", "none"])
        page.run(f"{VIEW}.set('picture.polariser', '30')")
        axes = f"(({{ lines }}) => lines.filter((_, i) => i % 4 > 1))({VIEW}.ticks)"
        page.wait(f"{VIEW}.ask('whole').then(() => Math.abs({axes}[1] / {axes}[0] - 0.57735) < 1e-3)")
        ends = page.run(axes)
        for right, up in zip(ends[::2], ends[1::2]):
            self.assertAlmostEqual(up / right, 3 ** -0.5, delta=1e-3)
        # A picture's pixel near the end of the first tick, or of its mirror image.
        light = f"""(async (image, mirrored) => {{ const [x, y, right, up] = {VIEW}.ticks.lines, drawing = new OffscreenCanvas(800, 320).getContext("2d");
            drawing.drawImage(await image, 0, 0);
            return [...drawing.getImageData(Math.floor(x + 0.6 * right), Math.floor(y + (mirrored ? 0.6 : -0.6) * up), 1, 1).data]; }})"""
        over = f"{VIEW}.shadowRoot.querySelector('[part=ticks]')"
        self.assertGreater(min(page.run(f"{light}({over}, false)")), 200)
        self.assertLess(page.run(f"{light}({over}, true)")[3], 100)
        bare = f"{VIEW}.ask('picture').then(({{ width, height, pixels }}) => createImageBitmap(new ImageData(pixels, width, height)))"
        self.assertLess(min(page.run(f"{light}({bare}, false)")), 120)
        self.assertGreater(min(page.run(f"{light}({VIEW}.png().then(createImageBitmap), false)")), 160)
        page.click("[data-key='picture.polariser'] input[type=number]")
        page.run("document.activeElement.value = ''; document.activeElement.dispatchEvent(new Event('change'))")
        page.wait(f"{VIEW}.ask('sceneLine').then((line) => !line.includes('polariser'))")
        page.run(f"{VIEW}.set('picture.ticks', '\"off\"')")
        page.wait(f"{VIEW}.ticks === null && {VIEW}.shadowRoot.querySelector('[part=ticks]').hidden")
        lit = f"""{VIEW}.ask('picture').then(({{ pixels }}) => {{
            window.before ??= pixels;
            return pixels.reduce((sum, value, i) => sum + (i % 4 < 3 ? value : 0), 0);
        }})"""
        plain = page.run(lit)
        page.run(f"{VIEW}.set('picture.streamlines', '\"on\"')")
        self.assertLess(page.run(lit), 0.97 * plain)
        self.assertTrue(page.run(f"{VIEW}.ask('picture').then(({{ pixels }}) => pixels.every((value, i) => value <= before[i]))"))

    def test_cards_have_the_titles_of_their_scenes(self):
        """Also of scenes whose images the page has not fetched."""
        wanted = {file.stem: tomllib.loads(file.read_text()) for file in (ROOT / "assets/scenes").glob("*.toml")}
        shown = {scene["name"]: scene for scene in self.page.ask("gallery")}
        self.assertGreater(len(shown), 20)
        for name, scene in shown.items():
            self.assertEqual((scene["title"], scene["description"]), (wanted[name]["name"], wanted[name]["description"]))

    def test_telescope(self):
        """The null follows the camera as its closed form says; the beam lies over the picture; a closed panel finds nothing."""
        page = self.page
        page.run(f"{VIEW}.open({json.dumps(BALL)})")
        page.run(f"window.found = null, {VIEW}.addEventListener('telescope', ({{ detail }}) => (window.found = detail))")

        def null_and_formula():
            page.wait("window.found?.curve?.length === 129", 300)    # of the picture at rest
            seen = 16 / math.sqrt(1 - (8 / page.camera()["r"]) ** 2) * 7.637986504702 * math.pi / 180 / 3600e6
            return page.run("window.found.minimum[0]"), 1e-9 * 1.219669891 / seen
        page.click("#tab-telescope")
        near, known = null_and_formula()
        self.assertFalse(page.shown("#telescope [aria-label=Object]"))   # it is m87
        self.assertAlmostEqual(near / known, 1, delta=0.01)
        self.assertIn("Gλ", page.text("#telescope .figures"))
        x, y = page.centre()
        page.run("window.found = null")
        for _ in range(6):
            page.mouse("mouseWheel", x, y, deltaX=0, deltaY=100)
        page.wait(f"{VIEW}.drawn.place[0] > 30 && {VIEW}.left === 0")
        page.run("window.found = null")
        page.run(f"{VIEW}.ask('touch')")
        far, known = null_and_formula()
        self.assertAlmostEqual(far / known, 1, delta=0.01)
        self.assertGreater(far, 1.04 * near)
        self.assertFalse(page.shown("#beam"))
        page.run("{ const list = document.querySelector('#telescope select'); list.value = 1; list.dispatchEvent(new Event('change')); }")
        page.wait("document.querySelector('#beam').checkVisibility()")
        edge, middle = page.run("""(() => { const over = document.querySelector('#beam'), { width, height } = over;
            const { data } = over.getContext('2d').getImageData(0, height / 2, width, 1);
            return [0.05, 0.5].map((x) => data[4 * Math.floor(x * width)]); })()""")
        self.assertGreater(middle, edge + 100)
        page.run(f"{VIEW}.change((now) => now.set('split', '{{ metric = \"schwarzschild\" }}'))")
        page.wait("document.querySelector('#telescope-says').textContent.includes('split')")
        self.assertFalse(page.shown("#beam"))
        page.click("#tab-settings")
        page.run(f"{VIEW}.ask('sceneLine').then(() => (window.found = 'none'))")
        self.page.fresh()
        page.run(f"{VIEW}.ask('whole')")
        self.assertEqual(page.run("window.found"), "none")

    def test_a_scene_whose_size_in_the_sky_nobody_knows(self):
        """The panel says whose it takes, what is missing, and gives the scene one."""
        page = self.page
        page.run(f"{VIEW}.open({json.dumps(BALL.replace('[object]', '').replace('name = ' + chr(34) + 'm87' + chr(34), ''))})")
        page.click("#tab-telescope")
        page.wait("/As if of M87.*Choose an object/.test(document.querySelector('#telescope-says').textContent)", 300)
        self.assertTrue(page.shown("#telescope [aria-label=Object]"))
        choose = "{ const list = document.querySelector('#telescope [aria-label=Object]'); list.value = %d; list.dispatchEvent(new Event('change')); }"
        page.run(choose % 2)
        page.wait("/^Sgr A/.test(document.querySelector('#telescope-says').textContent)", 300)
        self.assertEqual(page.values()["object.name"], "sgr-a")
        self.assertTrue(page.shown("#telescope [aria-label=Object]"))
        page.run(choose % 0)
        page.wait("/^As if of M87/.test(document.querySelector('#telescope-says').textContent)", 300)
        page.click("#tab-settings")
        page.fresh()

    def test_proof(self):
        page = self.page
        page.click("#tab-proof")
        page.wait("document.querySelector('.plan').textContent.includes('spacetime.metric')")
        page.click("#measure")
        page.wait("document.querySelector('#certificate').checkVisibility()", 240)
        text = page.text("#certificate")
        self.assertRegex(text, r"largest error   \d[.\d]*(e-\d+)? px")
        self.assertRegex(text, r"places          [1-9]")
        self.assertRegex(text, r"wrong fates     0\b")
        for part in ("SwiftShader", "Sky grid", "480 x 320", "every one", GRID):
            self.assertIn(part, text)
        self.assertTrue(page.shown("#heat"))
        x, y = page.centre()
        page.drag([(x, y), (x + 5, y)])
        self.assertFalse(page.shown("#heat"))
        page.click("#tab-settings")

    def test_nothing_is_certified_where_all_is_black(self):
        page = self.page
        page.run(f"{VIEW}.set('camera.r', '1.046')")
        page.click("#tab-proof")
        page.click("#measure")
        page.wait("/certifies no precision/.test(document.querySelector('#proof [role=status]').textContent)", 120)
        self.assertFalse(page.shown("#certificate"))
        self.assertNotIn("0 px", page.text("#proof .figures"))
        page.click("#tab-settings")

    def test_lost_context(self):
        page = self.page
        picture = page.picture()
        page.ask("loseContext")
        page.wait(f"/gone/.test({VIEW}.message.textContent) && !{VIEW}.message.hidden")
        page.ask("restoreContext")
        page.wait(f"{VIEW}.message.hidden")
        self.assertEqual(page.picture(), picture)

    def test_everything_has_a_name(self):
        page = self.page
        page.run("for (const section of document.querySelectorAll('#settings details')) section.open = true")
        for tab in ("scenes", "telescope", "proof", "settings"):
            page.click(f"#tab-{tab}")
            for node in page.page("Accessibility.getFullAXTree")["nodes"]:
                role, name = node.get("role", {}).get("value"), node.get("name", {}).get("value", "")
                if role in ("button", "slider", "spinbutton", "switch", "combobox", "textbox", "link", "tab", "ColorWell"):
                    self.assertNotEqual(name.strip(), "", node)


class Phone(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.page = Page(SERVER.url + GRID, PHONE)

    @classmethod
    def tearDownClass(cls):
        cls.page.close()

    def test_fingers(self):
        page = self.page
        before = page.camera()
        page.touch("touchStart", [(150, 250)])
        for x in (160, 175, 190):
            page.touch("touchMove", [(x, 250)])
        page.touch("touchEnd", [])
        looked = page.camera()
        self.assertLess(looked["yaw"], before["yaw"])
        self.assertEqual(looked["r"], before["r"])
        page.touch("touchStart", [(150, 250)])
        page.touch("touchStart", [(150, 250), (210, 250)])
        page.touch("touchMove", [(140, 250), (220, 250)])
        page.touch("touchMove", [(120, 250), (240, 250)])
        page.touch("touchEnd", [])
        self.assertAlmostEqual((page.camera()["r"] - 1) / (looked["r"] - 1), 0.5, delta=1e-6)

    def test_sheet(self):
        page = self.page
        self.assertFalse(page.shown("#settings"))
        for tab in ("scenes", "settings", "proof"):
            page.tap(f"#tab-{tab}")
            page.wait(f"document.querySelector('#{tab}').checkVisibility()")
            self.assertEqual(page.run("[document.documentElement.scrollWidth, document.body.scrollWidth]"), [360, 360])
            wide = page.run(f"""[...document.querySelectorAll('#{tab} *')].filter((e) => e.checkVisibility()
                && e.getBoundingClientRect().right > 360.5).map((e) => e.outerHTML.slice(0, 80))""")
            self.assertEqual(wide, [])
            small = page.run("""[...document.querySelectorAll('button, summary, select, input')].filter((e) => e.checkVisibility()
                && !e.matches('.switch, .name') && Math.max(e.clientHeight, e.offsetHeight) < 36).map((e) => e.outerHTML.slice(0, 80))""")
            self.assertEqual(small, [])
        page.tap("#tab-proof")
        page.wait("!document.querySelector('#proof').checkVisibility()")


class Elsewhere(unittest.TestCase):
    def test_offline(self):
        server = Server(PAGE)
        with Page(server.url + GRID) as page:
            page.wait("navigator.serviceWorker.ready.then((there) => there.active?.state === 'activated')")
            page.wait("Boolean(navigator.serviceWorker.controller)")
            server.close()
            server.http.server_close()
            page.page("Network.setCacheDisabled", cacheDisabled=True)
            page.page("Page.reload")
            page.until_drawn()
            page.wait("document.querySelector('h1').textContent === 'Sky grid'")

    def test_one_script_and_one_element_on_another_site(self):
        class Open(Quiet):
            def end_headers(self):
                self.send_header("Access-Control-Allow-Origin", "*")
                super().end_headers()

        http_server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Open, directory=str(PAGE)))
        threading.Thread(target=http_server.serve_forever, daemon=True).start()
        with Page(SERVER.url + "icon.png", drawn=False) as page:
            page.wait("document.readyState === 'complete'")
            page.run(f"""document.body.innerHTML = '<nullscope-view scene="sky-grid"></nullscope-view>';
                const script = document.createElement("script");
                script.type = "module", script.src = "http://127.0.0.1:{http_server.server_port}/view.js";
                document.body.append(script);""")
            page.wait(f"Boolean({VIEW}?.drawn)")
            page.run(f"{VIEW}.setAttribute('scene', 'flat')")
            page.wait(f"{VIEW}.ask('sceneLine').then((line) => line.includes('minkowski'))")
            self.assertIn("no scene of this name", page.run(f"{VIEW}.open('nosuch').catch((error) => error.message)"))
        http_server.shutdown()
        http_server.server_close()

    def test_without_float_targets(self):
        with Page(SERVER.url + GRID, script=WITHOUT % "buffer_float") as page:
            page.click("#tab-proof")
            page.click("#measure")
            page.wait("/cannot draw to textures of floats/.test(document.querySelector('#proof [role=status]').textContent)")

    def test_without_halves(self):
        with Page(SERVER.url + GRID, script=WITHOUT % "float", drawn=False) as page:
            page.wait(f"/cannot draw to textures of floats/.test({VIEW}?.message?.textContent)")

    def test_without_webgl(self):
        with Page(SERVER.url, script=NO_WEBGL, drawn=False) as page:
            page.wait(f"/no WebGL2/.test({VIEW}?.message?.textContent)")
            self.assertTrue(page.run(f"!{VIEW}.message.hidden"))


if __name__ == "__main__":
    PAGE = begin()[0]
    SERVER = Server(PAGE)
    unittest.main(verbosity=2)
