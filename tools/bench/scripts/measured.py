"""What scripts that measure documents have in common: results of measure.sh, figures, tables, and where they go.

measured.py LIMIT SECTION KEY COMMAND…   runs a command for measure.sh: what it prints goes to raw/, and to runs.tsv a line:
                                         section, key, status, seconds elapsed and of processor, bytes of resident memory
                                         at most, command
"""
import argparse
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import time

STANDARD = "balls gears mount rings teapot tetra tree".split()
KINDS = "primary", "diffuse", "random"  # of rays


def record(limit, section, key, *command):
    name = f"raw/{section}.{key}"
    began = time.monotonic()
    with open(name + ".out", "wb") as out, open(name + ".err", "wb") as err:
        try:
            process = subprocess.Popen(command, stdout=out, stderr=err)
        except OSError as error:
            sys.exit(f"  failed: {error}")
        signal.signal(signal.SIGALRM, lambda *_: process.kill())
        signal.alarm(int(limit))
        _, status, usage = os.wait4(process.pid, 0)
        signal.alarm(0)
    status = os.waitstatus_to_exitcode(status)
    figures = status, time.monotonic() - began, usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024
    with open("runs.tsv", "a") as runs:
        print(section, key, *figures, " ".join(command), sep="\t", file=runs)
    if status != 0:
        said = pathlib.Path(name + ".err").read_text(errors="replace").strip().splitlines()[-1:]
        print(f"  failed ({status}): {' '.join(command)}: {''.join(said)}", file=sys.stderr)


def gather(folder):
    runs = {}
    for line in (folder / "runs.tsv").read_text().splitlines():
        section, key, status, seconds, processor, peak, command = line.split("\t")
        run = {"command": command, "status": int(status), "elapsed_seconds": float(seconds),
               "cpu_seconds": float(processor), "peak_bytes": int(peak)}
        text = (folder / "raw" / f"{section}.{key}.out").read_text()
        if status == "0":
            run["output"] = json.loads(text) if text[:1] in ("[", "{") else text or None
        else:
            run["error"] = (folder / "raw" / f"{section}.{key}.err").read_text()
        runs.setdefault(section, {})[key] = run
    return {
        "machine": dict(line.split("=", 1) for line in (folder / "machine.txt").read_text().splitlines()),
        "bytes": {path.name: path.stat().st_size for path in sorted(folder.iterdir())
                  if path.suffix in (".scene", ".grid", ".png", ".pfm")},
        "runs": runs,
    }


def figure(make, form=None):
    """The value of make(), by default to three digits, or a dash where a run that it needs is missing or failed."""
    try:
        return form.format(make()) if form else f"{float(f'{make():.3g}'):.15g}"
    except (LookupError, ValueError, TypeError, ZeroDivisionError):
        return "-"


def table(head, rows):
    titles, *lines = (f"| {' | '.join(row)} |" for row in [head, *rows])
    return "\n".join([titles, f"|{'---|' * len(head)}", *lines])


def head(results):
    """Commit, date and machine; and what isn't a measurement, or failed."""
    machine = results["machine"]
    gpu = f"GPU: {machine['device']}, driver {machine['driver']}. " if machine["backend"] == "cuda" else "No GPU. "
    lines = [f"Commit {machine['commit']}, {machine['date']}. {gpu}CPU: {machine['cpu']}, {machine['cores']} cores."]
    if machine["quick"]:
        lines.append("**Tiny sizes, to try the script: not a measurement.**")
    failed = [run["command"] for section in results["runs"].values() for run in section.values() if run["status"]]
    return "\n".join(lines + [f"Failed: `{command}`" for command in failed])


NOT_MEASURED = "Not measured: "


def made_by(makers, without_gpu=()):
    """The table of each function by its name; a sentence instead where one can't be made."""
    made = {}
    for make in makers:
        if make in without_gpu:
            made[make.__name__] = NOT_MEASURED + "needs CUDA."
            continue
        try:
            made[make.__name__] = make()
        except (LookupError, ValueError, TypeError) as missing:
            made[make.__name__] = f"{NOT_MEASURED}{missing} is missing."
    return made


def run_script(description, tables, gather_more=lambda results, folder: None):
    """tables(results): texts by name; gather_more(results, folder): what there is beside commands."""
    options = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("results", type=pathlib.Path)
    options.add_argument("--gather", type=pathlib.Path)
    options.add_argument("--into", type=pathlib.Path, nargs="+", default=[])
    given = options.parse_args()
    if given.gather:
        results = gather(given.gather)
        gather_more(results, given.gather)
        given.results.write_text(json.dumps(results, indent=1) + "\n")
    results = json.loads(given.results.read_text())
    machine = results["machine"]
    origin = f"Commit {machine['commit']}, {machine.get('device', machine['cpu'])}:\n\n"  # of tables
    made = {name: origin + text if text.startswith("|") else text for name, text in tables(results).items()}
    mark = re.compile(r"(<!-- table (\w+) -->\n).*?\n?(<!-- end -->)", re.DOTALL)

    def why_stays(found):
        """Where less was measured than for the table that is there."""
        text = made[found[2]]
        if text.startswith(NOT_MEASURED):
            return text
        has_table = "|---" in found[0]
        return "it has more figures" if has_table and text.count("| - ") > found[0].count("| - ") else ""

    def filled(found):
        why = why_stays(found) or ("other tables do" if found[2] == "head" and some_stay else "")
        if why:
            print(f"{found[2]} stays: {why}", file=sys.stderr)
            return found[0]
        return found[1] + made[found[2]] + "\n" + found[3]

    for document in given.into:
        text = document.read_text()
        some_stay = any(why_stays(found) for found in mark.finditer(text))
        document.write_text(mark.sub(filled, text))
    if not given.into:
        print("\n\n".join(f"## {name}\n\n{text}" for name, text in made.items()))


if __name__ == "__main__":
    record(*sys.argv[1:])
