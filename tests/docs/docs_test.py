"""Types what a page of the documentation says, as its reader does: docs_test.py BUILD PAGE FOLDER.

The reader is in the source's folder after a build, in a new shell (bash): FOLDER, made anew and kept, is a copy of the
source with the programs of BUILD in build/, and neither the PATH nor files are prepared. A page that links to the "first
commands" (docs/tools/README.md#first-commands) is typed after these; any other file is made by a command of the page.

Commands are indented blocks. Those of a page are run one after another, and must end with 0. An indented block that
begins with `$ ` also has what its commands print, which must be the same. Fenced blocks say their language; one whose
first line is a comment with a file's name is written to that file, for the commands that follow. What can't be run is
named below with the reason; anything else fails. Environment: PYTHON, an interpreter with NumPy, which is python3 here.
"""

import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

# Commands that aren't run here, and why.
NOT_RUN = {
    r"^tools/(demo|test)\.sh": "install packages and build everything; test.sh runs this test",
    r"^pip install": "installs for the user: wheel_test.py installs into an environment of its own",
    r"tools/bench/scripts/(performance|accuracy)(\.sh|_tables\.py)": "take minutes to hours on a quiet machine",
    r"preset fuzz|^tests/fuzz/|^build/fuzz/": "need clang and minutes: tools/check.sh --full",
    r"preset tsan|^tests/sanitizers/tsan_tbb\.sh": "need packages' sources and minutes: tools/check.sh --full",
    r"^tools/bench/scripts/(charts|pictures)\.": "draw what is in docs/: run by Docs.pictures",
    r"^ssh ": "needs another machine",
    r"^srun ": "needs Slurm",
    r"--map-by ppr:4:node": "needs two machines",
}
# Fenced blocks that aren't typed.
OTHER_LANGUAGES = {"text": "not code", "json": "not code", "cuda": "examples_test.sh has a program",
                   "python": "needs PyTorch: run by python_gpu_test.py and python_torch_test.py"}
# Programs that are built where what they need was found.
OPTIONAL_PROGRAMS = ("mesh2bin", "gridview", "gridrender-mpi", "gridtrace-mpi", "masu_cpu_rays")
# How much is done, where it would take minutes, and on which device: a CPU is always there.
SMALLER = [
    (r"--repeat \d+", "--repeat 1"),
    (r"(gridbench (?:rays|frame)(?!.*--repeat))", r"\1 --repeat 1 --warm-up 0"),
    (r"--size \d{4,}x\d{4,}", "--size 64x48"),
    (r"(gridbench rays .*)--size \d{3,}x\d{3,}", r"\1--size 64x64"),
    (r"(gridbench rays(?!.*--size))", r"\1 --size 64x64 --random 1000"),
    (r"(gridrender .*--hits \S+(?!.*--size))", r"\1 --size 64x64"),
    (r"--turntable \d{2,}", "--turntable 3"),
    (r"--views \d{2,}", "--views 2"),
    (r"(gridview .*--export \S+(?!.*--size))", r"\1 --size 64x48"),
    (r"(gridview .*--export \S+(?!.*--views))", r"\1 --views 2"),
    (r"--count \d{4,}", "--count 100"),
    (r"--divisions 2,4,8,16,32,64,128", "--divisions 2,4,8"),
    (r"(gridbench stability(?!.*--count))", r"\1 --count 20"),
    (r"gridbench tradeoff", "gridbench tradeoff --precisions robust --merges none --overlaps exact --divisions 4 "
                            "--curve 4 --size 16x16 --random 64 --compared 64 --picture 8x8 --repeat 1"),
    (r"(gridbench rays .*)--loop \S+", r"\1"),  # loops are a GPU's
    (r"--(backend|device) cuda", r"--\1 cpu"),
    (r"--devices \S+", "--devices cpu"),
    (r"/opt/masu", "$SOURCE/opt/masu"),
]

# What stands for the programs of other packages while commands are typed. `cmake --build` of this source puts the
# tested build's products where a build would have put them; nothing is installed outside the folder.
SHELL = r"""
set -euo pipefail
SOURCE=$PWD
# Of a machine with one core, and without fast networks, which libfabric takes a second to look for.
export OMPI_MCA_btl=^ofi
export OMPI_MCA_rmaps_base_oversubscribe=1 PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe
export PYTHONDONTWRITEBYTECODE=1
where="the beginning"
trap 'code=$?; [ $code = 0 ] || echo "FAILED: $where ended with $code"' EXIT
say() { where=$1; printf '\n== %s\n' "$1"; }
made() { # folder
  mkdir -p "$1/bin" "$1/api" "$1/tools/package"
  cp -fl "$TESTED"/bin/* "$1/bin/"
  cp -fdl "$TESTED"/api/libmasu.so* "$1/api/"
  if ls "$TESTED"/tools/package/*.1.gz >/dev/null 2>&1; then cp -fl "$TESTED"/tools/package/*.1.gz "$1/tools/package/"; fi
}
cmake() {
  case "$*" in
    "--preset "*) command cmake "$@" "${CONFIGURED[@]}" ;;
    "--build build" | "--build build "*) made build ;;
    "--build --preset "*) made "build/$3" ;;
    "--install "*--prefix*) command cmake "$@" ;;
    "--install "*) command cmake "$@" --prefix "$PWD/usr" ;;
    "-S examples "*) command cmake "$@" -DCMAKE_CUDA_COMPILER=NOTFOUND ;; # examples_test.sh compiles that of CUDA
    *) command cmake "$@" ;;
  esac
}
ctest() { # the tested build's tests are listed: there must be some
  case "$*" in
    *"--test-dir build "*) command ctest "${@/#build/$TESTED}" -N | tee "$SOURCE/typed/printed" | grep 'Total Tests: [1-9]' ;;
    *) command ctest "$@" ;;
  esac
}
gridview() { # which serves until it is ended
  if [[ $* = *--export* || $* = *--help* ]]; then command gridview "$@"; return; fi
  rm -f "$SOURCE/typed/address" # of the one before
  command gridview "$@" --port 0 >"$SOURCE/typed/address" &
  until [ -s "$SOURCE/typed/address" ]; do kill -0 $! 2>/dev/null || break; sleep 0.1; done
  kill $! 2>/dev/null || true # ended by itself: with which code?
  wait $!
}
python3() { command "$PYTHON" "$@"; }
apt-get() { # install: the same packages as tools/setup.sh's
  (
    source tools/setup.sh
    known=" ${basics[*]} ${extras[*]} ${benchmarks[*]} ${tests[*]} libgtest-dev "
    for package in "${@:2}"; do
      [[ $package = -* || $known = *" $package "* ]] || { echo "tools/setup.sh has no $package"; exit 1; }
    done
    for package in $known; do [[ " $* " = *" $package "* ]] || { echo "$package is missing"; exit 1; }; done
  )
}
"""


HEAD = "docs/tools/README.md"


def blocks(text):
    """(number of the first line, language, text) of each code block; the language of an indented one is ""."""
    lines = text.split("\n")
    found, at, in_list, blank = [], 0, False, True
    while at < len(lines):
        line = lines[at]
        if line.startswith("```"):
            end = lines.index("```", at + 1)
            found.append((at + 2, line[3:].strip() or "no language", "\n".join(lines[at + 1:end])))
            at = end
        elif line.startswith("    ") and blank and not in_list:
            end = at
            while end < len(lines) and (lines[end].startswith("    ") or not lines[end].strip()):
                end += 1
            found.append((at + 1, "", "\n".join(row[4:] for row in lines[at:end]).rstrip()))
            at = end - 1
        elif line and not line.startswith(" "):
            in_list = re.match(r"(-|\d+\.) ", line) is not None or (in_list and not blank)
        blank = not line.strip() or at >= len(lines) or not lines[at].strip()
        at += 1
    return found


def commands(text):
    """(number of the line, command) of a block: lines are joined until the shell takes them for whole."""
    found, pending, first = [], [], 0
    for number, line in enumerate(text.split("\n")):
        if not pending:
            first = number
        pending.append(line)
        whole = "\n".join(pending)
        judged = subprocess.run(["bash", "-n"], input=whole + "\n", stderr=subprocess.PIPE, universal_newlines=True)
        if judged.returncode == 0 and not judged.stderr and not whole.endswith("\\"):
            if any(row.strip() and not row.strip().startswith("#") for row in pending):
                found.append((first, whole))
            pending = []
    if pending:
        found.append((first, "\n".join(pending)))  # which the shell will refuse
    return found


class Page:
    """The shell script that types a page."""

    def __init__(self, name, tested, typed):
        self.name = name
        self.tested = tested
        self.typed = typed
        self.script = [SHELL, "made build"]
        self.failures = []

    def file(self, name, text):
        (self.typed / name).write_text(text, encoding="utf-8")
        return '"$SOURCE/typed/{}"'.format(name)

    def run(self, line, command, shown=None):
        where = "{}:{}".format(self.name, line)
        # After an AND list the shell itself goes on.
        self.script += ["say {}".format(shlex.quote(where + ": " + (shown or command))), command, "(exit $?)"]

    def reason_not_run(self, command):
        """"" where it can be run."""
        reasons = [reason for pattern, reason in NOT_RUN.items() if re.search(pattern, command)]
        reasons += [name + " isn't built" for name in OPTIONAL_PROGRAMS
                    if re.search(r"(^|[\s/|]){}\b(?!-)".format(name), command) and not (self.tested / "bin" / name).exists()]
        return "; ".join(reasons)

    def skip(self, line, command, reason):
        self.script.append("say {}".format(shlex.quote("{}:{}: not run: {} ({})".format(
            self.name, line, command, reason))))

    def type(self, line, command):
        if reason := self.reason_not_run(command):
            self.skip(line, command, reason)
            return
        typed = command
        for pattern, smaller in SMALLER:
            command = re.sub(pattern, smaller, command)
        self.run(line, command, typed if typed == command else typed + "\n   run as: " + command)

    def console(self, line, text):
        """`$ COMMAND`, then what it prints, and so on."""
        rows = text.split("\n")
        starts = [number for number, row in enumerate(rows) if row.startswith("$ ")] + [len(rows)]
        for start, end in zip(starts, starts[1:]):
            command = rows[start][2:]
            if reason := self.reason_not_run(command):
                self.skip(line + start, command, reason)
                continue
            printed = "".join(row + "\n" for row in rows[start + 1:end])
            expected = self.file("{}.expected".format(line + start), printed)
            self.run(line + start, '{{ {}; }} >"$SOURCE/typed/printed"'.format(command), command)
            self.run(line + start, 'diff -u {} "$SOURCE/typed/printed"'.format(expected), "prints what the page shows")

    def fenced(self, line, language, text):
        named = re.match(r"(?:#|//|/\*) ([\w.]+\.\w+)\b", text)
        if named:
            self.run(line, "cp {} {}".format(self.file(named[1], text + "\n"), named[1]), "the file " + named[1])
        elif language in OTHER_LANGUAGES:
            self.skip(line, language, OTHER_LANGUAGES[language])
        else:
            self.failures.append("{}:{}: a fenced block of {} that names no file: indent commands".format(
                self.name, line, language))

    def type_blocks(self, first_line, text):
        for line, language, block in blocks(text):
            line += first_line - 1
            if language:
                self.fenced(line, language, block)
            elif block.startswith("$ "):
                self.console(line, block)
            else:
                for number, command in commands(block):
                    self.type(line + number, command)


def first_commands(source):
    """(number of the first line, text) of the section that pages link to."""
    before, head, rest = (source / HEAD).read_text(encoding="utf-8").partition("\n## First commands\n")
    assert head, HEAD
    return (before + head).count("\n") + 1, rest.partition("\n## ")[0]


def configured_options(tested):
    """Presets are configured for what the tested build has, whose products they get; but for CUDA, whose compiler CMake
    takes most of the time to examine, and of which nothing is installed."""
    options = ["-DCMAKE_SKIP_INSTALL_ALL_DEPENDENCY=ON", "-DMASU_CUDA=OFF"]
    for line in (tested / "CMakeCache.txt").read_text().splitlines():
        match = re.match(r"((?:MASU_(?:ASSIMP|EMBREE|MPI|VIEW))|HELP2MAN):\w+=(.*)", line)
        if match:
            options.append("-D{}={}".format(*match.groups()))
    return options


def stale_lists(source):
    """What NOT_RUN names and no page types any more."""
    pages = [source / "README.md"] + sorted((source / "docs").rglob("*.md"))
    typed = [command for page in pages for _, language, text in blocks(page.read_text(encoding="utf-8"))
             if not language for _, command in commands(text)]
    return [pattern for pattern in NOT_RUN if not any(re.search(pattern, command) for command in typed)]


def not_copied(folder, names):
    """What is no source: what commands make, and builds."""
    at_top = os.path.exists(os.path.join(folder, "CMakePresets.json")) # libgrid has a folder build, too
    return [name for name in names if name == "__pycache__" or (at_top and name in ("build", "out", ".git")) or
            os.path.exists(os.path.join(folder, name, "CMakeCache.txt"))]


def main():
    source = pathlib.Path(__file__).resolve().parent.parent.parent
    tested, name, folder = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2], pathlib.Path(sys.argv[3]).resolve()
    shutil.rmtree(folder, ignore_errors=True)
    shutil.copytree(source, folder, ignore=not_copied)
    (folder / "typed").mkdir()

    page = Page(name, tested, folder / "typed")
    text = (folder / name).read_text(encoding="utf-8")
    if name != HEAD and "README.md#first-commands)" in text:
        page.type_blocks(*first_commands(source))
    page.type_blocks(1, text)
    if name == "README.md": # once: it reads every page
        page.failures += ["NOT_RUN has {}, which no page types any more".format(p) for p in stale_lists(source)]
    kept = ("HOME", "PATH", "LANG", "LC_ALL", "TMPDIR", "PYTHON") # of the environment
    environment = {key: os.environ[key] for key in kept if key in os.environ}
    environment["TESTED"] = str(tested)
    options = "CONFIGURED=({})\n".format(" ".join(shlex.quote(option) for option in configured_options(tested)))
    page.file("script.sh", options + "\n".join(page.script) + "\n")
    ended = subprocess.run(["bash", "typed/script.sh"], cwd=str(folder), env=environment, stdin=subprocess.DEVNULL,
                           stderr=subprocess.STDOUT)
    for failure in page.failures:
        print("FAILED:", failure)
    return 1 if page.failures or ended.returncode else 0


if __name__ == "__main__":
    sys.exit(main())
