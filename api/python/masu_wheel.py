"""Builds the wheel of the module `masu` for pip and python3-build (a back end by PEP 517, named in pyproject.toml).

A wheel holds the module, libmasu.so and the shared libraries that this needs, unless every Linux has them. They have
names of their own there, so that another package's TBB in the same process is another library. On x86-64 libmasu.so is
built twice: masu/x86-64-v3/ has it for processors with AVX2 and FMA, with CUDA where there is nvcc; masu/ has it for
older processors, without CUDA. The module chooses when it is imported.

The wheel's tag names the oldest C library that has what the libraries import (PEP 600). Environment: CMAKE_ARGS, more
options of cmake. Settings: library=FILE, a libmasu.so that is already built and is taken for each. Needs Python 3.11,
patchelf, and what the library's build needs. Only Python's own modules are imported: nothing is downloaded.
"""

import base64
import hashlib
import os
import pathlib
import platform
import re
import shlex
import shutil
import subprocess
import tempfile
import tomllib
import zipfile

SOURCE = pathlib.Path(__file__).resolve().parents[2]
MACHINE = platform.machine()

# What the system provides, by PEP 600: the C library and GCC's libraries.
SYSTEM = re.compile(r"(lib(c|m|dl|rt|pthread|stdc\+\+|gcc_s)|ld-linux[-\w]*)\.so\.\d+")
# N of the C library 2.N that distributions have beside a version of GCC's C++ library, by the last number of a symbol's
# version: GCC 8 with 28, 10 with 31, 11 with 34, 12 with 35, 13 with 38, 14 with 39.
GLIBC_BESIDE = {"GLIBCXX_3.4": {25: 28, 28: 31, 29: 34, 30: 35, 32: 38, 33: 39},
                "CXXABI_1.3": {11: 28, 12: 31, 13: 34, 14: 38, 15: 39}}
# Packages of Debian whose code is in the wheel; their licences are, too.
CONTAINED = ("libflatbuffers-dev", "libfmt-dev", "libtbb-dev", "libxxhash-dev")


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    project = tomllib.loads((SOURCE / "pyproject.toml").read_text())["project"]
    version = re.search(r"project\(masu VERSION (\S+)", (SOURCE / "CMakeLists.txt").read_text())[1]
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        module = root / "masu"
        shutil.copytree(SOURCE / "api/python/masu", module, ignore=shutil.ignore_patterns("__pycache__"))
        for name, library in _libraries(config_settings or {}).items():
            _add(library, module, module / name)
        least, symbol = _least_glibc([file for file in module.rglob("*.so.*")])
        tag = "py3-none-manylinux_2_{}_{}".format(least, MACHINE)
        _describe(root / "masu-{}.dist-info".format(version), project, version, tag)
        wheel = "masu-{}-{}.whl".format(version, tag)
        _pack(root, pathlib.Path(wheel_directory) / wheel)
    print("{}: the C library must be 2.{} or later for {}".format(wheel, least, symbol), flush=True)
    return wheel


# --- Libraries ----------------------------------------------------------------------------------------------------

def _libraries(settings):
    """The builds of libmasu.so by their folders in the module."""
    builds = {"": ["-DMASU_AVX2=OFF"]}
    if MACHINE == "x86_64":
        builds = {"": ["-DMASU_AVX2=OFF", "-DMASU_CUDA=OFF"], "x86-64-v3": ["-DMASU_AVX2=ON"]}
    if "library" in settings:
        return dict.fromkeys(builds, pathlib.Path(settings["library"]).resolve())
    return {name: _compile(SOURCE / "build/wheel" / (name or "baseline"), options) for name, options in builds.items()}


def _compile(folder, options):
    generator = ["-G", "Ninja"] if shutil.which("ninja") and not (folder / "CMakeCache.txt").exists() else []
    parts_not_needed = ["-DMASU_{}=OFF".format(part) for part in ("TESTS", "ASSIMP", "MPI", "VIEW", "EMBREE")]
    subprocess.run(["cmake", "-S", SOURCE, "-B", folder, *generator, "-DCMAKE_BUILD_TYPE=Release", "-DMASU_STATIC=ON",
                    *parts_not_needed, *shlex.split(os.environ.get("CMAKE_ARGS", "")), *options], check=True)
    subprocess.run(["cmake", "--build", folder, "--target", "masu_shared", "--parallel", str(os.cpu_count())],
                   check=True)
    return folder / "api/libmasu.so"


def _add(library, module, folder):
    """Puts a build of libmasu.so into its folder, and what it needs into the module's."""
    needed = dict(re.findall(r"^\s*(\S+) => (/\S+)", _output("ldd", library), re.MULTILINE))
    needed = {name: path for name, path in needed.items() if not SYSTEM.fullmatch(name)}
    renamed = {name: name.replace(".so", "-masu.so", 1) for name in needed}
    soname = re.search(r"SONAME +(\S+)", _output("objdump", "-p", library))[1]
    copies = {folder / soname: library, **{module / renamed[name]: path for name, path in needed.items()}}
    folder.mkdir(exist_ok=True)
    for copy, original in copies.items():
        shutil.copy(original, copy)
        _output("strip", "--strip-unneeded", copy)
        path = pathlib.PurePosixPath("$ORIGIN", os.path.relpath(module, copy.parent))
        # One change a call: patchelf 0.14 gives one change another's argument.
        for change in [("--set-soname", copy.name), ("--set-rpath", path),
                       *[("--replace-needed", name, renamed[name]) for name in needed]]:
            _output("patchelf", *change, copy)


def _least_glibc(libraries):
    """The least N for which the C library 2.N and the C++ library beside it have all imports, and the import that sets
    it."""
    found = []
    for library in libraries:
        for group, number, symbol in re.findall(r"\*UND\*.*\((GLIBC_2|GLIBCXX_3\.4|CXXABI_1\.3)\.(\d+)[\d.]*\) +(\S+)",
                                                _output("objdump", "-T", library)):
            name = "{} ({}.{}, {})".format(symbol, group, number, library.name)
            beside = GLIBC_BESIDE.get(group, {int(number): int(number)})
            if int(number) > max(beside):
                raise RuntimeError("{}: which C library is beside it isn't known: add it to GLIBC_BESIDE".format(name))
            found.append((min(least for last, least in beside.items() if last >= int(number)), name))
    return max(found)


def _output(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout


# --- The file -----------------------------------------------------------------------------------------------------

def _describe(folder, project, version, tag):
    licenses = folder / "licenses"
    licenses.mkdir(parents=True)
    (folder / "METADATA").write_text("".join("{}: {}\n".format(*field) for field in [
        ("Metadata-Version", "2.1"), ("Name", project["name"]), ("Version", version),
        ("Summary", project["description"]), ("License", project["license"]["text"]),
        ("Requires-Python", project["requires-python"]),
        *[("Classifier", classifier) for classifier in project["classifiers"]]]))
    (folder / "WHEEL").write_text("Wheel-Version: 1.0\nGenerator: masu {}\nRoot-Is-Purelib: false\nTag: {}\n".format(
        version, tag))
    shutil.copy(SOURCE / "LICENSE", licenses)
    notices = {name: pathlib.Path("/usr/share/doc", name, "copyright") for name in CONTAINED}
    notices["Apache-2.0"] = pathlib.Path("/usr/share/common-licenses/Apache-2.0")
    for name, notice in notices.items():
        if notice.exists():
            shutil.copy(notice, licenses / name)


def _pack(root, wheel):
    """The same files make the same bytes. RECORD has the hash of every other file."""
    record = next(root.glob("*.dist-info")) / "RECORD"
    files = sorted(file for file in root.rglob("*") if file.is_file())
    lines = []
    for file in files:
        digest = base64.urlsafe_b64encode(hashlib.sha256(file.read_bytes()).digest()).decode().rstrip("=")
        lines.append("{},sha256={},{}\n".format(file.relative_to(root), digest, file.stat().st_size))
    record.write_text("".join(lines) + "{},,\n".format(record.relative_to(root)))
    wheel.parent.mkdir(parents=True, exist_ok=True)
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as archive:
        for file in [*files, record]:
            entry = zipfile.ZipInfo(str(file.relative_to(root)))
            entry.external_attr = (0o755 if ".so" in file.name else 0o644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, file.read_bytes(), compresslevel=9)
