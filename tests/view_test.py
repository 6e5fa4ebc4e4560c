"""The page of gridview, driven by headless Chromium.

view_test.py BIN_FOLDER [SCREENSHOT_FOLDER]
"""
import json
import os
import pathlib
import re
import shlex
import shutil
import struct
import subprocess
import sys
import time
import unittest

from gridview_run import Gridview, Tools, skip, wait_until

try:
    from selenium import webdriver
    from selenium.webdriver.chrome.options import Options
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
except ImportError:
    skip("Selenium for Python isn't installed (python3-selenium)")

CHROMIUM, DRIVER = shutil.which("chromium"), shutil.which("chromedriver")
if not CHROMIUM or not DRIVER:
    skip("Chromium or its driver isn't installed (chromium, chromium-driver)")

tools = None
scene = None
pictures = None


def open_browser():
    options = Options()
    options.binary_location = CHROMIUM
    # Containers have little shared memory; Chromium's sandbox doesn't run as root.
    for argument in ["--headless=new", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars", "--no-first-run"]:
        options.add_argument(argument)
    if os.geteuid() == 0:
        options.add_argument("--no-sandbox")
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    return webdriver.Chrome(service=Service(DRIVER), options=options)


def read_pfm(path):
    """Rows from the top of (r, g, b)."""
    data = path.read_bytes()
    match = re.match(rb"PF\n(\d+) (\d+)\n-1.0\n", data)
    width, height = int(match[1]), int(match[2])
    values = struct.unpack(f"<{3 * width * height}f", data[match.end():])
    rows = [values[3 * width * y:3 * width * (y + 1)] for y in range(height)]
    return width, height, rows[::-1]


def channel_of(color):
    """Relative luminance's part of a channel (WCAG)."""
    value = color / 255
    return value / 12.92 if value <= 0.03928 else ((value + 0.055) / 1.055) ** 2.4


def contrast(one, other):
    light = lambda rgb: sum(weight * channel_of(value) for weight, value in zip((0.2126, 0.7152, 0.0722), rgb))
    a, b = sorted([light(one), light(other)])
    return (b + 0.05) / (a + 0.05)


class Page(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = Gridview(tools, *scene, "-q")
        cls.browser = open_browser()

    @classmethod
    def tearDownClass(cls):
        cls.browser.quit()
        cls.server.__exit__()

    def setUp(self):
        self.show()
        self.logs()

    def tearDown(self):
        self.assert_quiet()

    # --- What tests do ---

    def show(self, width=860, height=420, dark=False, fragment="", server=None):
        self.browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}]})
        self.browser.get("about:blank")
        self.browser.get((server or self.server).address + fragment)
        self.wait_sharp()

    def js(self, script, *arguments):
        return self.browser.execute_script(script, *arguments)

    def wait_sharp(self):
        wait_until(lambda: self.js("return panes.length > 0 && panes.every((pane) => pane.root.dataset.state === 'sharp' && "
                                   "pane.frame.isSharp && Camera.same(pane.frame.view.camera, state.camera) && "
                                   "pane.frame.view.channel === pane.settings.channel && pane.frame.view.grid === pane.settings.grid)"),
                   "every picture is sharp", 120)

    def logs(self):
        return [json.loads(entry["message"])["message"] for entry in self.browser.get_log("performance")], self.browser.get_log("browser")

    def assert_quiet(self):
        """No message on the console, and no request but to the page's own address."""
        events, console = self.logs()
        self.assertEqual([entry["message"] for entry in console], [])
        for event in events:
            if event["method"] == "Network.requestWillBeSent":
                url = event["params"]["request"]["url"]
                self.assertTrue(url.startswith((f"http://127.0.0.1:{self.server.port}/", "data:", "blob:", "about:")), url)

    def screenshot(self, name):
        if pictures:
            self.browser.save_screenshot(str(pictures / f"{name}.png"))

    def find(self, selector):
        return self.browser.find_element(By.CSS_SELECTOR, selector)

    def keys(self, *keys):
        chain = ActionChains(self.browser)
        for key in keys:
            chain.send_keys(key)
        chain.perform()

    def pixels(self, pane=0):
        """Bytes of the picture: r, g, b, a."""
        return self.js("const {canvas} = panes[arguments[0]].picture, copy = document.createElement('canvas'); "
                       "copy.width = canvas.width; copy.height = canvas.height; "
                       "const context = copy.getContext('2d', {willReadFrequently: true}); context.drawImage(canvas, 0, 0); "
                       "return [copy.width, copy.height, Array.from(context.getImageData(0, 0, copy.width, copy.height).data)]", pane)

    def camera(self):
        return self.js("return state.camera")

    # --- Tests ---

    def test_the_picture_is_that_of_the_command_that_the_page_copies(self):
        command = shlex.split(self.js("return command()"))
        self.assertEqual(command[0], "gridrender")
        command[command.index("picture.png")] = "picture.pfm"
        tools.run(*command, "-q")
        width, height, rows = read_pfm(tools.folder / "picture.pfm")
        got_width, got_height, got = self.pixels()
        self.assertEqual((got_width, got_height), (width, height))
        difference = sum(abs(got[4 * (y * width + x) + c] - min(255, 255 * rows[y][3 * x + c]))
                         for y in range(0, height, 7) for x in range(0, width, 5) for c in range(3))
        samples = 3 * len(range(0, height, 7)) * len(range(0, width, 5))
        self.assertLess(difference / samples, 2.5, "mean difference, of 255: JPEG's alone")
        self.screenshot("loaded")

    def test_dragging_orbits_pans_and_the_wheel_zooms(self):
        stage = self.find(".stage")
        before, picture = self.camera(), self.pixels()
        distance = lambda camera: sum((a - b) ** 2 for a, b in zip(camera["from"], camera["at"])) ** 0.5
        ActionChains(self.browser).move_to_element(stage).click_and_hold().move_by_offset(90, 20).move_by_offset(30, 0).release().perform()
        orbited = self.camera()
        self.assertEqual(orbited["at"], before["at"])
        self.assertNotEqual(orbited["from"], before["from"])
        self.assertAlmostEqual(distance(orbited), distance(before))
        self.wait_sharp()
        self.assertNotEqual(self.pixels(), picture)
        ActionChains(self.browser).key_down(Keys.SHIFT).move_to_element(stage).click_and_hold().move_by_offset(40, 40).release().key_up(Keys.SHIFT).perform()
        panned = self.camera()
        self.assertNotEqual(panned["at"], orbited["at"])
        for a, b, c, d in zip(panned["from"], panned["at"], orbited["from"], orbited["at"]):
            self.assertAlmostEqual(a - b, c - d)
        ActionChains(self.browser).scroll_from_origin(webdriver.common.actions.wheel_input.ScrollOrigin.from_element(stage), 0, -300).perform()
        wait_until(lambda: distance(self.camera()) < distance(panned), "it zooms")
        self.wait_sharp()
        wait_until(lambda: "from=" in self.js("return location.hash"), "the address holds the view")

    def test_an_address_opens_the_same_view(self):
        self.js("setCamera(Camera.orbited(state.camera, 0.5, 0.1)); panes[0].set({channel: 'depth', cells: 'slice'}); toggleCompare()")
        self.wait_sharp()
        fragment, camera = self.js("return fragment()"), self.camera()
        self.show(fragment=fragment)
        self.assertEqual(self.camera(), camera)
        self.assertEqual(self.js("return state.panes"), [dict(grid=0, channel="depth", cells="slice"), dict(grid=1, channel="depth", cells="slice")])
        for damaged in ["#from=1,2&at=x&angle=999&grid=none&channel=none&slice=q,7&pixel=9,9&depth=-1", "#from=0,0,0&at=0,0,0", "#" + "a" * 5000]:
            self.show(fragment=damaged)  # the scene's own camera, for what makes no sense
            self.assertEqual(self.camera()["angle"], 45)

    def test_a_picked_pixels_walk_is_that_of_gridrender(self):
        stage = self.find(".stage")
        for dx, dy in [(0, 0), (-60, 40), (150, -120)]:
            ActionChains(self.browser).move_to_element_with_offset(stage, dx, dy).click().perform()
            wait_until(lambda: self.js("return walkPanel.walk && !walking.signal.aborted"), "a walk")
            time.sleep(0.3)
            pixel, walk = self.js("return [walkPanel.pixel, walkPanel.walk]")
            self.assertEqual(len(self.browser.find_elements(By.CSS_SELECTOR, ".walk-steps tbody tr")), len(walk["rays"][0]["steps"]))
            if "--walk " not in tools.run("gridrender", "--help"):
                continue
            command = [word for word in shlex.split(self.js("return command()")) if word not in ("-o", "picture.png")]
            printed = json.loads(tools.run(*command, "--sampling", "centers", "--walk", f"{pixel['x']},{pixel['y']}", "--json"))
            self.assertEqual(printed["rays"], walk["rays"])
        self.screenshot("walk")
        steps = len(walk["rays"][0]["steps"])
        self.js("walkPanel.select(0)")
        self.find(".walk-steps tbody tr:last-child").click()
        self.assertEqual(self.js("return walkPanel.step"), steps - 1)

    def test_channels(self):
        names = self.js("return state.scene.channels")
        self.assertGreater(len(names), 5)
        seen = []
        for name in names:
            self.js("const s = document.querySelector('.channel'); s.value = arguments[0]; s.dispatchEvent(new Event('change'))", name)
            self.wait_sharp()
            picture = self.pixels()
            self.assertNotIn(picture, seen, name)
            seen.append(picture)
            is_number = name in ("depth", "cells", "tests", "all cells", "all tests")
            self.assertEqual(self.find(".scale").is_displayed(), is_number, name)
        self.screenshot("channel")

    def test_two_grids_side_by_side(self):
        self.find("#compare").click()
        self.wait_sharp()
        self.assertEqual(self.js("return state.panes.map((pane) => pane.grid)"), [0, 1])
        # The picture doesn't depend on the grid.
        sizes = [self.pixels(0)[:2], self.pixels(1)[:2]]
        self.assertEqual(sizes[0], sizes[1])
        self.assertEqual(self.pixels(0)[2], self.pixels(1)[2])
        wait_until(lambda: len(self.browser.find_elements(By.CSS_SELECTOR, "#cost td.better")) > 1, "costs of both")
        self.screenshot("compare")
        self.js("for (const pane of panes) pane.set({channel: 'cells'})")
        self.wait_sharp()
        self.assertNotEqual(self.pixels(0)[2], self.pixels(1)[2])
        self.screenshot("compare-cells")
        self.find("#compare").click()
        self.wait_sharp()
        self.assertEqual(len(self.browser.find_elements(By.CSS_SELECTOR, ".picture")), 1)

    def test_slices(self):
        self.js("document.getElementById('slice-panel').open = true")
        wait_until(lambda: self.browser.find_elements(By.CSS_SELECTOR, "canvas.slice"), "a slice")
        for axis in range(3):
            self.js("const s = document.querySelector('#slice select'); s.value = arguments[0]; s.dispatchEvent(new Event('change'))", axis)
            wait_until(lambda: self.js("return slicePanel.of(0) && slicePanel.of(0).axis") == axis, "the slice along another axis")
            self.assertGreater(len(self.js("return slicePanel.of(0).cells")), 0)
        self.js("panes[0].set({cells: 'slice'})")
        self.wait_sharp()
        drawn = self.js("const c = panes[0].overlay.canvas; return c.getContext('2d').getImageData(0, 0, c.width, c.height).data.some((value) => value > 0)")
        self.assertTrue(drawn)
        self.screenshot("slice")

    def test_statistics_are_those_of_gridstat(self):
        wait_until(lambda: self.browser.find_elements(By.CSS_SELECTOR, "#statistics table"), "statistics")
        for index, grid in enumerate(scene[1:]):
            printed = json.loads(tools.run("gridstat", grid, "--json", "--histogram"))
            served = json.loads(self.server.get(f"/api/statistics?grid={index}"))
            self.assertEqual({**served, "commit": None}, {**printed, "commit": None})  # the tools may be of two builds
        self.js("document.getElementById('histogram-panel').open = true")
        self.assertGreater(len(self.browser.find_elements(By.CSS_SELECTOR, "#histogram rect")), 1)

    def test_keyboard_alone(self):
        order = []
        for _ in range(40):
            self.keys(Keys.TAB)
            name, outlined = self.js("const e = document.activeElement, s = getComputedStyle(e); "
                                     "return [e.id || e.className || e.tagName, s.outlineStyle !== 'none' && parseFloat(s.outlineWidth) >= 1]")
            self.assertTrue(outlined or name == "BODY", f"focus is visible on {name}")
            order.append(name)
            if name == "stage":
                break
        self.assertEqual(order[-1], "stage", order)
        for wanted in ["compare", "reset", "copy-link", "copy-command", "keys", "grid", "channel", "cells"]:
            self.assertIn(wanted, order)
        before = self.camera()
        self.keys(Keys.ARROW_LEFT, Keys.ARROW_UP, "+", "+")
        self.assertNotEqual(self.camera(), before)
        self.keys(Keys.HOME)
        self.assertEqual(self.camera(), before)
        self.keys("c", "g", "w")
        self.assertEqual(self.js("return state.panes"), [dict(grid=1, channel=self.js("return state.scene.channels[1]"), cells="slice")])
        self.keys("v")
        self.assertEqual(len(self.js("return state.panes")), 2)
        self.keys("v", "?")
        self.assertTrue(self.find("#keys-list").is_displayed())
        self.keys("?", Keys.ENTER, Keys.ARROW_RIGHT, Keys.ARROW_DOWN, Keys.ENTER)
        wait_until(lambda: self.js("return walkPanel.walk"), "a walk")
        last = self.js("return walkPanel.step")
        self.keys(",")
        self.assertEqual(self.js("return walkPanel.step"), max(0, last - 1))
        self.keys(".")
        self.assertEqual(self.js("return walkPanel.step"), last)
        self.keys(Keys.ESCAPE)
        self.assertIsNone(self.js("return walkPanel.walk"))
        self.wait_sharp()

    def test_every_control_has_a_name(self):
        self.js("document.querySelectorAll('details').forEach((details) => { details.open = true; }); toggleCompare()")
        self.wait_sharp()
        nameless = self.js("return [...document.querySelectorAll('button, select, input, canvas:not([aria-hidden]), [tabindex=\"0\"]')].filter((e) => "
                           "!(e.textContent.trim() && e.tagName === 'BUTTON') && !e.getAttribute('aria-label') && !(e.labels && e.labels.length > 0) && "
                           "!e.closest('[role=application]')).map((e) => e.outerHTML.slice(0, 90))")
        self.assertEqual(nameless, [])

    def test_widths_and_colors(self):
        for width, height in [(400, 800), (760, 900), (1000, 700), (1920, 1080)]:
            for dark in [False, True]:
                self.show(width, height, dark, fragment="#grid=" + ",".join(scene[1:]) + "&channel=shaded,cells&pixel=0.5,0.5")
                wait_until(lambda: self.js("return walkPanel.walk"), "a walk")
                self.js("document.querySelectorAll('details').forEach((details) => { details.open = true; })")
                wait_until(lambda: self.js("return document.querySelector('canvas.slice') && document.querySelector('#statistics table')"), "all panels")
                self.assertLessEqual(self.js("return document.scrollingElement.scrollWidth"), width, "nothing sticks out")
                wide = self.js("const w = innerWidth; return [...document.querySelectorAll('main *, header *')].filter((e) => e.getBoundingClientRect().right > w + 1 && "
                               "!e.closest('.scroll') && e.getClientRects().length > 0).map((e) => e.outerHTML.slice(0, 80))")
                self.assertEqual(wide, [], width)
                colors = self.js("const s = getComputedStyle(document.body), f = getComputedStyle(document.querySelector('.facts')); return [s.backgroundColor, s.color, f.color]")
                paper, ink, faint = [tuple(map(float, re.findall(r"[\d.]+", color)[:3])) for color in colors]
                self.assertEqual(paper < (100, 100, 100), dark)
                self.assertGreater(contrast(paper, ink), 7)
                self.assertGreater(contrast(paper, faint), 4.5)
                self.js("scrollTo(0, 0)")
                self.screenshot(f"{width}-{'dark' if dark else 'light'}")

    def test_an_exported_page_needs_no_server(self):
        tools.run("gridview", *scene, "--export", "page.html", "--views", "3", "--size", "160x120", "-q")
        text = (tools.folder / "page.html").read_text()
        self.assertIn("default-src 'none'", text)
        self.assertNotRegex(text, r'(src|href)="(?!data:|#)[^"]*"')
        self.browser.get("about:blank")
        self.logs()
        address = (tools.folder / "page.html").as_uri()
        self.browser.get(f"{address}#grid={scene[1]},{scene[2]}&channel=shaded,cells")
        self.wait_sharp()
        self.assertEqual(self.pixels(0)[:2], [160, 120])
        before = self.pixels(0)
        self.js("panes[0].stage.focus()")
        self.keys(Keys.ARROW_RIGHT)
        self.wait_sharp()
        self.assertNotEqual(self.pixels(0), before)
        for name in self.js("return state.scene.channels"):
            self.js("panes[1].set({channel: arguments[0]})", name)
            self.wait_sharp()
        self.js("document.querySelectorAll('details').forEach((details) => { details.open = true; })")
        wait_until(lambda: self.js("return document.querySelector('canvas.slice') && document.querySelector('#statistics table') && "
                                   "document.querySelectorAll('#cost td.better').length > 0"), "all panels")
        self.keys(Keys.ENTER, Keys.ENTER)
        wait_until(lambda: self.js("return walkPanel.walk"), "the middle pixel's walk")
        self.screenshot("exported")
        events, console = self.logs()
        self.assertEqual([entry["message"] for entry in console], [])
        for event in events:
            if event["method"] == "Network.requestWillBeSent":
                self.assertTrue(event["params"]["request"]["url"].startswith((address, "data:", "blob:", "about:")), event["params"]["request"]["url"])

    def test_a_hidden_or_closed_page_asks_nothing(self):
        self.browser.get("about:blank")
        self.logs()
        before = self.server.cpu_seconds()
        time.sleep(1)
        self.assertLess(self.server.cpu_seconds() - before, 0.2)

    def test_it_says_when_the_server_is_gone_and_goes_on_when_it_is_back(self):
        with Gridview(tools, *scene, "-q") as server:
            self.show(server=server)
            port = server.port
        self.js("setCamera(Camera.orbited(state.camera, 0.3, 0))")
        wait_until(lambda: self.find(".problem").is_displayed(), "a message")
        self.assertIn("still running", self.find(".problem").text)
        again = subprocess.Popen([tools.bin / "gridview", *scene, "--port", str(port), "-q"], cwd=tools.folder, stdout=subprocess.PIPE)
        try:
            again.stdout.readline()
            wait_until(lambda: not self.find(".problem").is_displayed(), "all is well again")
            self.wait_sharp()
        finally:
            again.terminate()
            again.wait(30)
            again.stdout.close()
        self.browser.get("about:blank")
        self.logs()  # what Chromium says of refused connections


if __name__ == "__main__":
    tools = Tools(sys.argv.pop(1))
    if len(sys.argv) > 1 and not sys.argv[1].startswith("-") and "." not in sys.argv[1]:
        pictures = pathlib.Path(sys.argv.pop(1))
        pictures.mkdir(exist_ok=True)
    scene = tools.make_scene()
    unittest.main(verbosity=2)
