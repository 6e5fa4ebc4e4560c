"""The module's wheel, made of a library that is already built and installed by pip: wheel_test.py LIBRARY. Ends with 77
where the interpreter, its pip or patchelf isn't there or too old. NumPy is the system's."""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[2]
LIBRARY = sys.argv.pop()


def run(*command, **options):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, universal_newlines=True, **options).stdout


class InstalledWheel(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        run(sys.executable, "-m", "venv", "--system-site-packages", cls.folder.name)
        cls.python = pathlib.Path(cls.folder.name, "bin/python")
        cls.dist = pathlib.Path(cls.folder.name, "dist")
        run(cls.python, "-m", "pip", "wheel", "--no-index", "--no-deps", "--wheel-dir", cls.dist,
            "--config-settings", "library=" + LIBRARY, SOURCE)
        run(cls.python, "-m", "pip", "install", "--no-index", "--no-deps", next(cls.dist.iterdir()))
        cls.module = pathlib.Path(cls.python_says("import masu; print(masu.__file__)").strip()).parent

    @classmethod
    def python_says(cls, text):
        return run(cls.python, "-I", "-c", text, cwd=cls.folder.name, env={})

    def test_it_is_in_the_environment(self):
        self.assertIn(pathlib.Path(self.folder.name).resolve(), self.module.parents)

    def test_its_tag_is_of_a_c_library_that_is_here(self):
        tag = re.fullmatch(r"masu-[\d.]+-py3-none-manylinux_2_(\d+)_\w+\.whl", next(self.dist.iterdir()).name)
        have = self.python_says("import os; print(os.confstr('CS_GNU_LIBC_VERSION'))")
        self.assertLessEqual(int(tag[1]), int(re.search(r" 2\.(\d+)", have)[1]))

    def test_its_libraries_are_its_own_or_every_systems(self):
        maps = self.python_says("import masu; print(open('/proc/self/maps').read())")
        loaded = {pathlib.Path(path) for path in re.findall(r"(/\S*\.so[.\d]*)$", maps, re.MULTILINE)}
        own = {path for path in loaded if self.module in path.parents}
        self.assertEqual({path.name for path in own}, {path.name for path in self.module.rglob("*.so.*")})
        used = self.python_says("from masu import _library as m; print(m._candidates()[0], m.library._name)").split()
        self.assertEqual(used[0], used[1])
        for path in loaded - own:
            self.assertNotRegex(path.name, "^lib(tbb|fmt|xxhash|masu)")
        for path in own:
            needed = re.findall(r"NEEDED +(\S+)", run("objdump", "-p", path))
            for name in needed:
                self.assertTrue(re.match(r"lib(c|m|dl|rt|pthread|stdc\+\+|gcc_s)\.so|ld-linux", name) or
                                (self.module / name).exists(), (path, name))

    def test_the_modules_own_example_runs(self):
        text = self.python_says("import masu; print(masu.__doc__)")
        example = "".join(line[4:] + "\n" for line in text.splitlines() if line.startswith("    "))
        self.assertTrue(self.python_says(example))

    def test_files_are_those_recorded(self):
        self.python_says("""
import base64, hashlib, importlib.metadata
for file in importlib.metadata.files("masu"):
    if file.hash:
        digest = hashlib.new(file.hash.mode, file.locate().read_bytes()).digest()
        assert base64.urlsafe_b64encode(digest).rstrip(b"=").decode() == file.hash.value, file
""")

    def test_the_library_for_avx2_is_taken_where_the_processor_has_it(self):
        second = self.module / "x86-64-v3"
        if not second.exists():
            self.skipTest("one build for all processors")
        for flags, expected in (("fpu avx2 fma bmi1 bmi2 abm popcnt", second), ("fpu", self.module),
                                ("fpu avx2 bmi1 bmi2 abm popcnt", self.module), (None, self.module)):
            first = self.python_says("""
import builtins, io, masu._library
def opened(name, *arguments, **options):
    if name != "/proc/cpuinfo" or {0!r} is None: raise FileNotFoundError(name)
    return io.StringIO("processor: 0\\nflags\\t\\t: " + {0!r} + "\\n")
builtins.open = opened
print(masu._library._candidates()[0])
""".format(flags))
            self.assertEqual(pathlib.Path(first.strip()).parent, expected, flags)


if __name__ == "__main__":
    if sys.version_info < (3, 11) or shutil.which("patchelf") is None or \
            subprocess.run([sys.executable, "-c", "import ensurepip"]).returncode:
        print("skipped: it needs Python 3.11 or later, its venv, and patchelf")
        sys.exit(77)
    unittest.main()
