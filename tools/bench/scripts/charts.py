#!/usr/bin/env python3
"""Draws the charts of docs/ from the tables and rows that are there (gnuplot).

charts.py DOCS GRIDBENCH               tradeoff/*/ of their tradeoff.csv, accuracy/*.png of the .csv beside them, peers.png
                                       and answer-*.png of tables of performance.md, lesson/tradeoff.png of one of lesson.md
charts.py DOCS GRIDBENCH RESULTS.json  the same, with the rows of accuracy/ from what accuracy.sh measured
"""
import csv
import itertools
import json
import pathlib
import re
import subprocess
import sys
import tempfile

from accuracy_tables import failed, picture_rows, sweep_rows
from measured import KINDS

SCRIPTS = pathlib.Path(__file__).resolve().parent.parent / "charts"
PEERS = {"cwbvh": 4, "cubql": 5, "optix": 6, "hagrid": 8}  # columns of performance.md's table
LESSON = {"teapot": 4, "balls": 7}             # columns of tests, cells and nanoseconds per ray in lesson.md's table
ACCURACY = {  # title, share that is drawn as none
    "sweeps": ("Wrong hits: missed, false, wrong, misplaced or by grid, share of rays", 1e-7),
    "embree": ("Wrong hits of triangles: missed, false, wrong, misplaced or by grid, share of rays", 1e-7),
    "pictures": ("Pixels of which a channel is off by more than 1/50, share of all", 1e-5),
}


def plot(script, folder, **variables):
    settings = "; ".join(f"{name}='{value}'" if isinstance(value, str) else f"{name}={value}"
                         for name, value in variables.items())
    subprocess.run(["gnuplot", "-e", settings, SCRIPTS / "style.gp", SCRIPTS / f"{script}.gp"], cwd=folder, check=True)


def table(document, head):
    """The rows of the table whose head begins so: lists of cells."""
    lines = iter(document.read_text().splitlines())
    next(line for line in lines if line.startswith(head))
    next(lines)
    rows = itertools.takewhile(lambda line: line.startswith("|"), lines)
    return [[cell.strip() for cell in line.strip("| ").split("|")] for line in rows]


def write_rows(file, head, rows):
    csv.writer(file, lineterminator="\n").writerows([head, *rows])
    file.flush()


def plot_rows(script, folder, head, rows, **variables):
    with tempfile.NamedTemporaryFile("w", suffix=".csv", newline="") as data:
        write_rows(data, head, rows)
        plot(script, folder, data=data.name, **variables)


def write_accuracy(results, folder):
    """The rows of the charts of accuracy.md."""
    rows = sweep_rows(results)
    beside = {row["sweep"] for row in rows if row["mode"] == "embree"}
    kept = {name: [] for name in ACCURACY}
    for row in rows:
        if row["store"] == "float32" and row["mode"] != "first-cell-hit":
            kept["embree" if row["sweep"] in beside else "sweeps"].append((row, row["mode"], failed(row)))
    for row in picture_rows(results):
        if row["origin"] == "local":
            kept["pictures"].append((row, row["precision"], row["pixels_off"]))
    for name, those in kept.items():
        with open(folder / f"{name}.csv", "w", newline="") as file:
            write_rows(file, ["sweep", "parameter", "step", "mode", "share"],
                       [[row["sweep"], re.split("[,;(]", row["parameter"])[0], row["step"], mode, share]
                        for row, mode, share in those])


def draw_accuracy(folder):
    """A panel for each sweep that fails; the document names the others."""
    for name, (title, floor) in ACCURACY.items():
        with open(folder / f"{name}.csv", newline="") as file:
            head, *rows = csv.reader(file)
        failing = {row[0] for row in rows if float(row[-1]) > 0}
        plot_rows("accuracy", folder, head, [row for row in rows if row[0] in failing], out=f"{name}.png",
                  title=f"{title} (lower is better)", floor=floor)


def draw_peers(docs):
    rows = table(docs / "performance.md", "| scene | `fastest` takes |")
    plot_rows("peers", docs, ["kind", "line", "scene", *PEERS],
              [[kind, line, f"{row[0].removesuffix('-triangles')} ({'hierarchy' if row[1] == '`bvh`' else 'irregular'})",
                *(row[column].split(", ")[i] for column in PEERS.values())]
               for line, row in enumerate(reversed(rows), 1) for i, kind in enumerate(KINDS)], out="peers.png")


def draw_answer(docs):
    """A chart for each processor: preparing, then rays at their rate."""
    points = {}
    for what, *cells in table(docs / "performance.md", "| triangles, on | Masu |"):
        triangles, processor = what.split(", ")
        panels = points.setdefault(processor, [])
        panel = panels[-1][0] + 1 if panels else 1
        for line, cell in enumerate(cells[:-2], 1):  # but bytes and moves
            if cell != "-":
                prepare, rate = (float(n) for n in cell.split(", "))
                panels.extend([panel, triangles.replace(",", ""), line, 10**(k / 4), prepare * 1e-3 + 10**(k / 4) / rate * 1e-6]
                              for k in range(12, 37))
    for processor, rows in points.items():
        plot_rows("answer", docs, ["panel", "triangles", "line", "rays", "seconds"], rows, machine=processor,
                  out=f"answer-{'cpu' if 'cores' in processor else 'gpu'}.png")


def draw_lesson(docs):
    rows = table(docs / "lesson.md", "| voxels per axis |")
    with tempfile.TemporaryDirectory() as folder:
        for scene, first in LESSON.items():
            lines = [" ".join([row[0], *row[first:first + 3]]) for row in rows]
            pathlib.Path(folder, f"{scene}.dat").write_text("\n".join(lines) + "\n")
        plot("lesson", folder, out=str(docs / "lesson" / "tradeoff.png"))


def main():
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    docs, gridbench = (pathlib.Path(path).resolve() for path in sys.argv[1:3])
    if len(sys.argv) == 4:
        write_accuracy(json.loads(pathlib.Path(sys.argv[3]).read_text()), docs / "accuracy")
    draw_accuracy(docs / "accuracy")
    draw_peers(docs)
    draw_answer(docs)
    draw_lesson(docs)
    for rows in sorted(docs.glob("tradeoff/*/tradeoff.csv")):
        subprocess.run([gridbench, "tradeoff", "--charts-only", "-o", rows.parent], check=True)


if __name__ == "__main__":
    main()
