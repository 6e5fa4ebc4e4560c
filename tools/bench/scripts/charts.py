#!/usr/bin/env python3
"""Draws the charts of docs/performance.md and docs/accuracy.md anew from the tables and rows that are there (gnuplot).

charts.py DOCS GRIDBENCH   peers.png of performance.md's table, tradeoff/*/ of their tradeoff.csv
"""
import pathlib
import subprocess
import sys
import tempfile

KINDS = "primary", "diffuse", "random"
PEERS = "Masu / CWBVH", "/ OptiX", "/ hagrid's best"


def table(document, name):
    """The rows between a table's marks, by column."""
    text = document.read_text().split(f"<!-- table {name} -->")[1].split("<!-- end -->")[0]
    head, _, *rows = [[cell.strip() for cell in line.strip("| ").split("|")] for line in text.strip().splitlines()]
    return [dict(zip(head, row)) for row in rows]


def draw_peers(docs):
    rows = table(docs / "performance.md", "peers")
    with tempfile.NamedTemporaryFile("w", suffix=".dat") as data:
        for line, row in enumerate(reversed(rows), 1):
            ratios = [row[peer].split(", ") for peer in PEERS]
            for i, kind in enumerate(KINDS):
                print(kind, line, row["scene"], *(ratio[i] for ratio in ratios), sep="\t", file=data)
        data.flush()
        script = pathlib.Path(__file__).parent / "peers.gp"
        subprocess.run(["gnuplot", "-e", f"data='{data.name}'; out='{docs / 'peers.png'}'", script], check=True)


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    docs, gridbench = pathlib.Path(sys.argv[1]), sys.argv[2]
    draw_peers(docs)
    for rows in sorted(docs.glob("tradeoff/*/tradeoff.csv")):
        subprocess.run([gridbench, "tradeoff", "--charts-only", "-o", rows.parent], check=True)


if __name__ == "__main__":
    main()
