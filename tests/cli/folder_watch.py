"""Which names appear in a folder, and how often (inotify)."""
import collections
import ctypes
import os
import struct

IN_MOVED_TO, IN_CREATE = 0x80, 0x100
HEADER = struct.Struct("iIII")


class FolderWatch:
    """With `with`. moved_to and created: how often each name came by a rename, and by itself; read() brings them up to date."""

    def __init__(self, folder):
        libc = ctypes.CDLL(None, use_errno=True)
        self.descriptor = libc.inotify_init1(os.O_NONBLOCK | os.O_CLOEXEC)
        if self.descriptor < 0 or libc.inotify_add_watch(self.descriptor, os.fsencode(folder), IN_MOVED_TO | IN_CREATE) < 0:
            raise OSError(ctypes.get_errno(), "inotify")
        self.moved_to, self.created = collections.Counter(), collections.Counter()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        os.close(self.descriptor)

    def read(self):
        while True:
            try:
                data = os.read(self.descriptor, 1 << 16)
            except BlockingIOError:
                return
            at = 0
            while at < len(data):
                _, mask, _, length = HEADER.unpack_from(data, at)
                at += HEADER.size
                name = os.fsdecode(data[at:at + length].rstrip(b"\0"))
                at += length
                if not name:
                    raise OSError("inotify: events were lost")
                (self.moved_to if mask & IN_MOVED_TO else self.created)[name] += 1
