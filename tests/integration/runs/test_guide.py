"""The README and the user guide can be followed: every scene is computed, every command does what the page states, every
place that a page names exists."""

import os
import pathlib
import re
import shutil
import socket
import subprocess
import tempfile
import unittest

import guide
from programs import BUILD, SOURCE, coupler

PATIENCE_S = 250
GUIDE = (SOURCE / "docs" / "user_guide.md").read_text()
PAGES = [SOURCE / "README.md", SOURCE / "CONTRIBUTING.md", SOURCE / "CHANGELOG.md", SOURCE / "SECURITY.md",
         *sorted((SOURCE / "docs").glob("*.md")), *sorted((SOURCE / "cases").glob("*/README.md"))]


def free_port():
    with socket.create_server(("127.0.0.1", 0)) as listener:
        return listener.getsockname()[1]


class UserGuide(unittest.TestCase):
    """The chapters in turn: each may use the results of those before."""

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix="adit_")) / "guide"
        cls.folder.mkdir()
        cls.addClassCleanup(shutil.rmtree, cls.folder.parent)
        for name, content in guide.files(GUIDE).items():
            (cls.folder / name).write_text(content)
        programs = ":".join(str(BUILD / name) for name in ("coupler", "fdm_server", "dem_server", "simplified"))
        cls.environment = {**os.environ, "PATH": f"{programs}:{os.environ['PATH']}", "ADIT": str(SOURCE)}

    def follow(self, step):
        commands = step.commands.replace("4712", str(free_port()))
        done = subprocess.run(["bash", "-e", "-c", f"trap 'kill $(jobs -p) 2>/dev/null || true' EXIT\n{commands}"],
                              cwd=self.folder, env=self.environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, timeout=PATIENCE_S)
        self.assertEqual(done.returncode, 0, f"{step.commands}\n{done.stdout}")
        for stated in step.stated.splitlines():
            self.assertTrue(any(guide.agrees(stated, line) for line in re.split("[\r\n]", done.stdout)),
                            f"{step.commands}\nthe page states: {stated}\nprinted:\n{done.stdout}")

    def test_every_scene_is_computed_by_a_chapter(self):
        typed = " ".join(step.commands for steps in guide.chapters(GUIDE).values() for step in steps).split()
        self.assertEqual([name for name in guide.files(GUIDE) if name not in typed], [])


def add_chapters():
    """A test for each chapter, in the order of the guide."""
    for number, (title, steps) in enumerate(guide.chapters(GUIDE).items(), start=1):
        def test(self, steps=steps):
            for step in steps:
                with self.subTest(step.commands):
                    self.follow(step)
        words = "_".join(re.findall(r"\w+", title.lower()))
        setattr(UserGuide, f"test_chapter_{number:02}_{words}", test)


add_chapters()


class Agreement(unittest.TestCase):
    def test_figures_are_compared_to_the_digits_that_the_page_states(self):
        row = "0.02,-0.0017435856,-107446.4044,-29307.36,0.022"
        self.assertTrue(guide.agrees("0.02,-0.001744,-107446,-29307,…", row))
        for drifted in ("0.02,-0.001744,-107445,-29307,…", "0.02,-0.001743,-107446,-29307,…"):
            self.assertFalse(guide.agrees(drifted, row) and not os.environ.get("ADIT_SANITIZE"), drifted)
        self.assertTrue(guide.agrees("ratio 1e-04, 4112 steps", "ratio  1.4e-04, 4112 steps"))
        self.assertFalse(guide.agrees("4112 steps", "4112 stops"))


class Readme(unittest.TestCase):
    text = (SOURCE / "README.md").read_text()

    def test_it_fits_on_a_few_screens(self):
        lines = self.text.splitlines()
        self.assertLessEqual(len(lines), 150)
        self.assertEqual([line for line in lines if len(line) > 130], [])

    def test_its_commands_name_what_exists(self):
        commands = [content for language, content in guide.blocks(self.text) if language in ("sh", "console")]
        named = re.findall(r"\b(?:scripts|cases|tools)/[\w./-]*[\w]", "".join(commands))
        self.assertTrue(named)
        for name in named:
            self.assertTrue((SOURCE / name).exists(), name)

    def test_its_scenes_can_be_computed(self):
        for name, content in guide.files(self.text).items():
            with tempfile.TemporaryDirectory(prefix="adit_") as folder:
                scene = pathlib.Path(folder, name)
                scene.write_text(content)
                result = coupler("run", scene, "--out", pathlib.Path(folder, "run"))
                self.assertEqual(result.returncode, 0, result.stderr)


class Links(unittest.TestCase):
    """Links and pictures of every page lead to files of the repository, and to headings that these have."""

    @staticmethod
    def anchors(page):
        """Headings as a code host links to them."""
        titles = re.findall(r"^#+ (.*)$", page.read_text(), re.MULTILINE)
        return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}

    def test_every_link_leads_somewhere(self):
        for page in PAGES:
            for target in re.findall(r"\]\(([^)\s]+)\)", page.read_text()):
                if re.match(r"https?://", target):
                    continue
                with self.subTest(page=page.name, target=target):
                    path, _, anchor = target.partition("#")
                    file = (page.parent / path).resolve() if path else page
                    self.assertTrue(file.exists())
                    if anchor and file.suffix == ".md":
                        self.assertIn(anchor, self.anchors(file))

    def test_pictures_are_small(self):
        for picture in (SOURCE / "docs" / "pictures").glob("guide_*.png"):
            self.assertLess(picture.stat().st_size, 150_000, picture.name)
