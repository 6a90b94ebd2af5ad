"""A screen of its own (Xvfb) whose pixels can be read, hands (xdotool), and PNG files: standard library only."""
import ctypes
import mmap
import os
import shutil
import struct
import subprocess
import tempfile
import time
import zlib
from pathlib import Path


def wait_until(what, condition, timeout_s=600.0, every_s=0.03):
    """The first true value of condition(); AssertionError with `what` if there is none in time."""
    end = time.monotonic() + timeout_s
    while True:
        value = condition()
        if value:
            return value
        assert time.monotonic() < end, f"waited {timeout_s:.0f} s in vain: {what}"
        time.sleep(every_s)


def missing_tools():
    """Says which programs a screen needs that are not installed; nothing is printed and False returned if all are."""
    missing = [tool for tool in ("Xvfb", "xdotool") if shutil.which(tool) is None]
    if missing:
        print(f"skipped: {' and '.join(missing)} not installed")
    return bool(missing)


class Picture:
    """8-bit RGB rows from the top."""

    def __init__(self, width, height, data):
        self.width, self.height, self.data = width, height, data

    def crop(self, left, top, right, bottom):
        rows = [self.data[3 * (y * self.width + left):3 * (y * self.width + right)] for y in range(top, bottom)]
        return Picture(right - left, bottom - top, b"".join(rows))

    def differing(self, other, tolerance=2, enough=1.0):
        """Share of the bytes that differ by more than tolerance; counted no further than to more than `enough`."""
        assert (self.width, self.height) == (other.width, other.height), "pictures of different size"
        count, stride = 0, 3 * self.width
        for at in range(0, len(self.data), stride):
            one, two = self.data[at:at + stride], other.data[at:at + stride]
            if one != two:     # most rows of most pairs are the same
                count += sum(abs(a - b) > tolerance for a, b in zip(one, two))
                if count > enough * len(self.data):
                    break
        return count / len(self.data)

    def changed(self, other, share):
        """Whether more than that share of the bytes differs."""
        return self.differing(other, enough=share) > share

    def grey(self, x, y):
        at = 3 * (y * self.width + x)
        return sum(self.data[at:at + 3])

    def mean(self):
        return sum(self.data) / len(self.data)


def read_png(path):
    """8-bit RGB or RGBA, not interlaced."""
    raw = Path(path).read_bytes()
    assert raw[:8] == b"\x89PNG\r\n\x1a\n", f"{path} is no PNG"
    at, packed = 8, b""
    while at < len(raw):
        size, kind = struct.unpack(">I4s", raw[at:at + 8])
        chunk = raw[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, depth, colour, _, _, interlace = struct.unpack(">IIBBBBB", chunk)
            assert depth == 8 and colour in (2, 6) and interlace == 0, f"{path}: an unexpected kind of PNG"
        elif kind == b"IDAT":
            packed += chunk
        at += 12 + size
    step = 3 if colour == 2 else 4
    data, stride, before = zlib.decompress(packed), width * step, bytearray(width * step)
    out = bytearray()
    for y in range(height):
        kind, row = data[y * (stride + 1)], bytearray(data[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        unfilter(kind, row, before, step)
        before = row
        out += row if step == 3 else bytes(value for i, value in enumerate(row) if i % 4 != 3)
    return Picture(width, height, bytes(out))


def unfilter(kind, row, before, step):
    for i in range(len(row)):
        left = row[i - step] if i >= step else 0
        corner = before[i - step] if i >= step else 0
        if kind == 1:
            row[i] = (row[i] + left) & 255
        elif kind == 2:
            row[i] = (row[i] + before[i]) & 255
        elif kind == 3:
            row[i] = (row[i] + (left + before[i]) // 2) & 255
        elif kind == 4:
            guess = left + before[i] - corner
            a, b, c = abs(guess - left), abs(guess - before[i]), abs(guess - corner)
            row[i] = (row[i] + (left if a <= b and a <= c else before[i] if b <= c else corner)) & 255


class Screen:
    """An Xvfb on a free display; its framebuffer is a file in XWD format."""

    def __init__(self, width, height):
        self.folder = tempfile.mkdtemp(prefix="nullscope-screen.")
        read_end, write_end = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write_end), "-screen", "0", f"{width}x{height}x24", "-fbdir", self.folder,
             # -noreset: a reset, when the last program leaves, turns away the next that comes. -r: a key that is down for long, as on a
             # slow machine, does not repeat itself.
             "-nolisten", "tcp", "-noreset", "-r"],
            pass_fds=[write_end], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write_end)
        with os.fdopen(read_end) as pipe:
            number = pipe.readline().strip()   # comes when the server is ready
        assert number, "Xvfb did not start"
        self.display = f":{number}"
        self.file = open(Path(self.folder) / "Xvfb_screen0", "rb")
        self.memory = mmap.mmap(self.file.fileno(), 0, prot=mmap.PROT_READ)

    def close(self):
        self.memory.close()
        self.file.close()
        self.server.terminate()
        self.server.wait()
        shutil.rmtree(self.folder, ignore_errors=True)

    def picture(self, left, top, right, bottom):
        header = struct.unpack(">25I", self.memory[:100])
        header_size, bits, stride, colours = header[0], header[11], header[12], header[19]
        little = header[7] == 0
        assert bits == 32, "a screen of 24 bits a pixel is stored in 32"
        start, rows = header_size + 12 * colours, []
        for y in range(top, bottom):
            row = self.memory[start + y * stride + 4 * left:start + y * stride + 4 * right]
            rgb = bytearray(3 * (right - left))
            for channel in range(3):
                rgb[channel::3] = row[(2 - channel if little else 1 + channel)::4]
            rows.append(bytes(rgb))
        return Picture(right - left, bottom - top, b"".join(rows))

    def hands(self, *words):
        """xdotool; returns what it prints."""
        return subprocess.run(["xdotool", *map(str, words)], env={**os.environ, "DISPLAY": self.display}, check=True,
                              stdout=subprocess.PIPE, text=True, timeout=600).stdout


class WindowCloser:
    """Closes windows as a window manager's button does, by WM_DELETE_WINDOW; xdotool of 2016 cannot."""

    class Message(ctypes.Structure):   # XClientMessageEvent, within the size of an XEvent
        _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("send_event", ctypes.c_int),
                    ("display", ctypes.c_void_p), ("window", ctypes.c_ulong), ("message_type", ctypes.c_ulong),
                    ("format", ctypes.c_int), ("data", ctypes.c_long * 5), ("padding", ctypes.c_long * 12)]

    def __init__(self, display):
        self.x11 = ctypes.CDLL("libX11.so.6")
        self.x11.XOpenDisplay.restype = self.x11.XInternAtom.restype = ctypes.c_void_p
        self.display = ctypes.c_void_p(self.x11.XOpenDisplay(display.encode()))
        assert self.display, f"nothing answers at {display}"

    def atom(self, name):
        return self.x11.XInternAtom(self.display, name.encode(), 0)

    def close(self, window):
        client_message, format_of_longs = 33, 32
        message = self.Message(type=client_message, window=window, message_type=self.atom("WM_PROTOCOLS"),
                               format=format_of_longs)
        message.data[0] = self.atom("WM_DELETE_WINDOW")
        self.x11.XSendEvent(self.display, ctypes.c_ulong(window), 0, ctypes.c_long(0), ctypes.byref(message))
        self.x11.XSync(self.display, 0)

    def leave(self):
        self.x11.XCloseDisplay(self.display)
