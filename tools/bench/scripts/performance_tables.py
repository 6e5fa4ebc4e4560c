#!/usr/bin/env python3
"""The tables of what performance.sh measured.

performance_tables.py RESULTS.json                  prints them as markdown
performance_tables.py RESULTS.json --into FILE…     puts each that was measured between its marks in these documents:
                                                    <!-- table NAME --> … <!-- end -->
performance_tables.py RESULTS.json --gather FOLDER  makes RESULTS.json of performance.sh's working folder first
performance_tables.py RESULTS.json --fit            prints the unit costs (libgrid/structure/sampled_costs.cpp) by which the choice
                                                    of a structure would be best for what section choices measured
"""
import json
import math
import pathlib
import random
import statistics
import sys

from measured import KINDS, STANDARD, figure, head, made_by, run_script, table

LARGE = "teapot-60 mount-10-triangles tetra-9 tetra-10 balls-triangles tree-triangles rings-triangles".split()


(_, *peers), *rates_of_peers = [line.split("\t") for line in (pathlib.Path(__file__).parent / "peers.tsv").read_text().splitlines()
                                if line[0] != "#"]
PEERS = {scene: {name: [float(n) for n in cell.split()] for name, cell in zip(peers, cells)} for scene, *cells in rates_of_peers}
# By triangles: milliseconds to prepare and million rays per second, by cuBQL's two builders.
ANSWERS = {row[0]: row[1:] for row in map(str.split, (pathlib.Path(__file__).parent / "answers.tsv").read_text().splitlines())
           if row[0] != "#"}

# Steps and tests a ray, of the pictures of 513x513 pixels: the least of the grids and octrees that V. Havran compared.
HAVRAN = dict(balls=25.8, gears=35.5, mount=26.9, rings=38.6, teapot=34.4, tetra=25.5, tree=13.6)


# --- The choice of a structure -------------------------------------------------------------------------------------

STRUCTURES = "uniform", "irregular", "bvh"
CHOICES = {"--structure fastest": STRUCTURES, "--merge auto": STRUCTURES[:2], "--merge irregular": STRUCTURES[1:2]}


def considered(results, processor):
    """For each scene the grids and the hierarchy that may be chosen, as gridbuild says it, with the geometric mean of
    their rates."""
    runs, found = results["runs"]["choice"], {}
    for key, run in runs.items():
        of, _, scene = key.partition(".")
        if of != processor or not scene.endswith(".grid") or not run.get("output"):
            continue
        scene = scene.removesuffix(".grid")
        fastest = runs[f"{of}.{scene}.fastest"]["output"]["considered"]
        found[scene] = rows = []
        for i, one in enumerate([*run["output"]["considered"], *(one for one in fastest if one["structure"] == "bvh")]):
            rates = [row["mrays_per_second"] for row in runs[f"{of}.{scene}.{i}"]["output"]]
            rows.append({**one, "rate": statistics.geometric_mean(rates)})
    return found


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
    def expected(row):  # as expected_time() has it
        step, test = units[row["structure"]]
        return statistics.geometric_mean(step * row[name][0] + test * row[name][1]
                                         for name in ("across", "aimed", "scattered"))

    def loss(time):
        return -statistics.fmean(math.log(ratio) for _, _, ratio in outcomes(results, time))

    random.seed(1)
    best = math.inf, {}
    for _ in range(8):
        units = {name: [math.exp(random.gauss(0, 0.5)) for _ in range(2)] for name in STRUCTURES}
        least, kept = loss(expected), units
        for turn in range(1500):
            units = {name: list(pair) for name, pair in kept.items()}
            units[random.choice(STRUCTURES)][random.randrange(2)] *= math.exp(random.gauss(0, 0.4 * 0.998**turn))
            if (value := loss(expected)) <= least:
                least, kept = value, units
        best = min(best, (least, kept), key=lambda pair: pair[0])
    one = best[1]["irregular"][0]
    for name, pair in best[1].items():
        print(f"{name:10} step {pair[0] / one:.2f}, test {pair[1] / one:.2f}")
    print(f"chosen over fastest: {math.exp(-best[0]):.3f} by these, "
          f"{math.exp(-loss(lambda row: row['expected_time'])):.3f} as it is")


# --- Tables --------------------------------------------------------------------------------------------------------

def fastest(results, scene):
    """The name of the grid that `--structure fastest` takes: the scene's irregular one, or its hierarchy."""
    return f"{scene}-bvh" if "nodes" in results["runs"]["fastest"][scene]["output"] else scene


def rates(results, scene, grid):
    """Mray/s of primary, diffuse and random rays by the loop `auto`, which is measured first."""
    rows = [row for row in results["runs"]["rays"][scene]["output"] if row["grid"] == f"{grid}.grid"]
    return [next(row["mrays_per_second"] for row in rows if row["rays"] == kind) for kind in KINDS]


def joined(numbers, form=".0f"):
    return ", ".join(f"{number:{form}}" for number in numbers)


def ms(make):
    return figure(lambda: make() * 1e3)


def tables(results):
    machine, size, runs = results["machine"], results["bytes"], results["runs"]
    output = lambda section, key: runs[section][key]["output"]
    seconds = lambda section, key, what="trace": output(section, key)["seconds"][what]
    primitives = lambda name: output("scenes", name)["primitives"]["total"]
    megabytes = lambda file: figure(lambda: size[file] * 1e-6)
    device = machine.get("device", f"{machine['cores']} cores")
    cuda = machine["backend"] == "cuda"

    def readme():
        rows = [["primitives", *(figure(lambda: primitives(s), "{}") for s in STANDARD)],
                [f"{device}, chosen structure", *(ms(lambda: seconds("pictures", f"{s}.chosen")) for s in STANDARD)],
                [f"{device}, uniform grid", *(ms(lambda: seconds("pictures", f"{s}.uniform")) for s in STANDARD)],
                ["one core, chosen structure", *(ms(lambda: seconds("one_core", s)) for s in STANDARD)]]
        return table(["", *STANDARD], rows)

    def views():
        part = lambda what: figure(lambda: seconds("views", "png", what))
        return table(["views", "trace, s", "download, s", "encode and write, s", "load, s", "whole process, s"],
                     [[figure(lambda: output("views", "png")["views"], "{}"), part("trace"), part("download"),
                       part("write"),
                       figure(lambda: sum(seconds("views", "png", what) for what in ("map", "validate", "upload"))),
                       figure(lambda: runs["views"]["png"]["elapsed_seconds"])]])

    def choice():
        rows = []
        for processor in ("gpu", "cpu") if cuda else ("cpu",):
            of_scenes = considered(results, processor)
            ratios = {(rule, scene): ratio for rule, scene, ratio
                      in outcomes(of_scenes, lambda row: row["expected_time"])}
            for scene, candidates in of_scenes.items():
                best = lambda key: "{structure} {division[0]}".format(**key(candidates)) if candidates else "-"
                rows.append([processor, scene, best(lambda all: chosen(all, lambda r: r["expected_time"])),
                             best(lambda all: max(all, key=lambda r: r["rate"])),
                             *(figure(lambda: ratios[rule, scene], "{:.2f}") for rule in CHOICES)])
            mean = lambda rule: statistics.geometric_mean(ratio for (of, _), ratio in ratios.items() if of == rule)
            rows.append([processor, "geometric mean", "", "", *(figure(lambda: mean(rule), "{:.3f}") for rule in CHOICES)])
        return table(["for", "scene", "`fastest` takes", "the fastest", *(f"`{rule}`" for rule in CHOICES)], rows)

    def hierarchies():
        rows = [[s, *(cell for grid in (s, f"{s}-bvh") for cell in (
                    figure(lambda: joined(rates(results, s, grid)), "{}"), megabytes(f"{grid}.grid"),
                    ms(lambda: seconds("hierarchies", grid))))] for s in LARGE]
        return table(["scene", "irregular: Mray/s", "MB", "picture, ms", "`--structure bvh`: Mray/s", "MB", "picture, ms"], rows)

    def peers():
        rows = []
        for s, peer in PEERS.items():
            taken = fastest(results, s)
            own = rates(results, s, taken)
            rows.append([s, "irregular" if taken == s else "`bvh`", joined(own), joined(peer["cwbvh"]),
                         *(joined((ours / theirs for ours, theirs in zip(own, peer[name])), ".2f")
                           for name in ("cwbvh", "cubql", "optix", "hagrid", "hagrid_best")),
                         f"{(size[f'{taken}.grid'] + 48 * primitives(s)) * 1e-6:.0f}, {peer['cwbvh_mb'][0]:.0f}"])
        return table(["scene", "`fastest` takes", "Masu", "CWBVH", "Masu / CWBVH", "/ cuBQL", "/ OptiX", "/ hagrid",
                      "/ hagrid's best", "MB: Masu, CWBVH"], rows)

    def cells():
        def cost(s, grid):
            stats = output("cells", f"{s}{grid}")
            rays = sum(stats[f"{kind}_rays"] for kind in ("eye", "reflection", "refraction", "shadow"))
            return (stats["cells_visited"] + sum(stats["intersection_tests"].values())) / rays
        grids = [*(f".none-{n}" for n in (32, "auto")), ".irregular", "-bvh"]
        rows = [[f"`{grid[1:].replace('-', ', ')}`", *(figure(lambda: cost(s, grid), "{:.1f}") for s in STANDARD)]
                for grid in grids]
        return table(["`--merge`, `--division`", *STANDARD],
                     [*rows, ["Havran's best grid or octree", *(f"{HAVRAN[s]:.1f}" for s in STANDARD)]])

    def builds():
        def middle(s, where):
            """What the run of median time reports."""
            of_this = [run["output"] for key, run in runs["builds"].items()
                       if key.startswith(f"{s}.{where}.") and "output" in run]
            return sorted(of_this, key=lambda run: run["build_seconds"])[(len(of_this) - 1) // 2]

        rows = [[s, figure(lambda: primitives(s), "{:,}"), ms(lambda: middle(s, "cuda")["device_seconds"]["build"]),
                 *(ms(lambda: middle(s, where)["build_seconds"]) for where in ("cuda", "cpu", "one"))] for s in LARGE]
        return table(["scene", "primitives", "GPU, build", "GPU, with set-up and copies", f"{machine['cores']} cores",
                      "one core"], rows)

    def load():
        """Of three runs the median of each of the seconds that the tool prints."""
        all_seconds = [output("load", key)["seconds"] for key in ("1", "2", "3")]
        times = {what: statistics.median(of[what] for of in all_seconds) for what in all_seconds[0]}
        steps = [times[name] for name in ("map", "validate", "upload")]
        size_of = sum(size.get(f"mount-10.{kind}", 0) for kind in ("scene", "grid"))
        return table([f"{size_of * 1e-6:.0f} MB", "ms"],
                     [["map; validate; upload", "; ".join(ms(lambda: step) for step in steps)],
                      ["load: the sum", ms(lambda: sum(steps))],
                      ["trace 1024×1024", ms(lambda: times["trace"])]])

    def embree():
        """What masu_cpu_rays prints for one thread: Masu's rate, Embree's and their ratio; of primary rays that of packets."""
        def cells(text):
            found = {}
            for line in text.splitlines():
                words = line.split()
                if words[:1] and words[0] in KINDS and words[1] == "1" and words[-1] != "-":
                    who = "packets" if "packets" in words else "Embree" if words[2] == "Embree" else "Masu"
                    found[words[0], who] = words[-2], words[-1]
            for kind in KINDS:
                ours, ratio = found.get((kind, "Masu"), "--")
                yield f"{ours}, {found.get((kind, 'Embree'), '-')[0]} ({ratio})"
                if kind == "primary":
                    yield found.get((kind, "packets"), "-")[0]
        return table(["scene", "primary", "packets", "diffuse", "random"],
                     [[s, *cells(run["output"])] for s, run in runs["embree"].items() if "output" in run])

    def library():
        rows, names = [], []
        for s in ("teapot-60", "balls", "tetra-9", "mount-10"):
            bench = {row["rays"]: row["mrays_per_second"] for row in output("library", f"{s}.gridbench")}
            for kind, rates in output("library", s).items():
                hits = rates.pop("hits_a_ray")
                names = list(rates)
                rows.append([f"{s}, {kind}", f"{bench[kind]:.4g}", f"{rates['nearest']:.4g} ({rates['nearest'] / bench[kind]:.2f})",
                             *(f"{rate:.4g}" for name, rate in rates.items() if name != "nearest"), f"{hits:.2f}"])
        return table(["scene, rays", "gridbench", "nearest (its ratio)", *names[1:], "hits per ray"], rows)

    def moved(output):
        return figure(lambda: joined(output["move_ms"].values(), ".3g"), "{}")

    def answer():
        rows, tracers = [], ("Masu", "Masu, `high`", "Embree, medium", "Embree, high", "cuBQL, median", "cuBQL, SAH")
        for key, run in runs["answer"].items():
            device, _, size = key.partition(".")
            found = run["output"]
            cells = {name: f"{of['prepare_ms']:.3g}, {of['mrays']:.4g}" for name, of in found["tracers"].items()}
            if device == "cuda":
                peer = ANSWERS.get(size, [])
                cells |= {f"cuBQL, {how}": ", ".join(pair) for how, pair in zip(("median", "SAH"), (peer[:2], peer[2:])) if pair}
            rows.append([f"{found['triangles']:,}, " + (machine["device"] if device == "cuda" else f"{machine['cores']} cores"),
                         *(cells.get(name, "-") for name in tracers), joined(found["bytes_a_triangle"].values()),
                         moved(found["tracers"]["Masu"])])
        return table(["triangles, on", *tracers, "bytes a triangle", "moved, ms"], rows)

    def closest():
        columns = ("cuda", "Masu"), ("cpu", "Masu"), ("cpu", "Open3D")
        cells, sizes = {}, {}
        for key, run in runs["closest"].items():
            device, _, size = key.partition(".")
            sizes[size] = f"{run['output']['triangles']:,}"
            for name, rates in run["output"]["mpoints"].items():
                cells[size, device, name] = joined(rates.values(), ".3g")
        return table(["triangles", machine.get("device", "GPU"), f"{machine['cores']} cores", f"Open3D, {machine['cores']} cores"],
                     [[triangles, *(cells.get((size, *column), "-") for column in columns)] for size, triangles in sizes.items()])

    def placed():
        rows, moves = [], runs["moves"].values()
        for key, run in runs["placed"].items():
            found, count = run["output"], int(key.partition(".")[2])
            for names, text in ((("placed",), f"{count:,} placements of 30 meshes"), (("written out",), "the same written out"),
                                (("by the identity",), "a mesh placed by the identity"), (("not placed",), "not placed"),
                                (("one world", "4096 worlds"), "14 placements; in each of 4096 worlds")):
                of = [found[name] for name in names]
                rows.append([text, *("; ".join(joined(one[kind], ".4g") for one in of) for kind in ("camera", "random")),
                             f"{of[-1]['bytes'] * 1e-6:.0f}", moved(of[-1])])
        counts = "; ".join(f"{int(key.partition('.')[2]):,}" for key in runs["moves"])
        rows.append([f"{counts} placements", "-", "-", "-", "; ".join(moved(run["output"]) for run in moves)])
        return table(["", "camera: nearest, any", "random: nearest, any", "MB", "moved, ms"], rows)

    def scale():
        tools = {"nff2bin": "nff2bin, from a pipe", "irregular": "gridbuild --merge irregular",
                 "bvh": "gridbuild --structure bvh", "gridrender": "gridrender, 64×64 rays"}
        files = {"nff2bin": "scene", "irregular": "irregular.grid", "bvh": "bvh.grid"}
        rows = []
        for tool, text in tools.items():
            for key, run in runs["scale"].items():
                n, _, of = key.partition(".")
                if of == tool:
                    rows.append([text, f"{4 ** int(n):,}", f"{run['cpu_seconds']:.1f}", f"{run['elapsed_seconds']:.1f}",
                                 f"{run['peak_bytes'] * 1e-6:,.0f}",
                                 figure(lambda: size[f"scale-{n}.{files[tool]}"] * 1e-6, "{:,.0f}")])
        return table(["tool", "triangles", "CPU, s", "elapsed, s", "peak, MB", "file, MB"], rows)

    def gpus():
        """Speed-up by the seconds of the whole process."""
        whole = {}
        for key, run in runs["gpus"].items():
            work, n, _ = key.split(".")
            whole.setdefault((work, int(n)), []).append(run["elapsed_seconds"])
        rows = [[work, f"{n}", f"{statistics.median(times):.3g}",
                 f"{statistics.median(whole[work, 1]) / statistics.median(times):.2f}"]
                for (work, n), times in sorted(whole.items(), reverse=True)]
        return table(["work", "GPUs" if cuda else "threads", "s", "speed-up"], rows)

    makers = readme, views, choice, cells, hierarchies, peers, load, builds, embree, library, answer, closest, placed, scale, gpus
    return {"head": head(results), **made_by(makers)}


if __name__ == "__main__":
    if sys.argv[2:] == ["--fit"]:
        measured_runs = json.loads(pathlib.Path(sys.argv[1]).read_text())
        fit({f"{of} {scene}": rows for of in ("gpu", "cpu") for scene, rows in considered(measured_runs, of).items()})
    else:
        run_script(__doc__, tables)
