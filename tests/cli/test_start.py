"""What it costs to start and to write the first picture: processor time, page faults, resident memory.

The promise is one second of wall time on two quiet cores, with a software driver and without its shader cache: docs/command-line.md has
measured times, measure_start.py measures. No clock can be bounded where others use the machine as well, so these are held:
- page faults and memory, which are counts;
- processor time of sky-only less what its pages cost on this machine at that moment, divided by the slowness (tests/machine.py): 0.65 to
  0.81 s measured with the pages where they are cheap, 0.75 to 1.2 s without them where they take 0.3 to 1 s; 0.8 to 1.2 s more while skies
  were built as floats;
- that of other scenes as a multiple of sky-only's, which the same driver compiles and draws in the same minute.
A bound lies so far from what is measured that a breach exceeds it by twice that. The least of up to six runs counts: whoever else
runs only adds.
"""
import os
import resource
import subprocess
import unittest

from support import BINARY, QUICK, CliTest
from machine import pages_s, slowness  # after support, which finds it

SIZE = "1280x720"
RUNS = 6
MOST_CPU_S = 1.2                # of sky-only, without its pages
# Of sky-only's time. Measured: 1.17 to 1.43, 1.77 to 1.96, 1.99 to 2.14; kerr-planet, whose shader holds bodies too, 4.6.
MOST_OVER_SKY = {"first-light": 1.8, "accretion": 2.4, "kerr": 2.6}
MOST_FAULTS = 90_000            # of 4 KiB pages: those of the driver's sky are 34 000; they were 224 000
MOST_RESIDENT_KB = 300 * 1024   # of sky-only; it was 567 MB


def cost(folder, scene):
    """(processor seconds, page faults, resident kB) of one capture."""
    picture = os.path.join(folder, "start.png")
    child = subprocess.Popen([BINARY, "capture", scene, "--size", SIZE, "-o", picture], cwd=folder, stdout=subprocess.DEVNULL,
                             env={**os.environ, "MESA_SHADER_CACHE_DISABLE": "true"})
    _, status, used = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0 or not os.path.exists(picture):
        raise AssertionError(f"capture {scene} ended with status {child.returncode}")
    os.remove(picture)
    return used.ru_utime + used.ru_stime, used.ru_minflt, used.ru_maxrss


class Start(CliTest):
    def check_faults(self, scene, faults):
        if resource.getpagesize() == 4096:
            self.assertLessEqual(faults, MOST_FAULTS, scene)

    def test_sky_only(self):
        runs = []
        while not runs or (len(runs) < RUNS and seconds > MOST_CPU_S):
            slow = slowness()
            used, faults, resident = cost(self.folder, "sky-only")
            pages = min(pages_s(faults) for _ in range(2))   # the lesser: what is taken off must not be too much
            runs.append((2 * (used - pages) / (slow + slowness()), faults, resident))
            print(f"sky-only: {used:.2f} s of processor time, its pages {pages:.2f} s, slowness {slow:.2f}")
            seconds, faults, resident = (min(values) for values in zip(*runs))
        print(f"sky-only: {seconds:.2f} s without pages, divided by the slowness; {faults} page faults, {resident / 1024:.0f} MB")
        self.assertLessEqual(seconds, MOST_CPU_S)
        self.check_faults("sky-only", faults)
        self.assertLessEqual(resident, MOST_RESIDENT_KB)

    def over_sky(self, scene, most, runs=RUNS):
        """Its processor time over sky-only's, run after run until it is at most that, and its page faults."""
        ratios = []
        while not ratios or (len(ratios) < runs and min(ratios) > most):
            (sky, *_), (used, faults, _) = cost(self.folder, "sky-only"), cost(self.folder, scene)
            ratios.append(used / sky)
        print(f"{scene}: {min(ratios):.2f} times sky-only's processor time, {faults} page faults")
        return min(ratios), faults

    def test_other_scenes(self):
        for scene, most in MOST_OVER_SKY.items():
            ratio, faults = self.over_sky(scene, most)
            self.assertLessEqual(ratio, most, scene)
            self.check_faults(scene, faults)

    @unittest.skipIf(QUICK, "that the check can fail: with --all")
    def test_a_shader_that_holds_more_is_seen(self):
        most = MOST_OVER_SKY["kerr"]
        self.assertGreater(self.over_sky("kerr-planet", most, runs=1)[0], most)


if __name__ == "__main__":
    unittest.main()
