#!/usr/bin/env python3
"""For developers: how good the automatic choice of a structure is, and what a step and a test should count in it.

choice.py measure BIN gpu|cpu SCENE...   builds what `gridbuild --structure fastest` considers for each scene file, and
                                         measures the rates of rays through each, in the working folder; prints JSON
choice.py fit FILE                       prints the unit costs (libgrid/structure/sampled_costs.cpp) by which the choice would
                                         be best for what was measured, `-`: standard input

Needs the Python standard library alone.
"""
import json
import math
import random
import subprocess
import sys

SETS = "across", "aimed", "scattered"
STRUCTURES = "uniform", "irregular", "bvh"
CHOICES = {"--structure fastest": STRUCTURES, "--merge auto": STRUCTURES[:2], "--merge irregular": STRUCTURES[1:2]}


def measure(tools, processor, scenes):
    def run(*command):
        done = subprocess.run([f"{tools}/{command[0]}", *command[1:]], stdout=subprocess.PIPE, check=True)
        return json.loads(done.stdout) if done.stdout else None

    backend = ["--backend", "cuda", "--size", "1024x1024", "--random", "1048576"] if processor == "gpu" else [
        "--backend", "cpu", "--size", "256x256", "--random", "262144"]
    results = {}
    for scene in scenes:
        built = run("gridbuild", scene, "-o", "choice.grid", "--structure", "fastest", "--for", processor, "--json", "-q")
        results[scene] = rows = []
        for one in built.get("considered", []):
            division = "x".join(map(str, one["division"]))
            options = ["--structure", "bvh"] if one["structure"] == "bvh" else [
                "--merge", {"uniform": "none"}.get(one["structure"], one["structure"]), "--division", division]
            run("gridbuild", scene, "-o", "choice.grid", "-q", *options)
            sets = run("gridbench", "rays", scene, "choice.grid", "--sets", "primary,diffuse,random", *backend,
                       "--warm-up", "3", "--repeat", "9", "--json")
            rates = [one_set["mrays_per_second"] for one_set in sets]
            rows.append({**one, "mrays_per_second": rates, "rate": math.prod(rates) ** (1 / len(rates))})
    return results


def score(units, row):
    """The expected time, as expected_time() has it."""
    step, test = units[row["structure"]]
    return math.prod(step * row[name][0] + test * row[name][1] for name in SETS) ** (1 / len(SETS))


def chosen(rows, time):
    """As gridbuild chooses by the expected time: what comes first, unless another takes clearly less."""
    best = rows[0]
    for row in rows[1:]:
        if time(row) < 0.95 * time(best):
            best = row
    return best


def outcomes(results, time):
    """For each scene and choice: its name, the scene's, and the rate of what is chosen over that of the fastest."""
    for choice, structures in CHOICES.items():
        for scene, rows in results.items():
            rows = [row for row in rows if row["structure"] in structures]
            if rows:
                yield choice, scene, chosen(rows, time)["rate"] / max(row["rate"] for row in rows)


def fit(results):
    """Units with the best geometric mean over all scenes and choices, by a random search from several starts."""
    def loss(units):
        ratios = [ratio for _, _, ratio in outcomes(results, lambda row: score(units, row))]
        return -sum(map(math.log, ratios)) / len(ratios)

    random.seed(1)
    best = None
    for _ in range(8):
        units = {name: [math.exp(random.gauss(0, 0.5)) for _ in range(2)] for name in STRUCTURES}
        least = loss(units)
        for turn in range(1500):
            tried = {name: list(pair) for name, pair in units.items()}
            tried[random.choice(STRUCTURES)][random.randrange(2)] *= math.exp(random.gauss(0, 0.4 * 0.998**turn))
            if (value := loss(tried)) <= least:
                units, least = tried, value
        if best is None or least < best[0]:
            best = least, units
    one = best[1]["irregular"][0]
    for name, pair in best[1].items():
        print(f"{name:10} step {pair[0] / one:.2f}, test {pair[1] / one:.2f}")
    print(f"chosen over fastest: {math.exp(-best[0]):.3f} by these, "
          f"{math.exp(-loss_of_choice(results)):.3f} as it is")


def loss_of_choice(results):
    ratios = [ratio for _, _, ratio in outcomes(results, lambda row: row["expected_time"])]
    return -sum(map(math.log, ratios)) / len(ratios)


if __name__ == "__main__":
    if len(sys.argv) == 3 and sys.argv[1] == "fit":
        fit(json.load(sys.stdin if sys.argv[2] == "-" else open(sys.argv[2])))
    elif len(sys.argv) > 4 and sys.argv[1] == "measure" and sys.argv[3] in ("gpu", "cpu"):
        print(json.dumps(measure(*sys.argv[2:4], sys.argv[4:]), indent=1))
    else:
        sys.exit(__doc__)
