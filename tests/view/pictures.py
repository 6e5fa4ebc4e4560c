"""Takes the documentation's pictures of gridview's page by headless Chromium: pictures.py BIN_FOLDER DOCS_FOLDER"""
import base64
import pathlib
import sys

from gridview_run import Gridview, Tools, wait_until
from view_test import load, open_browser, resize

SHARP = "return panes.length > 0 && panes.every((pane) => pane.frame && pane.frame.isSharp && pane.counts) && !slicePanel.isLoading"
WALKED = "return planeView && planeView.plots.length > 0 && !planeView.wish && planeView.plots.every((plot) => plot.counts.textContent)"
BUILDS = {"32": ["--division", 32], "balance": ["--division", 32, "--merge", "balance"],
          "irregular": ["--merge", "irregular"], "bvh": ["--structure", "bvh"]}
# Name, scene, grids, what the address holds, what there is to wait for.
PICTURES = [
    ("view.jpg", "balls", ["irregular", "32"], "#grid={0},{1}&channel=all tests,all tests", SHARP),
    ("cut.png", "teapot", ["32", "irregular"], "#grid={0},{1}&channel=cut,cut&slice=y,0.5", SHARP),
    ("plane.png", "teapot", ["balance", "irregular", "bvh"],
     "#view=plane&grid=division-32,{0},{1},{2}&slice=y,0.5&ray=-3.9,0,2.9,7.6,0,-1.4", WALKED),
]


def main():
    tools, docs = Tools(sys.argv[1]), pathlib.Path(sys.argv[2])
    browser = open_browser()
    resize(browser, 1280, 720)
    for name, scene, builds, fragment, shown in PICTURES:
        tools.run("nffgen", scene, "-o", f"{scene}.nff")
        tools.run("nff2bin", f"{scene}.nff", "-o", f"{scene}.scene")
        grids = [f"{scene}-{build}.grid" for build in builds]
        for build, grid in zip(builds, grids):
            tools.run("gridbuild", f"{scene}.scene", "-o", grid, *BUILDS[build])
        with Gridview(tools, f"{scene}.scene", *grids, "-q") as server:
            load(browser, server.address + fragment.format(*grids))
            wait_until(lambda: browser.execute_script(shown), name, 300)
            data = browser.execute_cdp_cmd("Page.captureScreenshot", {"format": "jpeg", "quality": 88} if name.endswith(".jpg") else {})["data"]
            (docs / name).write_bytes(base64.b64decode(data))
    browser.quit()


main()
