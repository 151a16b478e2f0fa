"""Memory of many calls, in a process of its own: interrupted calls of other tests end later."""

import os
import threading
import time

import pytest
from conftest import MOVING

import asperity


def resident():
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def test_a_thousand_calls_leave_memory_flat():
    values = {"surface": {"elements": 100}, "ensemble": {"realizations": 1}, "sweep": {"points": 2}}
    moving = {**MOVING, "surface": {"elements": 50}, "sliding": {**MOVING["sliding"], "duration": 1e-4}}

    def calls():
        scene = asperity.Scene(values)
        scene["load.normal_force"] = "20mN"
        asperity.curve(scene)
        asperity.friction(scene, {"load.normal_force": [1e-3, 1e-2]})
        contact = asperity.state(scene)
        contact.p, contact.u, contact.scene
        asperity.surface(scene).height
        asperity.sensitivity(scene)
        for wrong in ({"surface.hurst": 2}, {"surface.hurts": 1}):
            try:
                asperity.Scene(wrong)
            except asperity.InputError:
                pass

    for _ in range(100):
        calls()
    asperity.march(moving)
    before = resident()
    for _ in range(1000):
        calls()
    grown = resident() - before
    assert grown < 2e6, grown  # 2 kB a round


@pytest.mark.parametrize("call", [asperity.state, asperity.surface])
def test_an_interrupted_call_gives_its_memory_back(call):
    def interrupt():
        time.sleep(0.2)
        os.kill(os.getpid(), 2)

    before = resident()
    thread = threading.Thread(target=interrupt)
    thread.start()
    with pytest.raises(KeyboardInterrupt):
        call({"surface": {"elements": 2000000}})
    thread.join()
    latest = time.monotonic() + 60
    while resident() > before + 5e7 and time.monotonic() < latest:
        time.sleep(0.05)
    assert resident() < before + 5e7
