"""Progress, cancellation, Ctrl-C and threads."""

import os
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import unsliver

BALL = unsliver.ball((0, 0, 0), 1)
# For each strategy that has a loop of its own more work than any machine does in a second; no test lets it end.
LONG = [{"size": 0.01, "strategy": "thrifty"}, {"size": 0.006, "strategy": "octree"}]


def test_progress_is_told():
    seen = []
    with pytest.raises(unsliver.Stopped):
        unsliver.mesh(BALL, **LONG[0], on_progress=lambda p: seen.append((p.phase, p.vertices, p.tets)),
                      cancelled=lambda: len(seen) >= 3)
    assert {phase for phase, _, _ in seen} == {"size"}
    assert 0 < seen[0][1] < seen[1][1] < seen[2][1] and 0 < seen[0][2] < seen[1][2] < seen[2][2]


@pytest.mark.parametrize("options", LONG, ids=["thrifty", "octree"])
def test_a_run_can_be_cancelled(options):
    end = time.monotonic() + 0.3
    with pytest.raises(unsliver.Stopped) as caught:
        unsliver.mesh(BALL, cancelled=lambda: time.monotonic() > end, **options)
    assert caught.value.status == "cancelled"
    assert time.monotonic() < end + 5


@pytest.mark.parametrize("strategy", ["thrifty", "auto"])
def test_what_was_made_before_a_cancellation_can_be_kept(strategy):
    seen = []
    mesh = unsliver.mesh(BALL, size=0.01, strategy=strategy, keep_partial=True, on_progress=seen.append,
                         cancelled=lambda: len(seen) > 1)
    assert mesh.status == "cancelled" and len(mesh.tets) > 0


@pytest.mark.parametrize("callback", ["on_progress", "cancelled"])
def test_exceptions_in_callbacks_end_the_run(callback):
    def fail(*_):
        raise ZeroDivisionError("from the callback")

    with pytest.raises(ZeroDivisionError, match="from the callback"):
        unsliver.mesh(BALL, **LONG[0], **{callback: fail})


def test_checks_can_be_cancelled():
    mesh = unsliver.mesh(BALL, size=0.05, verify=False)
    verdict = unsliver.check(mesh, cancelled=lambda: True)
    assert not verdict and verdict.findings[0].check == "cancelled"


@pytest.mark.parametrize("options", LONG, ids=["thrifty", "octree"])
def test_ctrl_c_raises_keyboard_interrupt(options):
    script = f"""
import unsliver
try:
    print("start", flush=True)
    unsliver.mesh(unsliver.ball((0, 0, 0), 1), **{options!r})
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""
    child = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True)
    assert child.stdout.readline() == "start\n"
    time.sleep(0.5)
    os.kill(child.pid, signal.SIGINT)
    sent = time.monotonic()
    output, _ = child.communicate(timeout=60)
    assert output == "interrupted\n" and child.returncode == 0
    assert time.monotonic() - sent < 5


def test_other_threads_run_meanwhile():
    ticks, done = [], threading.Event()

    def tick():
        while not done.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.005)

    ticker = threading.Thread(target=tick)
    ticker.start()
    start = time.monotonic()
    with pytest.raises(unsliver.Stopped):
        unsliver.mesh(BALL, **LONG[0], cancelled=lambda: time.monotonic() > start + 0.5)
    end = time.monotonic()
    done.set()
    ticker.join()
    assert sum(start < t < end for t in ticks) >= 10


def test_several_threads_mesh_at_once():
    sizes = [0.2, 0.25, 0.3, "0.2 + 0.1 * x^2", lambda p: 0.2 + 0.1 * abs(p[:, 0])]
    alone = [unsliver.mesh(BALL, size=s) for s in sizes]
    together = [None] * len(sizes)

    def work(i):
        together[i] = unsliver.mesh(BALL, size=sizes[i], on_progress=lambda p: None, cancelled=lambda: False)

    threads = [threading.Thread(target=work, args=(i,)) for i in range(len(sizes))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for a, b in zip(alone, together):
        assert np.array_equal(a.points, b.points) and np.array_equal(a.tets, b.tets)
