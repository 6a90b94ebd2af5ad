"""Cases of what lies over the picture and beside it; each runs viewers of its own."""
import tomllib

from viewer_process import *


def opened(screen, program, *arguments, **more):
    return Viewer(screen, program, "--size", f"{WIDTH}x{HEIGHT}", "--layout", "layout.txt", *arguments, **more)


def test_a_path_is_eased(screen, program, folder):
    with opened(screen, program) as v:
        v.settle("key", "ctrl+t")
        v.click(*v.layout().place("Set key", "##timeline"))
        x, y = v.layout().place("Ease", "##timeline")
        v.click(x - 25, y)
        v.settle("key", "ctrl+s")
        saved = next(path for path in Path(v.folder).glob("*.toml") if path != v.scene)
        assert tomllib.loads(saved.read_text())["path"]["easing"] == "smooth", "Ease does not change the path"


CASES = []
# Of every depth but quick.
if EVERYTHING:
    CASES += [test_a_path_is_eased]
