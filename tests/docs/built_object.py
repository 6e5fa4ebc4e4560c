#!/usr/bin/env python3
"""A compiler launcher for a build of Masu as a part of another project, in FOLDER of Masu's own BUILD.

built_object.py BUILD FOLDER COMPILER ARGUMENT…

Copies the object that BUILD has of the same source, where it was compiled with the same macros, language and folders of
Masu's includes, however it was optimized; else compiles."""
import filecmp
import json
import os
import pathlib
import shlex
import shutil
import subprocess
import sys


def what_counts(arguments):
    """Of a command: without the program, warnings, optimization, other libraries' includes, and where to write what."""
    kept, rest = [], iter(arguments[1:])
    for argument in rest:
        if argument in ("-o", "-MF", "-MT", "-c", "-isystem"):
            next(rest)
        elif not argument.startswith(("-W", "-O", "-M")):
            kept.append(argument)
    return sorted(kept)


def after(arguments, option):
    return arguments[arguments.index(option) + 1] if option in arguments else ""


def built(build, folder, arguments):
    """The object in the build, or None."""
    here = os.getcwd()
    theirs = lambda path: str(path).replace(f"{build}/{folder}", str(build))
    source, target = (os.path.normpath(os.path.join(here, after(arguments, option))) for option in ("-c", "-o"))
    for command in json.loads((build / "compile_commands.json").read_text()):
        if os.path.basename(target) not in command["command"]:
            continue
        own = shlex.split(command["command"])
        found = pathlib.Path(command["directory"], after(own, "-o"))
        if os.path.normpath(found) != theirs(target) or not found.exists():
            continue
        if own[0].endswith("ccache"):
            own = own[1:]
        same = filecmp.cmp(source, command["file"], shallow=False) and \
            what_counts([theirs(argument) for argument in arguments]) == what_counts(own)
        return found if same and found.stat().st_mtime >= os.stat(command["file"]).st_mtime else None
    return None


def main():
    build, folder, *arguments = pathlib.Path(sys.argv[1]), *sys.argv[2:]
    found = built(build, folder, arguments) if "-c" in arguments else None
    if found is None:
        return subprocess.run(arguments, check=False).returncode
    shutil.copyfile(found, after(arguments, "-o"))
    if "-MF" in arguments:
        pathlib.Path(after(arguments, "-MF")).write_text(f"{after(arguments, '-o')}: {after(arguments, '-c')}\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
