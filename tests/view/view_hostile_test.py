"""gridview under requests that no page makes: refused, memory bounded, still serving.

view_hostile_test.py BIN_FOLDER
"""
import concurrent.futures
import contextlib
import http.client
import json
import os
import random
import select
import signal
import socket
import subprocess
import sys
import threading
import unittest

from gridview_run import Gridview, Tools, wait_until

PICTURE = ("/api/picture?grid=0&from=2.1,1.3,1.7&at=0,0,0&up=0,0,1&angle=45&depth=5&channel=shaded&quality=still"
           "&width={}&height={}")
SMALL = PICTURE.format(16, 16)
tools = None
scene = None


def connect(server):
    connection = socket.create_connection(("127.0.0.1", server.port), timeout=60)
    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    return connection


def reply_to(server, request, close=False):
    """All that comes back; b'' where the connection is closed without a reply."""
    with connect(server) as connection:
        try:
            connection.sendall(request)
            if close:
                connection.shutdown(socket.SHUT_WR)
            reply = b""
            while chunk := connection.recv(65536):
                reply += chunk
                if b"\r\n\r\n" in reply and b"Content-Length: 0" in reply.split(b"\r\n\r\n")[0]:
                    break
            return reply
        except (BrokenPipeError, ConnectionResetError):
            return b""


def response_of(server, target, method="GET", **headers):
    """Its status and headers."""
    connection = http.client.HTTPConnection("127.0.0.1", server.port, timeout=60)
    with contextlib.closing(connection):
        connection.putrequest(method, target, skip_host="Host" in headers, skip_accept_encoding=True)
        for name, value in headers.items():
            connection.putheader(name.replace("_", "-"), value)
        connection.endheaders()
        return connection.getresponse()


def status_of(*request, **headers):
    return response_of(*request, **headers).status


def get(path):
    return f"GET {path} HTTP/1.1\r\nHost: localhost\r\n\r\n".encode()


def query(parameters):
    return "&".join(f"{name}={value}" for name, value in parameters.items())


def at_once(function, arguments):
    """What a function returns for each argument, with a thread for each."""
    with concurrent.futures.ThreadPoolExecutor(len(arguments)) as pool:
        return list(pool.map(function, arguments))


class Hostile(unittest.TestCase):
    def setUp(self):
        self.server = Gridview(tools, *scene, "-q")
        self.addCleanup(self.server.__exit__)
        self.assert_serves()

    def assert_serves(self):
        self.assertTrue(self.server.get(SMALL).startswith(b"\xff\xd8"), "a picture")

    def assert_bounded(self, before, bytes_more=200e6):
        self.assertLess(self.server.memory() - before, bytes_more)

    def test_malformed_heads_are_refused(self):
        seed = random.randrange(2**32)
        print("seed", seed)
        numbers = random.Random(seed)
        good = f"GET / HTTP/1.1\r\nHost: localhost:{self.server.port}\r\n\r\n".encode()
        cases = [b"\r\n\r\n", b"GET\r\n\r\n", b"GET /\r\n\r\n", b"GET / HTTP/9.9\r\nHost: localhost\r\n\r\n",
                 b"GET / HTTP/1.1\r\n\r\n",
                 b"GET / HTTP/1.1\nHost: localhost\n\n", b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03" + b"\0" * 64,
                 b"GET /\0 HTTP/1.1\r\nHost: localhost\r\n\r\n", b"GET / HTTP/1.1\r\nHost: localhost\r\nHost: localhost\r\n\r\n",
                 b"GET / HTTP/1.1\r\nHost: localhost\r\nRange: bytes=" + b"0-," * 2000 + b"1-\r\n\r\n",
                 b"GET / HTTP/1.1\r\nHost: localhost\r\nContent-Length: 999999999999\r\n\r\n",
                 b"GET / HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n\r\nffffffff\r\n",
                 b"GET / HTTP/1.1\r\nHost: localhost\r\nMasu-Socket: 0\r\nMasu-Socket: zzz\r\nOrigin: null\r\n\r\n"]
        for _ in range(300):
            bad = bytearray(good)
            for _ in range(numbers.randrange(1, 6)):
                bad[numbers.randrange(len(bad) - 4)] = numbers.randrange(256)
            cases.append(bytes(bad))
        for case in cases:
            reply = reply_to(self.server, case, close=True)
            if case in cases[:13]:
                self.assertNotIn(b" 200 ", reply[:20], case)
        self.assert_serves()

    def test_other_methods_are_refused(self):
        for method in ["POST", "PUT", "DELETE", "OPTIONS", "TRACE", "CONNECT", "PATCH", "PRI", "FOO"]:
            self.assertEqual(status_of(self.server, "/", method), 405, method)
        self.assertEqual(status_of(self.server, "/", "HEAD"), 200)

    def test_long_heads_are_refused_and_take_no_memory(self):
        before = self.server.memory()
        for begin, piece in [(b"GET /" + b"a" * 100, b"a" * 65536), (b"GET / HTTP/1.1\r\nHost: localhost\r\nX: ", b"b" * 65536),
                             (b"GET / HTTP/1.1\r\nHost: localhost\r\n", b"X: y\r\n" * 10000), (b"", b"\xff" * 65536)]:
            with connect(self.server) as connection:
                sent = 0
                try:
                    connection.sendall(begin)
                    while sent < 2**28:
                        connection.sendall(piece)
                        sent += len(piece)
                except (BrokenPipeError, ConnectionResetError):
                    pass
                self.assertLess(sent, 2**28, "it reads on and on")
        self.assert_bounded(before, 20e6)
        self.assert_serves()

    def test_no_file_is_served_but_the_page(self):
        secret = tools.folder / "secret.txt"
        secret.write_text("secret")
        for path in ["/../secret.txt", "/..%2fsecret.txt", "/%2e%2e/secret.txt", "//secret.txt", "/secret.txt", "/./page.js",
                     f"/{secret}", f"file://{secret}", "/balls.scene", "/page.html", "/page.html/../page.js", "/page.js/", "/PAGE.JS",
                     "/api", "/api/", "/api/../page.js", "/%00", "/page.js%00.txt", "/.git/config", "/etc/passwd",
                     "/....//....//etc/passwd", "http://127.0.0.1/etc/passwd", "*", "/\\..\\secret.txt", "/page_files.h"]:
            reply = reply_to(self.server, f"GET {path} HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n".encode(), close=True)
            self.assertNotIn(b"secret", reply.split(b"\r\n\r\n", 1)[-1], path)
            self.assertNotIn(b"root:", reply, path)
            if path != "/page.html":
                self.assertNotIn(b" 200 ", reply[:20], path)

    def test_foreign_hosts_and_origins_are_refused(self):
        port = self.server.port
        good = f"127.0.0.1:{port}"
        for host in [good, "localhost", f"localhost:{port}", "[::1]:99", "127.0.0.1:1"]:  # ssh -L may map the port
            self.assertEqual(status_of(self.server, "/api/scene", Host=host), 200, host)
        for host in ["evil.example", f"evil.example:{port}", f"127.0.0.1.evil.example:{port}", "localhost.evil.example", "", "0.0.0.0", "127.0.0.2",
                     "localhost@evil.example", "[::2]:1", "LOCALHOST.evil.example", "127.0.0.1,evil.example"]:
            self.assertIn(status_of(self.server, "/api/scene", Host=host), (400, 421), host)
        for origin in ["http://evil.example", "null", "https://127.0.0.1", f"http://localhost:{port}", f"http://127.0.0.1:{port}.evil.example", "file://"]:
            self.assertEqual(status_of(self.server, "/api/scene", Host=good, Origin=origin), 403, origin)
        self.assertEqual(status_of(self.server, "/api/scene", Host=good, Origin=f"http://{good}"), 200)
        for site in ["cross-site", "same-site"]:
            self.assertEqual(status_of(self.server, SMALL, Sec_Fetch_Site=site, Sec_Fetch_Dest="image"), 403, site)
            self.assertEqual(status_of(self.server, "/page.js", Sec_Fetch_Site=site, Sec_Fetch_Dest="script"), 403, site)
            self.assertEqual(status_of(self.server, "/", Sec_Fetch_Site=site, Sec_Fetch_Dest="iframe"), 403, site)
            self.assertEqual(status_of(self.server, "/", Sec_Fetch_Site=site, Sec_Fetch_Dest="document"), 200, site)

    def test_headers_forbid_framing_and_foreign_content(self):
        for path in ["/", "/page.js", "/api/scene", SMALL, "/nothing"]:
            headers = response_of(self.server, path).headers
            for name, wanted in [("X-Frame-Options", "DENY"), ("Cross-Origin-Resource-Policy", "same-origin"),
                                 ("X-Content-Type-Options", "nosniff"), ("Access-Control-Allow-Origin", None)]:
                self.assertEqual(headers[name], wanted, (path, name))
            for wanted in ["default-src 'none'", "frame-ancestors 'none'"]:
                self.assertIn(wanted, headers["Content-Security-Policy"], path)
            self.assertNotIn("unsafe", headers["Content-Security-Policy"], path)

    def assert_refuses(self, path, good, bad):
        """Each bad value in place of the good one, and that none is given."""
        self.assertEqual(status_of(self.server, path + query(good)), 200, path)
        for name, values in bad.items():
            for value in values:
                self.assertEqual(status_of(self.server, path + query({**good, name: value})), 400, (name, value))
        for name in good:
            self.assertEqual(status_of(self.server, path + query({k: v for k, v in good.items() if k != name})), 400, name)

    def test_bad_parameters_are_refused(self):
        good = dict(grid="0", at="0,0,0", up="0,0,1", angle="45", depth="5", channel="shaded", quality="still", width="16", height="16")
        good["from"] = "2,1,1"
        bad = dict(grid=["-1", "11", "99999999999999999999", "x", "", "0x0", "1e0"], angle=["0", "180", "nan", "inf", "-1", "1e999"],
                   at=["2,1,1", "0,0", "0,0,0,0", "nan,0,0", "1e300,0,0", "a,b,c", ","], up=["0,0,0", "2,1,1"], depth=["0", "33", "-5"],
                   channel=["", "shade", "../x", "cut"], quality=["", "best"], width=["0", "-1", "8193", "4294967296", "1e9"], height=["0", "65536"],
                   crop=["0,0,17,1", "-1,0,1,1", "0,0,0,0", "1,1,1", "0,0,2147483647,2147483647"], other=["1"])
        bad["from"] = ["0,0,0", "inf,0,0"]
        self.assert_refuses("/api/picture?", good, bad)
        self.assertEqual(status_of(self.server, "/api/picture?" + query({**good, "width": "8192", "height": "8192"})), 400)
        self.assertEqual(status_of(self.server, "/api/picture?" + query(good) + "&grid=1"), 400, "given twice")
        cut = {**good, "channel": "cut", "axis": "0", "share": "0.5"}
        for at in ["2,1,1", "0,0.001,9"]:  # on the plane too, and along it
            self.assertEqual(status_of(self.server, "/api/picture?" + query({**cut, "from": at})), 200)
        for change in [{"axis": "3"}, {"axis": ""}, {"share": "1.5"}, {"share": "nan"}, {"channel": "depth"}]:
            self.assertEqual(status_of(self.server, "/api/picture?" + query({**cut, **change})), 400, change)
        for path in ["/api/slice?grid=0&axis=3&share=0.5", "/api/slice?grid=0&axis=0&share=1.5", "/api/slice?grid=0&axis=0&share=nan",
                     "/api/boxes?grid=11", "/api/boxes?grid=0&depth=-1", "/api/boxes?grid=0&depth=49", "/api/statistics?grid=11", "/api/statistics", "/api/scene?x=1", "/?x=1"]:
            self.assertEqual(status_of(self.server, path), 400, path)
        picked = {name: good[name] for name in ("from", "at", "up", "angle", "width", "height")} | dict(x="15", y="0")
        ray = dict(grid="0", origin="2,1,1", direction="-2,-1,-1", depth="5", all="0")
        for path, good, bad in [("/api/ray?", picked, dict(x=["16", "-1", "0.5", ""], y=["16"], width=["15"], up=["0,0,0"], grid=["0"])),
                                ("/api/walk?", ray, dict(grid=["11"], origin=["0,0", "nan,0,0", "1e300,0,0"], depth=["0", "33"], all=["2", ""], x=["0"],
                                                         direction=["0,0,0", "0,0,inf", "1e-300,0,0", "1e30,0,0"]))]:
            self.assert_refuses(path, good, bad)

    def test_slow_clients_give_way(self):
        before, threads, files = self.server.memory(), self.server.threads(), self.server.files()
        slow = [connect(self.server) for _ in range(200)]  # more than there are threads
        stop = threading.Event()

        def drip():
            head = b"GET / HTTP/1.1\r\nHost: localhost\r\nX: " + b"x" * 5000
            for byte in head:
                for connection in slow:
                    try:
                        connection.send(bytes([byte]))
                    except OSError:
                        pass
                if stop.wait(0.2):
                    return

        thread = threading.Thread(target=drip)
        thread.start()
        try:
            for _ in range(20):
                self.assert_serves()
            self.assert_bounded(before)
        finally:
            stop.set()
            thread.join()
            for connection in slow:
                connection.close()
        wait_until(lambda: self.server.files() <= files + 2, "connections end")
        wait_until(lambda: self.server.threads() <= threads + 4, "threads end")
        self.assert_serves()

    def test_thousands_at_once(self):
        before, files = self.server.memory(), self.server.files()

        def has_picture():
            try:
                with socket.create_connection(("127.0.0.1", self.server.port), timeout=30) as connection:
                    connection.sendall(get(SMALL))
                    return connection.recv(12).startswith(b"HTTP/1.1 200")
            except OSError:
                return False

        good = sum(at_once(lambda count: sum(has_picture() for _ in range(count)), [20] * 150))
        print(f"{good} of 3000 requests, 150 at once, had a picture; the others were refused")
        self.assertGreater(good, 0)
        self.assert_bounded(before)
        wait_until(lambda: self.server.files() <= files + 2, "connections end")
        self.assert_serves()

    def test_clients_that_hang_up_cost_nothing(self):
        before = self.server.memory()
        for _ in range(60):
            with connect(self.server) as connection:
                connection.sendall(get(PICTURE.format(2800, 2800)))
        self.assert_serves()
        wait_until(lambda: self.server.is_idle(), "pictures that nobody wants are given up")
        self.assert_bounded(before, 600e6)

    def test_walks_of_rays_that_double_are_bounded_and_hold_up_nothing_else(self):
        walk = "/api/walk?grid=0&origin=0,-4,0.3&direction=0.01,0.99,-0.05&depth=32&all=1"
        with Gridview(tools, *tools.make_nested_glass(), "-q") as server:
            before = server.memory()
            made = json.loads(server.get(walk))
            self.assertEqual(len(made["rays"]), 1000)
            self.assertGreater(made["more_rays"], 1000)
            self.assertTrue(made["ended_early"])
            few = json.loads(server.get(walk.replace("depth=32", "depth=8")))
            self.assertEqual([few["more_rays"], few["ended_early"]], [0, False])
            self.assertEqual(few["rays"][0]["hit"], made["rays"][0]["hit"])
            # Pictures, slices and figures are answered while walks are made.
            walkers = [connect(server) for _ in range(12)]
            for walker in walkers:
                walker.sendall(get(walk))
            for path in [SMALL, "/api/slice?grid=0&axis=0&share=0.5", "/api/boxes?grid=0", "/api/statistics?grid=0", "/", SMALL.replace("picture", "counts")]:
                server.get(path)
            self.assertLess(len(select.select(walkers, [], [], 0)[0]), len(walkers), "all walks came first")
            for walker in walkers:
                walker.close()
            server.get(SMALL)
            wait_until(lambda: server.is_idle(), "walks that nobody wants are given up")
            self.assertLess(server.memory("VmHWM") - before, 200e6)

    def test_divisions_that_many_ask_for_at_once_are_built_once(self):
        with Gridview(tools, *scene, "-q") as server:
            for _ in range(8):  # nobody waits for these
                with connect(server) as gone:
                    gone.sendall(get("/api/statistics?grid=10"))
            grids = [*range(2, 11)] * 3
            made = at_once(lambda grid: json.loads(server.get(f"/api/statistics?grid={grid}")), grids)
            divisions = json.loads(server.get("/api/scene"))["divisions"]
            self.assertEqual([one["division"] for one in made], [[divisions[grid - 2]] * 3 for grid in grids])
            self.assertEqual(len({json.dumps(one) for one in made}), len(divisions), "each is built once: it says the same time")
            wait_until(lambda: server.is_idle(), "all is done")
            self.assertLess(server.memory("VmHWM"), 1e9)

    def test_clients_that_do_not_read_do_not_block(self):
        with contextlib.ExitStack() as deaf:
            for _ in range(8):
                connection = deaf.enter_context(socket.socket())
                connection.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
                connection.connect(("127.0.0.1", self.server.port))
                connection.sendall(get(PICTURE.format(700, 700)))
            self.assert_serves()

    def test_requests_one_after_another_on_a_connection(self):
        with connect(self.server) as connection:
            connection.sendall(get("/page.css") * 3)
            reply = b""
            while reply.count(b"HTTP/1.1 200 OK") < 3:
                chunk = connection.recv(65536)
                self.assertTrue(chunk)
                reply += chunk

    def test_signals_end_it_at_once_with_exit_code_0(self):
        for number in [signal.SIGTERM, signal.SIGINT]:
            with Gridview(tools, *scene, "-q") as server, connect(server) as idle, connect(server) as busy:
                idle.sendall(b"GET / HT")
                busy.sendall(get(PICTURE.format(2800, 2800)))
                wait_until(lambda: server.cpu_seconds() > 0.3, "it traces")
                server.process.send_signal(number)
                self.assertEqual(server.process.wait(30), 0)

    def test_token(self):
        with Gridview(tools, *scene, "-q", "--token") as server:
            token = server.address.split("token=")[1]
            for path in ["/", "/page.js", "/api/scene", SMALL, "/?token=", "/?token=" + "0" * 32, "/?token=" + token[:-1], "/api/scene?token=" + token]:
                self.assertEqual(status_of(server, path), 401, path)
            name = f"masu_{server.port}"
            for cookie in ["", f"{name}=", f"{name}={token[:-1]}", f"{name}={token}0", f"x{name}={token}", f"masu={token}"]:
                self.assertEqual(status_of(server, "/api/scene", Cookie=cookie), 401, cookie)
            reply = response_of(server, "/?token=" + token)
            self.assertEqual((reply.status, reply.headers["Location"]), (303, "/"))
            self.assertEqual(reply.headers["Set-Cookie"], f"{name}={token}; HttpOnly; SameSite=Strict; Path=/")
            shown = json.loads(server.get("/api/scene", Cookie=f"a=b; {name}={token}; c=d"))
            self.assertEqual(shown["scene"]["name"], scene[0])

    def test_a_port_that_is_taken_is_an_error(self):
        ended = subprocess.run([tools.bin / "gridview", *scene, "--port", str(self.server.port), "-q"], cwd=tools.folder, capture_output=True, text=True)
        self.assertEqual(ended.returncode, 1)
        self.assertEqual(len(ended.stderr.strip().splitlines()), 1)
        self.assertIn(f"port {self.server.port}", ended.stderr)

    def test_it_says_that_the_usual_port_is_taken(self):
        def serve(**options):
            server = owned.enter_context(subprocess.Popen([tools.bin / "gridview", *scene], cwd=tools.folder, stdout=subprocess.PIPE, text=True, **options))
            owned.callback(server.terminate)
            self.assertNotIn(":8765/", server.stdout.readline())
            return server

        other, terminal = os.openpty()
        with contextlib.ExitStack() as owned:
            with contextlib.suppress(OSError):  # another one has taken it
                owned.enter_context(socket.create_server(("127.0.0.1", 8765)))
            self.assertIn("port 8765 is taken", serve(stderr=subprocess.PIPE).stderr.readline())
            # In colour where a person looks.
            serve(stderr=terminal, env={name: value for name, value in os.environ.items() if name != "NO_COLOR"})
            self.assertRegex(os.read(other, 4096), rb"\033\[1;33mgridview: port 8765 is taken")
        os.close(other)
        os.close(terminal)


if __name__ == "__main__":
    tools = Tools(sys.argv.pop(1))
    scene = tools.make_scene()
    unittest.main(verbosity=2)
