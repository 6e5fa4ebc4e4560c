#!/usr/bin/env python3
"""How soon gridview replies, over loopback: pictures of an orbit, and slices. Prints JSON, a row for each grid and request.

page_speed.py GRIDVIEW WxH REPEAT SCENE GRID…   what follows is gridview's: --backend cpu --threads 2
"""
import concurrent.futures
import http.client
import json
import math
import re
import statistics
import subprocess
import sys
import time
import urllib.parse

VIEWS = 60


def orbit(camera):
    """Views around the point that the camera looks at, about its up."""
    offset = [a - b for a, b in zip(camera["from"], camera["at"])]
    axis = [x / math.hypot(*camera["up"]) for x in camera["up"]]
    along = sum(a * b for a, b in zip(offset, axis))
    across = [axis[i - 2] * offset[i - 1] - axis[i - 1] * offset[i - 2] for i in range(3)]
    for view in range(VIEWS):
        c, s = math.cos(2 * math.pi * view / VIEWS), math.sin(2 * math.pi * view / VIEWS)
        yield [at + c * o + s * x + (1 - c) * along * a for at, o, x, a in zip(camera["at"], offset, across, axis)]


def replies(port, paths, count, in_flight):
    """Of so many requests, each client's next path in turn: milliseconds by stage, bytes; and the seconds of all."""
    def fetch(first):
        connection = http.client.HTTPConnection("127.0.0.1", port, timeout=600)
        for i in range(first, count, in_flight):
            begin = time.perf_counter()
            connection.request("GET", paths[i % len(paths)])
            reply = connection.getresponse()
            body = reply.read()
            total = 1e3 * (time.perf_counter() - begin)
            assert reply.status == 200, body
            stages = {name: float(ms) for name, ms in re.findall(r"(\w+);dur=([\d.]+)", reply.headers["Server-Timing"] or "")}
            yield {**stages, "http": total - sum(stages.values()), "total": total, "bytes": len(body)}
        connection.close()
    begin = time.perf_counter()
    with concurrent.futures.ThreadPoolExecutor(in_flight) as clients:
        rows = [row for rows in clients.map(lambda first: list(fetch(first)), range(in_flight)) for row in rows]
    return rows, time.perf_counter() - begin


def main():
    gridview, size, repeat, *arguments = sys.argv[1:]
    width, height = map(int, size.split("x"))
    server = subprocess.Popen([gridview, *arguments, "--port", "0", "-q"], stdout=subprocess.PIPE, text=True)
    try:
        port = urllib.parse.urlparse(server.stdout.readline().strip()).port
        connection = http.client.HTTPConnection("127.0.0.1", port)
        connection.request("GET", "/api/scene")
        scene = json.load(connection.getresponse())
        camera, rows = scene["camera"], []
        text = lambda vector: ",".join(map(repr, vector))
        for index, grid in enumerate(scene["grids"]):
            picture = (f"/api/picture?grid={index}&at={text(camera['at'])}&up={text(camera['up'])}&angle={camera['angle']}"
                       f"&width={width}&height={height}&depth=5&channel=shaded&from=")
            views = [picture + text(view) for view in orbit(camera)]
            requests = {quality: [f"{view}&quality={quality}" for view in views] for quality in ("moving", "still")}
            requests["slice"] = [f"/api/slice?grid={index}&axis={axis}&share={share / 20}" for axis in range(3) for share in range(21)]
            for name, paths in requests.items():
                for in_flight in (1, 2):
                    replies(port, paths, 5, in_flight)  # warms up
                    got, seconds = replies(port, paths, int(repeat), in_flight)
                    medians = {key: round(statistics.median(one[key] for one in got), 3) for key in got[0]}
                    rows.append({"grid": grid["path"], "request": name, "in_flight": in_flight, "a_second": round(len(got) / seconds, 2), "median": medians})
        json.dump({"scene": scene["scene"]["path"], "device": scene["device"], "commit": scene["commit"], "size": [width, height], "repeat": int(repeat), "rows": rows}, sys.stdout, indent=1)
        print()
    finally:
        server.terminate()


main()
