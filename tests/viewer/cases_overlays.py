"""Cases of what lies over the picture and beside it; each runs viewers of its own."""
import math
import re
import subprocess
import tomllib

from viewer_process import *
from x_screen import read_png

DARK = '[camera]\nr = 22.0\nfov = 60.0\n[sky]\nkind = "black"\n'
FLAMM = (120, 255, 150)     # of the photon sphere's circle


def opened(screen, program, *arguments, **more):
    return Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}", "--layout", "layout.txt", *arguments, **more)


def says(v, words):
    return any(words in text for _, text, _ in v.layout().texts)


def from_menu(v, menu, entry):
    v.click(*v.layout().place(menu, "##MainMenuBar"))
    v.click(*v.layout().place(entry, "##Menu"))


def shut_sections(v):
    for section in ("Camera", "Speed of the camera", "Lens"):
        v.click(*v.layout().place(section, "##side"))


def swept(r, alpha):
    """Angle that light sweeps to infinity about a hole of r_s = 1, from r, alpha from the direction to the hole: u'' = 1.5 u^2 - u."""
    u, slope = 1 / r, math.sqrt(1 - 1 / r) / (r * math.tan(alpha))
    angle, step = 0.0, 1e-4
    while u > 0:
        def force(x):
            return 1.5 * x * x - x
        k1, l1 = slope, force(u)
        k2, l2 = slope + step / 2 * l1, force(u + step / 2 * k1)
        k3, l3 = slope + step / 2 * l2, force(u + step / 2 * k2)
        k4, l4 = slope + step * l3, force(u + step * k3)
        u += step / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        slope += step / 6 * (l1 + 2 * l2 + 2 * l3 + l4)
        angle += step
        if u > 1:
            return math.inf
    return angle


def test_units_are_chosen_and_kept(screen, program, folder):
    with opened(screen, program, "--coarse", "4", home=folder) as v:
        shut_sections(v)
        v.click(*v.layout().place("Numbers", "##side"))
        assert says(v, "1.5 r_s") and not says(v, "3 M"), "the radii are not in r_s at first"
        v.click(*v.layout().place("M", "##side"))
        assert says(v, "3 M") and not says(v, "1.5 r_s"), "the radii are not in M"
        v.settle("key", "p", "mousemove", 600, 250)
        assert says(v, " M/c") or says(v, " M"), "the probe is not in M"
        v.click(*v.layout().place("km", "##side"))
        assert says(v, "1.9035e+07 km"), "the photon orbit about Sgr A* is not in km"
        assert says(v, "1.9035e+07 km") and "km" in v.layout().words(), v.layout().words()
        v.click(*v.layout().place("comma", "##side"))
        assert says(v, "1,9035e+07 km"), "there is no decimal comma"
        v.settle("mousemove", 600, 250)
        from_menu(v, "View", "Clock and redshift")
        assert says(v, "0,977008"), "the clock has no decimal comma"
        v.settle("key", "ctrl+s")
        saved = next(path for path in Path(v.folder).glob("*.toml") if path != v.scene)
        assert tomllib.loads(saved.read_text())["camera"]["r"] == 22.0, "a saved number was changed"
        assert tomllib.loads(v.settings.read_text())["units"] == "km", v.settings.read_text()
    with opened(screen, program, "--coarse", "4", home=folder, settings='units = "km"\nmass_suns = 1.0\ndecimal_comma = true\n') as v:
        shut_sections(v)
        v.click(*v.layout().place("Numbers", "##side"))
        assert says(v, "4,4299 km"), "the settings' mass is not used"


def test_a_path_is_eased(screen, program, folder):
    with opened(screen, program, "--coarse", "4") as v:
        v.settle("key", "ctrl+t")
        v.click(*v.layout().place("Set key", "##timeline"))
        x, y = v.layout().place("Ease", "##timeline")
        v.click(x - 25, y)
        v.settle("key", "ctrl+s")
        saved = next(path for path in Path(v.folder).glob("*.toml") if path != v.scene)
        assert tomllib.loads(saved.read_text())["path"].get("easing") == "smooth", "Ease does not change the path"


def test_image_orders_are_coloured(screen, program, folder):
    direct, first = (19, 52, 120), (120, 89, 14)     # over black
    near = lambda pixel, colour: max(abs(a - b) for a, b in zip(pixel, colour)) <= 3
    with opened(screen, program, scene=DARK) as v:
        v.settle("key", "Tab")
        v.settle("key", "o")
        data = v.picture((0, HEIGHT // 2, WIDTH, HEIGHT // 2 + 1)).data
        row = [tuple(data[i:i + 3]) for i in range(0, len(data), 3)]
        assert near(row[0], direct), f"the direct sky is {row[0]}"
        assert row[WIDTH // 2] == (0, 0, 0), "the shadow is coloured"
        low, high = 0.13, 0.6     # rad, on either side of the ring where the angle is pi
        for _ in range(30):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if swept(22.0, middle) > math.pi else (low, middle)
        ring = WIDTH / 2 / math.tan(math.radians(30)) * math.tan(low)
        edge = next(x for x, pixel in enumerate(row) if near(pixel, first))
        assert abs(WIDTH / 2 - edge - ring) < 1.5, f"the first order begins {WIDTH / 2 - edge} px from the middle, not {ring:.1f}"
        coloured = v.picture()
        v.settle("key", "o")
        assert v.picture().changed(coloured, CHANGED), "O does not take the colours away"
    kerr = DARK + '[spacetime]\nmetric = "kerr"\n'
    with opened(screen, program, scene=kerr) as v:
        plain = v.settle()
        v.settle("key", "o")
        assert says(v, "Not about a rotating hole"), "no reason is given"
        same(plain, v.picture((320, 300, 820, 490)), "a picture that cannot be coloured")
        v.click(*v.layout().place("View", "##MainMenuBar"))
        v.settle("mousemove", *v.layout().place("Image orders", "##Menu"))
        assert any(name.startswith("##Tooltip") and "rotating" in words for name, words, _ in v.layout().texts), "no tooltip says why"


def test_both_sides_of_a_comparison_have_image_orders(screen, program, folder):
    direct = (19, 52, 120)     # over black
    flat_direct = lambda v, x: max(abs(a - b) for a, b in zip(v.picture((x, 300, x + 1, 301)).data, direct)) <= 3
    with opened(screen, program, scene=DARK) as v:
        shut_sections(v)
        v.settle("key", "x")
        v.click(*v.layout().place("Light", "##side"))
        v.click(*LENSING)
        v.settle("key", "o")
        v.settle("mousemove", 700, 560)
        assert flat_direct(v, WIDTH // 2 - 100), "side A is not coloured"
        assert flat_direct(v, WIDTH - 20), "side B is not coloured"
        assert v.picture((WIDTH // 2 + 20, 300, WIDTH // 2 + 21, 301)).mean() == 0, "the shadow of side B is coloured"
        v.settle("key", "x")
        assert flat_direct(v, WIDTH - 20), "A alone is not coloured"
    with opened(screen, program, scene=DARK) as v:
        shut_sections(v)
        v.settle("key", "x")
        v.click(*v.layout().place("Spacetime", "##side"))
        v.click(*METRIC)
        v.click(*v.layout().place("kerr", "##Combo"))
        v.settle("key", "o", "mousemove", 700, 560)
        assert flat_direct(v, WIDTH - 20) and not flat_direct(v, WIDTH // 2 - 100), "not the side that does not rotate alone"


def test_lengths_of_the_panels_are_in_the_chosen_unit(screen, program, folder):
    units = 'units = "M"\n'
    scene = "[camera]\nr = 22.0\n[disc]\n[ball]\nposition = [6, 6, -3]\nradius = 3\n"
    with opened(screen, program, "--coarse", "4", scene=scene, settings=units) as v:
        assert says(v, "44 M") and says(v, "42 M"), v.layout().words()
        x, y = v.layout().place("44 M", "##side")
        v.click(x, y)
        v.settle("mousemove", x, y, "mousedown", 1)
        v.settle("mouseup", 1, "key", "ctrl+a")
        v.settle("key", "6", "key", "0", "key", "Return")  # as where a frame takes long
        v.settle("mousemove", *BESIDE)
        assert says(v, "60 M") and says(v, "58 M"), v.layout().words()
        shut_sections(v)
        v.click(*v.layout().place("Disc", "##side"))
        assert says(v, "6 M") and says(v, "24 M"), v.layout().words()
        v.settle("key", "ctrl+e")
        v.click(*v.layout().place("ball", "##sections"))
        assert says(v, "3 r_s = 6 M"), v.layout().words()
        v.settle("mousemove", *v.layout().place("position", "##sections"))
        assert says(v, "value = 12 M, 12 M, -6 M"), v.layout().words()
        v.settle("key", "ctrl+s", "mousemove", *BESIDE)
        saved = next(path for path in Path(v.folder).glob("*.toml") if path != v.scene)
        assert tomllib.loads(saved.read_text())["camera"]["r"] == 30.0, "60 M are not 30 r_s"


def test_the_embedding_diagram_is_drawn(screen, program, folder):
    with opened(screen, program, scene=DARK) as v:
        area = (300, 300, 600, 580)
        assert v.count(area, FLAMM) == 0, "a diagram that nobody asked for"
        from_menu(v, "View", "Embedding diagram")
        assert says(v, "Embedding diagram") and v.count(area, FLAMM) > 20, "no photon sphere in the diagram"
        before = v.count(area, RAY)
        v.settle("key", "p", "mousemove", 500, 200)
        assert v.count(area, RAY) > before + 20, "the probe's ray is not in the diagram"
        from_menu(v, "View", "Embedding diagram")
        assert v.count(area, FLAMM) == 0, "the diagram stays"
    with opened(screen, program, scene=DARK + '[spacetime]\nmetric = "kerr"\n') as v:
        v.click(*v.layout().place("View", "##MainMenuBar"))
        v.settle("mousemove", *v.layout().place("Embedding diagram", "##Menu"))
        assert any(name.startswith("##Tooltip") and "rotating" in words for name, words, _ in v.layout().texts), "no tooltip says why"


def test_framing_guides_lie_over_the_picture(screen, program, folder):
    area = (2 * WIDTH // 3 - 2, HEIGHT // 2 + 40, 2 * WIDTH // 3 + 3, HEIGHT // 2 + 90)   # right of the panels, beside the middle
    with opened(screen, program, scene=DARK) as v:
        dark = v.picture(area).data
        from_menu(v, "View", "Framing guides")
        shown = v.picture(area).data
        assert shown != dark, "no line at two thirds of the width"
        from_menu(v, "View", "Framing guides")
        assert v.picture(area).data == dark, "the guides stay"


def test_the_histogram_says_what_the_saved_picture_has(screen, program, folder):
    def judged(v):
        v.settle("key", "F12")
        path = next(Path(v.folder).glob("nullscope-*.png"))
        data = read_png(path).data
        path.unlink()
        pixels = list(zip(data[0::3], data[1::3], data[2::3]))
        luma = sorted((2126 * r + 7152 * g + 722 * b + 5000) // 10000 for r, g, b in pixels)
        at = lambda share: f"{luma[math.ceil(share * len(luma)) - 1] / 2.55:.1f} %"
        part = lambda known: f"{100 * sum(map(known, pixels)) / len(pixels):.2f} %"
        return {"Median": at(0.5), "99 % below": at(0.99), "Brightest": at(1.0), "Clipped": part(lambda p: max(p) == 255),
                "Black": part(lambda p: max(p) == 0)}

    def shown(v):
        rows = {}
        for _, words, (_, y, _, height) in [text for text in v.layout().texts if text[0] == "Histogram"]:
            rows.setdefault((y + height // 2 + 3) // 19, []).append(words)
        words = [" ".join(row) for row in rows.values()]
        return {name: next(row for row in words if row.startswith(name)).removeprefix(name).strip() for name in judged(v)}
    scene = DARK + '[disc]\nbrightness = 3.0\n'
    with opened(screen, program, scene=scene) as v:
        assert "Histogram" not in v.layout().windows
        v.settle("key", "g")
        first = shown(v)
        assert first == judged(v), (first, judged(v))
        x, y = v.layout().place("+0.00 EV", "Histogram")
        v.settle("mousemove", x, y, "mousedown", 1)
        v.settle("mousemove", x + 40, y, "mouseup", 1)
        brighter = shown(v)
        assert brighter == judged(v) != first, (brighter, judged(v))
        v.settle("key", "Escape")
        assert "Histogram" not in v.layout().windows, "Escape does not close it"


SPOT = """[camera]
r = 100.0
theta = 160.0
fov = 14.0
[sky]
kind = "black"
[disc]
emission = "thermal"
inner = 3.0
outer = 8.0
brightness = 0.0
opacity = 0.0
polarisation = "synchrotron"
[spot]
r = 5.0
temperature = 20000.0
brightness = 50.0
"""


def test_the_loop_of_a_hot_spot_is_drawn_behind_its_picture(screen, program, folder):
    with opened(screen, program, scene=SPOT) as v:
        assert "Q-U_loop" not in v.layout().windows
        v.settle("key", "u", measured=True)
        assert says(v, "2 clockwise"), v.layout().texts
        net = next(words for window, words, _ in v.layout().texts if window == "Q-U_loop" and words.endswith(" %") and not words.startswith("Q"))
        v.settle("key", "Escape")
        assert "Q-U_loop" not in v.layout().windows, "Escape does not close it"
        # The number that capture prints of the whole picture, but for what few pixels miss.
        file = Path(v.folder) / "spot.toml"
        file.write_text(SPOT)
        cli = Path(program).with_name("nullscope")
        said = subprocess.run([cli, "capture", file, "--size", f"{WIDTH}x{HEIGHT}", "-o", Path(v.folder) / "spot.png"], capture_output=True, text=True, check=True)
        known = float(re.search(r"polarised ([\d.e+-]+) % net", said.stdout).group(1))
        assert abs(float(net.removesuffix(" %")) - known) < 0.02 * known, (net, known)
    with opened(screen, program, scene=DARK + "[disc]\n") as v:   # nothing goes round
        v.settle("key", "u")
        assert "Q-U_loop" not in v.layout().windows


# A bright ball of 8 r_s in flat space: a uniform disc, wider near by as only its nearer part is seen. A r_s is 7.638 microarcseconds.
BALL_OF_M87 = """[spacetime]
metric = "minkowski"
[camera]
r = 20.0
fov = 70.0
[sky]
kind = "black"
[object]
name = "m87"
[sphere]
radius = 8
texture = "plain"
colour = [1, 1, 1]
"""


def test_the_telescope_follows_the_camera(screen, program, folder):
    def null_and_formula(v):
        r = next(float(words.split()[0]) for _, words, _ in v.layout().texts if re.fullmatch(r"[\d.]{5,} r_s", words))
        null = next(float(words.split()[0]) for window, words, _ in v.layout().texts if window == "Telescope" and " Gλ: " in words)
        seen = 2 * 8 / math.sqrt(1 - (8 / r) ** 2) * 7.637986504702 * math.pi / 180 / 3600e6     # rad, across
        return null, 1e-9 * 1.219669891 / seen     # the first zero of J1, over pi
    with opened(screen, program, scene=BALL_OF_M87) as v:
        plain = v.settle("mousemove", *BESIDE)
        assert "Telescope" not in v.layout().windows
        v.settle("key", "t")
        near, known = null_and_formula(v)
        assert abs(near / known - 1) < 0.01, (near, known)
        v.settle("mousemove", 420, 300, *["click", 5] * 8, "mousemove", *BESIDE)
        far, known = null_and_formula(v)
        assert abs(far / known - 1) < 0.01 and far > 1.05 * near, (near, far, known)
        assert not says(v, "rough")
        v.settle("mousemove", 420, 300, "mousedown", 1)
        v.settle("mousemove", 520, 300, "mouseup", 1)
        assert says(v, "rough"), "a camera that looks aside"
        v.settle("key", "r", "mousemove", *BESIDE)
        assert abs(null_and_formula(v)[0] / near - 1) < 1e-6
        v.settle("key", "Escape")
        same(plain, v.settle(), "the picture after the panel was closed")


def test_the_picture_is_seen_through_a_telescopes_beam(screen, program, folder):
    area = (330, 80, 450, 320)     # left of the panel: the ball's upper half
    with opened(screen, program, scene=BALL_OF_M87) as v:
        v.settle("key", "t", "mousemove", 420, 300, *["click", 5] * 8, "mousemove", *BESIDE)
        plain = v.picture(area)
        v.click(*v.layout().place("as it is", "Telescope"))
        v.click(*v.layout().place("through a beam", "##Combo"))
        beam = v.picture(area)
        assert beam.changed(plain, CHANGED), "the beam changes nothing"
        steepest = lambda picture: max(abs(picture.grey(60, y) - picture.grey(60, y + 1)) for y in range(picture.height - 1))
        assert steepest(beam) < 0.2 * steepest(plain), (steepest(beam), steepest(plain))
        x, y = v.layout().place("20.0 µas", "Telescope")
        v.click(x - 100, y)     # 7 µas
        assert steepest(v.picture(area)) > 1.5 * steepest(beam), "a narrower beam is not sharper"
        v.settle("mousemove", *BESIDE, "key", "F12")
        saved = next(Path(v.folder).glob("nullscope-*.png"))
        assert read_png(saved).crop(*area).differing(v.picture(area)) < NOISE, "F12 does not save what is shown"
        v.settle("key", "Escape")
        same(plain, v.picture(area), "the picture after the panel was closed")


def test_the_windows_place_is_kept(screen, program, folder):
    def place(v):
        words = subprocess.run(["xdotool", "getwindowgeometry", v.window], env=v.env, capture_output=True, text=True).stdout
        return tuple(map(int, re.search(r"Position: (-?\d+),(-?\d+)", words).groups()))
    size = ["--size", "500x400"]
    with Viewer(screen, program, *size, home=folder) as v:
        v.settle("windowmove", v.window, 60, 35)
        v.hands("key", "ctrl+q")
        assert v.process.wait(timeout=HUNG_S) == 0
        kept = v.settings.read_text()
        assert tomllib.loads(kept).get("window_place") == [60, 35], kept
    with Viewer(screen, program, *size, home=folder, settings="window_place = [60, 35]\n") as v:
        assert place(v) == (60, 35), f"it is at {place(v)}"
    with Viewer(screen, program, *size, home=folder, settings="window_place = [90000, -90000]\n") as v:
        left, top = place(v)
        assert 0 <= left <= WIDTH and top == 0, f"a window beyond the screen is put at {left}, {top}"


def press(v, *keys):
    """Down and up in frames of their own."""
    for key in keys:
        v.settle("keydown", key)
        v.settle("keyup", key)


def test_panels_are_used_by_keyboard(screen, program, folder):
    with opened(screen, program) as v:
        shut_sections(v)
        home = v.settle()
        v.settle("key", "ctrl+Tab")
        press(v, "Down", "End")     # the last header
        press(v, "Return")
        assert says(v, "Photon orbit"), "Enter does not open the section Numbers"
        v.settle("key", "w")
        press(v, "End", "Right", "Return")   # the last controls there: Decimals, point and comma
        assert says(v, "0,977008"), "Enter does not choose the comma"
        press(v, "Left", "space")
        assert says(v, "0.977008"), "Space does not choose the point"
        same(home, v.picture(), "W in the panels flies the camera")
        press(v, "Home", "Return")
        assert says(v, "accretion"), "Enter does not open the list of scenes"
        press(v, "Escape")
        assert not says(v, "accretion"), "Escape does not shut the list"
        v.settle("key", "w")
        same(home, v.picture(), "Escape leaves the panels with the list")
        v.settle("key", "Escape")
        v.settle("key", "w")
        assert v.picture().changed(home, CHANGED), "after Escape W does not fly"
        v.settle("key", "r")
        v.settle("key", "ctrl+Tab")
        v.settle("mousemove", 600, 400, "mousedown", 1)
        v.settle("mouseup", 1)
        v.settle("key", "w")
        assert v.picture().changed(home, CHANGED), "after a click on the picture W does not fly"


def test_the_sides_of_a_comparison_are_swapped(screen, program, folder):
    left, right = (320, 300, 400, 520), (640, 300, 820, 520)
    with opened(screen, program, "--coarse", "4") as v:
        shut_sections(v)
        v.settle("key", "shift+x")
        assert says(v, "Only in a comparison"), "Shift+X says nothing where there is no side B"
        v.settle("key", "x")
        v.click(*v.layout().place("Light", "##side"))
        v.click(*LENSING)
        sides = lambda: (v.picture(left), v.picture(right))
        straight, bent = sides()
        v.settle("key", "shift+x", "mousemove", *BESIDE)
        swapped = sides()
        assert swapped[0].changed(straight, CHANGED) and swapped[1].changed(bent, CHANGED), "the sides are not swapped"
        v.click(*LENSING)      # of what was side B
        v.settle("key", "ctrl+z")
        for one, other in zip(swapped, sides()):
            same(one, other, "after the switch was undone")
        v.settle("key", "ctrl+z")
        for one, other in zip((straight, bent), sides()):
            same(one, other, "after the swap was undone")
        v.settle("key", "ctrl+shift+z")
        for one, other in zip(swapped, sides()):
            same(one, other, "after the swap was done again")


def test_z_and_the_wheel_zoom_into_the_photon_ring(screen, program, folder):
    with Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}", "--coarse", "4", "--layout", "layout.txt", scene="photon-ring") as v:
        def zoomed(button, notches):
            v.settle("mousemove", 600, 300, "keydown", "z", *["click", button] * notches, "keyup", "z")
            return next((words for words in v.layout().words() if words.startswith("zoom")), "")
        plain = v.picture()
        assert zoomed(4, 5).startswith("zoom 5"), "five notches are not e^1.75"
        deep = zoomed(4, 60)
        assert deep.startswith("zoom 10^") and int(deep.rsplit(" ", 1)[1]) >= 6, deep
        before = v.picture()
        zoomed(4, 3)
        v.changes("the wheel goes on", before)
        v.settle("key", "ctrl+z")
        v.settle("key", "ctrl+z")
        assert not v.picture().changed(plain, CHANGED), "undo does not lead out"
        assert zoomed(5, 3) == "", "a zoom begins by going back"


def test_the_numbers_of_polarised_light_are_those_of_capture(screen, program, folder):
    """Of a small picture of its own, and of what the view turns to."""
    scene = shipped("m87-polarimetry").replace("outer = 15.0", "outer = 15.0\nfrequency = [228, 230]")
    percent = r"(-?[\d.e+-]+) %?"
    with Viewer(screen, program, "--size", "640x400", "--coarse", "2", "--layout", "layout.txt", scene=scene) as v:
        shut_sections(v)

        def measured():
            v.settle("mousemove", 150, 200, measured=True)   # the last row comes with the numbers
            seen, before = v.layout(), None
            while before is None or seen.texts != before.texts:   # to the end of the panel
                v.settle(*["click", 5] * 5)
                seen, before = v.layout(), seen
            value = lambda name: min((x, words) for words, (x, y) in seen.words().items()
                                     if abs(y - seen.place(name, "##side")[1]) < 9 and x > 100)[1]
            return [float(re.match(percent, value(name))[1]) for name in ("Net linear", "Resolved", "beta_2", "Net circular", "RM")]
        v.click(*v.layout().place("Numbers", "##side"))
        shown = measured()
        (folder / "bands.toml").write_text(scene)
        said = subprocess.run([Path(program).parent / "nullscope", "capture", folder / "bands.toml", "--size", "320x200", "-o",
                               folder / "bands.exr"], capture_output=True, text=True, check=True).stdout
        expected = [float(re.search(pattern + percent, said)[1])
                    for pattern in ("polarised ", "net, ", "beta_2 ", "circular ", "GHz ")]
        for one, other, bound in zip(shown, expected, (0.1, 0.2, 0.002, 0.1, 0.02 * abs(expected[4]))):
            assert abs(one - other) <= bound, f"{shown}, capture: {expected}"
        v.settle("mousemove", 500, 300, "mousedown", 1, "mousemove", 520, 360, "mouseup", 1)
        assert measured() != shown, "the numbers stay where the view has turned"


def test_what_changes_is_drawn_as_arrows(screen, program, folder):
    """A roll by 1 degree moves what is d px from the middle by d pi/180: half of the arrows of a picture of w x h lie within 0.383 of a side of a square."""
    scene = '[spacetime]\nmetric = "minkowski"\n[camera]\nr = 20.0\nfov = 40.0\n'
    with opened(screen, program, scene=scene) as v:
        plain = v.picture()
        v.settle("key", "j", measured=True)
        assert says(v, "camera.r + 1 %") and says(v, "nothing moves"), v.layout().texts   # a sky far away
        v.click(*v.layout().place("camera.r + 1 %", "What_changes"))
        v.click(*v.layout().place("camera.roll", "##Combo"))
        v.settle("mousemove", *BESIDE, measured=True)
        shown = {words: v.layout().place(words, "What_changes") for words in ("Median", "95 % below")}
        assert all(shown.values()), v.layout().texts
        v.changes("arrows are drawn", plain)
        median = next(float(words.removesuffix(" px").split()[-1]) for window, words, _ in v.layout().texts if window == "What_changes" and words.endswith(" px"))
        rows, columns = 22, int(WIDTH / (HEIGHT / 22))
        known = sorted(math.hypot((x + 0.5) / columns * WIDTH - WIDTH / 2, (y + 0.5) / rows * HEIGHT - HEIGHT / 2) for x in range(columns) for y in range(rows))
        assert abs(median - known[(len(known) - 1) // 2] * math.pi / 180) < 0.06 * median, (median, known[len(known) // 2] * math.pi / 180)
        v.settle("key", "Escape")
        assert "What_changes" not in v.layout().windows, "Escape does not close it"
    with opened(screen, program, scene=scene + 'observer = "rain"\n') as v:
        v.settle("key", "j", measured=True)
        assert says(v, "\"rain\": no"), v.layout().texts


def test_the_ray_about_a_rotating_hole_is_drawn(screen, program, folder):
    with opened(screen, program, scene=DARK + '[spacetime]\nmetric = "kerr"\n') as v:
        assert v.count(INSET, RAY) == 0, "a ray that nobody asked for"
        v.settle("key", "p", "mousemove", 500, 200)
        assert says(v, "Windings") and v.count(INSET, RAY) > 20, "no ray is drawn"
        v.settle("mousemove", WIDTH // 2 + 60, HEIGHT // 2)
        assert v.count(INSET, RAY) > 20, "no ray beside the shadow"


def test_the_ring_of_a_rotating_hole_can_be_zoomed_into(screen, program, folder):
    with Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}", "--coarse", "4", "--layout", "layout.txt", scene="kerr") as v:
        plain = v.picture()
        v.settle("mousemove", 600, 300, "keydown", "z", *["click", 4] * 60, "keyup", "z")
        words = next((words for words in v.layout().words() if words.startswith("zoom")), "")
        assert words.startswith("zoom 10^") and int(words.rsplit(" ", 1)[1]) >= 6, words
        v.changes("the picture is the ring", plain)


CASES = []
# Of every depth but quick.
if EVERYTHING:
    CASES += [test_both_sides_of_a_comparison_have_image_orders, test_lengths_of_the_panels_are_in_the_chosen_unit,
              test_z_and_the_wheel_zoom_into_the_photon_ring, test_the_ring_of_a_rotating_hole_can_be_zoomed_into,
              test_the_numbers_of_polarised_light_are_those_of_capture, test_what_changes_is_drawn_as_arrows,
              test_units_are_chosen_and_kept, test_a_path_is_eased, test_image_orders_are_coloured,
              test_the_embedding_diagram_is_drawn, test_the_ray_about_a_rotating_hole_is_drawn, test_framing_guides_lie_over_the_picture,
              test_the_histogram_says_what_the_saved_picture_has, test_the_loop_of_a_hot_spot_is_drawn_behind_its_picture,
              test_the_telescope_follows_the_camera, test_the_picture_is_seen_through_a_telescopes_beam,
              test_the_windows_place_is_kept,
              test_panels_are_used_by_keyboard, test_the_sides_of_a_comparison_are_swapped]
