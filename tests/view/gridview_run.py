"""Runs the built tools for tests of gridview."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time
import urllib.request


def skip(reason):
    """ctest shows a test that returns 77 as skipped."""
    print(f"skipped: {reason}")
    sys.exit(77)


class Tools:
    """The tools of a build folder, and a temporary folder with a scene and its grids."""

    def __init__(self, bin_folder):
        self.bin = pathlib.Path(bin_folder).resolve()
        if not (self.bin / "gridview").exists():
            skip("gridview isn't built: it needs cpp-httplib and libjpeg-turbo")
        self.folder_owner = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self.folder_owner.name)

    def run(self, *words):
        words = [str(self.bin / words[0]), *map(str, words[1:])]
        return subprocess.run(words, cwd=self.folder, check=True, capture_output=True, text=True).stdout

    def make_scene(self, name="balls", size=2):
        """NAME.scene, NAME.grid (irregular) and NAME_uniform.grid."""
        self.run("nffgen", name, "--size", size, "-o", f"{name}.nff")
        self.run("nff2bin", f"{name}.nff", "-o", f"{name}.scene")
        self.run("gridbuild", f"{name}.scene", "-o", f"{name}.grid", "--merge", "irregular")
        self.run("gridbuild", f"{name}.scene", "-o", f"{name}_uniform.grid", "--merge", "none")
        return [f"{name}.scene", f"{name}.grid", f"{name}_uniform.grid"]

    def make_hierarchy(self, scene):
        """NAME_bvh.grid of NAME.scene."""
        name = scene.replace(".scene", "_bvh.grid")
        self.run("gridbuild", scene, "-o", name, "--structure", "bvh")
        return name

    def make_nested_glass(self):
        """[scene, grid] of 30 spheres of glass in each other: the rays of a pixel double with each depth or two."""
        spheres = "\n".join(f"s 0 0 0 {1 - i * 0.03:.2f}" for i in range(30))
        (self.folder / "glass.nff").write_text(
            "v\nfrom 0 -4 0.3\nat 0 0 0\nup 0 0 1\nangle 45\nhither 0.01\nresolution 64 64\nb 0.2 0.3 0.4\n"
            f"l 5 -5 5\nl -5 -5 5\nf 1 1 1 0.1 0.4 10 0.6 1.5\n{spheres}\n")
        self.run("nff2bin", "glass.nff", "-o", "glass.scene")
        self.run("gridbuild", "glass.scene", "-o", "glass.grid")
        return ["glass.scene", "glass.grid"]


class Gridview:
    """A gridview that is serving; ends with the block."""

    def __init__(self, tools, *arguments, port=0):
        # A sanitizer's options are the environment's; its reports are on standard error.
        self.log = open(tools.folder / "gridview.log", "w+")
        self.process = subprocess.Popen([tools.bin / "gridview", *arguments, "--port", str(port)], cwd=tools.folder,
                                        stdout=subprocess.PIPE, stderr=self.log, text=True)
        self.address = self.process.stdout.readline().strip()
        match = re.fullmatch(r"http://127\.0\.0\.1:(\d+)/(\?token=[0-9a-f]{32})?", self.address)
        assert match, f"no address: {self.address!r}, {self.text()}"
        self.port = int(match[1])

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.terminate()
            self.process.wait(30)
        self.process.stdout.close()
        self.log.close()

    def text(self):
        """What it wrote to standard error."""
        self.log.flush()
        return pathlib.Path(self.log.name).read_text()

    def get(self, path, **headers):
        request = urllib.request.Request(f"http://127.0.0.1:{self.port}{path}", headers=headers)
        with urllib.request.urlopen(request, timeout=300) as response:  # for what hangs: other tests run, too
            return response.read()

    def memory(self, kind="VmRSS"):
        """Resident bytes; the most that there were is VmHWM."""
        return 1024 * int(re.search(rf"{kind}:\s+(\d+)", pathlib.Path(f"/proc/{self.process.pid}/status").read_text())[1])

    def threads(self):
        return len(os.listdir(f"/proc/{self.process.pid}/task"))

    def files(self):
        return len(os.listdir(f"/proc/{self.process.pid}/fd"))

    def cpu_seconds(self):
        fields = pathlib.Path(f"/proc/{self.process.pid}/stat").read_text().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")

    def is_idle(self):
        spent = self.cpu_seconds()
        time.sleep(0.5)
        return self.cpu_seconds() - spent < 0.1


def wait_until(condition, what, seconds=60):
    """Not a measurement: the bound is for what hangs."""
    end = time.monotonic() + seconds
    while not (value := condition()):
        assert time.monotonic() < end, f"never happened: {what}"
        time.sleep(0.05)
    return value
