"""A report says what the results say, whole in one file, also of a run that failed or was stopped."""

import html.parser
import json
import pathlib
import re
import subprocess
import unittest

from programs import ADIT, BUILD, CASE, PATIENCE_S, ProgramTest, SOURCE, coupler

from adit.report import page
from adit.report.quantities import quantity

SHORT = ("--set", "time.duration=12 ms", "--set", "output.field_times=[4 ms, 8 ms, 12 ms]")
PREFIXES = {"G": 1e9, "M": 1e6, "k": 1e3, "m": 1e-3, "µ": 1e-6, "": 1.0}
UNITS = ("m/s²", "m/s", "N m", "1/s", "rad", "Hz", "Pa", "N", "J", "B", "s", "m", "")
SUPERSCRIPTS = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
# Names that no scene may have, but results from elsewhere.
HOSTILE = {"plain_1": "<script>document.title='taken'</script>$\\frac{", "plain_2": "<img src=x onerror=alert(1)>$"}

# The grid is pulled at one end and held at the other.
BAR = """
description: "a bar & <b onload=alert(1)>"
material: {young_modulus: 30 GPa, poisson_ratio: 0.2, density: 2500 kg/m^3}
time: {duration: 1 ms}
continuum:
  block: {x_min: 0 m, x_max: 6 m, y_min: 0 m, y_max: 1 m, zones_x: 12, zones_y: 2}
  edge_loads: [{where: {x_max: 0 m}, force: {x: 10 MN}, time: {sine: {frequency: 1 kHz, end: 0.5 ms}}}]
  histories:
    - {name: plain_1, quantity: velocity_x, at: {x: 6 m, y: 0.5 m}}
    - {name: plain_2, quantity: acceleration_x, at: {x: 6 m, y: 0.5 m}}
"""


def rename_histories(run, names):
    for path in [path for path in run.rglob("*") if path.suffix in (".csv", ".yaml", ".json")]:
        text = path.read_text()
        for plain, name in names.items():
            in_json = json.dumps(name)[1:-1]  # of YAML, too
            text = text.replace(plain, name if path.suffix == ".csv" else in_json)
            path = path.rename(path.with_name(path.name.replace(plain, name))) if plain in path.name else path
        path.write_text(text)


class Elements(html.parser.HTMLParser):
    """Start tags with their attributes, and the text of table cells by data-key and data-raw."""

    def __init__(self, text):
        super().__init__()
        self.tags, self.cells, self._cell = [], {}, None
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.tags.append((tag, attributes))
        self._cell = next(((kind, attributes[kind]) for kind in ("data-key", "data-raw") if kind in attributes), None)
        if self._cell:
            self.cells[self._cell] = ""

    def handle_data(self, text):
        if self._cell:
            self.cells[self._cell] += text

    def handle_endtag(self, tag):
        self._cell = None


def value(text):
    """The number that a cell such as `14.97 MN` or `2.7 × 10⁻⁵` tells, in SI units."""
    number, unit = re.fullmatch(r"(−?[\d,.]+(?: × 10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?) ?(.*)", text).groups()
    mantissa, _, exponent = number.replace("−", "-").replace(",", "").partition(" × 10")
    prefix = next(unit.removesuffix(known) for known in UNITS if unit.endswith(known) and unit.removesuffix(known) in PREFIXES)
    return float(mantissa) * 10.0 ** int(exponent.translate(SUPERSCRIPTS) or 0) * PREFIXES[prefix]


class Pages(ProgramTest):
    def report(self, *folders):
        return subprocess.run([*ADIT, "report", *folders], capture_output=True, text=True, timeout=120)

    def page_of(self, run):
        done = self.report(run)
        self.assertEqual(done.returncode, 0, done.stderr)
        return (run / "report.html").read_text()

    def test_figures_are_those_of_the_summary(self):
        run = self.run_scene(CASE / "coupled.yaml", "--set", "time.duration=35 ms", "--set", "output.field_times=[35 ms]")
        summary, elements = self.summary(run), Elements(self.page_of(run))
        raw = {key: text for (kind, key), text in elements.cells.items() if kind == "data-raw"}
        self.assertEqual(raw, {key: each if isinstance(each, str) else json.dumps(each, ensure_ascii=False)
                               for key, each in summary.items()})
        shown = {key: text for (kind, key), text in elements.cells.items() if kind == "data-key"}
        for key in ("peak_bond_force_N", "crack_count", "first_crack_time_s", "max_energy_drift", "wall_s", "particles"):
            self.assertIn(key, shown)
        for key, text in shown.items():
            if not isinstance(summary[key], str):
                self.assertAlmostEqual(value(text), summary[key], delta=5e-4 * abs(summary[key]), msg=f"{key}: {text}")

    def test_quantities_read_back_to_four_digits(self):
        for unit in ("", "N", "Pa", "s", "m", "m/s²", "Hz"):
            for size in (1.2345e-9, 9.9996e-4, 0.123456, 9.99964, 999.96, 12345.6, 1.5e7, 3.21e11):
                for signed in (size, -size):
                    self.assertAlmostEqual(value(quantity(signed, unit)) / signed, 1, delta=5e-4, msg=quantity(signed, unit))

    def test_one_file_holds_all_tells_who_cannot_see_and_asks_for_nothing(self):
        text = self.page_of(self.run_scene(CASE / "coupled.yaml", *SHORT))
        with self.subTest("one file"):
            self.assert_stands_alone(text)
        with self.subTest("without sight"):
            self.assert_can_be_heard(text)

    def assert_stands_alone(self, text):
        self.assertLess(len(text.encode()), 5_000_000)
        tags = Elements(text).tags
        places = {f"#{attributes.get('id')}" for _, attributes in tags}
        links = {attributes["href"] for tag, attributes in tags if tag == "a"}
        self.assertTrue(links and links <= places, links - places)
        for tag, attributes in tags:
            self.assertNotIn(tag, ("link", "iframe", "object", "embed", "base"))
            for name in ("src", "srcset", "href", "action", "data"):
                self.assertRegex(attributes.get(name) or "#", r"^(#|data:image/)", f"{tag} {name}")
        style = re.search(r"<style>(.*?)</style>", text, re.S)[1]
        self.assertNotRegex(style, r"url\(|@import")
        self.assertIn("default-src 'none'", text)

    def assert_can_be_heard(self, text):
        tags = Elements(text).tags
        self.assertIn(("html", {"lang": "en"}), tags)
        images = [attributes for tag, attributes in tags if tag == "img"]
        self.assertGreater(len(images), 10)
        self.assertTrue(all(len(image["alt"]) > 10 for image in images))
        headings = [int(tag[1]) for tag, _ in tags if re.fullmatch(r"h[1-6]", tag)]
        self.assertEqual((headings[0], headings.count(1)), (1, 1))
        self.assertTrue(all(after <= before + 1 for before, after in zip(headings, headings[1:])), headings)
        self.assertTrue(all("scope" in attributes for tag, attributes in tags if tag == "th"))
        for figure in re.findall(r"<figure>.*?</figure>", text, re.S):
            self.assertRegex(figure, r"<ul class=\"legend\">|class=\"note\"|<table>", "a picture without its legend or numbers")

    def test_names_of_a_scene_stay_text(self):
        run = self.run_scene(self.scene(BAR + "output: {spectra: [{history: plain_2, shortest_period: 2 ms}]}\n"))
        rename_histories(run, HOSTILE)
        text = self.page_of(run)
        tags = Elements(text).tags
        self.assertEqual([tag for tag, _ in tags if tag in ("script", "b")], ["script"])
        self.assertEqual([attributes["src"] for tag, attributes in tags if tag == "img" and attributes["src"] == "x"], [])
        self.assertIn("&lt;img src=x onerror=alert(1)&gt;$_ax", text)
        self.assertIn("&lt;script&gt;document.title=&#x27;taken&#x27;&lt;/script&gt;$\\frac{", text)
        self.assertIn("A bar &amp; &lt;b onload=alert(1)&gt;", text)

    def test_a_failed_run_says_so_first_and_shows_what_there_is(self):
        scene = self.scene(BAR.replace("{duration: 1 ms}", "{duration: 20 ms, dt: 0.2 ms, beyond_critical: true}"))
        failed = coupler("run", scene, "--out", self.folder / "run")
        self.assertEqual(failed.returncode, 4, failed.stderr)
        self.assertIn(f"results            {self.folder / 'run'}\n", failed.stdout)
        text = self.page_of(self.folder / "run")
        before, found, after = text.partition("The run failed")
        self.assertTrue(found and before.count("<p") == 1, "it is the first paragraph")
        self.assertIn(html.escape(self.summary(self.folder / "run")["error"]), after)
        self.assertIn("Velocity over time", after)

    def test_a_run_that_was_killed_is_reported_as_unfinished(self):
        run = self.run_scene(CASE / "coupled.yaml", "--set", "time.duration=12 ms", "--set", "output.field_times=[]")
        (run / "summary.json").unlink()
        rows = (run / "histories.csv").read_text()
        (run / "histories.csv").write_text(rows[:len(rows) // 2])  # it ends in half a row
        text = self.page_of(run)
        self.assertRegex(text, r"The run was not finished: it was stopped at [\d.]+ ms of 12 ms")
        self.assertIn("Displacement over time", text)

    def test_damaged_files_are_named_and_the_rest_is_shown(self):
        run = self.run_scene(CASE / "coupled.yaml", *SHORT)
        damaged = sorted((run / "fields").glob("grid_*.vtu"))[1]
        damaged.write_text(damaged.read_text()[:300])
        (run / "cracks.csv").write_bytes(b"")
        text = self.page_of(run)
        self.assertIn(damaged.name, text)
        self.assertIn("Cracks.csv is damaged", text)
        self.assertIn("Displacement over time", text)

    def test_a_folder_without_results_is_refused(self):
        done = self.report(self.folder)
        self.assertEqual(done.returncode, 2)
        self.assertIn("is not the folder of a run", done.stderr)

    def test_a_large_page_shows_fewer_instants_and_says_so(self):
        times = ", ".join(f"{k} ms" for k in range(1, 13))
        run = self.run_scene(CASE / "full_fdm.yaml", "--set", "time.duration=12 ms", "--set", f"output.field_times=[{times}]")
        whole = self.page_of(run)
        self.assertIn("8 of 12 instants are shown", whole)
        largest = page.LARGEST
        self.addCleanup(setattr, page, "LARGEST", largest)
        page.LARGEST = int(0.8 * len(whole))
        page.of_run(run)
        smaller = (run / "report.html").read_text()
        self.assertIn("4 of 12 instants are shown", smaller)
        self.assertLessEqual(len(smaller.encode()), page.LARGEST)

    def test_runs_are_compared_by_the_figures_of_their_summaries(self):
        runs = [self.run_scene(CASE / f"{name}.yaml", *SHORT, out=name) for name in ("full_dem", "coupled")]
        subprocess.run([*ADIT, "compare", *runs], check=True, capture_output=True, timeout=120)
        text = (self.folder / "report.html").read_text()
        row = re.search(r'<tr><th scope="row">peak bond force</th>(.*?)</tr>', text)[1]
        told = [value(cell) for cell in re.findall(r"<td[^>]*>(.*?)</td>", row)]
        for found, run in zip(told, runs, strict=True):
            peak = self.summary(run)["peak_bond_force_N"]
            self.assertAlmostEqual(found / peak, 1, delta=5e-4)
        for name in ("full_dem", "coupled"):
            self.assertNotIn(f'href="{name}/report.html"', text, "these runs have no reports")
            self.assertIn(f"{name}: Normal forces in the bonds at t = 12 ms", text)

    def test_a_whole_tunnel_has_spectra_of_its_motion_and_of_its_stations(self):
        run = self.folder / "tunnel"
        subprocess.run([BUILD / "simplified" / "simplified", "run", SOURCE / "cases" / "hzm" / "uniform_0.1g.yaml", "--set",
                        "time.duration=8 s", "--out", run], check=True, capture_output=True, timeout=PATIENCE_S)
        rows = re.findall(r'<th scope="row">([^<]*), 5 %</th><td>pseudo acceleration \[g\]</td>(.*?)</tr>', self.page_of(run))
        told = {name: [value(cell) for cell in re.findall(r"<td>(−?[\d.,]+)</td>", cells)] for name, cells in rows}
        self.assertIn("out: middle, uy", told)
        self.assertGreater(9.80665 * max(told["in: the motion of the scene"]), self.summary(run)["peak_input_acceleration_m_per_s2"])

    def test_a_summary_says_how_to_compute_it_again(self):
        record = self.folder / "motion.csv"
        record.write_text("time_s,acceleration_g\n0,0\n0.01,0.1\n0.02,-0.1\n0.03,0\n0.04,0\n")
        scene = self.scene(BAR[:BAR.index("  edge_loads")] + "  base: {kind: rigid, acceleration: {file: {path: motion.csv}}}\n")
        run = self.run_scene(scene, "--set", "time.duration=2 ms")
        summary = self.summary(run)
        self.assertRegex(summary["started"], r"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ$")
        self.assertEqual(list(summary["inputs"]), [str(scene), str(record)])
        for path, told in summary["inputs"].items():
            self.assertEqual(told, fnv_1a(pathlib.Path(path).read_bytes()))
        (run / "summary.json").unlink()
        subprocess.run(["bash", "-c", summary["command"]], cwd=summary["folder"], check=True, capture_output=True, timeout=PATIENCE_S)
        self.assertEqual(self.summary(run)["scene_hash"], summary["scene_hash"])


def fnv_1a(data):
    """As http://www.isthe.com/chongo/tech/comp/fnv defines it, with 64 bits."""
    found = 0xcbf29ce484222325
    for byte in data:
        found = (found ^ byte) * 0x100000001b3 % 2**64
    return f"{found:016x}"


if __name__ == "__main__":
    unittest.main()
