#!/usr/bin/env python3
"""The tables of what accuracy.sh measured.

accuracy_tables.py RESULTS.json                  prints the tables as markdown
accuracy_tables.py RESULTS.json --into FILE…     puts each that was measured between its marks in these documents:
                                                 <!-- table NAME --> … <!-- end -->
accuracy_tables.py RESULTS.json --gather FOLDER  makes RESULTS.json of accuracy.sh's working folder first
"""
import csv
import itertools

from measured import STANDARD, head, made_by, run_script, table

FAILURES = {"missed": "missed", "false": "false", "wrong": "wrong", "misplaced": "misplaced",
            "by_grid": "by grid"}


# --- What was measured

def sweep_rows(results):
    """Rows of a precision at a step; those that compare two of them are left out."""
    return [row for row in results["runs"]["stability"]["cpu"]["output"] if "mode" in row]


def picture_rows(results):
    return results["runs"]["pictures"]["cpu"]["output"]


def names(rows):
    return list(dict.fromkeys(row["sweep"] for row in rows))


def failed(row):
    return sum(row[kind] for kind in FAILURES) / row["rays"]


def of(rows, sweep, **columns):
    return [row for row in rows if row["sweep"] == sweep and all(row[key] == value for key, value in columns.items())]


# --- Texts

def number(value):
    if value == 0 or 0.01 <= abs(value) < 1e4:
        return f"{value:.3g}" if abs(value) < 1000 else f"{value:.0f}"
    digits, exponent = f"{value:.2e}".split("e")
    return f"{float(digits):g}e{int(exponent)}"


def percent(share):
    return f"{float(f'{100 * share:.2g}'):g} %"


def span(steps):
    return number(steps[0]) if len(steps) == 1 else f"{number(steps[0])} … {number(steps[-1])}" if steps else ""


def spans(steps, among):
    """Steps in words: runs of those that are neighbours among all."""
    runs = itertools.groupby(enumerate(steps), lambda pair: among.index(pair[1]) - pair[0])
    return ", ".join(span([step for _, step in run]) for _, run in runs)


def failures(rows):
    if not rows:
        return ""
    bad = [row for row in rows if failed(row) > 0]
    if not bad:
        return "nowhere"
    worst = max(bad, key=failed)
    kind = max(FAILURES, key=lambda kind: worst[kind])
    what = f"{percent(failed(worst))} {FAILURES[kind]}"
    if len(bad) == 1:
        return f"at {number(worst['step'])}: {what}"
    steps = [row["step"] for row in rows]
    where = "everywhere" if len(bad) == len(rows) else spans([row["step"] for row in bad], steps)
    return f"{where}; worst at {number(worst['step'])}: {what}"


def envelope(rows):
    """Where most rays are sure; and failures, which there should be none of."""
    within = spans([row["step"] for row in rows if row["within_envelope"]], [row["step"] for row in rows])
    return within if all(failed(row) == 0 for row in rows) else f"{within}; **fails** {failures(rows)}"


def pixels(rows):
    off = [row for row in rows if row["pixels_off"] > 0]
    if not rows or not off:
        return "none" if rows else ""
    if len(off) <= 3:
        return ", ".join(f"{percent(row['pixels_off'])} at {number(row['step'])}" for row in off)
    worst = max(off, key=lambda row: row["pixels_off"])
    return f"up to {percent(worst['pixels_off'])}, at {number(worst['step'])}"


# --- Tables

def tables(results):
    machine, runs = results["machine"], results["runs"]
    output = lambda section, key: runs[section][key]["output"]

    def sweeps():
        """Those that fail somewhere; the others by name."""
        rows = sweep_rows(results)
        lines, right, beyond = [], [], []
        for sweep in names(rows):
            of_mode = lambda mode, store="float32": of(rows, sweep, mode=mode, store=store)
            judged = [row for row in of(rows, sweep) if row["mode"] in ("fast", "robust", "double")]
            if not any(failed(row) for row in judged):
                right.append(f"`{sweep}`")
                continue
            steps = span([row["step"] for row in of_mode("fast")])
            lines.append([f"`{sweep}`", failures(of_mode("fast")), envelope(of_mode("robust"))])
            if envelope(of_mode("double")) != steps:
                beyond.append(f"`{sweep}` ({envelope(of_mode('double'))})")
        return (table(["sweep", "`fast` fails", "`robust`"], lines) + f"\n\nNothing fails in {', '.join(right)}. "
                f"`double` is within its envelope at every step{', but for ' if beyond else ''}{', '.join(beyond)}.")

    def first_cell():
        rows = [row for row in sweep_rows(results) if row["mode"] == "first-cell-hit"]
        bad = [row for row in rows if failed(row) > 0]
        worst = max(bad, key=failed)
        kinds = {name for row in bad for kind, name in FAILURES.items() if row[kind]}
        return (f"`first-cell-hit` (`robust` with that rule) fails in {len(names(bad))} of {len(names(rows))} sweeps, "
                f"worst in `{worst['sweep']}` at {number(worst['step'])}: {percent(failed(worst))}. What it fails by: "
                f"{', '.join(sorted(kinds))}.")

    def embree():
        rows = sweep_rows(results)
        compared = [row for row in output("stability", "cpu") if "robust_right" in row]
        def sums(some):
            total = lambda what: sum(row[what] for row in some)
            return [f"{total('differing')} of {total('rays')}",
                    *(str(total(f"{who}_right")) for who in ("robust", "embree", "both", "neither"))]
        lines = [[f"`{sweep}`", *(failures(of(rows, sweep, mode=mode, store="float32")) for mode in ("embree", "embree-robust")),
                  *sums(of(compared, sweep))]
                 for sweep in names(row for row in rows if row["mode"].startswith("embree") and failed(row) > 0)]
        lines.append(["all sweeps", "", "", *sums(compared)])
        return table(["sweep", "`embree` fails", "`embree-robust` fails", "`robust`, `embree-robust` differ",
                      "right: `robust`", "Embree", "both", "neither"], lines)

    def pictures():
        rows, lines = picture_rows(results), []
        for sweep in names(rows):
            local = lambda precision: of(rows, sweep, precision=precision, origin="local")
            steps = [row["step"] for row in local("double")]
            lines.append([f"`{sweep}`", f"{local('double')[0]['parameter']}, {span(steps)}",
                          *(pixels(local(precision)) for precision in ("fast", "robust", "auto", "double")),
                          spans([row["step"] for row in local("double") if row["store"] == "float64"], steps)])
        return table(["sweep", "parameter", "`fast`", "`robust`", "`auto`", "`double`", "stored in float64"], lines)

    def oracle():
        """Of all scenes; a hierarchy has a row of its own where its counts aren't those of the irregular grid."""
        wrong = "missed", "false", "wrong", "misplaced", "unsure"
        precisions = "fast", "robust", "double"

        def counts(kind, precision):
            cells = [row for s in STANDARD for row in output("oracle", f"{s}.{kind}") if row["precision"] == precision]
            return [*(str(sum(cell[what] for cell in cells)) for what in wrong), number(max(cell["worst_t_error"] for cell in cells))]
        lines = [[f"`{precision}`", *counts("grid", precision)] for precision in precisions]
        lines += [[f"`{precision}`, hierarchy", *counts("bvh", precision)] for precision in precisions
                  if counts("bvh", precision) != counts("grid", precision)]
        lines.append(["`robust`, `first-cell-hit`", *counts("first", "robust")])
        count = output("oracle", "balls.grid")[0]["rays"]
        return table([f"{count:,} rays of each scene", *wrong, "worst relative error of t"], lines)

    structures = {("irregular", "exact"): "irregular grid", ("bvh", "exact"): "hierarchy"}

    def tradeoff():
        rows = [row for row in results["tradeoff"]["charts.csv"]
                if row["scene"] == "all" and (row["merge"], row["overlap"]) in structures]
        cell = lambda row, column: number(float(row[column]))
        lines = [[structures[row["merge"], row["overlap"]], f"`{row['precision']}`", row["stop_rule"],
                  cell(row, "mrays"), cell(row, "picture_ms"),
                  *(row[kind] for kind in ("missed", "false_hits", "wrong_primitives")),
                  *(cell(row, what) for what in ("worst_t_error", "picture_rmse", "picture_largest_error"))]
                 for row in rows]
        device = machine.get("device", f"{machine['cores']} CPU cores")
        compared = f"{int(rows[0]['rays_compared']):,}"
        chart = (f"![Speed against wrong hits and against picture error, mean of seven scenes, {device}]"
                 f"(tradeoff/{machine['backend']}/tradeoff.png)")
        return (f"{chart}\n\nOn {device}; {compared} rays of the seven scenes compared:\n\n"
                + table(["structure", "precision", "stop rule", "Mray/s", "ms per picture", "missed", "false hits",
                         "wrong primitives", "worst error of t", "picture RMSE", "largest"], lines))

    def gpu():
        rows = [row for row in output("stability", "cuda") if "backends" in row]
        count = lambda mode, what: sum(row[what] for row in rows if row["mode"] == mode)
        return " ".join(f"`{mode}`: {count(mode, 'rays'):,} rays by each of three loops, {count(mode, 'differing')} of "
                        "which differ from the CPU's hits in a bit." for mode in ("robust", "double"))

    makers = (tradeoff, sweeps, first_cell, embree, pictures, oracle, gpu)
    return {"head": head(results), **made_by(makers, {} if machine["backend"] == "cuda" else {gpu})}


def gather_more(results, folder):
    """The files that gridbench tradeoff wrote."""
    paths = [folder / "tradeoff" / name for name in ("tradeoff.csv", "charts.csv")]
    results["tradeoff"] = {path.name: list(csv.DictReader(path.open())) for path in paths if path.exists()}


if __name__ == "__main__":
    run_script(__doc__, tables, gather_more)
