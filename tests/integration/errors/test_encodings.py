"""Text in any encoding: what is wrong in a file arrives with its line, and a byte order mark is no part of the text."""

import os
import unittest

from programs import ProgramTest, coupler

PARTICLES = """
material: {young_modulus: 30 GPa, poisson_ratio: 0.2, density: 2500 kg/m^3}
time: {duration: 1 ms}
particles:
  placed: {path: discs.csv}
"""
SHAKEN = """
material: {young_modulus: 1 GPa, poisson_ratio: 0.2, density: 2000 kg/m^3}
time: {duration: 50 ms}
continuum:
  block: {x_min: 0 m, x_max: 4 m, y_min: 0 m, y_max: 4 m, zones_x: 4, zones_y: 4}
  base: {where: {y_max: 0 m}, acceleration: {file: {path: record.csv}}}
"""
DISCS = "x_m,y_m,radius_m\n0,0,1\n2,0,1\n4,0,1\n"
RECORD = "time_s,acceleration_m/s^2\n" + "".join(f"{i / 100},{(-1) ** i}\n" for i in range(20))
MARK = b"\xef\xbb\xbf"


class Encodings(ProgramTest):
    def ends(self, code, scene, table, content):
        """The standard error of `coupler check` of a scene beside a table."""
        (self.folder / table).write_bytes(content)
        result = coupler("check", self.scene(scene) if isinstance(scene, str) else self.bytes(scene))
        self.assertEqual(result.returncode, code, result.stderr)
        return result.stderr

    def bytes(self, content, name="scene.yaml"):
        path = self.folder / name
        path.write_bytes(content)
        return path

    def test_a_line_that_is_wrong_is_named_in_any_encoding(self):
        message = self.ends(2, PARTICLES, "discs.csv", DISCS.encode() + "6,0,groß\n".encode("latin-1"))
        self.assertIn("scene.yaml:5:12: particles.placed.path: line 5: `gro\ufffd` is not a number", message)
        message = self.ends(2, SHAKEN, "record.csv", RECORD.encode() + "0.2,größer\n".encode("latin-1"))
        self.assertIn("record.csv:22: `gr\ufffd\ufffder` is not a number", message)
        message = self.ends(2, SHAKEN, "record.csv", ("größe" * 30 + "," + RECORD).encode())
        self.assertIn("record.csv:1: `größegröße", message)
        for scene, table, text in ((PARTICLES, "discs.csv", DISCS), (SHAKEN, "record.csv", RECORD)):
            message = self.ends(2, scene, table, text.encode("utf-16"))
            self.assertIn("is text in UTF-16; save it as UTF-8", message)
            self.assert_one_line(message)

    def test_a_byte_order_mark_is_no_part_of_the_text(self):
        self.ends(0, PARTICLES, "discs.csv", MARK + DISCS.encode())
        self.ends(0, SHAKEN, "record.csv", MARK + RECORD.encode())
        self.ends(0, MARK + PARTICLES.encode(), "discs.csv", DISCS.encode())

    def test_names_in_latin_1_are_shown_with_a_replacement(self):
        (self.folder / "discs.csv").write_text(DISCS)
        folder = os.path.join(os.fsencode(self.folder), "Stra\xdfe".encode("latin-1"))
        os.mkdir(folder)
        scene = os.path.join(folder, b"scene.yaml")
        named = PARTICLES.replace("discs.csv", "../discs.csv").encode() + "name: M\xe4rz\n".encode("latin-1")
        with open(scene, "wb") as file:
            file.write(named)
        result = coupler("run", os.fsdecode(scene), "--out", self.folder / "run")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertTrue(self.summary(self.folder / "run")["completed"])
        with open(scene, "ab") as file:
            file.write(b"material: 1\n")
        result = coupler("run", os.fsdecode(scene), "--out", self.folder / "run")
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertIn("Stra\ufffde/scene.yaml:7:1:", result.stderr)


if __name__ == "__main__":
    unittest.main()
