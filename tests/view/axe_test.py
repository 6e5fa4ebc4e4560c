"""axe-core finds nothing, of any rank, in the states of gridview's page, at three widths and in both themes.

axe_test.py BIN_FOLDER, with axe.min.js by the environment variable MASU_AXE or from `npm install -g axe-core`.
"""
import os
import pathlib
import shutil
import subprocess
import sys

from gridview_run import Gridview, Tools, skip, wait_until
from view_test import load, open_browser, resize


def axe_script():
    if path := os.environ.get("MASU_AXE"):
        return pathlib.Path(path).read_text()
    npm = shutil.which("npm")
    root = npm and subprocess.run([npm, "root", "-g"], capture_output=True, text=True).stdout.strip()
    path = pathlib.Path(root or "/") / "axe-core/axe.min.js"
    return path.read_text() if path.exists() else skip("axe-core isn't found (MASU_AXE, or npm install -g axe-core)")


RUN = """const done = arguments[0]; axe.run(document, {resultTypes: ['violations']}).then(({violations}) =>
  done(violations.map(({id, impact, nodes}) => `${id} (${impact}): ${nodes.map(({html}) => html.slice(0, 160)).join(' ')}`)), (error) => done([String(error)]));"""
SHARP = "return typeof panes !== 'undefined' && panes.length > 0 && panes.every((pane) => pane.frame && pane.frame.isSharp && pane.counts)"
WALKED = "return typeof walkPanel !== 'undefined' && state.plane && walkPanel.ray && planeView.grids.every((grid) => walkPanel.rayOf(grid))"
ASKED = "return typeof walkPanel !== 'undefined' && walkPanel && document.querySelectorAll('.guess input').length > 0"
RAY = "&ray=2.1,1.3,1.7,-2.1,-1.3,-1.7"


def main():
    axe, tools = axe_script(), Tools(sys.argv[1])
    scene = tools.make_scene()
    scene.append(tools.make_hierarchy(scene[0]))
    tools.run("gridview", *scene, "--export", "page.html", "--views", "2", "--size", "160x120", "-q")
    export, browser, found = (tools.folder / "page.html").as_uri(), open_browser(), []
    # Name, whether of the export, fragment, what there is to wait for, what is done then.
    states = [
        ("two pictures", False, f"#grid={scene[1]},{scene[3]}&channel=shaded,cells&cells=ray,boxes{RAY}", SHARP, ""),
        ("messages", False, "#grid=other.grid", SHARP, "announce('said'); document.getElementById('lost').hidden = false"),
        ("cut", False, f"#grid={scene[1]}&channel=cut", SHARP, ""),
        ("divisions", False, f"#grid=division-8,division-16&channel=tests,tests{RAY}&guess=1", ASKED, ""),
        ("plane", False, "#view=plane&slice=y,0.5", WALKED, ""),
        ("keys", False, "#view=plane&slice=y,0.5", WALKED, "toggleKeys()"),
        ("plane of divisions", False, f"#view=plane&slice=y,0.5&grid=division-8,division-32,{scene[1]},{scene[3]}&cost=4,9.5", WALKED, ""),
        ("guess", False, "#view=plane&slice=y,0.5&guess=1", ASKED, ""),
        ("exported pictures", True, f"#grid={scene[1]},{scene[3]}&channel=shaded,cells", SHARP, ""),
        ("exported plane", True, "#view=plane&slice=y,0.5", WALKED, ""),
    ]
    with Gridview(tools, *scene, "-q") as server:
        for width, height in [(1024, 768), (1440, 900), (1920, 1080)]:
            resize(browser, width, height)
            for theme in ("light", "dark"):
                browser.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": theme}]})
                for name, is_export, fragment, shown, act in states:
                    load(browser, (export if is_export else server.address) + fragment)
                    wait_until(lambda: browser.execute_script(shown), f"{name} at {width}", 120)
                    browser.execute_script(act + "; document.querySelectorAll('details').forEach((details) => { details.open = true; })")
                    wait_until(lambda: browser.execute_script("return document.querySelector('#histogram svg')"), "all panels")
                    browser.execute_script(axe)
                    found += [f"{name}, {width}, {theme}: {one}" for one in browser.execute_async_script(RUN)]
                    print(".", end="", flush=True)
        # It does find something where there is something.
        browser.execute_script("document.body.append(document.createElement('button'))")
        blind = not any(one.startswith("button-name") for one in browser.execute_async_script(RUN))
    browser.quit()
    print(*["", *found, *(["axe finds nothing in a button without a name"] if blind else [])], sep="\n")
    sys.exit(1 if found or blind else 0)


main()
