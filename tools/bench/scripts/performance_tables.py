#!/usr/bin/env python3
"""The tables of what performance.sh measured.

performance_tables.py RESULTS.json                  prints them as markdown
performance_tables.py RESULTS.json --into FILE…     puts each between its marks in these documents instead:
                                                    <!-- table NAME --> … <!-- end -->
performance_tables.py RESULTS.json --gather FOLDER  makes RESULTS.json of performance.sh's working folder first
"""
import pathlib
import statistics

from choice import CHOICES, chosen, outcomes
from measured import STANDARD, figure, head, made_by, run_script, table

LARGE = "teapot-60 mount-10-triangles tetra-9 tetra-10 balls-triangles tree-triangles rings-triangles".split()


def peer_rates():
    lines = (pathlib.Path(__file__).parent / "peers.tsv").read_text().splitlines()
    head, *rows = [line.split("\t") for line in lines if not line.startswith("#")]
    return {scene: {name: [float(n) for n in cell.split()] for name, cell in zip(head[1:], cells)}
            for scene, *cells in rows}


PEERS = peer_rates()

# Steps and tests a ray, of the pictures of 513x513 pixels: the least of the grids and octrees that V. Havran compared.
HAVRAN = dict(balls=25.8, gears=35.5, mount=26.9, rings=38.6, teapot=34.4, tetra=25.5, tree=13.6)


def fastest(results, scene):
    """The name of the grid that `--structure fastest` takes: the scene's irregular one, or its hierarchy."""
    return f"{scene}-bvh" if "nodes" in results["runs"]["fastest"][scene]["output"] else scene


def fastest_rates(results, scene):
    """Mray/s of primary, diffuse and random rays through it, by the loop that `auto` takes."""
    rows = results["runs"]["rays"][scene]["output"]
    found = []
    for kind in ("primary", "diffuse", "random"):
        auto, *loops = [row for row in rows if row["rays"] == kind and row["grid"] == f"{fastest(results, scene)}.grid"]
        found += [row["mrays_per_second"] for row in loops if row["loop"] == auto["loop"]]
    return found


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

    def pictures():
        rows = [[s, ms(lambda: seconds("pictures", f"{s}.chosen")), ms(lambda: seconds("pictures", f"{s}.uniform")),
                 ms(lambda: seconds("one_core", s)),
                 figure(lambda: seconds("one_core", s) / seconds("pictures", f"{s}.chosen"), "{:.0f}")]
                for s in STANDARD]
        return table(["scene", "chosen structure, ms", "uniform grid, ms", "one CPU core, ms", f"core / {device}"], rows)

    def png():
        write = lambda s, kind: statistics.median(seconds("png", f"{s}.{kind}.{i}", "write") for i in (1, 2, 3))
        rows = [[s, ms(lambda: write(s, "png")), megabytes(f"{s}.png"), ms(lambda: write(s, "pfm")),
                 megabytes(f"{s}.pfm")] for s in STANDARD]
        return table(["scene", "PNG, ms", "MB", "PFM, ms", "MB"], rows)

    def views():
        part = lambda what: figure(lambda: seconds("views", "png", what))
        return table(["views", "trace, s", "download, s", "encode and write, s", "load, s", "whole process, s"],
                     [[figure(lambda: output("views", "png")["views"], "{}"), part("trace"), part("download"),
                       part("write"),
                       figure(lambda: sum(seconds("views", "png", what) for what in ("map", "validate", "upload"))),
                       figure(lambda: runs["views"]["png"]["elapsed_seconds"])]])

    def frames(section, key):
        return {row["grid"]: row["median_seconds"] for row in output(section, key)}

    def choice():
        rows = []
        for processor in ("gpu", "cpu") if cuda else ("cpu",):
            results = output("choice", processor)
            ratios = {(rule, scene): ratio for rule, scene, ratio
                      in outcomes(results, lambda row: row["expected_time"])}
            for scene, considered in results.items():
                best = lambda key: "{structure} {division[0]}".format(**key(considered)) if considered else "-"
                rows.append([processor, pathlib.Path(scene).stem, best(lambda all: chosen(all, lambda r: r["expected_time"])),
                             best(lambda all: max(all, key=lambda r: r["rate"])),
                             *(figure(lambda: ratios[rule, scene], "{:.2f}") for rule in CHOICES)])
            mean = lambda rule: statistics.geometric_mean(ratio for (of, _), ratio in ratios.items() if of == rule)
            rows.append([processor, "geometric mean", "", "", *(figure(lambda: mean(rule), "{:.3f}") for rule in CHOICES)])
        return table(["for", "scene", "`fastest` takes", "the fastest", *(f"`{rule}`" for rule in CHOICES)], rows)

    def division():
        time = lambda s, n: frames("division", s)[f"{s}.none-{n}.grid"]
        return table(["voxels an axis", *STANDARD], [[f"{n}, ms", *(ms(lambda: time(s, n)) for s in STANDARD)]
                                                     for n in (16, 32, 64, 128, 256, "auto")])

    def measured(name, grid, kind):
        """By one set of rays: the loop that `auto` takes, and Mray/s of each loop."""
        auto, *rows = [row for row in output("rays", name) if row["rays"] == kind and row["grid"] == f"{grid}.grid"]
        return auto["loop"], {row["loop"]: row["mrays_per_second"] for row in rows}

    def throughput(name, kind):
        taken, speeds = measured(name, name, kind)
        return ", ".join(f"**{speed:.0f}**" if loop == taken else f"{speed:.0f}" for loop, speed in speeds.items())

    def hierarchies():
        def speeds(s, grid):
            found = [measured(s, grid, kind) for kind in ("primary", "diffuse", "random")]
            return ", ".join(f"{each[taken]:.0f}" for taken, each in found)
        rows = [[s, *(cell for grid in (s, f"{s}-bvh") for cell in (
                    figure(lambda: speeds(s, grid), "{}"), megabytes(f"{grid}.grid"),
                    ms(lambda: seconds("hierarchies", grid))))] for s in LARGE]
        return table(["scene", "irregular: Mray/s", "MB", "picture, ms", "`--structure bvh`: Mray/s", "MB", "picture, ms"], rows)

    def fastest_pictures():
        time = lambda grid: seconds("hierarchies", grid)
        gain = lambda s: time(s) / time(fastest(results, s))
        rows = [[s, ms(lambda: time(s)), ms(lambda: time(f"{s}-bvh")),
                 figure(lambda: "irregular" if fastest(results, s) == s else "`bvh`", "{}"),
                 figure(lambda: gain(s), "{:.2f}")] for s in [*STANDARD, *LARGE]]
        rows += [[f"geometric mean of {what}", "", "", "",
                  figure(lambda: statistics.geometric_mean(gain(s) for s in scenes), "{:.2f}")]
                 for what, scenes in (("the standard sizes", STANDARD), ("the large ones", LARGE))]
        return table(["scene", "irregular, ms", "`bvh`, ms", "`fastest` takes", "as many pictures as irregular"], rows)

    def triangles():
        def cost(name):
            rows = {row["rays"]: row for row in output("rays", name) if row["grid"] == f"{name}.grid"}
            return "; ".join(f"{rows[kind]['tests_a_ray']:.2f} + {rows[kind]['cells_a_ray']:.2f}"
                             for kind in ("primary", "diffuse", "random"))
        rows = [[f"{s} ({figure(lambda: primitives(s), '{:,}')})", megabytes(f"{s}.grid"),
                 *(figure(lambda: throughput(s, kind), "{}") for kind in ("primary", "diffuse", "random")),
                 figure(lambda: cost(s), "{}")] for s in LARGE]
        return table(["scene (triangles)", "grid, MB", "primary", "diffuse", "random",
                      "tests + cells a ray: primary; diffuse; random"], rows)

    def curved():
        kinds = "primary", "diffuse", "random", "shadow"
        rows = [[s, megabytes(f"{s}.grid"), *(figure(lambda: throughput(s, kind), "{}") for kind in kinds)]
                for s in ("balls", "rings", "tree", "gears")]
        return table(["scene", "grid, MB", *kinds], rows)

    def peers():
        rows = []
        for s, peer in PEERS.items():
            rates, taken = fastest_rates(results, s), fastest(results, s)
            ratio = lambda name: ", ".join(f"{ours / theirs:.2f}" for ours, theirs in zip(rates, peer[name]))
            rows.append([s, "irregular" if taken == s else "`bvh`", ", ".join(f"{rate:.0f}" for rate in rates),
                         ", ".join(f"{rate:.0f}" for rate in peer["cwbvh"]),
                         ratio("cwbvh"), ratio("optix"), ratio("hagrid"), ratio("hagrid_best"),
                         f"{(size[f'{taken}.grid'] + 48 * primitives(s)) * 1e-6:.0f}, {peer['cwbvh_mb'][0]:.0f}"])
        return table(["scene", "`fastest` takes", "Masu", "CWBVH", "Masu / CWBVH", "/ OptiX", "/ hagrid", "/ hagrid's best",
                      "MB: Masu, CWBVH"], rows)

    def cells():
        def cost(s, grid):
            stats = output("cells", f"{s}{grid}")
            rays = sum(stats[f"{kind}_rays"] for kind in ("eye", "reflection", "refraction", "shadow"))
            return (stats["cells_visited"] + sum(stats["intersection_tests"].values())) / rays
        grids = [*(f".none-{n}" for n in (16, 32, 64, 128, "auto")), ".x-128", ".balance-128", ".irregular", "-bvh"]
        rows = [[f"`{grid[1:].replace('-', ', ')}`", *(figure(lambda: cost(s, grid), "{:.1f}") for s in STANDARD)]
                for grid in grids]
        return table(["`--merge`, `--division`", *STANDARD],
                     [*rows, ["Havran's best grid or octree", *(f"{HAVRAN[s]:.1f}" for s in STANDARD)]])

    def merge():
        def row(mode):
            stat = output("merge", mode)
            references = stat["references_per_occupied_cell"]
            return [f"{stat['cells']}", f"{stat['references']}", f"{references['mean']:.2f}",
                    f"{references['evenness']:.2f}", f"{stat['expected_per_ray']['cells']:.1f}",
                    f"{stat['expected_per_ray']['tests']:.1f}", f"{stat['bytes']['file']}"]
        return table(["`--merge`", "cells", "references", "mean a cell", "stddev / mean", "cells a random line",
                      "tests a random line", "bytes"],
                     [[f"`{mode}`", *row(mode)] for mode in ("none", "x", "balance", "irregular")])

    def schedules():
        names = "hardware", "block", "cyclic", "persistent"
        time = lambda s, name: {row["schedule"]: row["median_seconds"] for row in output("schedules", s)}[name]
        return table(["scene", *names], [[s, *(ms(lambda: time(s, name)) for name in names)]
                                         for s in ("teapot", "balls", "rings")])

    def kernels():
        def cell(s, which):
            row = output("kernels", f"{s}.{which}")[0]
            return f"{row['median_seconds'] * 1e3:.3g}, {row['kernel']['local_bytes']}"
        return table(["", *STANDARD], [[text, *(figure(lambda: cell(s, which), "{}") for s in STANDARD)]
                                       for text, which in (("the scene's kinds", "own"), ("all kinds", "general"))])

    def builds():
        def middle(s, where):
            """What the run of median time reports."""
            of_this = [run["output"] for key, run in runs["builds"].items()
                       if key.startswith(f"{s}.{where}.") and "output" in run]
            return sorted(of_this, key=lambda run: run["build_seconds"])[(len(of_this) - 1) // 2]

        def row(s):
            parts = ("set_up", "upload", "build", "download")
            return [s, figure(lambda: primitives(s), "{:,}"),
                    *(ms(lambda: middle(s, "cuda")["device_seconds"][part]) for part in parts),
                    *(ms(lambda: middle(s, where)["build_seconds"]) for where in ("cuda", "cpu", "one"))]
        return table(["scene", "primitives", "set-up", "upload", "build", "download", "GPU, whole",
                      f"{machine['cores']} cores", "one core"], [row(s) for s in STANDARD + LARGE])

    def load():
        part = lambda *names: ms(lambda: sum(output("load", "files")["median_seconds"][name] for name in names))
        rows = [["map; validate; upload", "; ".join(part(name) for name in ("map", "validate", "upload"))],
                ["load: the sum", part("load")],
                ["plain copy of the mapped files; by `read(2)`", f"{part('copy_mapped')}; {part('copy_read')}"],
                ["load / plain copy", figure(lambda: output("load", "files")["load_over_copy"]["mapped"], "{:.2f}")],
                ["trace 1024×1024", ms(lambda: seconds("load", "trace"))]]
        return table([figure(lambda: output("load", "files")["bytes"] * 1e-6, "{:.0f} MB"), "ms"], rows)

    def lists():
        rows = [[s, row["memory"].replace("_", "-"), f"{row['count']:,}", ms(lambda: row["median_seconds"]),
                 f"{row['mrays_per_second']:.0f}", ms(lambda: row["kernel_seconds"]),
                 ms(lambda: row["plain_copy_seconds"]), f"{row['plain_copy_over_list']:.2f}"]
                for s in ("mount-8", "balls-5") for row in output("lists", s)]
        return table(["scene", "memory", "rays", "list, ms", "Mray/s", "kernels, ms", "plain copies, ms",
                      "copies / list"], rows)

    makers = (readme, pictures, png, views, choice, cells, division, merge, triangles, curved, hierarchies,
              fastest_pictures, peers, schedules, kernels, load, builds, lists)
    return {"head": head(results), **made_by(makers, {} if cuda else {kernels, lists})}


if __name__ == "__main__":
    run_script(__doc__, tables)
