"""How slow this machine is now, so that a bound on processor time means the same on every machine and at every hour.

The same work takes up to twice the processor time on another machine, or while others use the same cores. slowness() times a fixed
piece of work (zlib; no code of this project) on all cores at once. It is 1 on the machine on which the bounds were set, 2 where that
work takes twice the processor time, and never below 1: a bound is never less than what it says. It takes some 0.2 s.
"""
import mmap
import os
import threading
import time
import zlib
from pathlib import Path

# Processor time of one core's part on the machine on which the bounds were set, where the first picture of kerr took 1.15 s (docs/
# command-line.md). In proportion: where it took 1.95 s, the part took 0.145 s.
REFERENCE_S = 0.085


def _work(data):
    for _ in range(12):
        zlib.compress(data, 6)


def slowness():
    data = "".join(f"{i * 2654435761 % 2 ** 32:08x}" for i in range(40000)).encode()
    cores = len(os.sched_getaffinity(0))
    before = time.process_time()
    threads = [threading.Thread(target=_work, args=(data,)) for _ in range(cores)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return max(1.0, (time.process_time() - before) / cores / REFERENCE_S)


def pages_s(pages):
    """What `pages` of memory that nobody has touched yet cost a process here, processor seconds: 0.1 to 0.5 us each on a real machine, up to
    15 us on a virtual one whose host has to find the memory, and three times that from one minute to the next. slowness() knows nothing of it."""
    before = time.process_time()
    memory = mmap.mmap(-1, pages * mmap.PAGESIZE)
    memory[::mmap.PAGESIZE] = bytes(pages)
    memory.close()
    return time.process_time() - before


def spent_s(process_id):
    """Processor time, user and system, of a process that runs, s; it comes in ticks of a hundredth."""
    fields = Path(f"/proc/{process_id}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def spent_with_children_s(process_id):
    """The same of a process and of all that run because of it, whose parents it is or they are; and of those of them that have ended, s."""
    parents, times = {}, {}
    for folder in Path("/proc").glob("[0-9]*"):
        try:
            fields = (folder / "stat").read_text().rsplit(")", 1)[1].split()
        except OSError:   # it has ended since
            continue
        parents[int(folder.name)] = int(fields[1])
        times[int(folder.name)] = sum(map(int, fields[11:15]))
    family = {process_id}
    while more := {child for child, parent in parents.items() if parent in family} - family:
        family |= more
    return sum(times.get(one, 0) for one in family) / os.sysconf("SC_CLK_TCK")


if __name__ == "__main__":
    print(f"{slowness():.2f}")
