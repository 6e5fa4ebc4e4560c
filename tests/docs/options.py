"""The lists of options in docs/tools/ are what `TOOL --help` says: options.py BIN_FOLDER [--write].

A page has a list between the lines `<!-- options COMMAND -->` and `<!-- end -->`. With --write it is written anew; without,
a list that differs is reported, and the exit code is 1. Lists of tools that aren't in BIN_FOLDER are left as they are.
"""
import os
import pathlib
import re
import subprocess
import sys

PAGES = pathlib.Path(__file__).resolve().parent.parent.parent / "docs" / "tools"
BLOCK = re.compile(r"(?m)^<!-- options (.+) -->\n((?:.*\n)*?)<!-- end -->$")
INDENT = " " * 26  # of descriptions (tools/common/command_line.cpp)
# docs/tools/README.md has them: these, and these where they are as everywhere.
SHARED = ("-h,", "--version")
COMMON = [["-q,--quiet", "no progress on standard error"],
          ["--threads N", "number of CPU threads; 0: all cores (0 to 4096; default 0)"]]
RENDERER = "gridrender"  # whose page has what other tools share with it


def help_of(bin_folder, command):
    environment = {name: value for name, value in os.environ.items() if name != "TMPDIR"}  # some default is there
    environment["COLUMNS"] = "400"
    tool, *subcommand = command.split()
    return subprocess.run([str(bin_folder / tool), *subcommand, "--help"], env=environment, check=True,
                          stdout=subprocess.PIPE, universal_newlines=True).stdout


def groups(text):
    """(group, [[names and argument, description], …]) of the options between the usage and what follows `General`."""
    found = []
    for line in text[text.index("\nUsage: "):].split("\n")[2:]:
        if line.endswith(":") and not line.startswith(" "):
            found.append((line[:-1], []))
        elif line.startswith(INDENT):
            option = found[-1][1][-1]
            option[1] = (option[1] + " " + line.strip()).strip()
        elif line.startswith("  "):
            names, _, description = line.strip().partition("  ")
            found[-1][1].append([names, description.strip()])
        elif found and found[-1][0] == "General":
            break
    return found


def code(names):
    return "`{}`".format(names.replace(",-", ", -"))


def line(names, description):
    """The default, which stands last in parentheses, follows the name."""
    default = ""
    notes = re.search(r" \(([^()]*)\)$", description)
    if notes:
        kept = [note for note in notes[1].split("; ") if not note.startswith("default ")]
        default = "".join(" (`{}`)".format(note[8:].strip("[]")) for note in notes[1].split("; ") if note not in kept)
        description = description[:notes.start()] + (" ({})".format("; ".join(kept)) if kept else "")
    return "- {}{}: {}\n".format(code(names), default, description.replace("*", r"\*"))


def listed(text, of_renderer=()):
    """Options that are the renderer's, too, are named in a line of their group alone."""
    lines = ""
    for group, options in groups(text):
        options = [option for option in options if not option[0].startswith(SHARED) and option not in COMMON]
        same = ", ".join(code(names) for names, _ in (option for option in options if option in of_renderer))
        own = [line(*option) for option in options if option not in of_renderer]
        own += ["- {}: as of [{r}]({r}.md)\n".format(same, r=RENDERER)] if same else []
        if own and group not in ("Positionals", "Options"):
            lines += "\n**{}**\n\n".format(group)
        lines += "".join(own)
    return lines


def commands(bin_folder, tool):
    """The tool, or its subcommands."""
    named = help_of(bin_folder, tool).partition("\nSubcommands:\n")[2].partition("\n\n")[0]
    return ["{} {}".format(tool, name) for name in re.findall(r"(?m)^  (\w+)", named)] or [tool]


def main():
    bin_folder, write = pathlib.Path(sys.argv[1]).resolve(), "--write" in sys.argv[2:]
    failed = False
    rendering = [option for _, options in groups(help_of(bin_folder, RENDERER)) for option in options]
    for page in sorted(PAGES.glob("*.md")):
        if page.name == "README.md":
            continue
        tool, text = page.stem, page.read_text(encoding="utf-8")
        if not (bin_folder / tool).exists():
            print("{}: not checked: {} isn't built".format(page.name, tool))
            continue
        for command in set(commands(bin_folder, tool)) ^ {match[1] for match in BLOCK.finditer(text)}:
            print("FAILED: {}: only one of the page and {} --help has {}".format(page.name, tool, command))
            failed = True
        new = BLOCK.sub(lambda match: "<!-- options {} -->\n{}<!-- end -->".format(
            match[1], listed(help_of(bin_folder, match[1]), () if tool == RENDERER else rendering)), text)
        if write:
            page.write_text(new, encoding="utf-8")
        elif new != text:
            print("FAILED: {}: the options aren't those of {} --help: run python3 tests/docs/options.py {} --write".format(
                page.name, tool, sys.argv[1]))
            failed = True
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
