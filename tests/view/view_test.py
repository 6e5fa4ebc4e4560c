"""The page of gridview, driven by headless Chromium.

view_test.py BIN_FOLDER [SCREENSHOT_FOLDER]
"""
import contextlib
import json
import math
import os
import pathlib
import random
import re
import shlex
import shutil
import struct
import subprocess
import sys
import time
import unittest
import urllib.error

from gridview_run import Gridview, Tools, skip, wait_until

try:
    from selenium import webdriver
    from selenium.webdriver.chrome.options import Options
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.common.actions import interaction
    from selenium.webdriver.common.actions.action_builder import ActionBuilder
    from selenium.webdriver.common.actions.pointer_input import PointerInput
    from selenium.webdriver.common.actions.wheel_input import ScrollOrigin
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
except ImportError:
    skip("Selenium for Python isn't installed (python3-selenium)")

CHROMIUM, DRIVER = shutil.which("chromium"), shutil.which("chromedriver")
if not CHROMIUM or not DRIVER:
    skip("Chromium or its driver isn't installed (chromium, chromium-driver)")

tools = None
scene = None
hierarchy = None
structures = None
pictures = None


def open_browser():
    options = Options()
    options.binary_location = CHROMIUM
    # Containers have little shared memory; Chromium's sandbox doesn't run as root.
    for argument in ["--headless=new", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars", "--no-first-run",
                     "--disable-quic", "--disable-background-networking", "--disable-component-update", "--disable-sync"]:
        options.add_argument(argument)
    if os.geteuid() == 0:
        options.add_argument("--no-sandbox")
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    return webdriver.Chrome(service=Service(DRIVER), options=options)


def resize(browser, width, height):
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False})


def load(browser, address):
    """Anew, though another part of the same page may be shown."""
    browser.get("about:blank")
    browser.get(address)


def read_pfm(path):
    """Rows from the top of (r, g, b), or of numbers."""
    data = path.read_bytes()
    match = re.match(rb"P([Ff])\n(\d+) (\d+)\n-1.0\n", data)
    width, height, numbers = int(match[2]), int(match[3]), 3 if match[1] == b"F" else 1
    values = struct.unpack(f"<{numbers * width * height}f", data[match.end():])
    rows = [values[numbers * width * y:numbers * width * (y + 1)] for y in range(height)]
    return width, height, rows[::-1]


def cost(printed, a=1, b=1, step=None):
    """a · tests + b · steps of a walk that gridtrace printed, up to a step; a node is the eight boxes that it tests."""
    steps = printed["steps"][:None if step is None else step + 1]
    per_step = 8 if steps and steps[0]["node"] else 1
    return a * sum(len(one["tests"]) for one in steps) + b * per_step * len(steps)


def counted(count, what):
    return f"{count} {what}{'' if count == 1 else 's'}"


def without(one, *names):
    return {key: value for key, value in one.items() if key not in names}


def what_of(grid):
    return "node" if grid.endswith("_bvh.grid") else "cell"


def counts_of(printed, what):
    """Of a walk that gridtrace printed."""
    return f"{counted(printed['cells'], what)}, {counted(printed['tests'], 'test')}"


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
        self.address = f"http://127.0.0.1:{self.server.port}/"
        self.show()
        self.logs()

    def tearDown(self):
        for url in self.requests():
            self.assertTrue(url.startswith((self.address, "data:", "blob:", "about:")), url)

    # --- What tests do ---

    def show(self, width=860, height=420, dark=False, fragment="", server=None):
        resize(self.browser, width, height)
        self.browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}]})
        self.open((server or self.server).address + fragment)

    def js(self, script, *arguments):
        return self.browser.execute_script(script, *arguments)

    def change(self, script, *arguments):
        self.js(script, *arguments)
        self.wait_sharp()

    def open(self, address, wait=None):
        load(self.browser, address)
        (wait or self.wait_sharp)()

    def wait_sharp(self):
        wait_until(lambda: self.js("return panes.length > 0 && panes.every((pane) => pane.root.dataset.state === 'sharp' && "
                                   "pane.frame.isSharp && Camera.same(pane.frame.view.camera, pane.camera(pane.frame.view.width, pane.frame.view.height)) && "
                                   "pane.frame.view.channel === pane.settings.channel && pane.frame.view.grid === pane.settings.grid)"),
                   "every picture is sharp", 120)
        self.take_picture()

    @contextlib.contextmanager
    def serving(self, *files, **options):
        """gridview with other files; afterwards its page is left."""
        with Gridview(tools, *files, "-q", **options) as server:
            yield server
            self.leave()

    def logs(self):
        return [json.loads(entry["message"])["message"] for entry in self.browser.get_log("performance")], self.browser.get_log("browser")

    def leave(self):
        """What the page asks for or says from now on isn't looked at."""
        self.browser.get("about:blank")
        self.logs()

    def open_file(self, path):
        """The address of a page, which is the only one that may be asked for from now on."""
        self.leave()
        self.address = path.as_uri()
        return self.address

    def export(self, name, *words):
        """The address of the page that gridview writes."""
        tools.run("gridview", *words, "--export", name, "-q")
        return self.open_file(tools.folder / name)

    def requests(self):
        """Addresses that were asked for since the last look; there is no message on the console."""
        events, console = self.logs()
        self.assertEqual([entry["message"] for entry in console], [])
        return [event["params"]["request"]["url"] for event in events if event["method"] == "Network.requestWillBeSent"]

    def chance(self):
        seed = int(os.environ.get("MASU_TEST_SEED", time.time_ns() % 10**9))
        print(f"seed {seed}", end=" ", file=sys.stderr, flush=True)
        return random.Random(seed)

    def assert_statistics(self, server, index, grid, *but):
        """They are those of gridstat, which may be of another build."""
        printed = json.loads(tools.run("gridstat", grid, "--json", "--histogram"))
        served = json.loads(server.get(f"/api/statistics?grid={index}"))
        self.assertEqual(without(served, "commit", *but), without(printed, "commit", *but))

    def assert_values(self, picture, pane=0):
        """Those of a picture are in a file that gridrender wrote; the canvas has its size."""
        width, height, rows = read_pfm(tools.folder / picture)
        self.assertEqual(self.pixels(pane)[:2], [width, height])
        values = self.js("return Array.from(panes[arguments[0]].picture.values.data, (value) => Number.isFinite(value) ? value : 1e38)", pane)
        self.assertEqual(values, [min(value, 1e38) for row in rows for value in row])

    def assert_near(self, numbers, wanted, delta=None):
        for number, one in zip(numbers, wanted):
            self.assertAlmostEqual(number, one, delta=delta)

    def assert_fits(self, width):
        """Nothing sticks out of the page."""
        self.assertLessEqual(self.js("return document.scrollingElement.scrollWidth"), width)
        wide = self.js("const w = innerWidth; return [...document.querySelectorAll('main *, header *')].filter((e) => e.getBoundingClientRect().right > w + 1 && "
                       "!e.closest('.scroll') && e.getClientRects().length > 0).map((e) => e.outerHTML.slice(0, 80))")
        self.assertEqual(wide, [], width)

    def take_picture(self):
        """Wherever the page has come to rest."""
        if pictures:
            self.browser.save_screenshot(str(pictures / f"{len(os.listdir(pictures)):03}-{self.id()}.png"))

    def find(self, selector):
        return self.browser.find_element(By.CSS_SELECTOR, selector)

    def find_all(self, selector):
        return self.browser.find_elements(By.CSS_SELECTOR, selector)

    def select(self, selector, value):
        self.js("const s = document.querySelector(arguments[0]); s.value = arguments[1]; s.dispatchEvent(new Event('change'))", selector, value)

    def keys(self, *keys):
        ActionChains(self.browser).send_keys(*keys).perform()

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
        ActionChains(self.browser).scroll_from_origin(ScrollOrigin.from_element(stage), 0, -300).perform()
        wait_until(lambda: distance(self.camera()) < distance(panned), "it zooms")
        self.wait_sharp()
        wait_until(lambda: "from=" in self.js("return location.hash"), "the address holds the view")

    # --- What walks' tests do ---

    def pick(self, x, y, pane=0):
        """A click so many pixels from the middle of a picture."""
        stage = self.find_all(".stage")[pane]
        self.js("walkPanel.clear()")
        ActionChains(self.browser).move_to_element_with_offset(stage, x, y).click().perform()
        self.wait_walk()

    def wait_walk(self):
        wait_until(lambda: self.js("return walkPanel.drawn === state.panes.map((pane) => pane.grid).join() && "
                                   "panes.every((pane) => !pane.walkCounts.hidden)"), "the ray's walk through each grid")
        self.take_picture()

    def walk(self):
        """What the page shows of the ray in each picture: [{grid, counts, table, boxes}]; boxes as they are drawn."""
        return self.js("""
          const drawn = new Map(), old = Overlay.prototype.boxes;
          Overlay.prototype.boxes = function(boxes, ...rest) { drawn.set(this, [...drawn.get(this) || [], boxes]); old.call(this, boxes, ...rest); };
          drawOverlays();
          Overlay.prototype.boxes = old;
          const rows = [...document.querySelectorAll('#walk > table tbody tr')].map((row) => [...row.cells].map((cell) => cell.textContent));
          return panes.map((pane, i) => ({grid: state.scene.grids[pane.settings.grid].path, counts: pane.walkCounts.textContent,
            table: rows.map((row) => row[i + 1]), boxes: (drawn.get(pane.overlay) || [])[0] || null}));""")

    def listed(self):
        """The rows of the walk that is listed: [[cell, voxels, t in, t out, tests]]."""
        return self.js("return [...document.querySelectorAll('.walk-steps tbody tr')].map((row) => [...row.cells].map((cell) => cell.textContent))")

    def printed(self, grid, index=0):
        """The page's ray as gridtrace walks it through a grid."""
        ray = self.js("return walkPanel.ray")
        numbers = ",".join(map(repr, ray["origin"] + ray["direction"]))
        more = ["--all-rays", "--depth", ray["depth"]] if ray["all"] else []
        return json.loads(tools.run("gridtrace", scene[0], grid, f"--ray={numbers}", *more, "--json", "-q"))["rays"][index]

    def assert_shows(self, grids, index=0, cells_drawn=True):
        """Each picture's counts, and the boxes of cells or nodes drawn in it, are those of the walk that gridtrace prints, which is returned."""
        walks, shown = [self.printed(grid, index) for grid in grids], self.walk()
        self.assertEqual([one["grid"] for one in shown], grids)
        for grid, printed, one in zip(grids, walks, shown):
            self.assertEqual(one["counts"], counts_of(printed, what_of(grid)))
            self.assertEqual(one["table"], [str(printed["cells"]), str(printed["tests"]), str(cost(printed))])
            if cells_drawn:
                self.assertEqual(one["boxes"], [step["box"] for step in printed["steps"]])
        return walks

    def assert_lists(self, printed):
        voxels = lambda box: " ".join(str(a) if a == b - 1 else f"{a}–{b - 1}" for a, b in zip(box["first"], box["end"]))
        boxes = lambda node: " · ".join(str(node[f"boxes_{name}"]) for name in ("met", "missed", "beyond"))
        place = lambda step: [str(step["node"]["index"]), str(step["node"]["depth"]), boxes(step["node"])] if step["node"] else [voxels(step["voxels"])]
        hit = lambda step: " hit" if any(test["kept"] for test in step["tests"]) else ""
        self.assertEqual([[*row[:-3], row[-1]] for row in self.listed()],
                         [[str(i), *place(step), f"{len(step['tests'])}{hit(step)}"] for i, step in enumerate(printed["steps"])])

    # --- Tests ---

    def test_an_address_opens_the_same_view(self):
        self.change("setCamera(Camera.orbited(state.camera, 0.5, 0.1)); panes[0].set({channel: 'depth', cells: 'slice'}); toggleCompare()")
        fragment, camera = self.js("return fragment()"), self.camera()
        self.show(fragment=fragment)
        self.assertEqual(self.camera(), camera)
        self.assertEqual(self.js("return state.panes"), [dict(grid=0, channel="depth", cells="slice"), dict(grid=1, channel="depth", cells="slice")])
        for damaged in ["#from=1,2&at=x&angle=999&grid=none&channel=none&slice=q,7&ray=1,2,3,0,0,0&walk=9,-1&depth=-1", "#ray=1,2,3,4,5,nan", "#ray=,,,,,", "#from=0,0,0&at=0,0,0", "#" + "a" * 5000]:
            self.show(fragment=damaged)  # the scene's own camera, for what makes no sense
            self.assertEqual(self.camera()["angle"], 45)

    def test_a_picked_pixels_walk_is_that_of_gridtrace(self):
        for dx, dy in [(0, 0), (-60, 40), (150, -120)]:
            self.pick(dx, dy)
            pixel, walk = self.js("return [walkPanel.pixel, walkPanel.walk]")
            self.assertEqual(len(self.listed()), len(walk["rays"][0]["steps"]))
            command = [word for word in shlex.split(self.js("return command()")) if word not in ("-o", "picture.png")]
            printed = json.loads(tools.run("gridtrace", *command[1:], "--sampling", "centers", "--pixel", f"{pixel['x']},{pixel['y']}", "--json"))
            self.assertEqual(printed["rays"], walk["rays"])
        panel = self.js("const r = document.getElementById('walk').getBoundingClientRect(); return [r.left, r.right]")
        for left, right in self.js("return [...document.querySelectorAll('#walk .value')].map((e) => { const r = e.getBoundingClientRect(); return [r.left, r.right]; })"):
            self.assertTrue(panel[0] <= left < right <= panel[1] + 1, "the ray's figures are in their panel")
        steps = len(walk["rays"][0]["steps"])
        self.js("walkPanel.select(0)")
        self.find(".walk-steps tbody tr:last-child").click()
        self.assertEqual(self.js("return walkPanel.step"), steps - 1)

    def test_the_same_ray_is_walked_through_each_grid_in_its_own_picture(self):
        self.show(1280, 640)
        self.change("toggleCompare(); for (const pane of panes) pane.set({cells: 'ray'})")
        for pane, x, y in [(0, 0, 0), (1, -30, 60), (0, 60, -90)]:
            self.pick(x, y, pane)
            printed = self.assert_shows(scene[1:])
            self.assertNotEqual(printed[0]["steps"], printed[1]["steps"])
            self.assert_lists(printed[pane])
            self.select(".walk-pane", 1 - pane)
            self.assert_lists(printed[1 - pane])
        # The grids change places; the ray stays.
        ray = self.js("return walkPanel.ray")
        self.change("panes[0].set({grid: 1}); panes[1].set({grid: 0}); setCamera(Camera.orbited(state.camera, 0.4, 0.1))")
        self.wait_walk()
        self.assertEqual(self.js("return walkPanel.ray"), ray)
        self.assertEqual(self.assert_shows([scene[2], scene[1]]), printed[::-1])
        # And with the rays that it spawns.
        self.find("#walk-all").click()
        self.wait_walk()
        rays = len(self.find_all(".walk-ray option"))
        self.assertGreater(rays, 3)
        for index in [0, 1, rays - 1]:
            self.select(".walk-ray", index)
            self.assert_shows([scene[2], scene[1]], index)
        self.change("toggleCompare()")
        self.wait_walk()
        self.assert_lists(*self.assert_shows([scene[2]], rays - 1))
        self.find("#walk-all").click()

    def test_a_link_reopens_the_walk_of_the_same_ray_through_its_grid_at_its_step(self):
        self.show(1280, 640)
        self.change("toggleCompare(); for (const pane of panes) pane.set({cells: 'ray'})")
        self.pick(0, 30, 1)
        self.find("#walk-all").click()
        self.wait_walk()
        index = self.js("return walkPanel.walk.rays.findIndex((ray) => ray.kind === 'shadow' && ray.cells > 3)")
        self.assertGreater(index, 0)
        self.select(".walk-ray", index)
        for _ in range(2):
            self.find("#walk .controls button").click()
        look = "return [walkPanel.ray, walkPanel.pane, walkPanel.index, walkPanel.step, walkPanel.current, document.querySelector('[aria-selected=true]').dataset.step]"
        for camera in ["state.camera", "Camera.orbited(state.camera, 0.7, 0.2)"]:
            self.change(f"setCamera({camera})")
            before, shown, listed, fragment = self.js(look), self.walk(), self.listed(), self.js("return fragment()")
            self.assertEqual([before[1], before[2], before[3]], [1, index, before[4]["cells"] - 3])
            for width, height in [(860, 420), (1280, 800), (400, 700)]:
                self.show(width, height, fragment=fragment)
                self.wait_walk()
                self.assertEqual(self.js(look), before)
                self.assertEqual(self.walk(), shown)
                self.assertEqual(self.listed(), listed)
                self.assertEqual(self.js("return fragment()"), fragment)
            self.assert_lists(self.assert_shows(scene[1:], index)[1])
        # Pasted into the page that is open.
        self.show()
        self.js("location.hash = arguments[0]", fragment)
        wait_until(lambda: len(self.js("return state.panes")) == 2, "two pictures")
        self.wait_walk()
        self.assertEqual(self.js(look), before)
        self.find("#walk-all").click()
        self.js("location.hash = arguments[0]", f"#grid={scene[1]}")
        wait_until(lambda: self.js("return panes.length") == 1, "one picture")
        self.wait_sharp()

    def test_a_link_tells_grids_of_one_name_apart(self):
        grids = []
        for folder, grid in zip(["a", "b", "c"], [scene[1], scene[2], scene[2]]):
            (tools.folder / folder).mkdir(exist_ok=True)
            grids.append(f"{folder}/{'one, two' if folder == 'c' else 'one'}.grid")
            shutil.copy(tools.folder / grid, tools.folder / grids[-1])
        with self.serving(scene[0], *grids) as server:
            self.show(server=server)
            for first, second in [(1, 0), (2, 0)]:
                self.change("state.panes = [{grid: arguments[0], channel: 'cells', cells: 'ray'}, {grid: arguments[1], channel: 'cells', cells: 'none'}]; update()", first, second)
                self.show(fragment=self.js("return fragment()"), server=server)
                shown = self.js("return state.panes.map((pane) => state.scene.grids[pane.grid].hash)")
                self.assertEqual(shown, [self.js("return state.scene.grids[arguments[0]].hash", grid) for grid in (first, second)])

    def test_a_walk_of_too_many_rays_says_how_many_more(self):
        glass = tools.make_nested_glass()
        with self.serving(*glass) as server:
            self.show(server=server)
            for depth, more in [(5, None), (12, False), (32, True)]:
                self.js("state.depth = arguments[0]; document.getElementById('walk-all').checked = true; update()", depth)
                self.pick(0, 0)
                notes = [note.text for note in self.find_all(".walk-more")]
                rays, count = self.js("return [walkPanel.walk.rays.length, walkPanel.walk.more_rays]")
                if more is None:
                    self.assertEqual(notes, [])
                else:
                    self.assertEqual(rays, 1000)
                    number = f"{count:,}".replace(",", "\u2009")
                    self.assertEqual(notes, [f"and {'more than ' if more else ''}{number} more rays, which aren’t listed"])
                if not more:
                    ray = self.js("return [...walkPanel.ray.origin, ...walkPanel.ray.direction].join()")
                    printed = json.loads(tools.run("gridtrace", *glass, f"--ray={ray}", "--all-rays", "--depth", depth, "--json", "-q"))
                    self.assertEqual(len(printed["rays"]), rays + count)
                    self.assertEqual(printed["rays"][:rays], self.js("return walkPanel.walk.rays"))

    def test_the_copied_command_of_a_channel_writes_its_values(self):
        for channel in ["cells", "all tests", "depth", "idle"]:
            self.change("panes[0].set({channel: arguments[0]})", channel)
            tools.run(*shlex.split(self.js("return command()")), "-q")
            self.assert_values(f"picture.{channel.split()[-1]}.pfm")

    def test_a_channel_has_one_scale_linear_or_logarithmic_and_its_values_are_shown(self):
        self.show(1280, 640)
        self.change("toggleCompare(); for (const pane of panes) pane.set({channel: 'all tests'})")
        kinds = []
        for kind in ["linear", "logarithmic", "automatic"]:
            self.keys("l")
            low, high, is_logarithmic = self.js("const {low, high, isLogarithmic} = scales.of('all tests'); return [low, high, isLogarithmic]")
            self.assertEqual(self.js("return scales.kind"), kind)
            if kind != "automatic":
                self.assertEqual(is_logarithmic, kind == "logarithmic")
            self.assertEqual(low, 0)
            samples = [tuple(int(color[i:i + 2], 16) for i in (1, 3, 5)) for color in self.js("return state.scene.colors")]
            for pane in range(2):
                width, height, got = self.pixels(pane)
                values = self.js("return Array.from(panes[arguments[0]].picture.values.data)", pane)
                for at in range(0, width * height, 997):
                    share = math.log1p(values[at]) / math.log1p(high) if is_logarithmic else values[at] / high
                    wanted = samples[round((len(samples) - 1) * min(1, share))]
                    self.assertLess(max(abs(got[4 * at + c] - wanted[c]) for c in range(3)), 14, "colours between samples")
            kinds.append((got, [scale.is_displayed() for scale in self.find_all(".scale")]))
        self.assertNotEqual(kinds[0][0], kinds[1][0])
        self.assertEqual([one[1] for one in kinds], [[True, False]] * 3)
        # Under the pointer, in both pictures, and under the cross hair.
        stage = self.find(".stage")
        ActionChains(self.browser).move_to_element_with_offset(stage, 30, 20).perform()
        shown = [value.text for value in self.find_all(".under-pointer")]
        values = self.js("return panes.map(({picture: {values: {width, height, data}}}) => data[Math.floor(state.pointer.y * height) * width + Math.floor(state.pointer.x * width)])")
        self.assertEqual(shown, ["all tests " + f"{round(value):,}".replace(",", "\u2009") for value in values])
        self.assertEqual(self.js("return [panes[0].stage.clientWidth, panes[0].stage.clientHeight]"), self.pixels()[:2])
        self.keys("l")
        fragment = self.js("return fragment()")
        self.show(1280, 640, fragment=fragment)
        self.assertEqual(self.js("return scales.kind"), "linear")

    def test_channels(self):
        names = self.js("return state.scene.channels")
        self.assertGreater(len(names), 5)
        seen = []
        for name in names:
            self.select(".channel", name)
            self.wait_sharp()
            picture = self.pixels()
            self.assertNotIn(picture, seen, name)
            seen.append(picture)
            is_number = name in ("depth", "cells", "tests", "idle", "all cells", "all tests", "cut")
            self.assertEqual(self.find(".scale").is_displayed(), is_number, name)

    def test_a_cut_shows_what_lies_behind_the_plane(self):
        choice = self.chance()
        met = 0
        for axis, grid in [(0, 1), (1, 0), (2, 0)]:
            self.show(fragment=f"#grid={scene[1 + grid]}&channel=cut&slice={'xyz'[axis]},{choice.uniform(0.4, 0.6)}")
            self.change("setCamera(Camera.orbited(state.camera, arguments[0], 0))", choice.uniform(-3, 3))
            wait_until(lambda: self.js("return slicePanel.of(panes[0].settings.grid) && !slicePanel.isLoading"), "the slice")
            width, height, got = self.pixels()
            plane = self.js("return slicePanel.of(panes[0].settings.grid)")
            view = self.js("const {from, at, up, angle} = panes[0].camera(arguments[0], arguments[1]); return `from=${from}&at=${at}&up=${up}&angle=${angle}`", width, height)
            pixels = [(choice.randrange(width), choice.randrange(height)) for _ in range(60)]
            rays = [json.loads(self.server.get(f"/api/ray?{view}&width={width}&height={height}&x={x}&y={y}")) for x, y in pixels]
            lines = ["ox,oy,oz,dx,dy,dz,tmin,tmax"]
            for ray in rays:
                ahead = (plane["position"] - ray["origin"][axis]) / ray["direction"][axis]
                lines.append(",".join(map(repr, [*ray["origin"], *ray["direction"], *([ahead, 1e30] if ahead >= 0 else [0, -1])])))
            (tools.folder / "rays.csv").write_text("\n".join(lines) + "\n")
            tools.run("gridtrace", *scene[:2], "rays.csv", "-o", "hits.csv", "--write", "object,normal", "-q")
            for (x, y), ray, line in zip(pixels, rays, (tools.folder / "hits.csv").read_text().splitlines()[1:]):
                name, *normal = map(float, line.split(","))
                met += name >= 0
                light = 0.3 + 0.7 * abs(sum(a * b for a, b in zip(normal, ray["direction"])))
                wanted = [light * lightest for lightest in (236, 229, 214)] if name >= 0 else [255] * 3
                # At edges JPEG mixes neighbours' colours.
                around = [[got[4 * (v * width + u) + c] for c in range(3)] for v in range(max(0, y - 3), min(height, y + 4)) for u in range(max(0, x - 3), min(width, x + 4))]
                nearest = min(max(abs(a - b) for a, b in zip(color, wanted)) for color in around)
                self.assertLess(nearest, 24, (x, y, axis, name))
            most = self.js("return slicePanel.most()")
            self.assertEqual(self.find(".scale").text.replace("\u2009", "").split(), ["references", "1", f"{most},", "log"])
            tools.run(*shlex.split(self.js("return command()")))
        self.assertGreater(met, 20)

    def test_two_grids_side_by_side(self):
        self.find("#compare").click()
        self.wait_sharp()
        self.assertEqual(self.js("return state.panes.map((pane) => pane.grid)"), [0, 1])
        # The picture doesn't depend on the grid.
        sizes = [self.pixels(0)[:2], self.pixels(1)[:2]]
        self.assertEqual(sizes[0], sizes[1])
        self.assertEqual(self.pixels(0)[2], self.pixels(1)[2])
        wait_until(lambda: len(self.find_all("#cost td.better")) > 1, "costs of both")
        self.change("for (const pane of panes) pane.set({channel: 'cells'})")
        self.assertNotEqual(self.pixels(0)[2], self.pixels(1)[2])
        self.find("#compare").click()
        self.wait_sharp()
        self.assertEqual(len(self.find_all(".picture")), 1)

    def test_slices_over_the_picture(self):
        self.js("document.getElementById('slice-panel').open = true; panes[0].set({cells: 'slice'})")
        for axis in range(3):
            self.select("#slice select", axis)
            wait_until(lambda: self.js("return slicePanel.of(0) && slicePanel.of(0).axis") == axis, "the slice along another axis")
            self.assertGreater(len(self.js("return slicePanel.of(0).cells")), 0)
        self.wait_sharp()
        drawn = self.js("const c = panes[0].overlay.canvas; return c.getContext('2d').getImageData(0, 0, c.width, c.height).data.some((value) => value > 0)")
        self.assertTrue(drawn)
        # Of a uniform grid with the empty cells: they fill the layer.
        self.js("panes[0].set({grid: 1})")
        wait_until(lambda: self.js("return slicePanel.of(1)"), "the uniform grid's slice")
        slice_ = self.js("return slicePanel.of(1)")
        self.assertEqual(len(slice_["cells"]), slice_["voxels"][0] * slice_["voxels"][1])
        self.assertFalse(slice_["without_empty"])

    # --- The plane ---

    def wait_plane(self):
        wait_until(lambda: self.js("return state.plane && planeView.plots.length === state.plane.length && !planeView.isFollowing && "
                                   "planeView.plots.every((plot) => plot.slice) && planeView.grids.every((grid) => walkPanel.rayOf(grid)) && "
                                   "planeView.last.rays.every((ray, i) => ray === walkPanel.rayOf(planeView.grids[i]))"), "the ray's walks in the plane")
        self.take_picture()

    def change_plane(self, script, *arguments):
        self.js(script, *arguments)
        self.wait_plane()

    def show_plane(self, server, width=1280, height=800, dark=False, fragment="#view=plane"):
        self.show(width, height, dark, "#", server)
        self.js("location.hash = arguments[0]", fragment)
        wait_until(lambda: self.js("return state.plane"), "the plane")
        self.wait_plane()

    def in_plane(self, plot=0):
        """Of the ray's origin and end, pixels from a slice's middle."""
        return self.js("""const {canvas, slice, pixel} = planeView.plots[arguments[0]], at = planeView.plots[arguments[0]].window(slice, planeView.zoom);
          return ['from', 'to'].map((name) => [(at.x(planeView.ends[name][0]) - canvas.width / 2) / pixel, (at.y(planeView.ends[name][1]) - canvas.height / 2) / pixel]);""", plot)

    def drag(self, plot, start, to, touch=False):
        canvas = self.find_all("canvas.slice")[plot]
        pointer = PointerInput(interaction.POINTER_TOUCH, "finger") if touch else PointerInput(interaction.POINTER_MOUSE, "mouse")
        actions = ActionBuilder(self.browser, mouse=pointer)
        actions.pointer_action.move_to(canvas, *map(round, start)).pointer_down()
        for share in (0.5, 1):
            actions.pointer_action.move_to(canvas, *(round(a + share * (b - a)) for a, b in zip(start, to)))
        actions.pointer_action.pointer_up()
        actions.perform()
        self.wait_plane()

    def assert_walks_in_plane(self, grids):
        """Counts, in the end and at each step, and the table are those of gridtrace."""
        printed, whats = [self.printed(grid) for grid in grids], [what_of(grid) for grid in grids]
        alls = [counts_of(one, what) for one, what in zip(printed, whats)]
        shown = lambda: self.js("return planeView.plots.map((plot) => plot.counts.textContent)")
        self.assertEqual(shown(), alls)
        rows = self.js("return [...document.querySelectorAll('#walk > table tbody tr')].map((row) => [...row.cells].slice(1, 1 + planeView.grids.length).map((cell) => cell.textContent))")
        self.assertEqual(rows, [[str(one["cells"]) for one in printed], [str(one["tests"]) for one in printed], [str(cost(one)) for one in printed]])
        last = max(len(one["steps"]) for one in printed) - 1
        for step in sorted({0, last // 2, max(0, last - 1)}):
            self.js("walkPanel.select(arguments[0])", step)
            wanted = []
            for one, what, all_ in zip(printed, whats, alls):
                steps = one["steps"]
                if step >= len(steps) - 1:
                    wanted.append(f"{all_}: ended" if len(steps) - 1 < step < last else all_)
                else:
                    so_far = sum(len(s["tests"]) for s in steps[:step + 1])
                    wanted.append(f"{what} {step + 1} of {one['cells']}: {counted(len(steps[step]['tests']), 'test')}, {so_far} so far")
                    if node := steps[step]["node"]:
                        wanted[-1] += f"; boxes: {node['boxes_met']} met, {node['boxes_missed']} missed, {node['boxes_beyond']} beyond the hit"
            self.assertEqual(shown(), wanted)
            # Of a node's boxes the plane cuts all that the ray meets.
            for plot, one in enumerate(printed):
                node = one["steps"][min(step, len(one["steps"]) - 1)]["node"] if one["steps"] else None
                if node:
                    met = self.js("""const plot = planeView.plots[arguments[0]], grid = planeView.grids[arguments[0]], ray = walkPanel.rayOf(grid);
                      return plot.fates(plot.slice, slicePanel.cellsOf(grid), ray, Math.min(arguments[1], ray.steps.length - 1)).met.length""", plot, step)
                    self.assertEqual(met, node["boxes_met"])
        self.js("walkPanel.select(walkPanel.lastStep)")

    def assert_sentences(self, grids):
        """What the plane says of each step, by the numbers of gridtrace: which hit is known, and why the walk goes on."""
        number = lambda text: float(text.replace("\u2009", ""))
        for plot, grid in enumerate(grids):
            printed, hit = self.printed(grid), None
            for i, step in enumerate(printed["steps"]):
                self.js("walkPanel.select(arguments[0])", i)
                text = self.js("return planeView.plots[arguments[0]].sentence.textContent", plot)
                kept = [test["t"] for test in step["tests"] if test["kept"]]
                hit = kept[-1] if kept else hit
                self.assertTrue(text.startswith(f"{'node' if step['node'] else 'cell'} {i + 1}: "), text)
                self.assertIn(f"{len(step['tests'])} test{'' if len(step['tests']) == 1 else 's'}", text)
                if node := step["node"]:
                    self.assertIn(f"{node['boxes_met']} of {node['boxes_met'] + node['boxes_missed'] + node['boxes_beyond']} boxes met", text)
                    self.assertEqual(f"{node['boxes_beyond']} beyond the hit" in text, node["boxes_beyond"] > 0)
                self.assertEqual("new hit" in text, bool(kept), text)
                if at := re.search(r"hit at ([\d.]+)", text):
                    self.assertAlmostEqual(number(at[1]), hit, delta=0.01 * hit)
                self.assertEqual("go on" in text, i < len(printed["steps"]) - 1, text)
                if end := re.search(r"beyond this cell’s end, ([\d.]+)", text):
                    self.assertAlmostEqual(number(end[1]), step["exit"], delta=0.01 * step["exit"])
                    self.assertGreater(hit, step["exit"])
                self.assertEqual("no hit yet" in text, hit is None and i < len(printed["steps"]) - 1, text)
        self.js("walkPanel.select(walkPanel.lastStep)")

    def test_a_ray_is_dragged_through_slices_of_every_structure(self):
        choice = self.chance()
        grids = [*scene[1:], "balance.grid", hierarchy]
        with self.serving(scene[0], *grids) as server:
            self.show_plane(server, fragment="#view=plane&slice=y,0.5")
            self.assert_walks_in_plane(grids)
            box = self.js("const c = planeView.plots[0].canvas; return [c.clientWidth / 2 - 20, c.clientHeight / 2 - 20]")
            for touch in (False, True):
                for end in (1, 0, "both"):
                    plot, before = choice.randrange(4), self.js("return walkPanel.ray")
                    ends = self.in_plane(plot)
                    if end == "both" and math.dist(*ends) < 120:
                        continue  # its middle is too near to an end
                    start = [(a + b) / 2 for a, b in zip(*ends)] if end == "both" else ends[end]
                    if end == "both":
                        places = ([a + choice.uniform(-15, 15) for a in start] for _ in range(10**4))
                    else:  # not so near to the other end that the next drag might take either
                        places = ([choice.uniform(-side, side) for side in box] for _ in range(10**4))
                        places = (at for at in places if math.dist(at, ends[1 - end]) > 60)
                    to = next(at for at in places if math.dist(at, start) > 8)  # farther than a click may move
                    self.drag(plot, start, to, touch)
                    ray = self.js("return walkPanel.ray")
                    self.assertNotEqual(ray, before)
                    if end == 0:
                        self.assertNotEqual(ray["origin"], before["origin"])
                    if end == "both":
                        self.assert_near(ray["direction"], before["direction"])
                    self.assert_walks_in_plane(grids)
            # Keys: the ray's end and its origin, steps, zoom.
            self.js("planeView.plots[0].canvas.focus()")
            before = self.js("return planeView.ends")
            self.keys(Keys.ARROW_LEFT)
            self.wait_plane()
            self.assertLess(self.js("return planeView.ends.to[0]"), before["to"][0])
            self.js("planeView.plots[0].canvas.dispatchEvent(new KeyboardEvent('keydown', {key: 'ArrowUp', shiftKey: true, bubbles: true}))")
            self.wait_plane()
            self.assertGreater(self.js("return planeView.ends.from[1]"), before["from"][1])
            self.assert_walks_in_plane(grids)
            last = self.js("return walkPanel.lastStep")
            self.keys(",")
            self.assertEqual(self.js("return walkPanel.step"), max(0, last - 1))
            self.keys(".", "+", "+")
            self.assertAlmostEqual(self.js("return planeView.zoom.scale"), 1.25 ** 2)
            self.keys("0")
            self.assertIsNone(self.js("return planeView.zoom"))
            # The wheel zooms about the pointer, in all slices.
            canvas = self.find("canvas.slice")
            under = "const p = planeView.plots[0], at = p.window(p.slice, planeView.zoom); return [at.u(p.canvas.width / 2 + 50 * p.pixel), at.v(p.canvas.height / 2 + 30 * p.pixel)]"
            place = self.js(under)
            ActionChains(self.browser).scroll_from_origin(ScrollOrigin.from_element(canvas, 50, 30), 0, -400).perform()
            wait_until(lambda: self.js("return planeView.zoom"), "it zooms")
            self.assert_near(self.js(under), place, 0.02)
            # What is under the pointer.
            ActionChains(self.browser).move_to_element(canvas).perform()
            self.assertRegex(self.find(".plots .status").text, r"^x .*, z .*: voxels \d")
            # A link reopens the plane, the ray and the step; another plane has the same ray.
            self.js("walkPanel.select(Math.min(1, walkPanel.lastStep))")
            look = "return [state.plane, state.slice, planeView.ends, walkPanel.ray, walkPanel.step, planeView.plots.map((plot) => plot.counts.textContent)]"
            before, fragment = self.js(look), self.js("return fragment()")
            self.show_plane(server, 1000, 700, fragment=fragment)
            self.assertEqual(self.js(look), before)
            self.js("slicePanel.set({share: 0.37})")
            wait_until(lambda: self.js("return planeView.slice.position === walkPanel.ray.origin[1]") and self.js("return planeView.slice.position") != before[3]["origin"][1], "the ray in another plane")
            self.wait_plane()
            self.assertEqual(self.js("return planeView.ends"), before[2])
            self.assert_walks_in_plane(grids)
            # Other structures, and back to the pictures.
            self.change_plane("planeView.choose(0, 3)")
            self.assert_walks_in_plane([grids[3], *grids[1:]])
            for width, height in [(400, 800), (1280, 800), (1920, 1080)]:
                for dark in (False, True):
                    self.show_plane(server, width, height, dark)
                    self.assert_fits(width)
            self.js("document.activeElement.blur()")
            self.keys("p")
            self.wait_sharp()
            self.assertIsNone(self.js("return walkPanel.ray"))
            self.change_plane("setCamera(Camera.orbited(state.camera, 0.1, 0)); showCost(); togglePlane()")  # before the next frame

    def test_a_hierarchy_beside_a_grid(self):
        names = [scene[1], hierarchy]
        with self.serving(scene[0], *names) as server:
            self.show(1280, 900, server=server, fragment=f"#grid={','.join(names)}&channel=cells,cells")
            # One range and one colour bar.
            highest = self.js("return Math.max(...panes.map((pane) => pane.span.high))")
            self.assertGreaterEqual(self.js("return scales.of('cells').high"), highest)
            self.assertEqual([scale.is_displayed() for scale in self.find_all(".scale")], [True, False])
            # The walk: nodes, and what became of their boxes.
            self.js("for (const pane of panes) pane.set({cells: 'ray'})")
            for pane, x, y in [(1, 0, 0), (0, 30, -60)]:
                self.pick(x, y, pane)
                printed = self.assert_shows(names)
                self.assertEqual(printed[0]["hit"], printed[1]["hit"])
                self.assert_lists(printed[pane])
            self.pick(0, 0, 1)
            cropped = self.js("return [...document.querySelectorAll('#walk .scroll, #statistics .scroll')].map((e) => e.scrollWidth - e.clientWidth)")
            self.assertEqual(cropped, [0, 0])
            # Boxes of each depth, chosen by keys.
            tools.run("gridstat", names[1], "--cells", "boxes.csv")
            boxes = [line.split(",") for line in (tools.folder / "boxes.csv").read_text().splitlines()[1:]]
            self.js("for (const pane of panes) pane.set({cells: 'boxes'})")
            self.assertTrue(self.js("return document.getElementById('slice-panel').open"))
            deepest = max(int(box[1]) for box in boxes)
            self.assertEqual(self.js("return slicePanel.depthOf(1) === null && state.scene.grids[1].greatest_depth"), deepest)
            self.js("slicePanel.depth.focus()")
            for depth in [None, *range(deepest + 1)]:
                if depth is not None:
                    self.keys(Keys.ARROW_RIGHT)
                self.assertEqual(self.js("return state.slice.depth"), depth)
                wanted = [[*map(float, box[2:8]), int(box[1])] for box in boxes if (int(box[8]) > 0 and (depth is None or int(box[1]) <= depth)) or int(box[1]) == depth]
                wait_until(lambda: self.js("return (slicePanel.boxesOf(1) || {}).count") == len(wanted), "the boxes of another depth")
                self.assertEqual(self.js("return slicePanel.boxesOf(1).boxes.map(({min, max, depth}) => [...min, ...max, depth])"), wanted)
                if depth == 1:
                    self.wait_sharp()
                    fragment = self.js("return fragment()")
            # Its slice is that of gridstat, with the grid's range of colours.
            self.change_plane("state.slice.depth = null; document.getElementById('plane').click()")
            for depth in [None, 1]:
                self.js("slicePanel.set({depth: arguments[0]})", depth)
                tools.run("gridstat", names[1], "--slice", "z=50%", "-o", "slice.json", *([] if depth is None else ["--depth", depth]))
                self.assertEqual(self.js("return slicePanel.cellsOf(1)"), json.loads((tools.folder / "slice.json").read_text())["cells"])
                most = self.js("return Math.max(...[0, 1].flatMap((grid) => slicePanel.cellsOf(grid).map((cell) => cell[4])))")
                wait_until(lambda: self.find(".slice-scale").text.split() == ["references", "1", str(most)], "one colour bar for both")
            self.assertEqual(len(self.find_all("canvas.slice")), 2)
            self.js("slicePanel.set({depth: null})")
            # The box under the pointer, those around it, and those of its node, as gridstat's slice has them.
            tools.run("gridstat", names[1], "--slice", "z=50%", "-o", "slice.json")
            cells = json.loads((tools.folder / "slice.json").read_text())["cells"]
            wait_until(lambda: self.js("return slicePanel.cellsOf(1)") == cells, "boxes of all depths")
            canvas = self.find_all("canvas.slice")[1]
            for x, y in [(0, 0), (5, -4), (-3, 6)]:
                ActionChains(self.browser).move_to_element_with_offset(canvas, x, y).perform()
                box, kin = self.js("const plot = planeView.plots[1]; return [plot.hovered, kin(plot.slice.cells, plot.hovered)]")
                around, node = [], box[7] // 8
                while node > 0:
                    around.append(next(cell for cell in cells if cell[6] == node))
                    node = around[-1][7] // 8
                self.assertEqual(kin, {"around": around, "within": [cell for cell in cells if cell[7] // 8 == box[6] > 0]})
                self.assertEqual(len(around), box[5])
                self.assertIn(f"box {box[7]}, depth {box[5]}", self.find_all(".plots .status")[1].text)
            # An address holds the depth.
            self.show(1280, 900, server=server, fragment=fragment)
            self.assertEqual(self.js("return [state.slice.depth, state.panes.map((pane) => pane.cells)]"), [1, ["boxes", "boxes"]])
            # Its statistics are those of gridstat.
            self.assert_statistics(server, 1, names[1])
            wait_until(lambda: "boxes per node" in self.find("#statistics").text and "occupied voxels" in self.find("#statistics").text, "both kinds of statistics")

    def test_statistics_are_those_of_gridstat(self):
        wait_until(lambda: self.find_all("#statistics table"), "statistics")
        for index, grid in enumerate(scene[1:]):
            self.assert_statistics(self.server, index, grid)
        self.js("document.getElementById('histogram-panel').open = true")
        self.assertGreater(len(self.find_all("#histogram rect")), 1)

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
        for wanted in ["compare", "plane", "reset", "copy-link", "copy-command", "keys", "grid", "channel", "cells"]:
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
        self.change("document.querySelectorAll('details').forEach((details) => { details.open = true; }); toggleCompare()")
        nameless = self.js("return [...document.querySelectorAll('button, select, input, canvas:not([aria-hidden]), [tabindex=\"0\"]')].filter((e) => "
                           "!(e.textContent.trim() && e.tagName === 'BUTTON') && !e.getAttribute('aria-label') && !(e.labels && e.labels.length > 0) && "
                           "!e.closest('[role=application]')).map((e) => e.outerHTML.slice(0, 90))")
        self.assertEqual(nameless, [])

    def test_widths_and_colors(self):
        for width, height in [(400, 800), (760, 900), (1000, 700), (1920, 1080)]:
            for dark in [False, True]:
                self.show(width, height, dark, fragment="#grid=" + ",".join(scene[1:]) + "&channel=shaded,cells&ray=2.1,1.3,1.7,-2.1,-1.3,-1.7")
                wait_until(lambda: self.js("return walkPanel.walk"), "a walk")
                self.js("document.querySelectorAll('details').forEach((details) => { details.open = true; })")
                wait_until(lambda: self.js("return document.querySelector('#statistics table')"), "all panels")
                self.assert_fits(width)
                colors = self.js("const s = getComputedStyle(document.body), f = getComputedStyle(document.querySelector('.facts')); return [s.backgroundColor, s.color, f.color]")
                paper, ink, faint = [tuple(map(float, re.findall(r"[\d.]+", color)[:3])) for color in colors]
                self.assertEqual(paper < (100, 100, 100), dark)
                self.assertGreater(contrast(paper, ink), 7)
                self.assertGreater(contrast(paper, faint), 4.5)
                self.js("scrollTo(0, 0)")

    def test_an_exported_page_needs_no_server(self):
        address = self.export("page.html", *scene, "--views", "3", "--size", "160x120")
        text = (tools.folder / "page.html").read_text()
        self.assertIn("default-src 'none'", text)
        self.assertNotRegex(text, r'(src|href)="(?!data:|#)[^"]*"')
        self.open(f"{address}#grid={scene[1]},{scene[2]}&channel=shaded,cells")
        self.assertEqual(self.pixels(0)[:2], [160, 120])
        before = self.pixels(0)
        self.js("panes[0].stage.focus()")
        self.keys(Keys.ARROW_RIGHT)
        self.wait_sharp()
        self.assertNotEqual(self.pixels(0), before)
        for name in self.js("return state.scene.channels"):
            self.change("panes[1].set({channel: arguments[0]})", name)
        self.js("document.querySelectorAll('details').forEach((details) => { details.open = true; })")
        wait_until(lambda: self.js("return document.querySelector('#statistics table') && "
                                   "document.querySelectorAll('#cost td.better').length > 0"), "all panels")
        self.keys(Keys.ENTER, Keys.ENTER)
        self.wait_walk()
        ray, shown = self.js("return walkPanel.ray"), self.walk()
        self.assert_shows(scene[1:], cells_drawn=False)
        # The walk of the nearest pixel that was exported.
        middle = self.js("return walkPanel.pixel")
        self.pick(-90, 30)
        pixel = self.js("return walkPanel.pixel")
        self.assertLess(pixel["x"], middle["x"])
        self.assert_shows(scene[1:], cells_drawn=False)
        self.pick(0, 0)
        self.keys(Keys.ARROW_RIGHT)  # the walk stays where it is, in the next view
        self.wait_sharp()
        self.assertEqual(self.walk(), shown)
        fragment = self.js("return fragment()")
        self.open(address + fragment)
        self.wait_walk()
        self.assertEqual(self.js("return walkPanel.ray"), ray)
        self.assertEqual(self.walk(), shown)
        # The plane: the ray's ends go from point to point.
        self.change_plane("document.getElementById('plane').click()")
        self.assert_walks_in_plane(scene[1:])
        for end in (1, 0):
            before = self.js("return walkPanel.ray")
            self.drag(1 - end, self.in_plane(1 - end)[end], (-40, -60) if end else (20, 60))
            self.assertNotEqual(self.js("return walkPanel.ray"), before)
            self.assert_walks_in_plane(scene[1:])
        # The slider stands where the slice is, and the list of keys has those that do something.
        self.change_plane("slicePanel.slider.value = 0.4; slicePanel.slider.dispatchEvent(new Event('input'))")
        self.assertEqual(self.js("return [slicePanel.slider.value, state.slice.share]"), ["0.5", 0.5])
        self.keys("?")
        self.assertNotRegex(self.find("#keys-list").text, r"pan\b|pinch, \+ −\n")
        self.assertIn("orbit", self.find("#keys-list").text)
        self.keys(Keys.ESCAPE)

    def test_an_exported_page_of_chosen_slices_has_the_rays_that_are_named(self):
        rays = ["-2.1,0.1,0.3,4.3,0.2,0", "-1.9,-0.2,0.3,3.9,0.1,0"]
        low, high = json.loads(self.server.get("/api/slice?grid=0&axis=2&share=0"))["range"]
        slices = [f"z,{(0.3 - low) / (high - low)}", "x,0.5"]
        address = self.export("slices.html", scene[0], *structures, "--views", "1", "--size", "64x48", "--boxes", "10",
                              *[f"--slices={one}" for one in slices], *[f"--rays={ray}" for ray in rays])
        for fragment, wanted in [("", rays[0]), (f"#view=plane&slice={slices[0]}&ray={rays[1]}", rays[1])]:
            self.open(address + fragment, self.wait_plane)
            ray = self.js("return walkPanel.ray")
            self.assert_near(ray["origin"] + ray["direction"], map(float, wanted.split(",")))
            self.assert_walks_in_plane(structures)
            self.assert_sentences(structures)
        # A ray that isn't there is the nearest that is, and says so by its ends; an axis without slices has the nearest one.
        self.open(f"{address}#view=plane&slice=y,0.2&ray=-1.95,-0.2,0.31,3.9,0.1,0", self.wait_plane)
        self.assertEqual(self.js("return [state.slice.axis, 'xyz'.indexOf(slicePanel.axis.selectedOptions[0].textContent)]"), [0, 0] if abs(0.2 - 0.5) < abs(0.2 - float(slices[0][2:])) else [2, 2])
        self.js("location.hash = arguments[0]", f"#view=plane&slice={slices[0]}&ray=-1.95,-0.2,0.31,3.9,0.1,0")
        wait_until(lambda: self.js("return state.slice.axis") == 2, "the other slice")
        self.wait_plane()
        self.assertEqual(self.js("return String([...walkPanel.ray.origin.slice(0, 2)])"), "-1.9,-0.2")
        self.assert_walks_in_plane(structures)
        for wrong in [["--slices=q"], ["--slices=y,2"], ["--slices=y,"], ["--slices=y,0.5", "--rays=1,2"], ["--slices=y,0.5", "--rays=0,9,0,1,0,0"], ["--slices=y,0.5", "--rays=0,0,0,1,1,0"]]:
            with self.assertRaises(subprocess.CalledProcessError) as failed:
                tools.run("gridview", *scene, "--export", "wrong.html", "--views", "1", "--size", "8x8", *wrong, "-q")
            self.assertEqual((failed.exception.returncode, failed.exception.stderr.count("\n")), (1, 1), wrong)
        self.assertFalse((tools.folder / "wrong.html").exists())

    def test_the_documents_page_shows_the_lessons_states(self):
        docs = pathlib.Path(__file__).resolve().parent.parent.parent / "docs"
        self.assertLess((docs / "plane.html").stat().st_size, 1_500_000)
        lesson = (docs / "lesson.md").read_text()
        links = re.findall(r"plane\.html(#view=plane[^)]*)", lesson)
        self.assertGreater(len(links), 5)
        served = re.search(r"gridview teapot\.scene teapot-\{(.*)\}\.grid", lesson)[1].split(",")
        divisions = json.loads(self.server.get("/api/scene"))["divisions"]
        loaded = {*(f"teapot-{name}.grid" for name in served), *(f"division-{division}" for division in divisions)}
        for grids in re.findall(r"8765/#grid=([^&]*)", lesson):  # of the server that the lesson starts
            self.assertLessEqual({*grids.split(",")}, loaded)
        address = self.open_file(docs / "plane.html")
        for width, link in [(1440, ""), *((1024, link) for link in links)]:
            resize(self.browser, width, 800)
            load(self.browser, address + link)
            wait_until(lambda: self.js("return state.plane && walkPanel.walks.size"), "walks")
            self.assertEqual(self.js("return walkPanel.isAsking"), "guess=1" in link)
            self.change_plane("setGuess(false)")
            grids, ray, slice_ = self.js("return [state.plane.map((grid) => state.scene.grids[grid].name), walkPanel.ray, state.slice]")
            wanted = dict(part.split("=") for part in link[1:].split("&")) if link else {
                "grid": "division-32,teapot-balance.grid,teapot-irregular.grid,teapot-bvh.grid", "slice": "y,0.5", "ray": "-3.9,0,2.9,7.6,0,-1.4"}
            self.assertEqual(",".join(grids), wanted["grid"])
            self.assertEqual([slice_["axis"], slice_["share"]], [1, float(wanted["slice"][2:])])
            self.assert_near(ray["origin"] + ray["direction"], map(float, wanted["ray"].split(",")), 1e-4)
            self.assertTrue(self.js("return planeView.plots.every((plot) => /^[\\d\u2009]+ (cell|node)s?, [\\d\u2009]+ tests?/.test(plot.counts.textContent))"))
            self.assertFalse(self.find("#missing").is_displayed())
            self.assert_fits(width)
        # Its slider has the lesson's answer: what one ray costs in four divisions.
        self.open(address + next(link for link in links if "grid=division-8&" in link).replace("&guess=1", ""), self.wait_plane)
        costs = []
        for grid in range(self.js("return state.scene.given"), self.js("return state.scene.grids.length")):
            self.change_plane("planeView.choose(0, arguments[0])", grid)
            costs.append(self.js("return planeView.plots[0].costText.textContent.split(' = ')[1]"))
        self.assertIn(f"it costs {', '.join(costs)}.", lesson)

    # --- Made in memory ---

    def test_a_demo_is_what_the_tools_make_and_leaves_no_file(self):
        builds = {"uniform": ["--merge", "none"], "balance": ["--merge", "balance"], "irregular": ["--merge", "irregular"], "bvh": ["--structure", "bvh"]}
        before = sorted(path.name for path in tools.folder.iterdir())
        with Gridview(tools, "--demo", "tetra") as server:
            served = json.loads(server.get("/api/scene"))
            self.show(server=server)
            command = self.js("toggleCompare(); return command()")
            self.leave()
            self.assertRegex(server.text(), r"(?m)^gridview: made in memory: tetra.scene tetra-uniform.grid tetra-balance.grid tetra-irregular.grid tetra-bvh.grid$")
        self.assertEqual(sorted({*before, "gridview.log"}), sorted(path.name for path in tools.folder.iterdir()))
        # The page's own commands write what was in memory.
        steps = command.split(" && ")
        self.assertEqual(len(steps), 6)
        for step in steps[:4]:
            tools.run(*shlex.split(step))
        for name, options in builds.items():
            tools.run("gridbuild", "tetra.scene", "-o", f"tetra-{name}.grid", *options)
        with Gridview(tools, "tetra.scene", *(f"tetra-{name}.grid" for name in builds), "-q") as server:
            written = json.loads(server.get("/api/scene"))
        keep = lambda one: without(one, "made_by", "upload_seconds")
        self.assertEqual([keep(served["scene"]), *map(keep, served["grids"])], [keep(written["scene"]), *map(keep, written["grids"])])
        self.assertEqual([one["made_by"] for one in written["grids"]], [[]] * 4)

    def test_a_mesh_nff_text_or_a_scene_is_shown_through_structures_made_in_memory(self):
        (tools.folder / "a mesh.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
        tools.run("nffgen", "tetra", "--size", "3", "-o", "small.nff")
        tools.run("nff2bin", "small.nff", "-o", "given.scene")
        for given, made in [("a mesh.obj", "a mesh.scene "), ("small.nff", "small.scene "), ("given.scene", "")]:
            stem = given.rsplit(".", 1)[0]
            before = sorted(path.name for path in tools.folder.iterdir())
            with Gridview(tools, given) as server:
                served = json.loads(server.get("/api/scene"))
                self.assertEqual([one["structure"] for one in served["grids"]], ["grid", "bvh"])
                self.assertIn(f"gridview: made in memory: {made}{stem}-irregular.grid {stem}-bvh.grid\n", server.text())
                self.assertEqual(sorted({*before, "gridview.log"}), sorted(path.name for path in tools.folder.iterdir()))
                for words in [*served["scene"]["made_by"], *(words for one in served["grids"] for words in one["made_by"])]:
                    tools.run(*words)
            with Gridview(tools, served["scene"]["path"], *(one["path"] for one in served["grids"]), "-q") as server:
                written = json.loads(server.get("/api/scene"))
                self.assertEqual([one["hash"] for one in [served["scene"], *served["grids"]]], [one["hash"] for one in [written["scene"], *written["grids"]]])

    def test_play_goes_through_the_steps_and_says_what_each_does(self):
        with self.serving(scene[0], *structures) as server:
            self.show_plane(server, fragment="#view=plane&slice=y,0.5")
            self.assert_sentences(structures)
            button = next(one for one in self.find_all("#planes button") if one.text == "Play")
            button.click()  # from the beginning, where all have ended
            self.assertEqual([self.js("return walkPanel.step"), button.text], [0, "Pause"])
            for step in (1, 2):
                wait_until(lambda: self.js("return walkPanel.step") >= step, "the next step")
            button.click()
            step = self.js("return walkPanel.step")
            self.assertEqual(button.text, "Play")
            time.sleep(1.7)
            self.assertEqual(self.js("return walkPanel.step"), step, "it has stopped")
            self.js("walkPanel.select(walkPanel.lastStep - 1)")
            button.click()
            wait_until(lambda: button.text == "Play", "it stops with the walks")
            self.assertEqual(self.js("return walkPanel.step === walkPanel.lastStep"), True)
            for width, dark in [(1024, False), (1024, True), (1440, False), (1440, True)]:
                self.show_plane(server, width, 800, dark, "#view=plane&slice=y,0.5")
                self.js("walkPanel.select(2)")
                self.assert_fits(width)
            self.change("togglePlane()")
            self.pick(0, 0)
            self.assertRegex(self.find("#walk p.of-pictures").text, r"^cell \d+: .*(nothing nearer can follow|leaves the grid)$")

    # --- Guess, cost and division ---

    def wait_question(self):
        wait_until(lambda: self.js("return walkPanel.isAsking && walkPanel.walks.size > 0 && document.querySelectorAll('.guess input').length > 0"), "a question")

    def assert_hidden(self):
        """No count of the ray is on the page, or said."""
        text = self.js("return [document.querySelector('#walk').textContent, document.querySelector('.unseen').textContent, ...[...document.querySelectorAll('.walk-counts, .walk-cost, .walk-sentence')].filter((e) => !e.hidden && !e.classList.contains('unused')).map((e) => e.textContent), "
                       "...[...document.querySelectorAll('canvas.slice')].map((e) => e.getAttribute('aria-label'))].join(' ')")
        self.assertNotRegex(text, r"\d+ (cells?|nodes?|tests?)\b(?! list)|cost")
        self.assertEqual(self.js("return [walkPanel.lastStep, document.querySelectorAll('.walk-steps').length]"), [0, 0])

    def test_what_a_ray_visits_is_shown_when_it_has_been_guessed(self):
        with self.serving(scene[0], *structures) as server:
            self.show(1280, 800, False, "#", server)
            self.js("location.hash = arguments[0]", "#view=plane&slice=y,0.5&guess=1")
            self.wait_question()
            self.assertTrue(self.find("#guess").is_selected())
            self.assertEqual(self.find(".guess p").text, "How many cells or nodes will this ray visit?")
            printed = [self.printed(name) for name in structures]
            self.assert_hidden()
            self.keys(",", ".")  # no step tells
            self.assert_hidden()
            self.js("planeView.plots[0].canvas.focus()")
            self.keys(Keys.ENTER)
            self.assertEqual(self.js("return document.activeElement === document.querySelector('.guess input')"), True)
            self.keys("1", "2", Keys.TAB, Keys.TAB, "7", Keys.ENTER)  # none of the second
            self.wait_plane()
            self.assertEqual(self.js("return document.activeElement.className"), "slice")
            guesses = ["; guessed 12", "", "; guessed 7"]
            self.assertEqual(self.js("return planeView.plots.map((plot) => plot.counts.textContent)"),
                             [counts_of(one, what_of(name)) + guess for name, one, guess in zip(structures, printed, guesses)])
            self.assertEqual(self.js("return [...document.querySelector('#walk > table tbody').rows[1].cells].map((cell) => cell.textContent)")[:4], ["guessed", "12", "–", "7"])
            self.assertEqual(self.find(".unseen").get_attribute("textContent"),
                             ". ".join(f"{name.removesuffix('.grid').replace('_', '_' + chr(0x200b))}: {counted(one['cells'], what_of(name))}{guess}" for name, one, guess in zip(structures, printed, guesses)))
            # Another ray, another question; the address holds that there are any.
            self.js("planeView.move('to', [-0.2, 0.1], null)")
            self.wait_question()
            self.assert_hidden()
            wait_until(lambda: "guess=1" in self.js("return location.hash"), "the address holds the question")
            self.js("document.activeElement.blur()")
            self.keys("q")
            self.wait_plane()
            self.assertEqual([self.find("#guess").is_selected(), self.find("#announcement").text], [False, "guess first: off"])
            self.assert_walks_in_plane(structures)
            wait_until(lambda: "guess" not in self.js("return location.hash"), "the address, too")
            # Of a pixel, in two pictures.
            self.show(1280, 640, server=server, fragment=f"#grid={structures[0]},{structures[2]}&channel=shaded,shaded&guess=1&cells=ray,ray")
            self.find(".stage").click()
            self.wait_question()
            wait_until(lambda: self.js("return document.activeElement === document.querySelector('.guess input')"), "where guesses are typed")
            self.assert_hidden()
            self.keys("3", Keys.ENTER)
            self.wait_walk()
            self.assertTrue(self.walk()[0]["counts"].endswith("tests; guessed 3") or self.walk()[0]["counts"].endswith("test; guessed 3"))
            self.js("panes[1].set({grid: 1})")  # the same ray isn't asked about again
            self.wait_walk()
            self.assertFalse(self.js("return walkPanel.isAsking"))

    def test_costs_are_weighted_counts_up_to_the_step(self):
        choice = self.chance()
        with self.serving(scene[0], *structures) as server:
            self.show_plane(server, fragment="#view=plane&slice=y,0.5&cost=4,9.5")
            self.assertEqual(self.js("return [document.querySelector('#cost-a').value, document.querySelector('#cost-b').value]"), ["4", "9.5"])
            printed = [self.printed(name) for name in structures]
            shown = "return planeView.plots.map((plot) => plot.costText.textContent.replaceAll('\u2009', ''))"
            for a, b in [(4, 9.5), (choice.randrange(2, 50), choice.randrange(0, 50))]:  # 1,1 isn't in the address
                for name, weight in [("a", a), ("b", b)]:
                    self.js("const e = document.getElementById(arguments[0]); e.value = arguments[1]; e.dispatchEvent(new Event('input'))", f"cost-{name}", weight)
                for step in [0, 1, max(len(one["steps"]) for one in printed) - 1]:
                    self.js("walkPanel.select(arguments[0])", step)
                    for text, bars, one in zip(self.js(shown), self.js("return planeView.plots.map((plot) => [...plot.costBar.children].map((part) => parseFloat(part.style.width)))"), printed):
                        wanted, tests, steps = cost(one, a, b, step), cost(one, 1, 0, step), cost(one, 0, 1, step)
                        self.assertEqual(text.rsplit(" = ", 1)[0], f"cost {a} · {tests} + {b} · {steps}")
                        self.assertAlmostEqual(float(text.rsplit(" = ", 1)[1]), wanted, delta=0.006 * wanted)
                        most = max(cost(each, a, b) for each in printed)
                        self.assert_near(bars, [100 * a * tests / most, 100 * b * steps / most], 0.01)
            wait_until(lambda: f"cost={a},{b}" in self.js("return location.hash"), "the address holds the weights")
            for wrong in ["cost=1", "cost=-1,2", "cost=1,x", "cost=1e9,1"]:
                self.show_plane(server, fragment=f"#view=plane&{wrong}")
                self.assertEqual(self.js("return state.cost"), [1, 1])
            self.js("const e = document.getElementById('cost-a'); e.value = '-3'; e.dispatchEvent(new Event('input'))")
            self.assertEqual(self.js("return state.cost"), [1, 1])
            # Of a view: the mean of its rays.
            self.show(1280, 640, server=server, fragment=f"#grid={structures[0]},{structures[2]}&cost=2,3")
            wait_until(lambda: self.js("return panes.every((pane) => pane.counts)") and "cost per ray" in self.find("#cost").text, "costs of the view")
            counts = self.js("return panes.map((pane) => pane.counts)")
            rows = self.js("return [...document.querySelectorAll('#cost table tbody tr')].map((row) => [...row.cells].map((cell) => cell.textContent))")
            row = next(cells for cells in rows if cells[0] == "cost per ray")
            for one, boxes, text in zip(counts, [1, 8], row[1:]):
                rays = sum(one[f"{kind}_rays"] for kind in ("eye", "shadow", "reflection", "refraction"))
                wanted = (2 * sum(one["intersection_tests"].values()) + 3 * boxes * one["cells_visited"]) / rays
                self.assertAlmostEqual(float(text), wanted, delta=0.006 * wanted)

    def test_a_slider_chooses_a_division_that_is_built_in_memory(self):
        names = [scene[1], hierarchy]
        with self.serving(scene[0], *names) as server:
            self.show_plane(server, fragment="#view=plane&slice=y,0.5")
            # Where no uniform grid was given, one of 32 voxels per axis is beside them.
            self.assertEqual(self.js("return state.plane.map((grid) => state.scene.grids[grid].name)"), ["division-32", *names])
            slider = self.find(".plots .division input")
            self.assertEqual([slider.get_attribute("aria-valuetext"), self.find(".plots .division output").text], ["32", "32³"])
            rows = self.js("return planeView.plots.map((plot) => plot.canvas.clientHeight)")
            self.assertEqual(len(set(rows[:2])), 1, "slices beside each other have one height")
            self.js("walkPanel.select(walkPanel.lastStep)")
            seen = []
            self.js("document.querySelector('.plots .division input').focus()")
            for division in [24, 16, 12, 8, 12, 16, 24, 32, 48, 64, 96, 128]:
                self.keys(Keys.ARROW_LEFT if len(seen) < 4 else Keys.ARROW_RIGHT)
                self.wait_plane()
                self.assertEqual(self.find(".plots .division output").text, f"{division}³")
                seen.append(division)
                if seen.count(division) > 1 or division in (12, 24, 48, 96):
                    continue
                # It is what gridbuild writes, by the command that the page copies.
                (words,) = self.js("return state.scene.grids[state.plane[0]].made_by")
                self.assertEqual(words[-4:], ["--merge", "none", "--division", str(division)])
                tools.run(*words)
                self.assert_statistics(server, self.js("return state.plane[0]"), words[3], "build_seconds", "hash")
                self.assert_walks_in_plane([words[3], *names])
                (tools.folder / words[3]).unlink()
            wait_until(lambda: "grid=division-128," in self.js("return location.hash"), "the address holds the division")
            fragment = self.js("return location.hash")
            for width, height in [(400, 800), (1024, 768), (1920, 1080)]:
                for asks in (False, True):
                    self.show_plane(server, width, height, fragment=fragment)
                    self.js("setGuess(arguments[0])", asks)
                    self.assertEqual(self.find(".plots .division output").text, "128³")
                    self.assertEqual(len(set(self.js("return planeView.plots.map((plot) => plot.canvas.clientHeight)"))), 1)
                    self.assert_fits(width)
            # Over the pictures, with the command that makes them; g goes through it, too.
            self.show(1280, 640, server=server, fragment="#grid=division-8,division-64&channel=tests,tests")
            self.assertEqual([text.text for text in self.find_all(".picture .division output")], ["8³", "64³"])
            for step in self.js("return command()").split(" && "):
                tools.run(*shlex.split(step), "-q")
            self.assert_values("picture-2.tests.pfm", 1)
            self.js("panes[0].stage.focus()")
            order = []
            for _ in range(4):
                self.keys("g")
                order.append(self.js("return state.scene.grids[state.panes[0].grid].name"))
            self.assertEqual(order, [*names, "division-8", names[0]])
            self.wait_sharp()
        for path in [*tools.folder.glob("*division*")]:
            path.unlink()

    def test_an_exported_plane_has_four_divisions_guesses_and_costs(self):
        address = self.export("divisions.html", *scene, "--views", "1", "--size", "64x48", "--boxes", "10", "--slices", "y,0.5", "x,0.25")
        self.open(f"{address}#view=plane&slice=y,0.5&grid=division-8,{scene[1]}", self.wait_plane)
        self.js("document.querySelector('.plots .division input').focus()")
        for division in [8, 16, 32, 64]:
            self.assertEqual(self.find(".plots .division output").text, f"{division}³")
            tools.run("gridbuild", scene[0], "-o", "divided.grid", "--merge", "none", "--division", division)
            self.assert_walks_in_plane(["divided.grid", scene[1]])
            self.keys(Keys.ARROW_RIGHT)
            self.wait_plane()
        self.drag(0, self.in_plane(0)[1], (40, 30))
        self.assert_walks_in_plane(["divided.grid", scene[1]])
        printed = [self.printed(grid) for grid in ("divided.grid", scene[1])]
        self.js("location.hash = arguments[0]", self.js("return fragment()") + "&guess=1&cost=2,3")
        self.wait_question()
        self.assert_hidden()
        self.js("walkPanel.focusGuess()")
        self.keys("9", Keys.ENTER)
        self.wait_plane()
        self.assertTrue(self.js("return planeView.plots[0].counts.textContent").endswith("; guessed 9"))
        self.assertEqual([text.rsplit(" = ", 1)[1] for text in self.js("return planeView.plots.map((plot) => plot.costText.textContent)")], [str(cost(one, 2, 3)) for one in printed])
        # There are no pictures through them.
        self.assertNotIn("N³", self.js("document.getElementById('plane').click(); return panes[0].gridSelect.textContent"))
        self.wait_sharp()
        self.open(f"{address}#grid=division-8,{scene[1]}&channel=cells,tests")
        self.assertIn("division-8, which isn’t loaded", self.find("#missing").text)
        self.assertEqual(self.js("return state.panes"), [dict(grid=0, channel="tests", cells="none")])

    def test_an_exported_hierarchy(self):
        names = [hierarchy, scene[1]]
        address = self.export("hierarchy.html", scene[0], *names, "--views", "1", "--size", "160x120")
        self.open(f"{address}#grid={','.join(names)}&channel=cells,cells&slice=z,0.5,1")
        self.js("for (const pane of panes) pane.set({cells: 'boxes'}); panes[0].stage.focus()")
        wait_until(lambda: self.js("return slicePanel.boxesOf(0) && slicePanel.boxesOf(1)"), "boxes of both")
        served = self.js("return slicePanel.boxesOf(0)")
        self.assertGreater(served["count"], 8)  # of depth 1
        self.assertEqual(served["count"], len(served["boxes"]))
        self.keys(Keys.ENTER, Keys.ENTER)
        self.wait_walk()
        self.assert_lists(self.assert_shows(names, cells_drawn=False)[0])

    def test_an_exported_page_shows_names_of_markup_as_text(self):
        names = ["<!--<script>.grid", "<\\script><b onclick=alert(1)>&amp;\u2028.grid"]
        for name, grid in zip(names, scene[1:]):
            shutil.copy(tools.folder / grid, tools.folder / name)
        self.open(self.export("markup.html", scene[0], *names, "--views", "1", "--size", "64x48"))
        self.assertEqual(self.js("return [...document.querySelectorAll('.grid option')].map((option) => option.textContent)"), names)
        self.assertEqual(self.js("return document.querySelectorAll('b').length"), 0)

    def test_a_hidden_or_closed_page_asks_nothing(self):
        self.leave()
        before = self.server.cpu_seconds()
        time.sleep(1)
        self.assertLess(self.server.cpu_seconds() - before, 0.2)

    def wait_lost(self, is_lost):
        wait_until(lambda: self.find("#lost").is_displayed() == is_lost, "a message while the server is gone")

    def test_it_says_when_the_server_is_gone_and_goes_on_when_it_is_back(self):
        with Gridview(tools, *scene, "-q") as server:
            self.show(server=server)
        self.js("setCamera(Camera.orbited(state.camera, 0.3, 0))")
        self.wait_lost(True)
        self.assertIn("still running", self.find("#lost").text)
        with self.serving(*scene, port=server.port):  # which drops what Chromium says of refused connections
            self.wait_lost(False)
            self.wait_sharp()

    def test_the_plane_keeps_slices_and_walk_while_the_server_is_gone(self):
        with Gridview(tools, *scene, "-q") as server:
            self.show_plane(server)
            ray = self.js("return walkPanel.ray")
        self.js("planeView.move('to', [-0.3, 0.2], null)")
        self.wait_lost(True)
        self.js("slicePanel.set({share: 0.4})")
        self.assertNotIn("Failed to fetch", self.find("body").text)
        self.assertTrue(self.js("return walkPanel.ray && planeView.plots.every((plot) => plot.slice && !plot.counts.hidden)"))
        with self.serving(*scene, port=server.port):
            self.wait_lost(False)
            wait_until(lambda: self.js("return planeView.slice.position === walkPanel.ray.origin[2] && planeView.slice.position") not in (False, ray["origin"][2]), "the slice that was chosen meanwhile")
            self.wait_plane()
            self.assertNotEqual(self.js("return walkPanel.ray.direction"), ray["direction"])
            self.assert_walks_in_plane(scene[1:])

    def test_a_server_of_other_grids_at_the_same_port_is_not_taken_for_the_old_one(self):
        with Gridview(tools, *scene, "-q") as server:
            self.show(server=server, fragment=f"#grid={scene[1]}")
        with self.serving(scene[0], scene[2], port=server.port) as server:
            self.js("setCamera(Camera.orbited(state.camera, 0.3, 0))")
            wait_until(lambda: self.js("return typeof state !== 'undefined' && state.scene && state.scene.grids.slice(0, state.scene.given).map((grid) => grid.name)") == [scene[2]], "the page is loaded anew")
            self.wait_sharp()
            self.assertIn(f"{scene[1]}, which isn’t loaded", self.find("#missing").text)
            with self.assertRaises(urllib.error.HTTPError) as refused:
                server.get("/api/statistics?grid=0&files=" + "0" * 32)
            self.assertEqual(refused.exception.code, 409)
            refused.exception.close()

    # --- Addresses ---

    def test_another_address_drops_the_counts_of_the_old_one(self):
        self.show(fragment=f"#grid={scene[1]}")
        wait_until(lambda: "cells per ray" in self.find("#cost").text, "counts")
        self.js("source.picture = () => new Promise(() => {}); location.hash = arguments[0]", f"#grid={scene[2]}")
        wait_until(lambda: "uniform" in self.find("#cost thead").text, "the other grid's name")
        for old in ["per ray", "trace", "shadow rays"]:
            self.assertNotIn(old, self.find("#cost table").text)
        self.assertEqual(len(self.find_all("#cost tr.head")), 1, "no headings of nothing")

    def test_a_link_to_grids_that_are_not_loaded_says_so(self):
        self.show(fragment=f"#grid=other.grid,{scene[2]}&channel=depth,cells")
        self.assertEqual(self.js("return state.panes"), [dict(grid=1, channel="cells", cells="none")])
        self.assertEqual(self.find("#missing").text, f"The link names other.grid, which isn’t loaded here. Shown: {scene[2]} of {scene[0]}.")
        self.select(".picture .grid", 0)
        self.assertFalse(self.find("#missing").is_displayed())
        self.show(fragment=f"#grid={scene[2]}")
        self.assertFalse(self.find("#missing").is_displayed())

    def test_a_link_holds_the_planes_zoom(self):
        self.show_plane(self.server, fragment="#view=plane&slice=y,0.5")
        self.js("planeView.zoomed(planeView.plots[0], 3, 0.2, 0.3)")
        zoom = self.js("return planeView.zoom")
        wait_until(lambda: "zoom=" in self.js("return location.hash"), "the address holds the zoom")
        fragment = self.js("return location.hash")
        self.show_plane(self.server, fragment=fragment)
        self.assertEqual(self.js("return planeView.zoom"), zoom)
        shown = "const plot = planeView.plots[0], {canvas} = plot; return plot.window(plot.slice, planeView.zoom).u(canvas.width / 2)"
        self.assertAlmostEqual(self.js(shown), zoom["u"])
        self.js("slicePanel.set({axis: 0})")  # another plane has its own middle
        wait_until(lambda: self.js("return planeView.slice.axis") == 0, "another plane")
        self.assertNotAlmostEqual(self.js(shown), zoom["u"])

    # --- Keys ---

    def test_the_skip_link_leads_to_what_is_shown_and_keeps_the_address(self):
        for plane in [False, True]:
            if plane:
                self.show_plane(self.server)
            else:
                self.show(fragment="#depth=3")
            time.sleep(0.4)  # until the address holds all of it
            fragment = self.js("return location.hash")
            self.js("document.querySelector('.skip').focus()")
            self.keys(Keys.ENTER)
            self.assertEqual(self.js("return document.activeElement.className"), "slice" if plane else "stage")
            time.sleep(0.4)
            self.assertEqual(self.js("return location.hash"), fragment)

    def test_keys_work_where_a_control_has_the_focus(self):
        self.show(1280, 640)
        self.pick(0, 0)
        last = self.js("return walkPanel.step")
        self.assertGreater(last, 1)
        self.js("document.querySelector('#slice-panel').open = true; panes[0].set({cells: 'slice'})")
        for control in [".picture .channel", "#slice input", "#walk-all"]:
            self.js("document.querySelector(arguments[0]).focus()", control)
            self.keys(",")
            self.assertEqual(self.js("return walkPanel.step"), last - 1, control)
            self.assertRegex(self.find(".unseen").get_attribute("textContent"), rf"^step {last} of {last + 1}: cell \d.*, \d+ tests?(, hit)?$")
            self.keys(".")
            self.assertEqual(self.js("return walkPanel.step"), last, control)
            self.keys("?")
            self.assertTrue(self.find("#keys-list").is_displayed(), control)
            self.keys(Keys.ESCAPE)
            self.assertFalse(self.find("#keys-list").is_displayed(), control)
        self.js("document.getElementById('cost-a').select()")
        self.keys("?")
        self.assertTrue(self.find("#keys-list").is_displayed())
        self.keys(Keys.ESCAPE, "1", ".", "5")  # numbers have a point
        self.assertEqual(self.js("return [walkPanel.step, state.cost[0]]"), [last, 1.5])
        # Esc closes the list alone, not the walk.
        self.js("panes[0].stage.focus()")
        self.keys("?", Keys.ESCAPE)
        self.assertFalse(self.find("#keys-list").is_displayed())
        self.assertTrue(self.js("return walkPanel.ray"))
        # To the plane and back, and where the second picture is closed.
        for wanted in ["slice", "stage"]:
            self.keys("p")
            self.assertEqual(self.js("return document.activeElement.className"), wanted)
        self.keys("v")
        self.js("panes[1].stage.focus()")
        self.keys("v")
        self.assertEqual(self.js("return document.activeElement === panes[0].stage"), True)
        self.wait_sharp()

    def test_the_plane_shows_the_grids_that_were_compared_and_gives_their_walk_back(self):
        with self.serving(*scene, "balance.grid") as server:
            self.show(1280, 640, server=server, fragment="#grid=balance.grid,balls_uniform.grid&channel=cells,cells")
            self.pick(0, 0, 1)
            self.js("walkPanel.move(-1)")
            look = "return [walkPanel.ray, walkPanel.pane, walkPanel.step]"
            before, commands = self.js(look), self.js("return command()").split(" && ")
            for grid, one in zip(["balance.grid", "balls_uniform.grid"], commands):
                self.assertIn(grid, one)
            self.assertEqual([shlex.split(one)[shlex.split(one).index("-o") + 1] for one in commands], ["picture.png", "picture-2.png"])
            self.change_plane("togglePlane()")
            self.assertEqual(self.js("return state.plane"), [2, 1])
            self.change("togglePlane()")
            self.wait_walk()
            self.assertEqual(self.js(look), before)

    # --- Once ---

    def test_what_lies_over_pictures_does_not_trace_them_anew(self):
        self.show(1280, 640, fragment=f"#grid={scene[1]},{scene[2]}&channel=shaded,cells")
        wait_until(lambda: self.js("return panes.every((pane) => pane.counts)"), "counts")
        self.logs()
        for change in ["panes[0].set({cells: 'slice'})", "panes[1].set({cells: 'boxes'})", "toggleKeys()", "slicePanel.set({share: 0.4})", "panes[0].set({cells: 'none'})", "toggleKeys()", "setCamera(state.camera)"]:
            self.js(change)
            time.sleep(0.4)
            self.assertEqual([url for url in self.requests() if "/api/picture" in url], [], change)
        self.assertTrue(self.js("return panes.every((pane) => pane.counts)"))

    def test_pictures_that_are_compared_have_one_size_and_one_angle(self):
        for width in [1024, 1100, 1200, 1280, 1440]:
            for grids in [f"{scene[1]},{scene[2]}", f"division-8,{scene[2]}"]:
                self.show(width, 640, fragment=f"#grid={grids}&channel=shaded,cells")
                self.assertEqual(*self.js("return panes.map((pane) => [pane.stage.clientHeight, pane.frame.view.camera.angle])"))
                self.assertEqual([status.text.split()[0] for status in self.find_all(".picture .status")], ["sharp"] * 2)
                self.assertTrue(self.js("""return panes.every(({status}) => { const range = document.createRange(); range.setStart(status.firstChild, 0); range.setEnd(status.firstChild, 5);
                  return range.getBoundingClientRect().right < status.getBoundingClientRect().right - 12; })"""), "it isn't cut off")

    def test_many_boxes_are_drawn_once_and_cover_the_scene(self):
        tools.run("nffgen", "balls", "--size", "5", "-o", "many.nff")
        tools.run("nff2bin", "many.nff", "-o", "many.scene")
        tools.run("gridbuild", "many.scene", "-o", "many.grid", "--merge", "none", "--division", "96")
        grids = ["many.grid", tools.make_hierarchy("many.scene")]
        with self.serving("many.scene", *grids) as server:
            bounds = json.loads(server.get("/api/scene"))["scene"]["bounds"]
            for i, grid in enumerate(grids):
                made = json.loads(server.get(f"/api/boxes?grid={i}"))
                self.assertGreater(made["count"], 8000)
                self.assertLessEqual(len(made["boxes"]), 8000)
                self.assertGreater(len(made["boxes"]), 2000)
                for axis in range(3):
                    low, high = min(box["min"][axis] for box in made["boxes"]), max(box["max"][axis] for box in made["boxes"])
                    extent = bounds["max"][axis] - bounds["min"][axis]
                    self.assertLess(max(low - bounds["min"][axis], bounds["max"][axis] - high), 0.05 * extent, "not one patch of them")
            self.assertEqual({box["depth"] <= made["depth"] for box in made["boxes"]}, {True})
            self.show(1280, 640, server=server, fragment=f"#grid={grids[1]}&cells=boxes")
            wait_until(lambda: self.js("return slicePanel.boxesOf(1)"), "boxes")
            self.assertRegex(self.find("#slice .note").text, r"down to depth \d+: all are")
            self.js("window.draws = 0; const old = Pane.prototype.drawBoxes; Pane.prototype.drawBoxes = function(boxes) { draws += 1; old.call(this, boxes); }")
            begin = time.monotonic()
            for _ in range(40):
                self.js("panes[0].picture.stillMsPerPixel = 1; setCamera(Camera.orbited(state.camera, 0.02, 0))")  # as many bands as there may be
            self.wait_sharp()
            print(f"40 moves: {time.monotonic() - begin:.1f} s", end=" ", file=sys.stderr, flush=True)
            self.assertLessEqual(self.js("return draws"), 41)
            draws = self.js("const before = draws; panes[0].picture.stillMsPerPixel = 1; setCamera(Camera.orbited(state.camera, 0.02, 0)); return before")
            self.wait_sharp()
            self.assertEqual(self.js("return draws") - draws, 1)

    def test_the_planes_first_ray_begins_in_a_cell(self):
        tools.run("gridbuild", scene[0], "-o", "even.grid", "--division", "32", "--merge", "none")
        with self.serving(scene[0], "even.grid", *scene[1:]) as server:
            for axis in "xyz":
                self.show_plane(server, fragment=f"#view=plane&slice={axis},0.5")
                ray, slice_ = self.js("return walkPanel.ray"), self.js("return planeView.slice")
                for k, at in enumerate(slice_["axes"]):
                    share = (ray["origin"][at] - slice_["min"][k]) / slice_["step"][k] % 1
                    self.assertTrue(0.05 < share < 0.95, share)
                for i in range(3):
                    self.js("walkPanel.look({pane: arguments[0]})", i)
                    numbers = [text for row in self.listed() for text in row[2:4]]
                    self.assertGreater(len(numbers), 1)
                    self.assertEqual([text for text in numbers if text.startswith("-")], [])
        (tools.folder / "corner.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
        with self.serving("corner.obj") as server:  # its space begins a margin before 0
            for share, text in [(0, "x = 0 of 0 to 1.00"), (0.5, "x = 0.500 of 0 to 1.00")]:
                self.show_plane(server, fragment=f"#view=plane&slice=x,{share}")
                self.assertEqual(self.js("return slicePanel.position.textContent"), text)

    def test_four_structures_have_four_colors(self):
        with self.serving(*scene, "balance.grid", hierarchy) as server:
            for dark in [False, True]:
                self.show_plane(server, dark=dark)
                self.js("document.getElementById('histogram-panel').open = true")
                wait_until(lambda: self.find_all("#histogram .key"), "the histogram")
                keys, bars = self.js("return [[...document.querySelectorAll('#histogram .key')].map((key) => getComputedStyle(key, '::before').backgroundColor), "
                                     "[...new Set([...document.querySelectorAll('#histogram rect')].map((bar) => getComputedStyle(bar).fill))]]")
                self.assertEqual(len(set(keys)), 4)
                self.assertEqual(set(bars), set(keys))

    def test_contrast_of_hits_and_lines_and_room_for_controls(self):
        for dark in [False, True]:
            self.show(1024, 640, dark, fragment=f"#grid={scene[1]}&channel=depth&cells=slice")
            self.pick(0, 0)
            self.js("walkPanel.select(walkPanel.lastStep)")
            colors = self.js("""const cell = document.querySelector('[aria-selected=true] .hit'), canvas = document.createElement('canvas'), context = canvas.getContext('2d', {willReadFrequently: true});
              const rgb = (color) => { context.fillStyle = color; context.fillRect(0, 0, 1, 1); return [...context.getImageData(0, 0, 1, 1).data].slice(0, 3); };
              return [rgb(getComputedStyle(cell).color), rgb(getComputedStyle(cell.parentElement).backgroundColor)];""")
            self.assertGreater(contrast(*colors), 4.5)
            self.assertEqual(self.js("return document.querySelectorAll('[aria-hidden=\"\"]').length"), 0)
            # Lines of a slice are seen on white, too.
            wait_until(lambda: self.js("return slicePanel.of(0)"), "the slice")
            self.assertTrue(self.js("const c = panes[0].overlay.canvas, copy = new OffscreenCanvas(c.width, c.height).getContext('2d', {willReadFrequently: true}); "
                                    "copy.drawImage(c, 0, 0); const {data} = copy.getImageData(0, 0, c.width, c.height); for (let i = 0; i < data.length; i += 4) if (data[i + 3] > 60 && data[i] < 60 && data[i + 1] < 60 && data[i + 2] < 60) return true; return false"))
            self.js("announce('something')")
            toast = self.js("const r = document.getElementById('announcement').getBoundingClientRect(); return [r.left, r.top, r.right, r.bottom]")
            for left, top, right, bottom in self.js("return [...document.querySelectorAll('button, select, input')].map((e) => { const r = e.getBoundingClientRect(); return [r.left, r.top, r.right, r.bottom]; })"):
                self.assertTrue(right <= toast[0] or left >= toast[2] or bottom <= toast[1] or top >= toast[3], "the toast lies over a control")
        # The slider of a plane that nothing shows isn't there.
        self.js("document.querySelector('#slice-panel').open = true; panes[0].set({cells: 'boxes'})")
        self.assertFalse(self.find("#slice select").is_displayed())
        self.js("panes[0].set({cells: 'slice'})")
        self.assertTrue(self.find("#slice select").is_displayed())


if __name__ == "__main__":
    tools = Tools(sys.argv.pop(1))
    if len(sys.argv) > 1 and not sys.argv[1].startswith("-") and "." not in sys.argv[1]:
        pictures = pathlib.Path(sys.argv.pop(1))
        pictures.mkdir(exist_ok=True)
    scene = tools.make_scene()
    hierarchy = tools.make_hierarchy(scene[0])
    structures = [*scene[1:], hierarchy]
    tools.run("gridbuild", scene[0], "-o", "balance.grid", "--division", "16", "--merge", "balance")
    unittest.main(verbosity=2)
