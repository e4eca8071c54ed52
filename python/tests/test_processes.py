"""Threads and processes: who may use what, and what others are told."""

import gc
import multiprocessing
import os
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

import candela
from conftest import square

SIZE = {"width": 64, "height": 48, "samples": 2, "environment": None}


def in_forked_child(action):
    """What `action` returns, or the error that it raises, as text, in a process forked here."""
    read, write = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            text = str(action())
        except BaseException as error:
            text = f"{type(error).__name__}: {error}"
        os.write(write, text.encode())
        os._exit(0)
    os.close(write)
    with os.fdopen(read) as pipe:
        text = pipe.read()
    os.waitpid(child, 0)
    return text


def test_any_thread_may_draw(renderer, wall, ahead):
    expected = renderer.render(wall, ahead, aovs=["Z"], **SIZE)["Z"]
    results = []

    def draw():
        results.append(renderer.render(wall, ahead, aovs=["Z"], **SIZE)["Z"])

    threads = [threading.Thread(target=draw) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(results) == 4
    for result in results:
        np.testing.assert_array_equal(result, expected)


def test_other_threads_run_while_a_picture_is_drawn(renderer):
    scene = candela.load("plaza:2000")
    uploaded = renderer.upload(scene)
    longest, last, stop = 0.0, time.perf_counter(), threading.Event()

    def count():
        nonlocal longest, last
        while not stop.is_set():
            now = time.perf_counter()
            longest, last = max(longest, now - last), now
            time.sleep(0.001)

    thread = threading.Thread(target=count)
    thread.start()
    start = time.perf_counter()
    renderer.render(uploaded, width=640, height=360, samples=16).radiance()
    drawing = time.perf_counter() - start
    stop.set()
    thread.join()
    assert longest < 0.5 * drawing, "the thread waits for the GIL no longer than for its turn on the cores"


def test_two_contexts_in_two_threads_at_once(wall, ahead):
    results = {}

    def draw(name):
        with candela.Renderer() as own:
            for _ in range(3):
                results[name] = own.render(wall.copy(), ahead, aovs=["Z"], **SIZE)["Z"]

    threads = [threading.Thread(target=draw, args=(name,)) for name in "ab"]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    np.testing.assert_array_equal(results["a"], results["b"])


def test_what_is_used_after_its_context_was_closed_says_so(wall, ahead):
    with candela.Renderer() as own:
        uploaded = own.upload(wall, environment=None)
        frame = own.render(uploaded, ahead, width=32, height=24)
    assert own.context.closed
    for use in (lambda: own.render(uploaded, ahead), lambda: frame.rgb(), lambda: uploaded.set_time(0.0)):
        with pytest.raises(candela.InputError, match="is used after its context was closed"):
            use()
    with pytest.raises(candela.InputError, match="the Context is closed"):
        own.context.renderer


def test_a_scene_of_another_context_says_so(renderer, wall, ahead):
    with candela.Renderer() as other:
        uploaded = other.upload(wall, environment=None)
        with pytest.raises(candela.InputError, match="belongs to another context"):
            renderer.render(uploaded, ahead)


def test_objects_may_be_forgotten_in_any_thread(wall, ahead, capfd):
    own = candela.Renderer()
    keep = [own.upload(wall, environment=None) for _ in range(3)]
    own.render(keep[0], ahead, width=32, height=24)
    thread = threading.Thread(target=lambda: (keep.clear(), gc.collect()))
    thread.start()
    thread.join()
    del own
    gc.collect()
    assert "leaked" not in capfd.readouterr().err


def test_a_forked_child_that_uses_its_parents_context_gets_an_error(renderer, wall, ahead):
    uploaded = renderer.upload(wall, environment=None)
    for use in (
        lambda: renderer.render(uploaded, ahead),
        lambda: uploaded.set_time(1.0),
        lambda: candela.Renderer(),
        lambda: candela.Context(),
        lambda: candela.devices(),
    ):
        text = in_forked_child(use)
        assert text.startswith("MachineError: this process was forked from one that uses OpenGL"), text
        assert "spawn" in text
    # The parent draws on.
    assert renderer.render(uploaded, ahead, width=32, height=24).radiance().shape == (24, 32, 4)


def test_a_forked_child_may_forget_its_parents_objects_and_use_scenes(wall, ahead):
    with candela.Renderer() as own:
        keep = [own.upload(wall, environment=None), own.render(wall, ahead, width=32, height=24, environment=None)]
        assert in_forked_child(lambda: (keep.clear(), gc.collect(), candela.load("plaza:64").bounds().shape)[2]) == "(2, 3)"


def draw_in_worker(number):
    scene = candela.Scene()
    scene.add_mesh(*square(4.0))
    with candela.Renderer() as own:
        view = candela.look_at((0, 0, 2 + number), (0, 0, 0))
        return float(own.render(scene, view, width=32, height=24, samples=1, environment=None)["depth"][12, 16])


def test_spawned_workers_draw(renderer):
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        assert pool.map(draw_in_worker, [1, 2]) == [pytest.approx(3.0, rel=1e-5), pytest.approx(4.0, rel=1e-5)]


def test_processes_that_are_forked_before_the_first_context_draw():
    program = (
        "import multiprocessing, candela, sys\n"
        f"sys.path.insert(0, {os.path.dirname(__file__)!r})\n"
        "from test_processes import draw_in_worker\n"
        "candela.load('plaza:64')\n"
        "with multiprocessing.get_context('fork').Pool(2) as pool:\n"
        "    print(pool.map(draw_in_worker, [1, 2]))\n"
    )
    ended = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=120)
    assert ended.returncode == 0, ended.stderr
    np.testing.assert_allclose(eval(ended.stdout), [3.0, 4.0], rtol=1e-5)


def test_an_interrupt_ends_a_long_picture(wall, ahead):
    program = (
        "import candela\n"
        "scene = candela.load('plaza:256')\n"
        "print('drawing', flush=True)\n"
        "candela.Renderer().render(scene, width=640, height=360, samples=60000)\n"
    )
    with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        process.stdout.readline()
        time.sleep(1.0)
        process.send_signal(2)
        _, errors = process.communicate(timeout=60)
    assert process.returncode != 0 and "KeyboardInterrupt" in errors
