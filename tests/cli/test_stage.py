#!/usr/bin/env python3
"""Pictures and rays by compute shaders: the same files, and where OpenGL is too old fragments and one line that says so."""
import json

import support
from image_bytes import png_chunks
from test_pictures import png_texts

SIZE = ("--size", "48x27")
OLD = {"MESA_GL_VERSION_OVERRIDE": "3.3", "MESA_GLSL_VERSION_OVERRIDE": "330"}   # what Mesa then says it is
FALLS_BACK = "fragment shaders draw in the place of compute shaders: this OpenGL is older than 4.3"
RAYS = "r,theta,phi,n_r,n_theta,n_phi\n10,1.2,0.3,-0.9,0.1,0.4\n10,1.2,0.3,-1,0,0\n10,1.2,0.3,-0.96,0.2,0.15\n"


def pixels(data):
    return [body for kind, body in png_chunks(data) if kind == b"IDAT"]


class Stage(support.CliTest):
    def capture(self, file, *options, environment=None):
        ran = self.run_nullscope("capture", "kerr", *SIZE, "-o", file, *options, environment=environment)
        self.assertEqual(ran.status, 0, ran)
        return ran, (self.folder / file).read_bytes()

    def test_the_same_picture_that_says_its_stage(self):
        _, by_fragments = self.capture("f.png")
        ran, by_compute = self.capture("c.png", "--stage", "compute")
        self.assertEqual(ran.said(), "")
        self.assertEqual(pixels(by_fragments), pixels(by_compute))
        self.assertNotIn("--stage", png_texts(by_fragments)["nullscope.options"])
        self.assertIn("--stage compute", png_texts(by_compute)["nullscope.options"])
        self.assertTrue(png_texts(by_compute)["nullscope.renderer"].endswith(", compute"))
        again = self.run_nullscope("capture", "c.png", "-o", "again.png")
        self.assertIn(", compute", again.out, again)
        self.assertEqual(pixels(by_compute), pixels((self.folder / "again.png").read_bytes()))

    def test_an_older_opengl_draws_by_fragments_and_says_so_once(self):
        _, whole = self.capture("f.png")
        ran, old = self.capture("o.png", "--stage", "compute", environment=OLD)
        self.assertEqual(ran.said(), FALLS_BACK + "\n")
        self.assertEqual(pixels(whole), pixels(old))
        self.assertNotIn("compute", png_texts(old)["nullscope.renderer"])
        plan = self.run_nullscope("plan", "sky-only", "--set", "camera.size=[48,27]", "--measure", "--frames", "3", "--json", environment=OLD)
        self.assertEqual(json.loads(plan.out)["stage"],
                         {"name": "fragment", "reason": "this OpenGL is older than 4.3", "measured": []}, plan)

    def test_plan_says_which_draws_for_less(self):
        unmeasured = json.loads(self.run_nullscope("plan", "sky-only", "--json").out)
        self.assertEqual(unmeasured["stage"]["name"], "fragment")
        self.assertLess(unmeasured["shader"]["compute_bytes"] - unmeasured["shader"]["bytes"], 3000)
        ran = self.run_nullscope("plan", "sky-only", "--set", "camera.size=[48,27]", "--measure", "--frames", "3", "--json")
        stage = json.loads(ran.out)["stage"]
        self.assertRegex(stage["reason"], r"^[\d.]+ ms a frame by fragments, [\d.]+ by compute \(", ran)
        fragment, compute = (float(word) for word in stage["reason"].replace(",", "").split()[0::6][:2])
        self.assertEqual(stage["name"], "compute" if compute < fragment else "fragment", stage)
        remembered = json.loads(self.run_nullscope("plan", "sky-only", "--json").out)["stage"]["measured"]
        self.assertEqual(len(remembered), 1, remembered)
        self.assertTrue(remembered[0].startswith(stage["name"] + ": " + stage["reason"].split(" (")[0]), remembered)
        self.assertEqual(json.loads(self.run_nullscope("plan", "kerr", "--json").out)["stage"]["measured"], [])
        self.assertIn("\n  measured           " + remembered[0], self.run_nullscope("plan", "sky-only").out)

    def test_lists_of_rays_are_the_same(self):
        self.write("rays.csv", RAYS)
        traced = [self.run_nullscope("trace", "kerr", "--rays", "rays.csv", "--with", "gl", "--crossings", "2", "--stage", stage)
                  for stage in ("fragment", "compute")]
        self.assertEqual(traced[0].status, 0, traced[0])
        self.assertEqual(len(traced[0].out.splitlines()), 4)
        self.assertEqual(traced[0].out, traced[1].out)
        old = self.run_nullscope("trace", "kerr", "--rays", "rays.csv", "--with", "gl", "--crossings", "2", "--stage", "compute", environment=OLD)
        self.assertEqual((old.out, old.said()), (traced[0].out, FALLS_BACK + "\n"))

    def test_what_draws_no_shader_has_no_stage(self):
        self.write("rays.csv", RAYS)
        self.refused("capture", "kerr", *SIZE, "-o", "r.png", "--renderer", "reference", "--stage", "compute", says=["--stage"])
        self.refused("trace", "kerr", "--rays", "rays.csv", "--stage", "compute", says=["--stage", "--with gl"])


if __name__ == "__main__":
    support.main()
