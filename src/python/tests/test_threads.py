"""Time: an import is quick, other threads go on while Rust works, and Ctrl-C ends a long call."""

import subprocess
import sys
import textwrap
import threading
import time

import chattercheck as cc


def run(code: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, "-c", textwrap.dedent(code)], capture_output=True, text=True, timeout=120)


def test_an_import_takes_less_than_a_tenth_of_a_second() -> None:
    code = "import time; t = time.perf_counter(); import chattercheck; print(time.perf_counter() - t)"
    assert min(float(run(code).stdout) for _ in range(3)) < 0.1


def test_a_broken_name_is_an_attribute_error() -> None:
    assert "has no attribute 'chater'" in run("import chattercheck; chattercheck.chater").stderr
    assert "chatter" in dir(cc) and all(hasattr(cc, name) for name in cc.__all__)


def test_other_threads_go_on() -> None:
    ticks, done = 0, threading.Event()

    def tick() -> None:
        nonlocal ticks
        while not done.is_set():
            ticks += 1
            time.sleep(0.001)

    beside = threading.Thread(target=tick)
    beside.start()
    began = time.perf_counter()
    cc.critical_amplitude(2, 0.93)
    cc.chatter([1.02] * 20_000, 2, 0.92)
    took = time.perf_counter() - began
    done.set()
    beside.join()
    # One that holds the lock lets it have a turn before and after only.
    assert ticks > 20 * took


def test_two_threads_get_their_own_answers() -> None:
    found: dict[float, float] = {}

    def ask(a: float) -> None:
        found[a] = cc.chatter([a] * 2000, 2, 0.9).tau_ch[-1]

    threads = [threading.Thread(target=ask, args=(a,)) for a in (1.01, 1.02, 1.03)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert found == {a: cc.chatter(a, 2, 0.9).tau_ch for a in (1.01, 1.02, 1.03)}


INTERRUPTED = """
    import os, signal, threading, time
    import numpy as np, chattercheck as cc
    block = cc.Block(0.4, 2.0)
    pulse = cc.GroundMotion.sine(0.35, 1.0, phase=0.0, cycles=50)
    threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
    began = time.perf_counter()
    try:
        {call}
        print("not interrupted")
    except KeyboardInterrupt:
        print(time.perf_counter() - began)
"""


def test_an_interrupt_ends_a_long_call() -> None:
    calls = (
        "cc.chatter(np.full(10**7, 1.03), 2, 0.92)",
        "cc.impacts(np.full(10**6, 1.03), 2, 0.92, impacts=10)",
        "cc.overturning(block, pulse)",
        "cc.verify(lambda case: time.sleep(1), cases=1000, case_timeout=5)",
    )
    for call in calls:
        done = run(INTERRUPTED.format(call=call))
        assert float(done.stdout) < 3, (call, done.stdout, done.stderr)
