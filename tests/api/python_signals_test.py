"""Handlers of signals, and progress, in the middle of the Python module's calls: each in a process of its own, whose limit
of time is a watchdog alone. Environment: PYTHONPATH=api/python MASU_LIBRARY=…/libmasu.so."""

import signal
import subprocess
import sys
import time
import unittest

WATCHDOG = 300  # seconds
COMMON = """
import os, random, signal, sys, threading, time
import numpy as np
import masu
seed = int(os.environ.get("MASU_TEST_SEED", 0)) or int.from_bytes(os.urandom(4), "little")
print("seed", seed, flush=True)
random.seed(seed)
generator = np.random.default_rng(seed)

def mesh(count):
    return (generator.uniform(0, 1, (count, 1, 3)) + generator.uniform(-.02, .02, (count, 3, 3))).reshape(-1, 3).astype(np.float32)

def rays(count):
    return generator.uniform(-1, 1, (count, 6)).astype(np.float32)

def endless(count=100_000):  # a query that takes minutes, or an hour
    return masu.Tracer(masu.Scene(mesh(count)), brute_force=True), rays(1 << 20)

class Alarm(Exception):
    pass

def on_alarm(act, seconds=0.3):
    signal.signal(signal.SIGALRM, lambda *_: act())
    signal.setitimer(signal.ITIMER_REAL, seconds)
"""


def started(text):
    return subprocess.Popen([sys.executable, "-c", COMMON + text], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, universal_newlines=True)


class Signals(unittest.TestCase):
    def ended(self, child):
        try:
            out, err = child.communicate(timeout=WATCHDOG)
        except subprocess.TimeoutExpired:
            child.kill()
            self.fail("hangs: {}".format(child.communicate()))
        self.assertEqual(child.returncode, 0, out + err)
        return out, err

    def run_python(self, text):
        out, err = self.ended(started(text))
        self.assertEqual(err, "", out)
        return out

    def test_an_interrupt_ends_builds_and_queries(self):
        for prepare, work, after in (
                ("vertices = mesh(300_000)", "masu.Scene(vertices)", "masu.Scene(vertices).close()"),
                ("scene = masu.Scene(mesh(300_000))", "scene.build()", "scene.close()"),
                ("scene = masu.Scene(mesh(300_000))", "scene.build(structure='bvh')", "scene.close()"),
                ("scene = masu.Scene(mesh(300_000))", "scene.build(structure='bvh', quality='fast')", "scene.close()"),
                ("scene = masu.Scene(mesh(300_000))", "masu.Tracer(scene)", "scene.close()"),
                *(("tracer, many = endless()", "tracer." + query, "tracer.nearest(many[:2]); tracer.close()")
                  for query in ("nearest(many)", "nearest(many, precision='double')", "nearest(many, fields='t_hit64')",
                                "occluded(many)", "all_hits(many, 2)", "count_hits(many)", "inside(many, threads=1)",
                                "closest(many[:, :3])"))):
            with self.subTest(work=work):
                child = started(prepare + """
print("begins", flush=True)
try:
    while True:
        """ + work + """
except KeyboardInterrupt:
    """ + after + """
    print("interrupted", flush=True)
""")
                while child.stdout.readline() not in ("begins\n", ""):
                    pass
                time.sleep(0.2)  # into the middle of it
                child.send_signal(signal.SIGINT)
                out, err = self.ended(child)
                self.assertEqual((out, err), ("interrupted\n", ""))

    def test_handlers_that_raise_leave_nothing_that_close_waits_for(self):
        self.run_python("""
def raise_alarm(*_):
    if is_armed:
        raise Alarm
signal.signal(signal.SIGALRM, raise_alarm)
scene = masu.Scene(mesh(2000))
grid = scene.build(structure="bvh")
tracer = masu.Tracer(scene, grid)
some = rays(3000)
kept = []  # with their tracebacks, and so with what their frames refer to
works = (lambda: tracer.nearest(some), lambda: tracer.occluded(some[:1]), lambda: tracer.closest(some[:, :3]),
         scene.describe, grid.describe, lambda: scene.primitive(5), lambda: scene.build(structure="bvh", quality="fast"),
         lambda: masu.Tracer(scene, grid), lambda: masu.Scene(mesh(100)))
for _ in range(1000):
    try:
        try:
            is_armed = True
            signal.setitimer(signal.ITIMER_REAL, random.uniform(1e-6, 3e-3), 3e-3)
            while True:
                random.choice(works)()
        finally:
            is_armed = False
    except Alarm as alarm:
        kept.append(alarm)
signal.setitimer(signal.ITIMER_REAL, 0)
for one in tracer, grid, scene:
    one.close()
    one.close()
""")

    def test_closing_within_a_call_is_an_error(self):
        for query in ("nearest(many)", "count_hits(many)", "closest(many[:, :3])"):
            self.run_python("""
tracer, many = endless()
on_alarm(tracer.close)
try:
    tracer.""" + query + """
    sys.exit("not interrupted")
except RuntimeError as error:
    assert str(error) == "the tracer can't be closed from within a call that uses it: close it afterwards", error
tracer.scene.close()
assert tracer.nearest(many[:10])["t_hit"].shape == (10,)
tracer.close()
""")

    def test_an_argument_that_closes_is_an_error(self):
        self.run_python("""
class Closing:
    def __array__(self, *_, **__):
        tracer.close()
        return rays(10)
tracer, _ = endless(100)
try:
    tracer.nearest(Closing())
    sys.exit("no error")
except ValueError as error:
    assert str(error) == "the tracer is closed", error
""")

    def test_others_wait_for_a_call_until_it_ends(self):
        self.run_python("""
tracer, many = endless()
closing = threading.Thread(target=tracer.close)
def act():
    closing.start()
    on_alarm(raise_alarm)
def raise_alarm():
    assert closing.is_alive()
    raise Alarm
on_alarm(act)
try:
    tracer.nearest(many)
    sys.exit("not interrupted")
except Alarm:
    closing.join()
""")

    def test_handlers_may_query_meanwhile(self):
        self.run_python("""
tracer, many = endless(20_000)
few = many[:500]
expected = tracer.nearest(few)["t_hit"].tobytes()
calls = []
def act():
    assert tracer.nearest(few)["t_hit"].tobytes() == expected
    calls.append(1)
    if len(calls) == 5:
        raise Alarm
    signal.setitimer(signal.ITIMER_REAL, 0.05)
on_alarm(act, 0.05)
try:
    tracer.nearest(many)
except Alarm:
    pass
assert len(calls) == 5, calls
""")

    def test_progress_rises_and_ends_calls_by_what_it_raises(self):
        self.run_python("""
class Seen(list):
    def __call__(self, done):
        assert 0 <= done <= 1 and done >= max(self, default=0), (self, done)
        assert threading.current_thread() is threading.main_thread()
        self.append(done)
        if len(self) == self.last:
            raise Alarm
def expect_ended(work, last=3):
    seen = Seen()
    seen.last = last
    try:
        while True:
            work(seen)
            seen.clear()
    except Alarm:
        assert len(seen) == last, seen
scene = masu.Scene(mesh(600_000))  # each builds for longer than the two calls are apart
expect_ended(lambda progress: scene.build(progress=progress), 2)
expect_ended(lambda progress: masu.Tracer(scene, progress=progress), 2)
tracer, many = endless()
for query in tracer.nearest, tracer.occluded, tracer.count_hits, tracer.inside:
    expect_ended(lambda progress: query(many, threads=1, progress=progress))
expect_ended(lambda progress: tracer.all_hits(many, 3, threads=1, progress=progress))
expect_ended(lambda progress: tracer.closest(many[:, :3], threads=1, progress=progress))
""")


if __name__ == "__main__":
    unittest.main()
