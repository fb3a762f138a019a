"""A report works in a browser: its slider moves, nothing overlaps on a phone or a screen, and it prints."""

import base64
import subprocess
import unittest

from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

from browser import FAULTS, page, requested
from programs import ADIT, CASE, COUPLER, PATIENCE_S, ProgramTest

WIDTHS = (390, 1400)  # CSS pixels: a phone and a screen
TIMES = ("20 ms", "32 ms", "36 ms")  # before the first crack, with one, with several


def reported(name, folder):
    """A run of the cantilever with its report."""
    run = folder / name
    subprocess.run([COUPLER, "run", CASE / f"{name}.yaml", "--out", run, "--set", "time.duration=36 ms", "--set",
                    f"output.field_times=[{', '.join(TIMES)}]"], check=True, capture_output=True, timeout=PATIENCE_S)
    subprocess.run([*ADIT, "report", run], check=True, capture_output=True, timeout=120)
    return run


class Browser(ProgramTest):
    @classmethod
    def setUpClass(cls):
        cls.run_folder = reported("coupled", cls.folder_for_all())
        cls.path = cls.run_folder / "report.html"

    @staticmethod
    def shown(driver):
        """Sources of the pictures of instants that are seen, and what the slider says."""
        pictures = [image.get_attribute("src") for image in driver.find_elements(By.CSS_SELECTOR, ".instant img")
                    if image.is_displayed()]
        return pictures, driver.find_element(By.CSS_SELECTOR, ".slider output").text

    def test_the_slider_shows_the_pictures_of_one_instant_after_the_other(self):
        with page(self.path) as driver:
            slider = driver.find_element(By.ID, "instant")
            slider.send_keys(Keys.HOME)
            seen = []
            for time in TIMES:
                pictures, told = self.shown(driver)
                self.assertEqual(told, f"t = {time}")
                self.assertEqual(slider.get_attribute("aria-valuetext"), told)
                self.assertEqual(len(pictures), 5)
                seen.append(set(pictures))
                slider.send_keys(Keys.ARROW_RIGHT)
            self.assertFalse(seen[0] & seen[1] or seen[1] & seen[2], "a picture of another instant stayed")
            self.assertEqual(self.shown(driver)[1], f"t = {TIMES[-1]}", "it stops at the last instant")

    def test_it_begins_at_the_largest_bond_force(self):
        peak = self.summary(self.run_folder)["peak_bond_force_time_s"]
        nearest = min(TIMES, key=lambda time: abs(float(time.split()[0]) / 1e3 - peak))
        with page(self.path) as driver:
            self.assertEqual(self.shown(driver)[1], f"t = {nearest}")

    def test_nothing_overlaps_or_reaches_beyond_the_page(self):
        other = reported("full_dem", self.run_folder.parent)
        subprocess.run([*ADIT, "compare", self.run_folder, other], check=True, capture_output=True, timeout=120)
        compared = self.run_folder.parent / "report.html"
        self.assertIn('href="full_dem/report.html"', compared.read_text())
        for path in (self.path, compared):
            for width in WIDTHS:
                with page(path, width) as driver:
                    self.assertEqual(driver.execute_script(FAULTS), [], f"{path.parent.name} at {width} px")
                    driver.execute_script("document.querySelectorAll('details:not(.instant)').forEach(d => { d.open = true; })")
                    self.assertEqual(driver.execute_script(FAULTS), [], f"{path.parent.name} at {width} px, all opened")

    def test_the_check_sees_boxes_that_overlap_or_are_too_wide(self):
        with page(self.path, 390) as driver:
            driver.execute_script("document.querySelector('h2').style.marginBottom = '-40px'")
            self.assertIn("lies on", " ".join(driver.execute_script(FAULTS)))
            driver.execute_script("document.querySelector('h2').style.width = '500px'")
            self.assertIn("the page is", " ".join(driver.execute_script(FAULTS)))

    def test_pictures_are_seen_and_letters_in_them_are_readable_on_a_phone(self):
        with page(self.path, 390) as driver:
            for image in driver.find_elements(By.TAG_NAME, "img"):
                if image.is_displayed():
                    natural, width, stated = driver.execute_script(
                        "return [arguments[0].naturalWidth, arguments[0].clientWidth, arguments[0].width]", image)
                    self.assertGreater(natural, 0, image.get_attribute("alt"))
                    drawn = float(image.get_dom_attribute("width"))
                    self.assertGreater(9 / 72 * 96 * width / drawn, 7.5, "letters of 9 points, in CSS pixels")

    def test_it_asks_the_network_for_nothing_and_the_browser_has_nothing_to_say(self):
        with page(self.path) as driver:
            self.assertEqual(requested(driver), {self.path.resolve().as_uri()})
            self.assertEqual([entry["message"] for entry in driver.get_log("browser")], [])

    def test_without_scripts_the_instants_open_one_by_one(self):
        with page(self.path, scripts=False) as driver:
            self.assertFalse(driver.find_element(By.ID, "instant").is_displayed())
            instants = driver.find_elements(By.CSS_SELECTOR, ".instant")
            self.assertEqual([each.find_element(By.TAG_NAME, "summary").text for each in instants], [f"t = {t}" for t in TIMES])
            closed = next(each for each in instants if each.get_dom_attribute("open") is None)
            self.assertLess(closed.size["height"], 100)  # its heading alone
            closed.find_element(By.TAG_NAME, "summary").click()
            self.assertGreater(closed.size["height"], 400)

    def test_it_prints_on_a_few_pages(self):
        with page(self.path) as driver:
            printed = base64.b64decode(driver.print_page())
        self.assertTrue(printed.startswith(b"%PDF"))
        self.assertIn(printed.count(b"/Type /Page\n"), range(3, 13))


if __name__ == "__main__":
    unittest.main()
