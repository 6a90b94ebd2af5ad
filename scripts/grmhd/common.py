"""What the readers of GRMHD files share: messages, numbers and their ranges, HDF5 files that know what of them was used, texts of parameters."""
import dataclasses
import math
import os
import re
import sys
import time

import numpy as np

ELECTRON_INDEX, PROTON_INDEX = 4 / 3, 5 / 3    # adiabatic
RATIO = "r-high"                                # --electrons: by the plasma's beta
PACKED = 1100                                   # no filter of HDF5 makes numbers smaller than to 1/1032 (deflate)


def fail(text):
    sys.exit(f"convert_grmhd: {text}")


def said(text):
    print(f"convert_grmhd: {text}", file=sys.stderr)


class Progress:
    """A line on standard error every five seconds, of work that takes longer."""

    def __init__(self, what, count):
        self.what, self.count, self.last = what, count, time.monotonic()

    def at(self, number):
        if time.monotonic() - self.last > 5:
            said(f"{self.what}: {100 * number // max(self.count, 1)} %")
            self.last = time.monotonic()


@dataclasses.dataclass
class Flow:
    """What a reader makes of a file. Lengths in M; vectors ut^i = u^i + u^t lapse^2 g^ti and B^i = *F^it in the file's own basis, as chart has it."""
    path: str
    spin: float                       # a/M; below 0 where the hole turns westward
    gamma: float                      # the gas's adiabatic index
    chart: object                     # of charts.py: the file's coordinates
    mesh: object                      # of mesh.py: cells of density, internal energy, ut^1, 2, 3, B^1, 2, 3, and what electrons says
    electrons: str = ""               # "entropy" (p_e/rho^electron_index), "kelvin" or nothing
    electron_index: float = ELECTRON_INDEX
    proton_index: float = PROTON_INDEX
    density_unit: float = 0           # g/cm^3, where the file has it
    excised: float = 0                # M: cells whose middle is at or within this radius hold nothing
    unused: list = dataclasses.field(default_factory=list)
    notes: list = dataclasses.field(default_factory=list)
    files: list = dataclasses.field(default_factory=list)   # of which the SHA-256 is kept; path alone where empty

    @property
    def horizon(self):
        return 1 + math.sqrt(1 - self.spin ** 2)


def text_of(value):
    """What stands in a text of HDF5, however it is stored."""
    value = np.asarray(value).reshape(-1)
    word = value[0] if value.size == 1 else ""
    return (word.decode("utf-8", "replace") if isinstance(word, bytes) else str(word)).strip("\0 ")


def words_of(value):
    return [text_of(word) for word in np.asarray(value).reshape(-1)]


def in_range(path, name, value, least, most, allowed):
    if not (math.isfinite(value) and least <= value <= most):
        fail(f"{path}: {name} is {value:g}; allowed: {allowed or f'{least:g} to {most:g}'}")
    return value


SPIN = (math.nextafter(-1, 0), math.nextafter(1, 0), "between -1 and 1")
INDEX = (1 + 1e-6, 3, "above 1, up to 3")
POSITIVE = (1e-300, 1e300, "above 0")


class Hdf5:
    """Datasets "folder/name" and attributes "folder@name" ("@name" of the root) of a file, and which of them were asked for."""

    def __init__(self, path, file):
        self.path, self.file, self.used = path, file, set()
        self.size = os.path.getsize(path)
        self.names = {f"@{key}" for key in file.attrs}
        def add(name, item):
            self.names.update(f"{name}@{key}" for key in item.attrs)
            if hasattr(item, "shape"):
                self.names.add(name)
        file.visititems(add)

    def has(self, name):
        return name in self.names

    def take(self, name):
        """A dataset as it lies in the file, or an attribute's value."""
        if not self.has(name):
            fail(f"{self.path}: the file has no {name.replace('@', ' attribute ').strip()}")
        self.used.add(name)
        if "@" in name:
            folder, key = name.rsplit("@", 1)
            return self.file[folder or "/"].attrs[key]
        return self.file[name]

    def value(self, name):
        item = self.take(name)
        self.check_size(name, item)
        return item[()] if hasattr(item, "id") else item

    def check_size(self, name, item):
        if math.prod(getattr(item, "shape", None) or (1,)) * getattr(getattr(item, "dtype", None), "itemsize", 1) > PACKED * self.size:
            fail(f"{self.path}: {name} has the shape {item.shape}, more than the file can hold")

    def array(self, name, shape=None, integers=False):
        """Of numbers; shape: None for any length of a side."""
        item = self.take(name)
        dtype, sides = np.asarray(item).dtype if "@" in name else item.dtype, np.shape(item)
        if dtype.kind not in ("iu" if integers else "fiu"):
            fail(f"{self.path}: {name.replace('@', ' attribute ').strip()} is no dataset of numbers ({dtype})")
        if shape is not None and (len(sides) != len(shape) or any(want not in (None, side) for want, side in zip(shape, sides))):
            want = ", ".join("any" if side is None else str(side) for side in shape)
            fail(f"{self.path}: {name.replace('@', ' attribute ').strip()} has the shape {tuple(map(int, sides))}; allowed: ({want})")
        self.check_size(name, item)
        return np.asarray(item[()] if "@" not in name else item)

    def number(self, name, least=-math.inf, most=math.inf, allowed=None):
        value, shown = np.asarray(self.value(name)), name.replace("@", " attribute ").strip()
        if value.size != 1 or value.dtype.kind not in "fiub":
            fail(f"{self.path}: {shown} is no single number (shape {value.shape}, {value.dtype}); allowed: one number")
        return in_range(self.path, shown, float(value.reshape(-1)[0]), least, most, allowed)

    def text(self, name):
        return text_of(self.value(name))

    def unused(self):
        """Their names; where one group has many attributes, their number."""
        names, groups = [], {}
        for name in sorted(self.names - self.used):
            groups.setdefault(name.rsplit("@", 1)[0] if "@" in name else None, []).append(name)
        for group, members in sorted(groups.items(), key=lambda pair: pair[0] or ""):
            if group and len(members) > 6:
                names.append(f"{len(members)} attributes of {group}")
            else:
                names += [f"attribute {name.replace('@', '/').lstrip('/')}" if "@" in name else name for name in members]
        return names


class Parameters:
    """The text of parameters that Athena's descendants keep: <block>, key = value, # comment, a last & continues the line."""

    def __init__(self, path, text, where):
        self.path, self.where, self.blocks, block = path, where, {}, None
        for line in re.sub(r"&[ \t]*(#[^\n]*)?\n", " ", text).splitlines():
            line = line.split("#", 1)[0].strip()
            head = re.fullmatch(r"<(.+)>", line)
            if head:
                block = self.blocks.setdefault(head[1].strip(), {})
            elif "=" in line and block is not None:
                key, value = line.split("=", 1)
                block[key.strip()] = value.strip()

    def has(self, block, key=None):
        return block in self.blocks and (key is None or key in self.blocks[block])

    def word(self, block, key, usual=None):
        if not self.has(block, key):
            if usual is None:
                fail(f"{self.path}: {self.where} has no {key} in <{block}>")
            return usual
        return self.blocks[block][key]

    def number(self, block, key, least=-math.inf, most=math.inf, allowed=None, usual=None):
        word = self.word(block, key, usual)
        try:
            value = float(word)
        except ValueError:
            fail(f"{self.path}: {self.where}: {key} in <{block}> is {str(word)[:40]!r}; allowed: a number")
        return in_range(self.path, f"{self.where}: {key} in <{block}>", value, least, most, allowed)

    def flag(self, block, key, usual=False):
        return self.word(block, key, str(usual)).lower() in ("true", "1", "yes", "on")


def asked(path, wanted, option, what, held=None):
    """The number that the file has, else that of the option; exactly one of the two."""
    given = getattr(wanted, option)
    name = "--" + option.replace("_", "-")
    if held is None and given is None:
        fail(f"{path}: the file does not hold {what}; needed: {name}")
    if held is not None and given is not None:
        fail(f"{path}: the file holds {what}, {held:g}; {name} is for files that do not")
    return held if given is None else given


def chosen_electrons(path, wanted, names):
    """Of the electrons' numbers in a file the one to be used, or "" where their temperature follows from beta."""
    choice = wanted.electrons
    if choice == RATIO or choice is None and not names:
        return ""
    if choice is None and len(names) > 1:
        fail(f"{path}: the file holds several numbers of electrons; needed: --electrons {', '.join(names)} or {RATIO}")
    if choice is not None and choice not in names:
        fail(f"{path}: the file holds no electrons {choice}; allowed: --electrons {', '.join(names + [RATIO])}")
    return choice or names[0]
