"""Cases that run viewers of their own."""
import math
import os
import shutil
import struct
import subprocess
import time
import tomllib

from viewer_process import *
from x_screen import Picture, read_png, wait_until

ANSWER_MS = 50.0   # of processor time, divided by the machine's slowness: what an answer may take
# of the processor time that a whole picture costs the window's thread where it draws it: it must stay far below
WINDOWS_SHARE = 0.5
PICTURES = 8   # in flight: a second
COARSE = ["--size", f"{WIDTH}x{HEIGHT}", "--coarse", "4"]   # where panels are looked at, and pictures only for whether they change


def run(program, *arguments, **changes):
    env = {name: value for name, value in {**os.environ, **changes}.items() if value is not None}
    return subprocess.run([program, *arguments], env=env, capture_output=True, text=True, timeout=HUNG_S)


def test_screenshot(screen, program, folder):
    """Of whole pictures, whoever draws them."""
    shots = []
    for more in [[], ["--hidden", "--after-frames", "7"], ["--one-context"]]:
        path = folder / "window.png"
        done = run(program, "sky-only", "--size", "640x360", "--screenshot", path, *more, DISPLAY=screen.display)
        assert done.returncode == 0, f"{more}: exit status {done.returncode}: {done.stderr}"
        picture = read_png(path)
        assert (picture.width, picture.height) == (640, 360) and picture.mean() > 1, f"{more}: not a picture of 640x360"
        shots.append(picture.crop(300, 0, 640, 330))     # no panel lies here
        path.unlink()
    for shot in shots[1:]:
        same(shots[0], shot, "between screenshots of one scene")


def test_split_screens_have_a_line_and_labels(screen, program, folder):
    shots = []
    for labels in ("off", "on"):
        scene, path = folder / "split.toml", folder / "window.png"
        scene.write_text(f'[camera]\nr = 8\n[sky]\nkind = "black"\n[split]\nmetric = "minkowski"\nlabels = "{labels}"\n')
        done = run(program, scene, "--size", "960x540", "--screenshot", path, DISPLAY=screen.display)
        assert done.returncode == 0, done.stderr
        shots.append(read_png(path))
    for shot in shots:
        line = [max(shot.grey(x, y) for x in range(476, 485)) for y in range(MENU, 500)]
        assert min(line) > 600, "no line between the halves"
    without, labelled = (shot.crop(330, MENU, 960, 500) for shot in shots)     # no panel lies here
    for what, left, right in [("left", 0, 140), ("right", 160, 630)]:
        assert without.crop(left, 0, right, 40).mean() < 1, f"something on the {what} where nothing is asked for"
        assert labelled.crop(left, 0, right, 40).mean() > 2, f"no label on the {what}"
    same(without.crop(0, 60, 630, 479), labelled.crop(0, 60, 630, 479), "below the labels")


def test_polarised_light_is_shown(screen, program, folder):
    shots = {}
    for shown in ("off", "ticks", "streamlines"):
        scene, path = folder / "polarised.toml", folder / "window.png"
        scene.write_text('[camera]\nr = 25\ntheta = 60\nfov = 40\n[sky]\nkind = "black"\n[disc]\nemission = "thermal"\n'
                         'polarisation = "synchrotron"\n[picture]\n' + ("" if shown == "off" else f'{shown} = "on"\n'))
        done = run(program, scene, "--size", "960x540", "--screenshot", path, DISPLAY=screen.display)
        assert done.returncode == 0, done.stderr
        shots[shown] = read_png(path).crop(330, MENU, 960, 500)     # no panel lies here
    plain = shots["off"].data
    brighter = sum(a > b + 30 for a, b in zip(shots["ticks"].data, plain))
    assert brighter > len(plain) / 1000, f"no ticks: {brighter} of {len(plain)} values are brighter"
    darker = sum(a < b - 30 for a, b in zip(shots["streamlines"].data, plain))
    assert darker > len(plain) / 100, f"no streamlines: {darker} of {len(plain)} values are darker"
    assert all(a <= b for a, b in zip(shots["streamlines"].data, plain)), "streamlines make the picture brighter"


def test_the_gallery_finds_and_opens(screen, program, folder):
    with Viewer(screen, program, "--gallery", *COARSE) as v:
        cards = v.settle()
        saturated = sum(max(cards.data[i:i + 3]) > 120 for i in range(0, len(cards.data), 3))
        assert saturated > 2000, "no pictures of scenes"
        v.hands("type", "--delay", 100, "sky grid")
        found = v.settle()
        assert found.changed(cards, CHANGED), "the words that are typed find nothing"
        v.settle("key", "Return")
        grid = v.settle()
        assert v.title() == "Sky grid - nullscope", v.title()
        v.settle("key", "ctrl+o")
        same(cards, v.settle(), "the gallery, opened again")
        same(grid, v.settle("key", "Escape"), "the picture after the gallery was left")
        v.settle("key", "ctrl+o")
        v.click(*FIRST_CARD)
        assert v.title() == "First light - nullscope", v.title()
        v.settle("key", "ctrl+z")
        assert v.title() == "Sky grid - nullscope", "undo does not bring the scene before back"


def test_undo_in_a_search_that_was_left_does_not_touch_the_next(screen, program, folder):
    """Of fields whose text is another when they are entered again, Dear ImGui undoes what is not there."""
    with Viewer(screen, program, *COARSE, "--layout", "layout.txt") as v:
        v.settle("key", "ctrl+o")
        v.hands("type", "--delay", 60, "kerr planet")
        v.settle("key", "Escape")
        v.settle("key", "Escape")
        for _ in range(3):
            v.settle("key", "ctrl+o")
            v.settle("key", "ctrl+z")
            v.hands("type", "--delay", 60, "torus")
            v.settle()
            assert v.layout().place("torus", "##gallery"), v.layout().words()
            v.settle("key", "Escape")


def test_a_file_is_chosen_in_the_desktops_dialog(screen, program, folder):
    tools = folder / "tools"
    tools.mkdir()
    scene = folder / "chosen.toml"
    scene.write_text('name = "Chosen one"\n')
    (tools / "zenity").write_text(f"#!/bin/sh\necho warning >&2\nsleep 0.2\necho {scene}\n")
    (tools / "zenity").chmod(0o755)
    path = os.environ["PATH"]
    os.environ["PATH"] = f"{tools}:{path}"
    try:
        with Viewer(screen, program, "--gallery", *COARSE, "--layout", "layout.txt") as v:
            v.settle()
            v.click(*v.layout().words()["Browse..."])
            wait_until("the chosen file is open", lambda: v.title() == "Chosen one - nullscope", HUNG_S)
    finally:
        os.environ["PATH"] = path


def test_the_first_visit_has_hints_and_the_next_has_none(screen, program, folder):
    shots = []
    for first_visit in (True, False):
        v = Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}", first_visit=first_visit)
        try:
            v.window = wait_until("the window", v.find)
            v.hands("windowfocus", v.window, "mousemove", *BESIDE)
            wait_until("the picture", lambda: any(word == "rest" for word, _ in v.log.since()))
            shots.append(v.picture(HINTS))
            shots.append((v.settle("mousedown", 1, "mouseup", 1), v.picture(HINTS))[1])
            assert "hints_seen = true" in v.settings.read_text(), "that hints were seen is not kept"
        finally:
            v.kill()
    assert shots[0].changed(shots[1], CHANGED), "no hints"
    same(shots[2], shots[1], "where hints were")
    same(shots[2], shots[3], "where no hints were")


def test_menus_do_what_they_say(screen, program, folder):
    with Viewer(screen, program, *COARSE, "--layout", "layout.txt") as v:
        keys = v.picture(KEYS)
        v.choose("Help", "Keys")
        assert v.picture(KEYS).changed(keys, CHANGED), "Help, Keys shows no keys"
        v.settle("key", "F1")
        small = v.picture(SIDE)
        v.choose("View", "Larger text")
        assert v.picture(SIDE).changed(small, CHANGED), "View, Larger text changes nothing"
        assert "text_scale = 1.25" in v.settings.read_text(), "the size of text is not kept"
        v.settle("key", "ctrl+minus")
        same(small, v.picture(SIDE), "the panel with text of the first size")
        v.click(*MENUS["File"])
        v.settle("key", "Escape")
        assert v.process.poll() is None, "Escape quits while a menu is open"
        v.click(*MENUS["File"])
        v.hands("mousemove", *v.layout().place("Quit", "##Menu"), "mousedown", 1)
        v.hands("mouseup", 1)
        assert v.process.wait(timeout=HUNG_S) == 0, "File, Quit does not quit"


def test_the_critical_curve_is_synges_circle_and_the_potential_is_drawn(screen, program, folder):
    r, curve, potential = 22.0, (120, 255, 150), (245, 171, 84)
    with Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}", "--layout", "layout.txt", scene=f'[camera]\nr = {r}\nfov = 30\n[sky]\nkind = "black"\n') as v:
        v.settle("key", "Tab")
        area = (0, 0, WIDTH, HEIGHT)

        def places():
            data = v.picture(area).data
            return [(i // 3 % WIDTH, i // 3 // WIDTH) for i in range(0, len(data), 3) if tuple(data[i:i + 3]) == curve]
        assert not places(), "a curve that nobody asked for"
        v.settle("key", "k")
        sine = 1.5 * math.sqrt(3) * math.sqrt(1 - 1 / r) / r
        radius = math.tan(math.asin(sine)) * 0.5 * WIDTH / math.tan(math.radians(15))
        home = places()
        assert len(home) > 100, f"{len(home)} pixels of the curve"
        for x, y in home:
            away = math.hypot(x + 0.5 - 0.5 * WIDTH, y + 0.5 - 0.5 * HEIGHT)
            assert abs(away - radius) < 1.5, f"({x}, {y}) is {away:.1f} px from the middle, not {radius:.1f}"
        v.settle("mousemove", 400, 300, "mousedown", 1)
        v.settle("mousemove", 460, 300)
        v.settle("mouseup", 1)
        middle = lambda found: (min(x for x, _ in found) + max(x for x, _ in found)) / 2
        assert abs(middle(places()) - middle(home) - 60) < 3, "the curve does not follow a drag"
        v.settle("key", "r", "key", "Tab", "key", "p", "mousemove", 440, 300)
        assert v.count(INSET, potential) == 0, "a potential that nobody asked for"
        v.choose("View", "Effective potential")
        v.settle("mousemove", 440, 300)
        assert v.count((300, 200, 830, 560), potential) > 20, "View, Effective potential draws none"
        v.settle("key", "k", "key", "Tab", "key", "p")
        assert not places(), "the curve is still there"


def test_a_planet_is_added_saved_under_a_name_and_escape_closes_one_thing_at_a_time(screen, program, folder):
    with Viewer(screen, program, *COARSE, "--layout", "layout.txt") as v:
        v.settle()
        bare = v.picture(ADDED)
        v.choose("Add", "Planet")
        v.settle("key", "F1")
        v.settle("key", "Escape")     # the editor that adding has opened
        v.settle("key", "Escape")     # the list of keys
        assert v.process.poll() is None, "Escape quits while something is open"
        assert v.picture(ADDED).changed(bare, 4 * NOISE), "no planet is to be seen"
        v.settle("key", "ctrl+shift+s")
        for key in ["ctrl+a", "BackSpace"]:
            v.settle("key", key)
        v.hands("type", "--delay", 60, "mine")
        v.settle()
        v.settle("key", "Return")
        file = Path(v.folder) / "mine.toml"
        wait_until("the file", file.exists)
        saved = tomllib.loads(file.read_text())
        assert "ball" in saved, "the planet is not in the file"
        v.hands("key", "f", "key", "Escape", "key", "Escape")
        assert v.process.wait(timeout=HUNG_S) == 0, "Escape does not quit when nothing is open"


def test_a_tour_is_led_forward_and_back_and_closed(screen, program, folder):
    with Viewer(screen, program, *COARSE, "--layout", "layout.txt") as v:
        home = v.picture(TOUR)
        v.choose("Help", "Guided tours")
        v.click(*FIRST_TOUR)
        assert v.title() == "Black ball - nullscope", v.title()
        ball, panel = v.picture(TOURED), v.picture(TOUR)
        assert panel.changed(home, CHANGED), "the tour has no panel"
        v.click(*TOUR_NEXT)
        assert v.title() == "A black hole and the sky - nullscope", v.title()
        hole = v.picture(TOURED)
        assert hole.changed(ball, CHANGED) and v.picture(TOUR).changed(panel, CHANGED), "Next does not go on"
        v.settle("key", "e")     # flown elsewhere meanwhile
        assert v.picture(TOURED).changed(hole, CHANGED), "E does not roll the camera"
        v.settle("key", "r")
        same(hole, v.picture(TOURED), "the step's view after R")
        v.click(*TOUR_BACK)
        same(ball, v.picture(TOURED), "the first step's picture after Back")
        same(panel, v.picture(TOUR), "the first step's panel after Back")
        v.settle("key", "Prior")     # there is none before
        v.settle("key", "Next")
        same(hole, v.picture(TOURED), "the second step's picture after Page Down")
        v.settle("key", "ctrl+z")
        same(ball, v.picture(TOURED), "the picture after undo")
        v.settle("key", "Escape")
        assert v.process.poll() is None, "Escape quits instead of closing the tour"
        bare = v.picture(TOUR)
        assert bare.changed(panel, CHANGED), "Escape does not close the tour"
        v.settle("key", "ctrl+o")
        v.click(*GALLERY_TOUR)
        same(panel, v.picture(TOUR), "the panel of the tour that was opened in the gallery")
        v.click(*TOUR_CLOSE)
        same(bare, v.picture(TOUR), "where the panel was, after Close")


def test_a_file_is_known_as_a_tour(screen, program, folder):
    tour = 'title = "Mine"\ndescription = "One."\n[[step]]\nscene = "disc-grid"\noff = ["disc"]\ntext = "Words."\n'
    with Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}", scene=tour) as v:
        assert v.title() == "Disc grid - nullscope", v.title()
    path = folder / "broken.toml"
    path.write_text(tour.replace("disc-grid", "disc-gird"))
    done = run(program, path, DISPLAY=screen.display)
    assert done.returncode == 2 and "broken.toml:4: step[1].scene: " in done.stderr, done.stderr


def test_a_killed_viewer_leaves_its_scene(screen, program, folder):
    """kill -9 at random moments: a whole file is left, and nothing is lost but what is younger than the 2 s from file to file and the
    pauses that the machine makes in the viewer's loop."""
    chance, interval_s = dice(), 2.0
    start = lambda: Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}", "--coarse", "4", home=folder)
    left = folder / "nullscope"
    for run in range(20 if "NULLSCOPE_EVERYTHING" in os.environ else 2 if EVERYTHING else 1):
        v = start()
        try:
            v.start()
            begun = time.time()
            while time.time() < begun + 2.5 or chance.random() < 0.5:
                v.hands("keydown", chance.choice("eqwsad"))
                time.sleep(0.3 * chance.random())
                v.hands(*[word for key in "eqwsad" for word in ("keyup", key)])
                edited = time.time()
            if run == 0:     # long enough for what is on the screen to be kept
                last = v.settle("mousemove", *BESIDE)
                latest = time.time() + 10     # unless it was kept before the last key went up
                newest = lambda: max((path.stat().st_mtime for path in left.glob("unsaved-*")), default=0)
                wait_until("it is kept", lambda: newest() >= edited or time.time() > latest, HUNG_S)
            else:
                time.sleep(1.5 * chance.random())
            v.process.kill()
            killed = time.time()
            found = list(left.glob(f"unsaved-{v.process.pid}.toml"))
            assert found, "nothing is left of the scene"
            kept = found[0].stat().st_mtime
            moments = [kept, *(v.begun + float(turn["t"]) for turn in v.log.turns()), killed]
            moments = sorted(moment for moment in moments if kept <= moment <= killed)
            pause = max(after - before for before, after in zip(moments, moments[1:]))
            assert kept >= edited or killed - kept <= interval_s + 0.5 + 2 * pause, \
                f"the last {killed - kept:.1f} s are lost; the longest pause was {pause:.1f} s"
            assert "camera" in tomllib.loads(found[0].read_text()), "the file has no camera"
        finally:
            v.kill()
        again = start()
        try:
            again.start()
            again.click(*RESTORE)
            assert not found[0].exists(), "the scene is not restored"
            if run == 0:
                same(last, again.settle(), "the restored picture")
            again.settle("key", "e")
            again.hands("key", "Escape", "key", "Escape")
            again.process.wait(timeout=HUNG_S)
            assert not list(left.glob("unsaved-*")), "an end in order leaves an unsaved scene"
        finally:
            again.kill()


def test_a_flight_is_recorded_played_saved_and_filmed(screen, program, folder):
    with Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}", "--layout", "layout.txt") as v:
        home = v.settle()
        v.hands("key", "F9", "keydown", "d")
        wait_until("it flies", lambda: v.picture().changed(home, CHANGED), HUNG_S)
        time.sleep(0.6)
        v.hands("keyup", "d", "key", "F9")
        v.settle()
        same(home.crop(0, 0, 500, 120), v.picture((320, 300, 820, 420)), "the first frame of the record, above the timeline and its message")
        v.hands("key", "l")
        wait_until("it plays", lambda: v.picture().changed(home, CHANGED), HUNG_S)
        v.settle("key", "l", "key", "ctrl+s")
        saved = next(path for path in Path(v.folder).glob("*.toml") if path != v.scene)
        path = tomllib.loads(saved.read_text())["path"]
        assert len(path["key"]) >= 4, "the saved path has no keys"
        frames = path.get("frames", int(path["key"][-1]["frame"]) + 1)
        v.click(*v.layout().place("Film...", "##timeline"))
        if not v.layout().place("A film needs ffmpeg", ""):
            v.click(*v.layout().place("Frames (.png)", ""))
        for words in ["1280 x 720", "640 x 360", "Draw"]:
            v.click(*v.layout().place(words, ""))
        pictures = lambda: list(Path(v.folder).glob("*.png"))
        wait_until("a file of this viewer's own has the film's scene", (v.settings.parent / f"film-{v.process.pid}.toml").exists, HUNG_S)
        wait_until("the film's frames are drawn", lambda: len(pictures()) == frames, HUNG_S)
        wait_until("the film's scene file is removed", lambda: not list(v.settings.parent.glob("film*")), HUNG_S)
        picture = read_png(pictures()[0])
        assert (picture.width, picture.height) == (640, 360), f"frames of {picture.width}x{picture.height}"


class Effects:
    """A viewer whose effects panel is open."""

    def __init__(self, screen, program, *arguments):
        scene = UNDER_STARS + BODIES + '[sky]\nkind = "black"\n'     # whose coarse pictures are hardly others
        self.viewer = Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}", *arguments, scene=scene, environment=COMPILING)

    def __enter__(self):
        self.viewer.start()
        for header in [*HEADERS, EFFECTS]:
            self.viewer.toggle(*header)
        return self

    def __exit__(self, *_):
        self.viewer.kill()

    def switch(self, row, what):
        """The picture before, the one after, those seen on the way, the turns meanwhile and the programs compiled."""
        v = self.viewer
        before, seen, at = v.picture(RIGHT), [], v.log.size()
        programs = int(v.log.turns()[-1]["programs"])
        v.settle("mousemove", *EFFECT_ROW(row))
        v.settle("mousedown", 1)
        v.hands("mouseup", 1)

        def switched():
            picture = v.picture(RIGHT)
            if not seen or picture.data != seen[-1].data:
                seen.append(picture)
            return seen[-1].changed(before, CHANGED)
        wait_until(what, switched, HUNG_S)
        v.settle("mousemove", *BESIDE)
        turns = v.log.turns(at)
        return before, v.picture(RIGHT), seen, turns, int(turns[-1]["programs"]) - programs


def dearest(turns):
    """Processor time of the window's thread in its longest turn, ms."""
    return max(float(turn["cpu_ms"]) for turn in turns)


def test_an_effect_is_switched_without_a_hitch(screen, program, folder):
    """The window's thread never draws a picture, nor waits for one; in one context it does, and that is seen."""
    with Effects(screen, program) as effects:
        longest = 0.0
        for what, compiled in [("the ball goes", 1), ("the ball comes back", 0)]:
            before, after, seen, turns, programs = effects.switch(row_of("ball"), what)
            assert programs == compiled, f"{what}: {programs} programs compiled instead of {compiled}"
            assert all(turn["here"] == "0" for turn in turns), f"{what}: the window's thread drew a picture"
            for picture in seen:     # the last picture until the next is whole
                kept = min(picture.differing(before), picture.differing(after))
                assert kept <= CURSOR, f"{what}: neither picture is seen: {kept:.1%} differ from both"
            longest = max(longest, dearest(turns))
    with Effects(screen, program, "--one-context") as effects:
        _, _, _, turns, programs = effects.switch(row_of("ball"), "the ball goes")
        hitch = dearest(turns)
        assert programs == 1 and int(turns[-1]["here"]) > int(turns[0]["here"]), "in one context somebody else drew"
    print(f"    processor time of the longest turn: {longest:.0f} ms, in one context {hitch:.0f} ms", flush=True)
    assert longest < WINDOWS_SHARE * hitch, "a turn takes as long as one that draws and compiles"


def test_keys_count_before_the_first_picture_and_what_moves_is_followed_coarsely(screen, program, folder):
    """A scene whose program takes a second and more to compile, and whose picture is slower than 30 a second."""
    v = Viewer(screen, program, "--size", "640x300", scene="torus", environment=COMPILING)
    try:
        # no panel lies in the first, in the second none of the letters that are whole pixels of their colour but F1's
        area, keys = (290, 20, 630, 260), (250, 40, 350, 260)
        v.window = wait_until("the window", v.find)
        v.hands("windowfocus", v.window, "key", "F1")
        wait_until("F1 is answered", lambda: v.count(keys, LETTERS) > 4, HUNG_S)
        assert v.log.turns()[-1]["picture"] == "none", "F1 is answered after the first picture only"
        v.settle("key", "F1", "mousemove", *BESIDE)
        home, at = v.picture(area), v.log.size()
        v.hands("keydown", "e")

        def followed():
            return sum(turn["picture"] == "coarse" for turn in v.log.turns(at)) >= 3
        wait_until("three coarse pictures on the way", followed, HUNG_S)
        v.settle("keyup", "e")
        assert v.log.turns()[-1]["picture"] == "whole", "a coarse picture stays"
        assert v.picture(area).changed(home, CHANGED), "E does not roll the camera"
        v.settle("key", "r")
        same(home, v.picture(area), "R after E")
    finally:
        v.kill()


def test_matter_along_rays_holds_no_input(screen, program, folder):
    """A soft disc: the window's thread answers while others draw, and what follows a key is coarse and younger than a whole picture."""
    v = Viewer(screen, program, "--size", "1280x720", scene="soft-disc")
    try:
        v.start()
        at = v.log.size()
        v.hands("keydown", "e")
        wait_until("three coarse pictures on the way", lambda: sum(turn["picture"] == "coarse" for turn in v.log.turns(at)) >= 3, HUNG_S)
        v.settle("keyup", "e")
        turns = v.log.turns(at)
        assert len({turn["here"] for turn in turns}) == 1, "the window's thread drew a picture"
        ages = {kind: [float(turn["age_ms"]) for turn in turns if turn["picture"] == kind and float(turn["age_ms"]) > 0.0] for kind in ("coarse", "whole")}
        print(f"    of {len(turns)} turns the longest {dearest(turns):.0f} ms; coarse pictures {max(ages['coarse']):.0f} ms old, whole ones {max(ages['whole']):.0f}",
              flush=True)
        longest = dearest(turns)
        assert longest < ANSWER_MS or longest / slowness() < ANSWER_MS, "a turn of the window's thread took longer than an answer may"
        assert max(ages["coarse"]) < max(ages["whole"]), "what follows a key is as old as a whole picture"
    finally:
        v.kill()


def test_a_flight_about_a_rotating_hole_goes_on_among_point_stars(screen, program, folder):
    """The search for the stars' images takes long: in flight there is a quick one."""
    v = Viewer(screen, program, "--size", "420x300",
               scene='[spacetime]\nmetric = "kerr"\nspin = 0.9\n[camera]\nr = 40\n[sky]\nkind = "points"\n')
    try:
        v.start()
        v.settle("mousemove", *BESIDE)
        at = v.log.size()
        v.hands("keydown", "w")
        first = wait_until("it flies", lambda: [t for t in v.log.turns(at) if t["picture"] == "coarse"], HUNG_S)[0]

        def flown():
            turn = v.log.turns(at)[-1]
            return turn if int(turn["pictures"]) >= int(first["pictures"]) + PICTURES else None
        last = wait_until(f"{PICTURES} pictures", flown, HUNG_S)
        kinds = {turn["picture"] for turn in v.log.turns(at) if int(turn["pictures"]) >= int(first["pictures"])}
        v.settle("keyup", "w")
        rate = (int(last["pictures"]) - int(first["pictures"])) / (float(last["t"]) - float(first["t"]))
        print(f"    {rate:.1f} pictures a second in flight", flush=True)
        assert kinds == {"coarse"}, "a whole search was waited for in flight"
        assert v.log.turns()[-1]["picture"] == "whole", "at rest the whole search was not done"
    finally:
        v.kill()


def test_several_rays_a_pixel_wait_for_rest(screen, program, folder):
    """What moves is followed with one ray a pixel; at rest there are all."""
    v = Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}", scene=SCENE + '[picture]\nsamples = 4\n')
    try:
        v.start()
        v.settle("mousemove", *BESIDE)
        home, at = v.picture(), v.log.size()
        v.hands("keydown", "e")

        def followed():
            seen = {turn["pictures"] for turn in v.log.turns(at) if turn["picture"] == "coarse"}
            return len(seen) >= PICTURES
        wait_until(f"{PICTURES} pictures on the way", followed, HUNG_S)
        v.settle("keyup", "e")
        assert v.log.turns()[-1]["picture"] == "whole", "a picture of one ray a pixel stays"
        v.settle("key", "r")
        same(home, v.picture(), "R after E")
    finally:
        v.kill()


def test_a_warp_mesh_is_looked_through_and_dragged(screen, program, folder):
    """Its right side is at x = 570: the window is dark beyond."""
    (folder / "mesh.data").write_text("2\n2 2\n-1 -1 .3 .3 1\n.5 -1 .7 .3 1\n-1 1 .3 .7 1\n.5 1 .7 .7 1\n")
    scene = f'[camera]\nprojection = "fisheye"\nwarp = "{folder}/mesh.data"\n[sky]\nkind = "checker"\n'
    with Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}", scene=scene) as v:
        left, top, right, bottom = PICTURE
        inside, beside = lambda: v.picture((left, top, 565, bottom)), lambda: v.picture((575, top, right, bottom))
        v.settle("mousemove", *BESIDE)
        before = inside()
        assert before.mean() > 5, "the mesh shows nothing"
        assert beside().mean() < 0.1, "there is light beside the mesh"
        v.settle("mousemove", 520, 400, "mousedown", 1)
        v.settle("mousemove", 440, 420)
        v.settle("mouseup", 1, "mousemove", *BESIDE)
        assert inside().changed(before, CHANGED), "the drag does not turn the camera"
        assert beside().mean() < 0.1, "there is light beside the mesh after a drag"


def test_exposure_follows_like_an_eye(screen, program, folder):
    """Towards the dark sky: the picture is there, and goes on growing brighter without a hand."""
    v = Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}", scene=UNDER_STARS + '[picture]\nauto_exposure = "on"\n')
    try:
        v.start()
        v.settle("mousemove", 800, 300)
        v.settle("mousedown", 1)
        area = (330, 100, 830, 500)     # read in little time, also where other programs run
        before = v.picture(area)
        rests, means, at = v.send("mousemove", 320, 540), [], 0
        while not rests():
            with v.stopped():           # a stop is a hitch, in which exposure goes no further than in 0.1 s
                now = v.picture(area)
            if means or now.changed(before, CHANGED):
                at = at if means else v.log.size()
                means.append(now.mean())
            time.sleep(0.02)
        v.settle("mouseup", 1)
        last = v.picture(area).mean()
        # Those that were seen; or a third of all frames, of which some were drawn while nobody looked (174; 14 without an eye).
        dark, steps = min(means), max(len({round(mean, 3) for mean in means}), len(v.log.turns(at)) // 3)
        print(f"    mean {dark:.2f} to {last:.2f} of 255 in {steps} pictures", flush=True)
        assert steps >= 10, f"exposure jumped: {steps} pictures"
        assert last > 1.1 * dark, f"from {dark:.2f} to {last:.2f}: exposure did not follow"
    finally:
        v.kill()


def test_the_clock_runs_and_stops(screen, program, folder):
    """A ball goes on while the clock runs, stays where it is when it stops, and jumps when its light takes no time."""
    dark, ball = '[sky]\nkind = "black"\n', '[ball]\nposition = [6, 0, 0]\nmotion = "orbit"\n'
    v = Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}", "--coarse", "2", scene=UNDER_STARS.replace("[disc]", "") + dark + ball)
    try:
        v.start()
        for header in [*HEADERS, CLOCK]:
            v.toggle(*header)
        before = v.picture()
        v.settle("mousemove", *RUN)
        v.hands("mousedown", 1, "sleep", 0.2, "mouseup", 1)     # no rest while the clock runs
        for _ in range(2):
            v.changes("the ball moves", before)
            before = v.picture()
        v.hands("mousedown", 1, "sleep", 0.2, "mouseup", 1)
        before = v.settle()
        same(before, v.settle(), "with the clock stopped")
        v.click(*DELAY)
        assert v.picture().changed(before, CHANGED), "light that takes no time shows it at the same place"
    finally:
        v.kill()


def test_dumps_follow_the_clock_without_a_hitch(screen, program, folder):
    """Matter of a simulation: other threads read its dumps and draw while the clock runs, over and over."""
    dumps, nodes = 4, (96, 48, 64)   # 9.4 MB each
    for dump in range(dumps):
        head = "nullscope-medium 1\ncoordinates kerr-schild\nspin 0\nr 1.1 10 {}\ntheta 0.1 3 {}\nphi 0 {}\ndata\n".format(*nodes)
        bright = struct.pack("<8f", 4.0 ** dump, 1e4, 0, 0, 0, 0, 0, 0)
        (folder / f"large-{dump}.grid").write_bytes(head.encode() + bright * math.prod(nodes))
    scene = UNDER_STARS.replace("[disc]", f"""[object]
mass_suns = 4e6
[sky]
kind = "black"
[medium]
kind = "grid"
file = "{folder}/large-%d.grid"
cadence = 2
outer = 9
emissivity = 3e-21
""")
    v = Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}", "--coarse", "2", scene=scene)
    try:
        v.start()
        for header in [*HEADERS, CLOCK]:
            v.toggle(*header)
        v.settle("mousemove", *RUN)
        at, means = v.log.size(), [v.picture().mean()]
        v.hands("mousedown", 1, "sleep", 0.2, "mouseup", 1)     # no rest while the clock runs

        def came_round():
            """From the last dump, the brightest, to the first."""
            means.append(v.picture().mean())
            return max(means) > 1.5 * means[0] and means[-1] < max(means) / 1.4
        wait_until("the dumps begin again", came_round, HUNG_S)
        v.hands("mousedown", 1, "sleep", 0.2, "mouseup", 1)
        same(v.settle(), v.settle(), "with the clock stopped")
        turns = v.log.turns(at)
        longest = dearest(turns)
        print(f"    of {len(turns)} turns the longest {longest:.0f} ms; mean light {min(means):.1f} to {max(means):.1f}", flush=True)
        assert len({turn["here"] for turn in turns}) == 1, "the window's thread drew a picture"
        assert longest < ANSWER_MS or longest / slowness() < ANSWER_MS, "a turn of the window's thread took longer than an answer may"
    finally:
        v.kill()


def test_bad_input(screen, program, folder):
    scene = folder / "bad.toml"
    scene.write_text("[camera]\nr = -1\n")
    for arguments in [[scene], ["no-such-scene"], ["--size", "12"], ["--screenshot", "x.jpg"], ["--hidden"], ["--no"]]:
        done = run(program, *arguments, DISPLAY=screen.display)
        assert done.returncode == 2, f"{arguments}: exit status {done.returncode}"
        assert done.stderr.strip(), f"{arguments}: no word on what is wrong"
    line = run(program, scene, DISPLAY=screen.display).stderr
    assert line.count("\n") == 1 and "bad.toml:2: camera.r" in line, f"not one line with file, line and key: {line}"


def test_a_scene_that_cannot_be_drawn(screen, program, folder):
    """Found out by the painter, while the window is there already."""
    (folder / "broken.png").write_text("no image")
    scene = folder / "image.toml"
    scene.write_text('[disc]\nimage = "broken.png"\n')
    done = run(program, scene, DISPLAY=screen.display)
    assert done.returncode == 2, f"exit status {done.returncode}"
    assert done.stderr.count("\n") == 1 and "broken.png" in done.stderr, f"not one line with the file: {done.stderr}"


def test_no_display(screen, program, folder):
    for display, words in [(None, "DISPLAY is not set"), (":9999", ":9999")]:
        done = run(program, DISPLAY=display, WAYLAND_DISPLAY=None)
        assert done.returncode == 1, f"exit status {done.returncode}"
        assert "display" in done.stderr and words in done.stderr and "nullscope capture" in done.stderr, done.stderr


def test_shaders_are_timed_once_for_each_kind_of_scene(screen, program, folder):
    """At rest, where that is asked for though the processor draws; the next viewer knows, and one that is told nothing times nothing."""
    kept = folder / "nullscope" / "stages.csv"

    def said(*arguments):
        with Viewer(screen, program, "--size", "640x700", "--layout", "layout.txt", *arguments, scene="sky-only", home=str(folder)) as v:
            if "measured" in arguments:
                wait_until("both are timed", kept.exists, HUNG_S)
            v.settle("mousemove", *BESIDE)
            v.click(*v.layout().place("Accuracy", "##side"))
            v.settle()
            return " ".join(words for window, words, _ in v.layout().texts if window.startswith("##side"))
    assert "draws on the processor" in said() and not kept.exists(), "shaders are timed where nothing can be gained"
    first_words = said("--shaders", "measured")
    assert "ms a frame by fragments" in first_words, f"what was timed is not said: {first_words}"
    first = kept.read_text()
    assert len(first.splitlines()) == 2 and "schwarzschild strip, " in first, first
    assert "ms a frame by fragments" in said("--shaders", "measured"), "what was timed is forgotten"
    assert kept.read_text() == first, "what is known is timed again"
    assert "compute: chosen by hand" in said("--shaders", "compute")


def test_old_opengl(screen, program, folder):
    done = run(program, DISPLAY=screen.display, MESA_GL_VERSION_OVERRIDE="2.1")
    assert done.returncode == 1, f"exit status {done.returncode}"
    assert "3.3" in done.stderr and "2.1" in done.stderr and "display" not in done.stderr, done.stderr


def test_bookmarks_are_kept_opened_renamed_and_deleted(screen, program, folder):
    with Viewer(screen, program, *COARSE) as v:
        kept = lambda kind: sorted((v.settings.parent / "bookmarks").glob(f"*.{kind}"), reverse=True)
        name = lambda: tomllib.loads(kept("toml")[0].read_text())["name"]
        before = v.settle("key", "ctrl+b")
        assert name() == "scene 1" and "disc" in tomllib.loads(kept("toml")[0].read_text()), "the scene is not kept"
        assert kept("jpg")[0].read_bytes()[:2] == b"\xff\xd8", "no picture of it is kept"
        v.hands("keydown", "w")
        v.changes("the camera flies", before)
        v.hands("keyup", "w")
        elsewhere = v.settle()
        assert elsewhere.changed(before, CHANGED), "the camera is where it was"
        v.settle("key", "b")
        assert v.picture(BOOKMARK).mean() > 40, "no card with a picture"
        v.click(*BOOKMARK_PICTURE)
        v.settle("key", "b")
        assert v.title() == "scene 1 - nullscope", v.title()
        same(before, v.picture(), "the view that was kept")
        v.settle("key", "ctrl+z")
        assert v.title() == "scene - nullscope", v.title()
        same(elsewhere, v.picture(), "the view that was left")
        v.settle("key", "b")

        def choose(entry):
            v.settle("mousemove", *BOOKMARK_PICTURE)
            v.settle("mousedown", 3)
            v.settle("mouseup", 3)
            v.click(BOOKMARK_PICTURE[0] + 20, BOOKMARK_PICTURE[1] + 16 + 19 * entry)
        choose(2)
        v.hands("type", "--delay", 60, "ring")
        v.settle("key", "Return")
        assert name() == "ring", f"renamed to {name()}"
        files = {file: file.read_bytes() for kind in ("toml", "jpg") for file in kept(kind)}
        choose(3)
        assert not kept("toml") and not kept("jpg"), "a bookmark that was deleted is there"
        v.click(*BOOKMARK_RESTORE)
        assert {file: file.read_bytes() for file in files if file.exists()} == files, "what was deleted does not come back"
        broken = kept("toml")[0].with_name("broken.toml")
        broken.write_text("[camera]\nr = ")
        v.settle("key", "b")
        v.settle("key", "b")
        assert v.refused(NOT_SHOWN) > 50, "a broken file is not named"


def test_a_drag_goes_round_the_hole_at_constant_r(screen, program, folder):
    with Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}") as v:
        before = v.settle()

        def drag(button, *keys):
            v.settle(*keys, "mousemove", 560, 300, "mousedown", button)
            v.hands("mousemove", 660, 350)
            v.changes("the camera goes round", before)
            there = v.settle()
            same(before, v.settle("mousemove", 560, 300), "after the hand came back", CURSOR)
            v.settle("mousemove", 660, 350, "mouseup", button)
            return there, v.settle("mousemove", *BESIDE)
        there, after = drag(2)
        same(there, after, "after the button was let go", CURSOR)
        v.settle("key", "ctrl+s")
        camera = tomllib.loads((Path(v.folder) / "scene-2.toml").read_text())["camera"]
        angle = 180 / HEIGHT
        for key, expected in {"r": 22, "roll": -6, "phi": -100 * angle, "theta": 80 - 50 * angle}.items():
            assert abs(camera[key] - expected) < 1e-9, f"{key} is {camera[key]}, not {expected}"
        assert not {"yaw", "pitch"} & set(camera), f"the camera looks elsewhere: {camera}"
        v.settle("key", "ctrl+z", "key", "ctrl+z")     # the file, the drag
        same(after, drag(1, "keydown", "alt")[1], "after Alt and a left drag")
        v.settle("keyup", "alt")


def type_into_slider(v, place, text):
    v.settle("mousemove", *place)
    v.settle("keydown", "ctrl", "mousedown", 1)
    v.settle("mouseup", 1, "keyup", "ctrl")
    v.settle("key", "ctrl+a")
    v.hands("type", "--delay", 100, text)
    v.settle("key", "Return")
    v.settle("mousemove", *BESIDE)


def test_what_a_scene_file_may_say_can_be_typed_in(screen, program, folder):
    scene = '[camera]\nr = 20\n[sky]\nkind = "black"\n[disc]\nemission = "thermal"\ntemperature = 1234567\n'
    with Viewer(screen, program, *COARSE, "--layout", "layout.txt", scene=scene) as v:
        v.settle()
        if not v.layout().place("1234567 K", ""):
            v.click(*v.layout().place("Disc", ""))
        at = v.layout().place("1234567 K", "")
        for typed, taken in [("3e6", 3e6), ("2500000,5", 2500000), ("5", 1e3)]:     # beyond the slider's ends; a decimal comma; below what a file may say
            type_into_slider(v, at, typed)
            assert v.layout().place(f"{taken:.0f} K", ""), (typed, [words for _, words, _ in v.layout().texts if words.endswith(" K")])
        v.settle("key", "ctrl+s")
        saved = next(path for path in Path(v.folder).glob("*.toml") if path != v.scene)
        assert tomllib.loads(saved.read_text())["disc"]["temperature"] == 1e3, saved.read_text()


def test_a_lamp_lights_a_disc_and_moves_up(screen, program, folder):
    scene = '[camera]\nr = 20\n[sky]\nkind = "black"\n[disc]\nemission = "thermal"\n'
    with Viewer(screen, program, *COARSE, "--layout", "layout.txt", scene=scene) as v:
        v.settle()
        if not v.layout().place("Shines by", ""):
            v.click(*v.layout().place("Disc", ""))
        by_accretion = v.picture(PICTURE)
        v.click(*v.layout().place("accretion", ""))
        v.click(*v.layout().place("a lamp on its axis", ""))
        lit = v.picture(PICTURE)
        assert lit.changed(by_accretion, CHANGED), "a lamp lights the disc as accretion does"
        type_into_slider(v, v.layout().place("2.00", ""), "3.25")   # its index
        v.settle("key", "ctrl+s")
        saved = tomllib.loads(next(path for path in Path(v.folder).glob("*.toml") if path != v.scene).read_text())["disc"]
        assert (saved["emissivity"], saved["lamp_index"]) == ("lamp", 3.25), saved
        v.settle("key", "ctrl+z", "key", "ctrl+z")     # the file, the index
        same(lit, v.picture(PICTURE), "the index taken back", CURSOR)
        v.settle("key", "ctrl+z")
        same(by_accretion, v.picture(PICTURE), "the lamp taken back", CURSOR)


def test_the_side_panel_takes_what_the_key_table_allows(screen, program, folder):
    scene = '[camera]\nr = 20\n[sky]\nkind = "black"\n[disc]\nrotation = 30\n'
    with Viewer(screen, program, *COARSE, "--layout", "layout.txt", scene=scene) as v:
        def typed(shown, text, taken, by_click=[]):
            place = v.layout().place(shown, "##side")
            assert place, (shown, v.layout().words())
            v.settle("mousemove", *place)
            v.settle(*by_click, "mousedown", 1)
            v.settle("mouseup", 1, *(["keyup", "ctrl"] if by_click else []))
            v.settle("key", "ctrl+a")
            v.hands("type", "--delay", 100, text)
            v.settle("key", "Return")
            v.settle("mousemove", *BESIDE)
            assert v.layout().place(taken, "##side"), (shown, text, v.layout().words())
        control = ["keydown", "ctrl"]
        typed("0 c", "0,99999995", "0.99999995 c")     # a decimal comma
        typed("60.0", "175", "175.0", control)
        typed("84.80", "200", "180.00", control)     # no more than the file may say
        for section in ("Camera", "Speed of the camera", "Lens", "Disc"):
            v.click(*v.layout().place(section, "##side"))
        typed("30.00", "720", "720.00", control)
        v.settle("key", "ctrl+s")
        saved = tomllib.loads(next(path for path in Path(v.folder).glob("*.toml") if path != v.scene).read_text())
        fov = saved["camera"].get("fov") or math.degrees(2 * math.atan(saved["camera"]["plane_width"] / 2))
        assert abs(fov - 175) < 1e-9 and saved["disc"]["rotation"] == 720, saved
        assert max(map(abs, saved["camera"]["velocity"])) == 0.99999995, saved


def test_the_light_theme_is_switched_and_kept(screen, program, folder):
    start = lambda again: Viewer(screen, program, *COARSE, "--layout", "layout.txt", first_visit=again, home=folder)

    def switch(v):
        v.choose("View", "Light theme")
    with start(False) as v:
        dark, picture = v.picture(SIDE), v.picture()
        switch(v)
        light = v.picture(SIDE)
        assert dark.mean() < 60 and light.mean() > 180, f"means {dark.mean():.0f} of dark panels, {light.mean():.0f} of light ones"
        same(picture, v.picture(), "the picture beside the panels")
        wait_until("the settings", lambda: 'theme = "light"' in v.settings.read_text().replace("'", '"'))
    with start(True) as v:
        same(light, v.picture(SIDE), "light panels at the next start")
        switch(v)
        same(dark, v.picture(SIDE), "dark panels again")


def test_messages_and_the_sign_of_a_record_keep_beside_the_panels(screen, program, folder):
    red, corner = bytes([240, 60, 50]), (700, MENU, 840, 80)
    with Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}", "--layout", "layout.txt") as v:
        v.settle("key", "ctrl+e", "key", "ctrl+c")
        windows = v.layout().windows
        side, (left, _, width, _), editor = windows["##side"], windows["##message"], windows["Scene"]
        assert side[0] + side[2] < left and left + width < editor[0], f"the message lies on a panel: {windows}"
        v.settle("key", "ctrl+e")
        assert v.count(corner, red) == 0, "a sign without a record"
        signed = lambda: v.count(corner, red) > 20
        v.hands("key", "F9")
        wait_until("the sign", signed, HUNG_S)
        v.hands("key", "Tab", "key", "F12")
        wait_until("the picture's file", lambda: list(Path(v.folder).glob("*.png")), HUNG_S)
        assert signed(), "no sign without panels"
        saved = read_png(next(Path(v.folder).glob("*.png"))).crop(*(700, 0, 840, 80))
        assert red not in (saved.data[i:i + 3] for i in range(0, len(saved.data), 3)), "the sign is in the saved picture"
        v.hands("key", "F9")
        wait_until("the sign goes", lambda: v.count(corner, red) == 0, HUNG_S)


def test_the_cameras_clock_is_shown_and_follows(screen, program, folder):
    def value(name):
        at = v.layout().words()
        x, y = at[name]
        return float(min((place, words) for words, place in at.items() if abs(place[1] - y) < 6 and place[0] > x)[1].split()[0])
    at_rest, shift = "dtau/dt at rest", "g from far away, at rest"
    with Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}", "--coarse", "4", "--layout", "layout.txt") as v:
        v.settle()
        assert shift not in v.layout().words(), "shown before it was asked for"
        v.click(*MENUS["View"])
        v.click(*v.layout().words()["Clock and redshift"])
        assert abs(value(at_rest) - math.sqrt(1 - 1 / 22)) < 1e-6 and abs(value(shift) * value(at_rest) - 1) < 1e-5
        v.hands("key", "f")
        time.sleep(1.0)
        v.settle("key", "f")
        assert value("tau since release") > 0.5, "the clock stands while the camera falls"
        assert abs(value("dtau/dt of the camera") - value(at_rest) ** 2 / math.sqrt(1 - 1 / 22)) < 3e-6, "A/E of the fall"
        v.settle("key", "r")
        assert abs(value(at_rest) - math.sqrt(1 - 1 / 22)) < 1e-6 and "tau since release" not in v.layout().words()


def test_a_gamepad_flies_and_its_buttons_do_what_keys_do(screen, program, folder):
    """A library in place of a device answers for GLFW."""
    linked = subprocess.run(["ldd", program], capture_output=True, text=True).stdout
    if "libglfw" not in linked or "libasan" in linked:
        return     # GLFW's function cannot be replaced; a sanitizer must be loaded first
    shim, state = folder / "gamepad.so", folder / "gamepad.txt"
    source = Path(__file__).with_name("gamepad_shim.c")
    subprocess.run([os.environ.get("CC", "cc"), "-shared", "-fPIC", "-o", shim, source], check=True)

    def pad(sticks="0 0 0 0", buttons=""):
        (folder / "next.txt").write_text(f"{sticks} -1 -1 {buttons}")
        os.replace(folder / "next.txt", state)     # never half written

    def press(button):
        pad(buttons=button)
        time.sleep(0.4)
        pad()
    with Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}",
                environment={"LD_PRELOAD": str(shim), "NULLSCOPE_TEST_PAD": str(state)}) as v:
        home = v.settle()
        v.rests()
        for what, sticks in [("flies", "0 -1 0 0"), ("looks around", "0 0 1 0")]:
            pad(sticks)
            wait_until(f"a stick {what}", lambda: v.picture().changed(home, CHANGED), HUNG_S)
            press("0")
            same(home, v.settle(), "the scene's camera after A")
        press("7")
        assert v.settle().changed(home, CHANGED), "Start does not open the gallery"
        press("1")
        same(home, v.settle(), "B does not close the gallery")
        press("1")
        assert v.process.poll() is None, "B quits when it is pressed once"
        time.sleep(0.4)
        press("1")
        assert v.process.wait(timeout=HUNG_S) == 0, "B does not quit when nothing is open"


def test_a_body_is_hidden_and_shown(screen, program, folder):
    with Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}", "--layout", "layout.txt", scene=SCENE + BODIES) as v:
        v.settle()
        whole = v.picture(RIGHT)
        v.settle("key", "ctrl+e")
        v.click(*v.layout().words()["ball"])
        v.click(*v.layout().words()["Hide"])
        assert "ball (hidden)" in v.layout().words(), "the section does not say that it is hidden"
        v.settle("key", "ctrl+e")
        assert v.picture(RIGHT).changed(whole, CHANGED), "a hidden body is drawn"
        v.settle("key", "ctrl+s")
        saved = next(path for path in Path(v.folder).glob("*.toml") if path != v.scene)
        assert "ball" in tomllib.loads(saved.read_text()), "a hidden body is not saved"
        v.settle("key", "ctrl+e")
        v.click(*v.layout().words()["Show"])
        v.settle("key", "ctrl+e")
        same(whole, v.picture(RIGHT), "the picture with the body that is shown again")


def test_two_settings_are_compared_across_a_line_to_drag(screen, program, folder):
    left, middle, right = (320, 300, 400, 520), (440, 300, 590, 520), (640, 300, 820, 520)
    with Viewer(screen, program, *COARSE) as v:
        for header in HEADERS:
            v.click(*header)
        v.click(*LIGHT)
        areas = lambda: [v.picture(area) for area in (left, middle, right)]
        before = areas()
        v.settle("key", "x")
        for one, other in zip(before, areas()):
            same(one, other, "both sides are alike")
        v.click(*LENSING)
        straight = areas()
        assert straight[0].changed(before[0], CHANGED), "side A does not follow the switch"
        for place in (1, 2):
            same(before[place], straight[place], "side B keeps its setting", 0.0)

        def drag(start, end):
            v.settle("mousemove", *start, "mousedown", 1)
            v.settle("mousemove", *end)
            v.settle("mouseup", 1)
            v.settle("mousemove", 700, 200)
            return areas()
        dragged = drag((420, 500), (620, 420))
        same(straight[0], dragged[0], "left of the line after it was dragged", 0.0)
        assert dragged[1].changed(before[1], CHANGED), "the line does not follow the pointer"
        same(before[2], dragged[2], "right of the line after it was dragged", 0.0)
        turned = drag((740, 450), (700, 450))
        for place in (0, 1, 2):
            assert turned[place].changed(dragged[place], CHANGED), "the camera does not turn on both sides"
        v.settle("key", "ctrl+z")
        for one, other in zip(dragged, areas()):
            same(one, other, "after the turn was undone")
        v.settle("key", "x")
        assert v.picture(right).changed(before[2], CHANGED), "side A is not all of the picture"
        v.click(*LENSING)
        for one, other in zip(before, areas()):
            same(one, other, "after the comparison")


def test_a_camera_that_side_b_cannot_have_is_refused(screen, program, folder):
    with Viewer(screen, program, *COARSE, scene="[camera]\nr = 6.0\nyaw = 30\n[disc]\n") as v:
        for header in HEADERS:
            v.click(*header)
        v.settle("key", "x")
        v.click(*SPACETIME)
        v.click(*METRIC)
        v.click(*FLAT)
        near = lambda: [v.settle("mousemove", 700, 400, *["click", 4] * 10) for _ in range(3)][-1]
        near()
        assert v.refused(REFUSAL) > 50, "the panel does not refuse a camera inside side B's horizon"
        kept = v.picture()
        v.settle("key", "x")
        assert near().changed(kept, CHANGED), "flat spacetime alone refuses the camera, too"


def test_an_edit_before_a_flight_is_two_steps_of_undo_away(screen, program, folder):
    with Viewer(screen, program, *COARSE) as v:
        for header in [*HEADERS, LIGHT]:
            v.click(*header)
        home, panel = v.settle(), v.picture(PANEL)
        v.click(*LENSING)
        edited = v.settle("mousemove", *BESIDE)
        assert edited.changed(home, CHANGED), "the switch changes nothing"
        v.settle("mousemove", 560, 420, "mousedown", 1)
        v.settle("mousemove", 640, 440, "mouseup", 1)
        v.settle("click", 4)
        flown = v.settle("key", "e", "mousemove", *BESIDE)
        v.settle("key", "r")
        same(flown, v.settle("key", "ctrl+z"), "after R was undone")
        same(edited, v.settle("key", "ctrl+z"), "after drag, wheel and keys were undone")
        same(home, v.settle("key", "ctrl+z"), "after the switch was undone")
        same(panel, v.picture(PANEL), "the panel then")
        v.settle("key", "ctrl+y")
        same(flown, v.settle("key", "ctrl+y"), "after the flight was done again")


def test_a_bookmarks_camera_is_taken_into_another_scene(screen, program, folder):
    with Viewer(screen, program, *COARSE, home=folder) as v:
        v.settle("key", "e")
        v.settle("key", "ctrl+b")
    other = SCENE.replace("[disc]", "[sphere]\nradius = 1.8")
    with Viewer(screen, program, *COARSE, home=folder, scene=other) as v:
        above = (320, 60, 820, 350)     # neither the bookmarks nor a message lie there
        v.settle("key", "b")
        before = v.picture(above)
        v.settle("keydown", "Shift_L")
        v.click(*BOOKMARK_PICTURE)
        v.settle("keyup", "Shift_L")
        taken = v.picture(above)
        assert v.title() == "scene - nullscope", f"Shift and a click open {v.title()}"
        assert taken.changed(before, CHANGED), "the camera stays where it was"
        v.settle("key", "ctrl+s")
        saved = tomllib.loads((Path(v.folder) / "scene-2.toml").read_text())
        assert "sphere" in saved and "disc" not in saved, f"another scene: {saved}"
        assert saved["camera"]["roll"] != -6, "not the bookmark's camera"
        v.settle("key", "ctrl+z")     # the file
        v.settle("key", "ctrl+z")
        same(before, v.picture(above), "after undo")
    far_side = '[spacetime]\nmetric = "ellis"\n[camera]\nr = -8\n'
    with Viewer(screen, program, *COARSE, home=folder, scene=far_side) as v:
        v.settle("key", "ctrl+b")
    with Viewer(screen, program, *COARSE, "--layout", "layout.txt", home=folder) as v:
        v.settle("key", "b")
        v.settle("keydown", "Shift_L")
        v.click(*BOOKMARK_PICTURE)
        v.settle("keyup", "Shift_L")
        assert v.layout().place("Cannot use the camera of scene 2", ""), v.layout().words()


def test_a_recording_is_put_aside_and_brought_back(screen, program, folder):
    with Viewer(screen, program, *COARSE, "--layout", "layout.txt") as v:
        def record(key):
            before = v.settle("key", "F9")
            v.hands("keydown", key)
            v.changes("it flies", before)
            time.sleep(0.4)
            v.hands("keyup", key)
            v.settle("key", "F9")
        record("d")
        record("e")
        assert v.layout().place("Recorded. The path before was put aside", ""), v.layout().words()
        v.settle("key", "F9")     # a third, which goes on when another scene is opened
        v.hands("keydown", "q")
        time.sleep(0.6)
        v.hands("keyup", "q")
        v.settle("key", "F5")
        assert v.layout().place("The recording was put aside", ""), v.layout().words()
        assert not v.layout().place("Play", "##timeline"), "the scene that was read again has a path"
        v.settle("key", "ctrl+z")
        assert v.layout().place("Play", "##timeline"), "undo brings no recording back"
        while "Play" in v.layout().words():     # under the timeline, which is open
            v.settle("key", "ctrl+z")
        assert v.layout().place("Nothing to undo", "") is None, "the path cannot be undone"


def test_a_recording_that_was_left_is_in_the_gallery_of_the_next_viewer(screen, program, folder):
    for last in (False, True):
        with Viewer(screen, program, *COARSE, "--layout", "layout.txt", home=folder) as v:
            if not last:
                before = v.settle("key", "F9")
                v.hands("keydown", "d")
                v.changes("it flies", before)
                time.sleep(0.4)
                v.hands("keyup", "d")
                v.settle("key", "F9")
            v.settle("key", "ctrl+o")
            if last:
                v.click(*v.layout().place("Last recording", "##gallery"))
                assert v.layout().place("Play", "##timeline"), "the recording is not in its file"
                continue
            v.click(*FIRST_CARD)
            assert v.layout().place("The recording was put aside", ""), v.layout().words()


def test_the_editor_stays_where_it_is_and_escape_closes_a_picker_alone(screen, program, folder):
    scene = SCENE + "".join(f"[[ball]]\nposition = [{x}, 6, -3]\nradius = 1\n" for x in (4, 8, 12))
    with Viewer(screen, program, *COARSE, "--layout", "layout.txt", scene=scene) as v:
        def turn_to(words):     # scrolls down
            for _ in range(40):
                if place := v.layout().place(words, "##sections"):
                    return place
                v.settle("mousemove", 800, 350, "click", 5)
            raise AssertionError(f"no {words} in {v.layout().words()}")
        v.settle("key", "ctrl+e")
        v.click(*turn_to("ball[2]"))
        turn_to("ball[3]")
        x, y = turn_to("colour")
        v.settle("mousemove", 800, 350, *["click", 5] * 20)
        x, y = turn_to("colour")
        for right in range(800, 700, -6):     # the square that opens the picker
            for step in [["mousemove", right, y], ["mousedown", 1], ["mouseup", 1]]:
                v.settle(*step)
            if any(name.startswith("##Popup") for name in v.layout().windows):
                break
        popup = next(place for name, place in v.layout().windows.items() if name.startswith("##Popup"))
        left, top = popup[0] + 60, popup[1] + 60
        v.settle("mousemove", left, top, "mousedown", 1)
        v.settle("mousemove", left + 20, top + 30)
        v.settle("mouseup", 1)
        assert v.layout().place("colour", "##sections") == (x, y), "an edit scrolls the editor"
        v.settle("key", "Escape")
        assert not any(name.startswith("##Popup") for name in v.layout().windows), "Escape leaves the picker open"
        assert "Scene" in v.layout().windows, "Escape closes the editor with the picker"
        assert v.layout().place("colour", "##sections") == (x, y), "the editor is scrolled"
        v.settle("key", "Escape")
        assert "Scene" not in v.layout().windows, "a second Escape does not close the editor"


def test_controls_have_tooltips_while_a_search_is_typed(screen, program, folder):
    with Viewer(screen, program, *COARSE, "--layout", "layout.txt") as v:
        def explained(words, window):
            v.settle("mousemove", *v.layout().place(words, window))
            return any(name.startswith("##Tooltip") for name in v.layout().windows)
        v.settle("key", "ctrl+e")
        assert explained("Search keys", "Scene") and explained("Add...", "Scene"), "no tooltip in the editor"
        v.click(*v.layout().place("Search keys", "Scene"))
        assert explained("Add...", "Scene"), "no tooltip while a search is typed"
        v.settle("key", "Escape", "key", "Escape")
        v.settle("key", "ctrl+o")
        for words in ["Search", "File to open", "Why is the shadow", "Close"]:
            assert explained(words, "##gallery"), f"no tooltip on {words} in the gallery"
        v.click(*v.layout().place("Why is the shadow", "##gallery"))
        for words in ["1 of", "Back", "Next", "Close"]:
            assert explained(words, "##tour"), f"no tooltip on {words} in a tour"


def test_a_tours_last_step_says_so_and_offers_others(screen, program, folder):
    steps = "".join(f'[[step]]\nscene = "disc-grid"\ntext = "Step {n}."\n' for n in (1, 2))
    with Viewer(screen, program, *COARSE, "--layout", "layout.txt",
                scene=f'title = "Mine"\ndescription = "One."\n{steps}') as v:
        has = lambda words: v.layout().place(words, "##tour")
        assert has("Next") and not has("Other tours"), v.layout().words()
        v.settle("key", "Next")
        assert has("2 of 2: the last step") and not has("Next"), v.layout().words()
        v.settle("key", "Next")
        assert v.layout().place("This was the tour's last step", ""), v.layout().words()
        v.click(*has("Other tours"))
        v.click(*v.layout().place("Why is the shadow", "Guided_tours"))
        assert has("1 of 7"), v.layout().words()


def test_tooltips_leave_the_row_free_that_they_explain(screen, program, folder):
    with Viewer(screen, program, *COARSE, "--layout", "layout.txt") as v:
        def tooltip(*place):
            v.settle("mousemove", *place)
            return next(place for name, place in v.layout().windows.items() if name.startswith("##Tooltip"))
        x, y = v.layout().place("Azimuth", "##side")
        left, top, width, height = tooltip(x, y)
        assert top > y + 10, f"a tooltip at {top} for a row at {y}"
        v.settle("key", "ctrl+plus", "key", "ctrl+plus", "mousemove", *BESIDE)
        lowest = max((place for name, words, place in v.layout().texts if name == "##side" and words in ("Polar angle", "Azimuth", "Yaw", "Pitch", "Roll", "Speed", "beta")),
                     key=lambda place: place[1])
        left, top, width, height = tooltip(lowest[0] + 4, lowest[1] + 4)
        assert top + height < lowest[1] or top > lowest[1] + lowest[3], f"a tooltip from {top} to {top + height} over a row at {lowest[1]}"
        assert top + height <= HEIGHT, "a tooltip leaves the window"
        v.settle("key", "ctrl+minus", "key", "ctrl+minus", "mousemove", *BESIDE)
        v.click(*MENUS["View"])
        x, y = v.layout().place("Critical curve", "##Menu")
        menu = next(place for name, place in v.layout().windows.items() if name.startswith("##Menu"))
        assert tooltip(x, y)[0] >= menu[0] + menu[2], "an entry's tooltip lies over the menu"


def test_a_click_on_a_body_opens_it_in_the_editor(screen, program, folder):
    with Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}", "--layout", "layout.txt", scene=SCENE + BODIES) as v:
        def press(x, y, *drag):
            for step in [["mousemove", x, y], ["mousedown", 1], [*drag, "mouseup", 1], ["mousemove", *BESIDE]]:
                v.settle(*step)
            return "Scene" in v.layout().windows
        assert not press(665, 400), "a click on the disc before the ball opens the editor"
        assert not press(600, 60), "a click on the sky opens the editor"
        assert not press(665, 500, "mousemove", 680, 500), "a drag that begins on the ball opens the editor"
        v.settle("key", "r")
        assert press(420, 270), "a click on the sphere does not open the editor"
        assert v.layout().place("Remove", "##sections"), v.layout().words()
        assert "radius" in v.layout().words(), v.layout().words()
        v.settle("key", "ctrl+e")
        v.settle("mousemove", 665, 500, "mousedown", 1)
        v.settle("mouseup", 1, "mousemove", *BESIDE)
        assert v.layout().place("position", "##sections"), f"the ball's section is shut: {v.layout().words()}"


def test_coarse_pictures_fill_the_window_and_are_clicked_on(screen, program, folder):
    arguments = ["--size", f"{WIDTH}x{HEIGHT}", "--layout", "layout.txt"]
    with Viewer(screen, program, *arguments, scene=SCENE + BODIES) as v:
        fine = v.settle()
    with Viewer(screen, program, *arguments, "--coarse", "4", scene=SCENE + BODIES) as v:
        coarse = v.settle()
        assert coarse.changed(fine, CHANGED), "the picture is as fine as ever"
        assert coarse.differing(fine, tolerance=60) < CHANGED, "another picture"
        v.settle("mousemove", 420, 270, "mousedown", 1)
        v.settle("mouseup", 1, "mousemove", *BESIDE)
        assert v.layout().place("Remove", "##sections"), "a click on the sphere does not open the editor"


def test_a_hidden_body_is_left_out_of_films(screen, program, folder):
    with Viewer(screen, program, *COARSE, "--layout", "layout.txt", scene=SCENE + BODIES) as v:
        press = lambda words, window="": v.click(*v.layout().place(words, window))
        v.settle("mousemove", 420, 270, "mousedown", 1)
        v.settle("mouseup", 1, "mousemove", *BESIDE)     # the sphere's section
        press("Hide", "##sections")
        v.settle("key", "ctrl+e", "key", "ctrl+t")
        press("Set key", "##timeline")
        press("Film...", "##timeline")
        press("Frames (.png)")
        press("Draw")
        file = v.settings.parent / f"film-{v.process.pid}.toml"
        scene = tomllib.loads(wait_until("the film's scene", lambda: file.exists() and file.read_text(), HUNG_S))
        assert "ball" in scene and "sphere" not in scene, f"the film has {list(scene)}"
        press("Cancel", "##timeline")
        assert not file.exists(), "the scene of a film that was cancelled stays"


def test_f12_saves_both_sides_of_a_comparison_without_line_and_labels(screen, program, folder):
    with Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}") as v:
        def saved():
            v.settle("key", "F12")
            path = wait_until("F12 saves a file", lambda: next(Path(v.folder).glob("nullscope-*.png"), None))
            picture = read_png(path)
            path.unlink()
            return picture
        v.settle()
        alone = saved()
        v.settle("key", "x")
        same(alone, saved(), "both sides, which are the same")
        for header in [*HEADERS, LIGHT, LENSING]:
            v.click(*header)
        both = saved()
        right = (WIDTH // 2 + 4, 0, WIDTH, HEIGHT)
        same(alone.crop(*right), both.crop(*right), "side B")
        assert both.crop(0, 0, WIDTH // 2 - 4, HEIGHT).changed(alone.crop(0, 0, WIDTH // 2 - 4, HEIGHT), CHANGED), "side A is not saved"


def test_a_film_without_ffmpeg_is_frames_and_a_failure_is_told_at_once(screen, program, folder):
    (folder / "xdotool").symlink_to(shutil.which("xdotool"))     # and nothing else
    with Viewer(screen, program, *COARSE, "--layout", "layout.txt", environment={"PATH": str(folder)}) as v:
        v.settle("key", "ctrl+t")
        v.click(*v.layout().place("Set key", "##timeline"))
        v.click(*v.layout().place("Film...", "##timeline"))
        assert v.layout().place("A film needs ffmpeg", ""), v.layout().words()
        v.settle("mousemove", *v.layout().place(v.scene.stem, "##Popup"), "mousedown", 1)
        v.settle("mouseup", 1)
        v.settle("key", "ctrl+a")
        v.hands("type", "--delay", 60, "nowhere/film")
        v.settle()
        v.settle("mousemove", *v.layout().place("Draw", ""), "mousedown", 1)
        v.hands("mouseup", 1)     # nothing else happens to the window
        wait_until("the message", lambda: v.layout().place("No film", ""), HUNG_S)


def test_a_view_that_is_pasted_in_the_gallery_opens_its_scene(screen, program, folder):
    with Viewer(screen, program, *COARSE, "--layout", "layout.txt", scene="disc-grid") as v:
        turned = v.settle("key", "e")
        v.settle("key", "ctrl+c")
        for paste in (lambda: v.settle("key", "ctrl+v"), lambda: v.choose("Edit", "Paste view")):
            v.settle("key", "ctrl+o")
            v.click(*FIRST_CARD)
            assert v.title() == "First light - nullscope", v.title()
            v.settle("key", "ctrl+o")
            paste()
            assert v.title() == "Disc grid - nullscope", v.title()
            same(turned, v.settle(), "the view that was pasted")
        v.settle("key", "ctrl+o")
        v.click(*FIRST_CARD)
        v.settle("key", "ctrl+v")
        assert v.title() == "First light - nullscope", v.title()
        assert v.layout().place("View pasted: the camera alone", ""), v.layout().words()


def test_a_scene_that_was_changed_is_sent_as_one_line(screen, program, folder):
    scene = 'name = "mine"\n[camera]\nr = 20\n[[ball]]\nposition = [4, 3, 1]\n[[ball]]\nposition = [4, -3, 1]\n'
    with Viewer(screen, program, *COARSE, "--layout", "layout.txt", scene=scene) as v:
        turned = v.settle("key", "e")
        v.settle("key", "ctrl+c")
        v.settle("key", "ctrl+o")
        v.click(*FIRST_CARD)
        assert v.title() == "First light - nullscope", v.title()
        v.settle("key", "ctrl+v")
        assert v.title() == "mine - nullscope", v.title()
        same(turned, v.settle(), "the scene that was pasted")


def test_a_search_shows_what_it_finds_and_says_when_it_finds_nothing(screen, program, folder):
    with Viewer(screen, program, *COARSE, "--layout", "layout.txt") as v:
        def typed(words, hint, window):     # the pointer stays where it was clicked
            for step in [["mousemove", *v.layout().place(hint, window)], ["mousedown", 1], ["mouseup", 1]]:
                v.settle(*step)
            v.hands("type", "--delay", 60, words)
            v.settle()
            assert not any(name.startswith("##Tooltip") for name in v.layout().windows), f"a tooltip over what {words} finds"
        v.settle("key", "ctrl+e")
        typed("fov", "Search keys", "Scene")
        assert v.layout().place("fov", "##sections") and not v.layout().place("No key", ""), v.layout().words()
        typed("xyz", "fov", "Scene")
        assert v.layout().place("No key of this scene", ""), v.layout().words()
        v.settle("key", "ctrl+o")
        typed("kerr.toml", "File to open", "##gallery")


def test_a_section_that_is_opened_is_seen(screen, program, folder):
    with Viewer(screen, program, *COARSE, "--layout", "layout.txt") as v:
        v.settle("mousemove", 150, 400, *["click", 5] * 20)
        v.click(*v.layout().place("Numbers", "##side"))
        assert v.layout().place("Decimals", "##side"), v.layout().words()
        v.settle("key", "ctrl+e")
        lowest = max((y, words) for name, words, (_, y, _, _) in v.layout().texts if "##sections" in name)[1]
        v.click(*v.layout().place(lowest, "##sections"))
        assert any(y > v.layout().place(lowest, "##sections")[1] for name, _, (_, y, _, _) in v.layout().texts
                   if "##sections" in name), f"what {lowest} has is not seen"


def test_a_stereo_scene_says_that_one_picture_is_shown(screen, program, folder):
    pair = '[camera]\nstereo = "pair"\n[sky]\nkind = "plain"\n'
    with Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}", "--layout", "layout.txt", scene=pair) as v:
        wait_until("the message", lambda: v.layout().place("The window shows what is seen from between the eyes", ""), HUNG_S)


def test_a_fall_says_where_it_ended(screen, program, folder):
    black = '[camera]\nr = 8\n[sky]\nkind = "black"\n'
    for scene, where in [(black, "in the singularity"),
                         (black + '[spacetime]\nmetric = "kerr"\nspin = 0.9\n', "inside the hole at r = 0.")]:
        with Viewer(screen, program, *COARSE, "--layout", "layout.txt", scene=scene) as v:
            for header in HEADERS:
                v.click(*header)
            v.settle("key", "f", "key", "f")     # released, and held at once
            v.click(*v.layout().place("Free fall", "##side"))
            x, y = v.layout().place("Proper time", "##side")
            v.settle("mousemove", 150, y, "mousedown", 1)
            v.settle("mousemove", 400, y)
            v.settle("mouseup", 1)
            wait_until(f"the fall ends {where}", lambda: v.layout().place(f"The fall has ended {where}", ""), HUNG_S)


def test_recent_files_are_told_apart_and_are_there(screen, program, folder):
    for name in ("one", "two"):
        (folder / name).mkdir()
        (folder / name / "mine.toml").write_text(f'name = "Mine {name}"\n')
    files = [str(folder / file) for file in ("one/mine.toml", "two/mine.toml", "gone.toml")]
    with Viewer(screen, program, "--gallery", *COARSE, "--layout", "layout.txt", settings=f"recent = {files}\n") as v:
        v.settle()
        has = lambda words: v.layout().place(words, "##gallery")
        assert has("one/mine") and not has("gone"), v.layout().words()
        v.click(*has("two/mine"))
        assert v.title() == "Mine two - nullscope", v.title()


def test_a_scene_that_is_not_there_yet_is_named(screen, program, folder):
    with Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}", environment=COMPILING) as v:
        area = (320, 310, 820, 490)     # below the words
        before = v.picture(area)
        dimmed = Picture(before.width, before.height, bytes(round(byte * 55 / 255) for byte in before.data))
        v.settle("key", "ctrl+o")
        v.hands("type", "--delay", 100, "kerr planet")
        v.settle()
        v.hands("key", "Return")     # its shaders are compiled for a second or more
        wait_until("the picture of the scene before is dimmed", lambda: not v.picture(area).changed(dimmed, CHANGED), HUNG_S)
        v.settle()
        assert v.title() == "Kerr planet - nullscope", v.title()
        v.settle("key", "ctrl+z")
        same(before, v.picture(area), "the scene before, after undo")


CASES = [test_an_effect_is_switched_without_a_hitch,
         test_keys_count_before_the_first_picture_and_what_moves_is_followed_coarsely,
         test_matter_along_rays_holds_no_input, test_a_flight_about_a_rotating_hole_goes_on_among_point_stars,
         test_the_clock_runs_and_stops, test_dumps_follow_the_clock_without_a_hitch, test_screenshot, test_the_gallery_finds_and_opens,
         test_the_first_visit_has_hints_and_the_next_has_none, test_menus_do_what_they_say,
         test_the_critical_curve_is_synges_circle_and_the_potential_is_drawn, test_a_killed_viewer_leaves_its_scene,
         test_a_planet_is_added_saved_under_a_name_and_escape_closes_one_thing_at_a_time,
         test_a_tour_is_led_forward_and_back_and_closed, test_a_file_is_known_as_a_tour,
         test_messages_and_the_sign_of_a_record_keep_beside_the_panels,
         test_a_flight_is_recorded_played_saved_and_filmed,
         test_split_screens_have_a_line_and_labels, test_bad_input,
         test_a_scene_that_cannot_be_drawn, test_no_display, test_old_opengl]
# Of every depth but quick.
if EVERYTHING:
    CASES += [test_polarised_light_is_shown, test_shaders_are_timed_once_for_each_kind_of_scene,
              test_undo_in_a_search_that_was_left_does_not_touch_the_next,
              test_coarse_pictures_fill_the_window_and_are_clicked_on,
              test_a_recording_that_was_left_is_in_the_gallery_of_the_next_viewer,
              test_the_editor_stays_where_it_is_and_escape_closes_a_picker_alone,
              test_controls_have_tooltips_while_a_search_is_typed, test_a_tours_last_step_says_so_and_offers_others,
              test_an_edit_before_a_flight_is_two_steps_of_undo_away,
              test_a_bookmarks_camera_is_taken_into_another_scene, test_a_recording_is_put_aside_and_brought_back,
              test_tooltips_leave_the_row_free_that_they_explain, test_a_click_on_a_body_opens_it_in_the_editor,
              test_a_hidden_body_is_left_out_of_films,
              test_f12_saves_both_sides_of_a_comparison_without_line_and_labels,
              test_a_camera_that_side_b_cannot_have_is_refused, test_a_gamepad_flies_and_its_buttons_do_what_keys_do,
              test_a_film_without_ffmpeg_is_frames_and_a_failure_is_told_at_once,
              test_a_view_that_is_pasted_in_the_gallery_opens_its_scene,
              test_a_scene_that_was_changed_is_sent_as_one_line,
              test_a_search_shows_what_it_finds_and_says_when_it_finds_nothing, test_a_section_that_is_opened_is_seen,
              test_a_fall_says_where_it_ended, test_a_stereo_scene_says_that_one_picture_is_shown, test_recent_files_are_told_apart_and_are_there,
              test_a_scene_that_is_not_there_yet_is_named,
              test_a_warp_mesh_is_looked_through_and_dragged,
              test_exposure_follows_like_an_eye, test_several_rays_a_pixel_wait_for_rest,
              test_a_file_is_chosen_in_the_desktops_dialog,
              test_bookmarks_are_kept_opened_renamed_and_deleted,
              test_what_a_scene_file_may_say_can_be_typed_in, test_a_lamp_lights_a_disc_and_moves_up, test_the_side_panel_takes_what_the_key_table_allows,
              test_the_light_theme_is_switched_and_kept,
              test_a_body_is_hidden_and_shown,
              test_the_cameras_clock_is_shown_and_follows,
              test_two_settings_are_compared_across_a_line_to_drag,
              test_a_drag_goes_round_the_hole_at_constant_r]
