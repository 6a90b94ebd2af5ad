"""Cases of what lies over the picture and beside it; each runs viewers of its own."""
import tomllib

from viewer_process import *


def opened(screen, program, *arguments, **more):
    return Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}", "--layout", "layout.txt", *arguments, **more)


def says(v, words):
    return any(words in text for _, text, _ in v.layout().texts)


def from_menu(v, menu, entry):
    v.click(*v.layout().place(menu, "##MainMenuBar"))
    v.click(*v.layout().place(entry, "##Menu"))


def shut_sections(v):
    for section in ("Camera", "Boost", "Lens"):
        v.click(*v.layout().place(section, "##side"))


def test_units_are_chosen_and_kept(screen, program, folder):
    with opened(screen, program, home=folder) as v:
        shut_sections(v)
        v.click(*v.layout().place("Numbers", "##side"))
        assert says(v, "1.5 r_s") and not says(v, "3 M"), "the radii are not in r_s at first"
        v.click(*v.layout().place("M", "##side"))
        assert says(v, "3 M") and not says(v, "1.5 r_s"), "the radii are not in M"
        v.settle("key", "p", "mousemove", 600, 250)
        assert says(v, " M/c") or says(v, " M"), "the probe is not in M"
        v.click(*v.layout().place("km", "##side"))
        assert says(v, "1.9035e+07 km"), "the photon orbit about Sgr A* is not in km"
        v.click(LENSING[0], v.layout().place("Comma", "##side")[1])
        assert says(v, "1,9035e+07 km"), "there is no decimal comma"
        v.settle("mousemove", 600, 250)
        from_menu(v, "View", "Clock and redshift")
        assert says(v, "0,977008"), "the clock has no decimal comma"
        v.settle("key", "ctrl+s")
        saved = next(path for path in Path(v.folder).glob("*.toml") if path != v.scene)
        assert tomllib.loads(saved.read_text())["camera"]["r"] == 22.0, "a saved number was changed"
        assert tomllib.loads(v.settings.read_text())["units"] == "km", v.settings.read_text()
    with opened(screen, program, home=folder, settings='units = "km"\nmass_suns = 1.0\ndecimal_comma = true\n') as v:
        shut_sections(v)
        v.click(*v.layout().place("Numbers", "##side"))
        assert says(v, "4,4299 km"), "the settings' mass is not used"


def test_a_path_is_eased(screen, program, folder):
    with opened(screen, program) as v:
        v.settle("key", "ctrl+t")
        v.click(*v.layout().place("Set key", "##timeline"))
        x, y = v.layout().place("Ease", "##timeline")
        v.click(x - 25, y)
        v.settle("key", "ctrl+s")
        saved = next(path for path in Path(v.folder).glob("*.toml") if path != v.scene)
        assert tomllib.loads(saved.read_text())["path"]["easing"] == "smooth", "Ease does not change the path"


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
        assert tomllib.loads(kept)["window_place"] == [60, 35], kept
    with Viewer(screen, program, *size, home=folder, settings="window_place = [60, 35]\n") as v:
        assert place(v) == (60, 35), f"it is at {place(v)}"
    with Viewer(screen, program, *size, home=folder, settings="window_place = [90000, -90000]\n") as v:
        left, top = place(v)
        assert 0 <= left <= WIDTH and top == 0, f"a window beyond the screen is put at {left}, {top}"


CASES = []
# Of every depth but quick.
if EVERYTHING:
    CASES += [test_units_are_chosen_and_kept, test_a_path_is_eased, test_the_windows_place_is_kept]
