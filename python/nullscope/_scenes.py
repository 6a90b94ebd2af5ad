"""Scenes, however they are given."""
import json
import math
import os
import tomllib
from collections.abc import Mapping

from . import _core

SceneLike = _core.Scene | str | os.PathLike | Mapping   # what every function takes as a scene


def _value(value):
    if hasattr(value, "item") and not getattr(value, "ndim", 0):   # of NumPy
        value = value.item()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, (str, os.PathLike)):
        return json.dumps(os.fspath(value), ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{json.dumps(str(key))} = {_value(item)}" for key, item in value.items()) + "}"
    if isinstance(value, (list, tuple)) or (hasattr(value, "tolist") and getattr(value, "ndim", 0)):
        return "[" + ", ".join(map(_value, value)) + "]"
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        return repr(value) if math.isfinite(value) else ("nan" if math.isnan(value) else "inf" if value > 0 else "-inf")
    raise _core.Error(f"scene: {type(value).__name__} is nothing that a scene holds; allowed: numbers, text, lists, dicts")


def _text(sections):
    """The text of a scene file. A list of dicts is a list of sections, [[ball]]."""
    lines = [f"{json.dumps(str(key))} = {_value(value)}" for key, value in sections.items() if not _is_section(value)]
    for name, value in sections.items():
        if not _is_section(value):
            continue
        several = not isinstance(value, Mapping)
        for one in value if several else [value]:
            word = json.dumps(str(name))
            lines.append(f"[[{word}]]" if several else f"[{word}]")
            lines += [f"{json.dumps(str(key))} = {_value(item)}" for key, item in one.items()]
    return "\n".join(lines) + "\n"


def _is_section(value):
    return isinstance(value, Mapping) or (isinstance(value, (list, tuple)) and bool(value)
                                          and all(isinstance(one, Mapping) for one in value))


def scene(given: SceneLike, /, **changes: object) -> _core.Scene:
    """A Scene, by its name, path, text or a dict; with changes, section by section.

    given: the name of a scene that ships, the path of a scene file, the text of one (anything with a line end or "="), a dict as TOML
    would give it, or a Scene. changes: keys as in docs/scenes.md, in the units of scene files (degrees): a dict changes the keys of its
    section that it names, None removes a section, anything else is the new value.

    >>> scene("kerr", camera={"r": 8.0}, spacetime={"spin": 0.5})
    <nullscope.Scene A rotating black hole>
    """
    if isinstance(given, _core.Scene):
        made = given
    elif isinstance(given, Mapping):
        made = None
    elif isinstance(given, os.PathLike) or (isinstance(given, str) and not ("\n" in given or "=" in given)):
        made = _core.load_scene(os.fspath(given))
    elif isinstance(given, str):
        made = _core.parse_scene(given)
    else:
        raise _core.Error(f"scene: {type(given).__name__} is no scene; allowed: a name, a path, text, a dict or a Scene")
    if made is not None and not changes:
        return made
    sections = dict(given) if made is None else tomllib.loads(made.text)
    for name, change in changes.items():
        if change is None:
            sections.pop(name, None)
        elif isinstance(change, Mapping) and isinstance(sections.get(name), Mapping):
            sections[name] = {**sections[name], **change}
        else:
            sections[name] = change
    return _core.parse_scene(_text(sections), lines=False)
