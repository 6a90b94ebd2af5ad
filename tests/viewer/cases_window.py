"""Cases that share one viewer, in this order."""
import re
from pathlib import Path

from viewer_process import *
from x_screen import read_png, wait_until


def shift_between(before, after, reach):
    """(dx, dy) by which the picture's middle moved, in px; coarse pixels, all shifts up to reach."""
    def distance(dx, dy):
        total = 0
        for y in range(reach, before.height - reach, 12):
            for x in range(reach, before.width - reach, 12):
                total += abs(before.grey(x, y) - after.grey(x + dx, y + dy))
        return total
    steps = range(-reach, reach + 1, 5)
    return min(((dx, dy) for dx in steps for dy in steps), key=lambda shift: distance(*shift))


def test_the_first_picture_is_coarse_and_none_is_drawn_twice(v):
    kinds = [values["picture"] for word, values in v.log.since() if word == "first"]
    turns = v.log.turns()
    assert kinds == ["coarse", "whole"], f"the first pictures: {kinds}"
    assert turns[0]["picture"] == "none", "the window waited for its first picture"
    assert turns[-1]["programs"] == "1", f"{turns[-1]['programs']} programs for one picture"


def test_motion_without_a_drag_changes_nothing(v):
    before = v.settle()
    for x, y in [(400, 320), (700, 500), (330, 550), BESIDE]:
        v.hands("mousemove", x, y)
    same(before, v.settle(), "after motion without a drag")


def test_a_drag_moves_what_is_grabbed_with_the_hand(v):
    before = v.settle("mousemove", *BESIDE)
    v.hands("mousemove", 560, 420, "mousedown", 1, "mousemove", 600, 440)
    v.changes("a drag turns the camera", before)
    dragged = v.settle()
    same(before, v.settle("mousemove", 700, 300, "mousemove", 560, 420), "after the hand came back", CURSOR)
    after = v.settle("mousemove", 600, 440, "mouseup", 1, "mousemove", *BESIDE)
    same(dragged, after, "after the button was let go", CURSOR)
    dx, dy = shift_between(before, after, 60)
    assert abs(dx - 40) <= 10 and abs(dy - 20) <= 10, f"the hand went 40 px right, 20 down, the picture {dx} and {dy}"
    same(after, v.settle("mousemove", 640, 500, "mousemove", *BESIDE), "after motion that follows the drag")


def test_a_drag_on_a_panel_does_not_turn_the_camera(v):
    before = v.settle()
    for step in [["mousemove", 60, 450 + MENU], ["mousedown", 1], ["mousemove", *BESIDE], ["mouseup", 1]]:
        v.settle(*step)
    same(before, v.picture(), "after a drag that began on the panel")


def test_right_drag_rolls(v):
    before = v.settle()
    after = v.settle("mousemove", 700, 300, "mousedown", 3, "mousemove", 700, 420, "mouseup", 3, "mousemove", *BESIDE)
    assert after.changed(before, CHANGED), "a right drag does not roll the camera"


def test_keys_and_wheel_move_and_r_comes_back(v):
    home = v.settle("mousemove", *BESIDE, "key", "r")
    for name, press, release in [("W", ["keydown", "w"], ["keyup", "w"]), ("D", ["keydown", "d"], ["keyup", "d"]),
                                 ("space", ["keydown", "space"], ["keyup", "space"]),
                                 ("E", ["keydown", "e"], ["keyup", "e"]),
                                 ("wheel", ["click", 4], ["click", 4]),
                                 ("shift and wheel", ["keydown", "shift", "click", 5], ["click", 5, "keyup", "shift"])]:
        v.hands(*press)
        v.changes(f"{name} moves the camera", home)
        v.settle(*release)     # the wheel's motion runs on for a while
        same(home, v.settle("key", "r"), f"R after {name}")


def test_typing_a_number_does_not_fly(v):
    shots = []
    for text in ["14", "w14"]:     # w is no part of a number, and no flight while a field has the keyboard
        before = v.settle("mousemove", *BESIDE, "key", "r")
        for step in [["mousemove", 200, 98 + MENU], ["mousedown", 1], ["mouseup", 1]]:
            v.settle(*step)
        for key in ["ctrl+a", *text, "Return"]:
            for sign in ("keydown", "keyup"):     # Dear ImGui 1.86 sees keys that are down during a frame
                v.settle(sign, key) if "+" not in key else v.settle("key", key)
        shots.append(v.settle())
        assert shots[-1].changed(before, CHANGED), "a radius that is typed in takes no effect"
    same(*shots, "between 14 and w14")
    v.settle("mousemove", *BESIDE, "key", "r")


def test_a_broken_scene_is_said_and_survived(v):
    good = v.scene.read_text()
    before, side = v.settle("mousemove", *BESIDE, "key", "r"), v.picture(SIDE)
    v.scene.write_text("[camera]\nr = -1\n")
    v.click(*RELOAD)
    assert v.picture(SIDE).changed(side, CHANGED), "the panel does not show the error"
    same(before, v.picture(), "the picture of a scene that became unreadable")
    v.scene.write_text(good.replace("r = 22.0", "r = 12.0"))
    v.click(*RELOAD)
    assert v.picture().changed(before, CHANGED), "the mended scene is not read"
    v.scene.write_text(good)
    v.click(*RELOAD)
    same(before, v.settle(), "after reading the first scene again")


def test_tab_hides_the_panels(v):
    before = v.settle()
    side = v.picture(SIDE)
    same(before, v.settle("key", "Tab"), "the picture beside the panels")
    hidden = v.picture(SIDE)
    assert hidden.changed(side, CHANGED), "Tab does not hide the panels"
    v.settle("key", "Tab")
    assert v.picture(SIDE).changed(hidden, CHANGED), "Tab does not bring the panels back"


def test_f1_lists_the_keys(v):
    v.settle("key", "F1")
    assert v.count(KEYS, LETTERS) > 20, "no list of keys"
    v.settle("key", "F1")
    assert v.count(KEYS, LETTERS) <= 20, "the list of keys stays"


def test_f12_saves_the_picture_without_panels(v):
    shown = v.settle()
    v.hands("key", "F12")
    path = wait_until("F12 saves a file", lambda: next(Path(v.folder).glob("nullscope-*.png"), None))
    saved = read_png(path)
    assert (saved.width, saved.height) == (WIDTH, HEIGHT), f"saved {saved.width}x{saved.height}"
    same(saved.crop(*PICTURE), shown, "the saved picture beside the panels")
    v.settle("key", "Tab")
    same(saved.crop(*SIDE), v.picture(SIDE), "the saved picture below the panels")
    v.settle("key", "Tab")
    path.unlink()


def test_undo_redo_copy_paste_and_save(v):
    home = v.settle("mousemove", *BESIDE, "key", "r")
    turned = v.settle("mousemove", 560, 420, "mousedown", 1, "mousemove", 640, 440, "mouseup", 1, "mousemove", *BESIDE)
    assert turned.changed(home, CHANGED), "a drag does not turn the camera"
    same(home, v.settle("key", "ctrl+z"), "after undo")
    same(turned, v.settle("key", "ctrl+shift+z"), "after redo")
    v.settle("key", "ctrl+c", "key", "r")
    same(turned, v.settle("key", "ctrl+v"), "the view that was pasted")
    before = set(Path(v.folder).glob("*.toml"))
    v.settle("key", "ctrl+s")
    saved = wait_until("Ctrl+S writes a file", lambda: next(iter(set(Path(v.folder).glob("*.toml")) - before), None))
    v.hands("keydown", "e")
    v.changes("E rolls", turned)
    assert v.settle("keyup", "e").changed(turned, CHANGED), "E does not roll"
    same(turned, v.settle("key", "r"), "R after a file was saved")
    for _ in range(8):     # to the scene as it was opened, and to the test's first view
        v.settle("key", "ctrl+z")
    v.click(*RELOAD)
    same(home, v.settle("key", "r"), "after everything was undone")
    saved.unlink()


def test_the_editor_adds_changes_refuses_and_removes(v):
    def seen(*words):
        v.settle(*words)
        return v.picture(ADDED)
    home = seen("mousemove", *BESIDE, "key", "r")
    v.settle("key", "ctrl+e")
    v.click(*EDITOR_ADD)
    v.click(EDITOR_ADD[0], EDITOR_ADD[1] + 22 + 19 * 6)     # spot, cap, split, path, sphere, cylinder, ball: the disc is there
    ball = seen("key", "ctrl+e")
    assert ball.changed(home, 4 * NOISE), "no ball is there after it was added"
    v.settle("key", "ctrl+e")
    v.click(*EDITOR_SEARCH)
    v.hands("type", "--delay", 60, "disc inner")
    v.settle()
    v.settle("mousemove", *EDITOR_FIELD, "keydown", "ctrl")
    for step in [["mousedown", 1], ["mouseup", 1], ["keyup", "ctrl"]]:
        v.settle(*step)
    for key in ["ctrl+a", *"900", "Return"]:
        v.settle("key", key)
    v.settle("mousemove", *BESIDE)
    assert v.refused(EDITOR) > 20, "an inner radius beyond the outer one is not refused"
    v.click(*EDITOR_SEARCH)
    for key in ["ctrl+a", "BackSpace", "Escape"]:
        v.settle("key", key)
    v.settle("mousemove", *BESIDE, "key", "ctrl+e")
    same(ball, v.picture(ADDED), "after a value that was refused")
    same(home, seen("key", "ctrl+z"), "after the ball was undone")


def test_f11_fills_the_screen(v):
    def saved_size():
        for old in Path(v.folder).glob("nullscope-*.png"):
            old.unlink()
        v.settle("key", "F12")
        picture = read_png(next(Path(v.folder).glob("nullscope-*.png")))
        next(Path(v.folder).glob("nullscope-*.png")).unlink()
        return picture.width, picture.height
    before = v.settle()
    v.hands("key", "F11")
    wait_until("the window fills the screen", lambda: saved_size() == (WIDTH + 100, HEIGHT + 100))
    v.hands("key", "F11")
    wait_until("the window has its size again", lambda: saved_size() == (WIDTH, HEIGHT))
    same(before, v.settle(), "the window where it was")


def test_at_rest_it_leaves_the_processor_alone(v):
    v.settle(measured=True)
    v.rests()


def test_h_lays_the_errors_over_the_picture(v):
    before = v.settle("mousemove", *BESIDE, "key", "r")
    assert v.count(LEGEND, WRONG_FATE) == 0, "the legend is there before"
    v.hands("key", "h")
    v.changes("H lays the errors over the picture", before)
    wait_until("the legend is there", lambda: v.count(LEGEND, WRONG_FATE) > 40)
    first = v.picture()
    v.changes("the colours grow finer", first)
    if EVERYTHING:
        measured = v.settle(measured=True)
        v.rests()
        left = v.picture(BESIDE_LEGEND)
        stars = sum(min(left.data[i:i + 3]) > 120 for i in range(0, len(left.data), 3))
        assert stars < 20, f"the picture still shows through: {stars} bright pixels"
    dark = v.picture().mean()
    v.hands("keydown", "e")     # the picture in flight, then the errors of where it came to rest
    wait_until("in flight the picture is seen", lambda: v.picture().mean() > 1.5 * dark)
    v.hands("keyup", "e", "key", "r")
    if EVERYTHING:
        v.settle(measured=True)
        same(v.picture(), measured, "the errors at the same place")
    same(before, v.settle("key", "h"), "the picture after the overlay")
    assert v.count(LEGEND, WRONG_FATE) == 0, "the legend is still there"


def entry(method):
    """Where the open list of methods shows one: below auto, in the order of the file that ships."""
    lines = (Path(__file__).resolve().parents[2] / "assets" / "frontier.csv").read_text().splitlines()
    names = [line.split(",")[1] for line in lines if line.startswith("schwarzschild,")]
    return AUTO[0], AUTO[1] + 19 * (1 + names.index(method))


def test_p_shows_the_ray_under_the_cursor(v):
    v.settle("mousemove", 500, 200)
    before = v.picture(INSET)
    v.settle("key", "p")
    first = v.picture(INSET)
    assert first.changed(before, CHANGED) and v.count(INSET, RAY) > 20, "no ray is drawn"
    v.settle("mousemove", 420, 250)
    assert v.picture(INSET).changed(first, NOISE), "the same ray elsewhere"
    v.settle("key", "p", "mousemove", 500, 200)
    same(v.picture(INSET), before, "the picture alone")


def test_the_accuracy_section_chooses_refuses_and_measures(v):
    before = v.settle("mousemove", *BESIDE, "key", "r")
    for header in [*HEADERS, ALONE]:
        v.toggle(*header)
    same(before, v.settle(measured=EVERYTHING), "the picture beside the section")
    usual = v.picture(WORDS)
    assert v.refused() == 0, "0.05 px is refused"
    v.click(*LEAST)
    assert v.refused() > 20, "1e-4 px is not refused in words"
    v.click(*MOST)
    assert v.refused() == 0, "10 px is not granted"
    granted = v.picture(WORDS)
    assert granted.differing(usual) > 0, "the words do not name what was asked"
    v.click(*METHOD)
    v.click(*entry("table:64:bilinear"))     # some 0.3 px off in this frame
    assert v.picture(WORDS).changed(granted, CHANGED), "the words do not name the method chosen by hand"
    plain = v.picture(BESIDE_LEGEND).data[::3]
    v.settle("key", "h", measured=EVERYTHING)

    def worse():     # yellow to white: above some 0.03 px; where the picture, which shows until then, is dark
        reds = v.picture(BESIDE_LEGEND).data[::3]
        return sum(red > 120 and was < 60 for red, was in zip(reds, plain)) / len(reds)
    wait_until("a coarse table is above 0.03 px in 2 % of the pixels", lambda: worse() > 0.02, MEASURED_S)
    v.settle("key", "h")
    v.click(*METHOD)
    v.settle("mousemove", 150, 300)     # the list begins where the method in use is
    for _ in range(10):
        v.settle("click", 4)
    v.click(*AUTO)
    same(before, v.settle(), "the picture of auto")
    for header in [ALONE, *reversed(HEADERS)]:
        v.toggle(*header)
    same(before, v.settle(), "the picture afterwards")


def test_resizing_keeps_the_horizontal_field_of_view(v):
    v.hands("windowsize", v.window, 600, 500)

    def saved_size():
        for old in Path(v.folder).glob("nullscope-*.png"):
            old.unlink()
        v.settle("key", "F12")
        picture = read_png(next(Path(v.folder).glob("nullscope-*.png")))
        return picture if (picture.width, picture.height) == (600, 500) else None
    small = wait_until("a picture of the new size", saved_size)
    assert small.mean() > 1, "the picture of the new size is black"
    v.settle("windowsize", v.window, WIDTH, HEIGHT)


def test_escape_quits(v):
    v.settle("key", "Escape")
    assert v.process.poll() is None, "one Escape quits"
    v.hands("key", "Escape")
    assert v.process.wait(timeout=HUNG_S) == 0, f"exit status {v.process.returncode}"


CASES = [test_the_first_picture_is_coarse_and_none_is_drawn_twice, test_motion_without_a_drag_changes_nothing,
         test_a_drag_moves_what_is_grabbed_with_the_hand, test_a_drag_on_a_panel_does_not_turn_the_camera,
         test_right_drag_rolls, test_keys_and_wheel_move_and_r_comes_back, test_typing_a_number_does_not_fly,
         test_a_broken_scene_is_said_and_survived, test_tab_hides_the_panels, test_f1_lists_the_keys,
         test_undo_redo_copy_paste_and_save,
         test_the_editor_adds_changes_refuses_and_removes, test_f11_fills_the_screen,
         test_at_rest_it_leaves_the_processor_alone, test_h_lays_the_errors_over_the_picture,
         test_p_shows_the_ray_under_the_cursor,
         test_the_accuracy_section_chooses_refuses_and_measures, test_f12_saves_the_picture_without_panels,
         test_resizing_keeps_the_horizontal_field_of_view, test_escape_quits]
