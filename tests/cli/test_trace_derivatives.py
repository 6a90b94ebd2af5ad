#!/usr/bin/env python3
"""nullscope trace --derivatives: as differences of what it prints itself, rays that are marked, and what it refuses."""
import csv
import io
import math

import support

HOLE = '[spacetime]\nmetric = "kerr-newman"\nspin = {spin}\ncharge = 0.5\n[disc]\nopacity = 0.5\ntilt = 20.0\n'
FORMULA = '[spacetime]\nmetric = "formula"\nA = "1 - 1/r - 0.1/r^3"\n'
HEADER = "r,theta,phi,n_r,n_theta,n_phi"
RAYS = [(15.0, 1.4, 0.2, -1.0, 0.25, 0.1), (6.0, 0.9, -2.0, -1.0, 0.1, -0.8), (3.0, 1.7, 1.0, 0.2, 0.9, 0.4), (9.0, 1.2, 0.0, -1.0, 0.03, 0.02)]
STEP = 4e-4
BOUND = 2e-9          # of differences of order 4 with this step, of the derivative or 1
VALUES = ("x", "y", "z", "g", "delay", "r_1", "phi_1")


def numbers(row):
    """What the derivatives are of; None where there is none."""
    at = {name: float(row[name]) if row[name] else None for name in ("theta_inf", "phi_inf", "g", "delay", "r_1", "phi_1")}
    theta, phi = at["theta_inf"], at["phi_inf"]
    sky = (None,) * 3 if theta is None else (math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi), math.cos(theta))
    return dict(zip(VALUES, (*sky, at["g"], at["delay"], at["r_1"], at["phi_1"])))


class Derivatives(support.CliTest):
    def trace(self, scene, rays, *options, header=HEADER):
        self.write("rays.csv", "\n".join([header, *(",".join(map(repr, ray)) for ray in rays)]) + "\n")
        ran = self.run_nullscope("trace", self.write("scene.toml", scene), "--rays", "rays.csv", "--crossings", "1", *options)
        return list(csv.DictReader(io.StringIO(ran.out)))

    def differences(self, at):
        """By steps of STEP and twice that: of order 4. at: what trace prints where the parameter is so much more."""
        rows = [[numbers(row) for row in at(k * STEP)] for k in (-2, -1, 1, 2)]
        for far_down, down, up, far_up in zip(*rows):
            yield {name: None if up[name] is None else (8 * (up[name] - down[name]) - (far_up[name] - far_down[name])) / (12 * STEP) for name in VALUES}

    def compare(self, name, rows, expected):
        for row, slopes in zip(rows, expected):
            self.assertEqual(row["derivatives"], "yes")
            for value, slope in slopes.items():
                text = row[f"d_{name}.{value}"]
                self.assertEqual(text == "", slope is None, (name, value))
                if slope is not None:
                    self.assertLess(abs(float(text) - slope), BOUND * max(1, abs(slope)), (name, value, text, slope))

    def test_as_differences(self):
        def moved(column):
            return lambda by: [ray[:column] + (ray[column] + by,) + ray[column + 1:] for ray in RAYS]
        for scene in (HOLE.format(spin=0.7), FORMULA):
            rows = self.trace(scene, RAYS, "--derivatives", "camera.r,camera.theta,camera.phi")
            for column, name in enumerate(("camera.r", "camera.theta", "camera.phi")):
                self.compare(name, rows, self.differences(lambda by, rays=moved(column): self.trace(scene, rays(by))))
        rows = self.trace(HOLE.format(spin=0.7), RAYS, "--derivatives", "spin")
        self.compare("spin", rows, self.differences(lambda by: self.trace(HOLE.format(spin=0.7 + by), RAYS)))

    def test_yaw_is_what_turns_the_view(self):
        """Of a camera that is not turned yaw moves what is ahead to the right, pitch up: n_phi and -n_theta."""
        ray = (15.0, 1.4, 0.2, -1.0, 0.0, 0.3)
        row, = self.trace(FORMULA, [ray], "--derivatives", "camera.yaw")
        size = math.hypot(1.0, 0.3)
        turn = math.atan2(0.3, 1.0)
        expected = self.differences(lambda by: self.trace(FORMULA, [ray[:3] + (-size * math.cos(turn + by), 0.0, size * math.sin(turn + by))]))
        self.compare("camera.yaw", [row], expected)

    def test_marks(self):
        """Next to the critical curve, and to the disc's rim, of 0.1 px of the scene's camera; a body in the way leaves no sky."""
        critical = math.asin(math.sqrt(27) / 2 * math.sqrt(1 - 1 / 15) / 15)
        scene = '[spacetime]\nmetric = "schwarzschild"\n[camera]\nfov = 60.0\nsize = [1000, 1000]\n'
        pixel = math.radians(60) / 1000
        for off, word in ((0.02, "edge"), (-0.02, "edge"), (1, "yes"), (-1, "yes")):
            alpha = critical + off * pixel
            row, = self.trace(scene, [(15.0, 1.3, 0.0, -math.cos(alpha), math.sin(alpha), 0.0)], "--derivatives", "camera.theta")
            self.assertEqual(row["derivatives"], word, off)
            self.assertEqual(row["fate"], "escaped" if off > 0 else "captured")
            self.assertEqual(row["d_camera.theta.x"] == "", off < 0)
        row, = self.trace(scene, RAYS[:1])
        for off, word in ((1e-5, "edge"), (1, "yes")):
            rim = f'{scene}[disc]\nopacity = 0.5\ninner = 3.0\nouter = {float(row["r_1"]) + off!r}\n'
            self.assertEqual(self.trace(rim, RAYS[:1], "--derivatives", "camera.theta")[0]["derivatives"], word)
        opaque, = self.trace(scene + "[disc]\ninner = 1.5\nouter = 20.0\n", RAYS[:1], "--derivatives", "camera.r")
        self.assertEqual((opaque["fate"], opaque["d_camera.r.x"], opaque["derivatives"]), ("hit:disc", "", "yes"))
        self.assertNotEqual(opaque["d_camera.r.r_1"], "")

    def test_redshift_of_the_matter(self):
        """Of a thermal disc each crossing has its g too. Rays that go on: the reference's own g is known to 1e-12."""
        scene = HOLE.replace("[disc]", '[disc]\nemission = "thermal"')
        row, = self.trace(scene.format(spin=0.7), RAYS[:1], "--derivatives", "spin,camera.theta")
        by_spin = [float(self.trace(scene.format(spin=0.7 + k * STEP), RAYS[:1])[0]["g_1"]) for k in (-2, -1, 1, 2)]
        theta = RAYS[0][1]
        by_theta = [float(self.trace(scene.format(spin=0.7), [(RAYS[0][0], theta + k * STEP) + RAYS[0][2:]])[0]["g_1"]) for k in (-2, -1, 1, 2)]
        for name, (far_down, down, up, far_up) in (("spin", by_spin), ("camera.theta", by_theta)):
            self.assertAlmostEqual(float(row[f"d_{name}.g_1"]), (8 * (up - down) - (far_up - far_down)) / (12 * STEP), delta=3e-8)

    def test_refused(self):
        hole = self.write("scene.toml", HOLE.format(spin=0.7))
        self.write("rays.csv", HEADER + "\n" + ",".join(map(repr, RAYS[0])) + "\n")
        for options, words in ((("--derivatives", "spni"), 'no derivatives by "spni" of this scene; allowed: spacetime.spin, spacetime.charge, camera.r'),
                               (("--derivatives", "spin,spacetime.spin"), "twice"),
                               (("--derivatives", "camera.r,"), 'by ""'),
                               (("--derivatives", "spin", "--with", "core64"), "not with --with core64; allowed: --with reference"),
                               (("--derivatives", "spin", "--points", "9"), "not of curves; allowed: without --points")):
            self.refused("trace", hole, "--rays", "rays.csv", *options, says=[words])
        wormhole = self.write("wormhole.toml", '[spacetime]\nmetric = "ellis"\n')
        self.refused("trace", wormhole, "--rays", "rays.csv", "--derivatives", "camera.r", says=["no derivatives in metric ellis; allowed: schwarzschild"])
        self.write("rays.csv", "q,zeta0,s\n0.4,0.1,1\n")
        says = ["rays.csv:2: no derivatives of a ray given by q, zeta0, s"]
        self.refused("trace", "sky-only", "--rays", "rays.csv", "--derivatives", "camera.r", says=says)


if __name__ == "__main__":
    support.main()
