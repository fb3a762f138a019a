"""Pages in headless Chromium, driven by Debian's chromium-driver (scripts/setup test installs both)."""

import contextlib
import json

from selenium import webdriver
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service

# Pairs of visible boxes with text or pictures that lie on each other by more than a pixel, and what is wider than the page.
FAULTS = """
const kinds = "h1,h2,h3,p,li,th,td,caption,summary,label,output,input,img,pre,figcaption,a,strong";
const boxes = [...document.querySelectorAll(kinds)]
  .filter(e => e.checkVisibility() && e.getClientRects().length)
  .map(e => [e, e.getBoundingClientRect()]);
const named = e => e.tagName + " " + (e.textContent || e.alt || e.id).trim().slice(0, 40);
const found = [];
const wide = document.documentElement.scrollWidth;
if (wide > innerWidth) found.push("the page is " + wide + " wide");
boxes.forEach(([a, r], i) => boxes.slice(i + 1).forEach(([b, s]) => {
  if (a.contains(b) || b.contains(a)) return;
  const x = Math.min(r.right, s.right) - Math.max(r.left, s.left), y = Math.min(r.bottom, s.bottom) - Math.max(r.top, s.top);
  if (x > 1 && y > 1) found.push(named(a) + " lies on " + named(b));
}));
boxes.forEach(([e, r]) => {
  if (r.right > innerWidth + 1 && !e.closest(".table")) found.push(named(e) + " reaches beyond the page");
});
return found;
"""


@contextlib.contextmanager
def page(path, width=1400, scripts=True):
    """A driver that shows the file at the width [CSS pixels]."""
    options = Options()
    options.binary_location = "/usr/bin/chromium"
    for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"):
        options.add_argument(argument)
    if not scripts:
        options.add_experimental_option("prefs", {"profile.managed_default_content_settings.javascript": 2})
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    driver = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
    try:
        driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                               {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": False})
        driver.get(path.resolve().as_uri())
        yield driver
    finally:
        driver.quit()


def requested(driver):
    """Addresses that the page asked for, without what it carries itself."""
    events = (json.loads(entry["message"])["message"] for entry in driver.get_log("performance"))
    urls = {event["params"]["request"]["url"] for event in events if event["method"] == "Network.requestWillBeSent"}
    return {url for url in urls if not url.startswith("data:")}
