"""What a caller meets: import, threads, Ctrl+C, progress, processes."""

import os
import subprocess
import sys
import threading
import time

import numpy as np
import pytest
from conftest import MOVING, SMALL

import asperity

LONG = asperity.Scene(ensemble={"realizations": 100000})  # minutes


def python(code, **environment):
    return subprocess.run([sys.executable, "-B", "-c", code], capture_output=True, text=True, check=False,
                          env={**os.environ, **environment})


def test_the_import_is_quick_and_needs_neither_qt_nor_numpy_nor_a_display():
    code = """
import sys, time
begin = time.process_time()
import asperity
spent = time.process_time() - begin
maps = open('/proc/self/maps').read()
assert 'libQt' not in maps and 'libGL' not in maps, 'Qt'
assert 'numpy' not in sys.modules
print(spent)
"""
    spent = []
    for _ in range(5):
        found = python(code, DISPLAY="", WAYLAND_DISPLAY="")
        assert found.returncode == 0, found.stderr
        spent.append(float(found.stdout))
    assert min(spent) <= 0.1, spent


CALLS = {
    "curve": lambda **more: asperity.curve(LONG, **more),
    "friction": lambda **more: asperity.friction(LONG, {"load.normal_force": np.geomspace(1e-3, 1, 100)}, **more),
    "sensitivity": lambda **more: asperity.sensitivity(LONG, **more),
    "march": lambda **more: asperity.march({**MOVING, "surface": {"elements": 5000},
                                            "sliding": {"kind": "start", "duration": 10}}, every=100000, **more),
    "state": lambda **more: asperity.state({"surface": {"elements": 2000000}}, **more),
    "surface": lambda **more: asperity.surface({"surface": {"elements": 2000000}}, **more),
    "fit": lambda **more: asperity.fit(LONG, {"velocity": [0.1, 1, 10], "mu": [0.001, 0.002, 0.001]},
                                       "elastomer.shear_modulus", **more),
}


@pytest.mark.parametrize("name", CALLS)
def test_ctrl_c_ends_a_long_call_within_a_tenth_of_a_second(name):
    delays = []
    for _ in range(3):
        sent = []

        def interrupt():
            time.sleep(0.2)
            sent.append(time.perf_counter())
            os.kill(os.getpid(), 2)

        thread = threading.Thread(target=interrupt)
        thread.start()
        with pytest.raises(KeyboardInterrupt):
            CALLS[name]()
        delays.append(time.perf_counter() - sent[0])
        thread.join()
    assert min(delays) <= 0.1, delays


def test_an_interrupted_process_ends_cleanly():
    code = """
import os, threading, asperity
threading.Timer(0.3, lambda: os.kill(os.getpid(), 2)).start()
try:
    asperity.curve(asperity.Scene(ensemble={'realizations': 100000}))
except KeyboardInterrupt:
    print('interrupted')
"""
    found = python(code)
    assert (found.returncode, found.stdout.strip(), found.stderr) == (0, "interrupted", "")


def test_progress_rises_to_one():
    parts = []
    asperity.curve({**SMALL, "ensemble": {"realizations": 400}}, progress=parts.append)
    assert parts == sorted(parts) and parts[-1] == 1 and parts[0] >= 0


def test_what_the_progress_function_raises_ends_the_call():
    def refuse(part):
        raise RuntimeError("enough")

    begin = time.perf_counter()
    with pytest.raises(RuntimeError, match="enough"):
        asperity.curve(LONG, progress=refuse)
    assert time.perf_counter() - begin < 5


def test_other_python_threads_run_meanwhile():
    counted = [0]
    stop = threading.Event()

    def count():
        while not stop.is_set():
            counted[0] += 1
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    asperity.curve({"ensemble": {"realizations": 60}}, threads=1)
    stop.set()
    thread.join()
    assert counted[0] > 10


def test_several_threads_at_once_have_the_results_of_one():
    seeds = range(6)
    scenes = [asperity.Scene(SMALL, surface={"seed": seed}) for seed in seeds]
    alone = [asperity.curve(scene).mu for scene in scenes]
    states = [asperity.state(scene).p for scene in scenes]
    found, errors = {}, []

    def work(i):
        try:
            for _ in range(5):
                found[i] = asperity.curve(scenes[i]).mu
                np.testing.assert_array_equal(asperity.state(scenes[i]).p, states[i])
                with pytest.raises(asperity.InputError):
                    scenes[i].replace({"surface.hurst": 2})
        except BaseException as error:  # noqa: BLE001, shown below
            errors.append(error)

    threads = [threading.Thread(target=work, args=(i,)) for i in seeds]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not errors
    for i in seeds:
        np.testing.assert_array_equal(found[i], alone[i])


def test_processes_that_begin_after_a_call_compute_too():
    code = """
import multiprocessing, asperity
values = {'surface': {'elements': 200}, 'ensemble': {'realizations': 2}, 'sweep': {'points': 2}}
def work(seed):
    return asperity.curve(asperity.Scene(values, surface={'seed': seed})).mu.tolist()
alone = [work(seed) for seed in range(4)]
with multiprocessing.get_context('fork').Pool(2) as pool:
    assert pool.map_async(work, range(4)).get(60) == alone
"""
    found = python(code)
    assert found.returncode == 0, found.stderr


def test_a_failing_balance_is_a_runtime_error_and_memory_is_asked_for_in_vain():
    with pytest.raises(asperity.InputError):
        asperity.curve({"elastomer": {"rheology": "prony", "equilibrium_modulus": 0, "arms":
                                      [{"modulus": 1e6, "relaxation_time": 1e-3}]}})
