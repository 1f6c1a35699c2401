"""The plugin in ParaView's programs: pvpython, pvbatch, a pvserver with its client, and pvbatch on several ranks. Each test starts them
with one of the scripts beside this file; Testing/ParaView/test.sh sets the paths."""
import functools
import json
import os
import pathlib
import re
import socket
import subprocess
import sys
import time

import pytest

HERE = pathlib.Path(__file__).resolve().parent
DATA = HERE.parents[1] / "Data"
sys.path.insert(0, str(DATA))
import listing  # noqa: E402
import vtk_build  # noqa: E402

GOOD = 200 if "OVERSKETCH_FULL" in os.environ else 20  # models of the collection; three bad ones come on top
RANKS = (1, 2, 4)
TIMEOUT = 1500  # s, for one program on a busy machine
WITHOUT_DISPLAY = {name: value for name, value in os.environ.items() if name != "DISPLAY"}


def run(*command, env=WITHOUT_DISPLAY):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True, timeout=TIMEOUT, env=env)
    assert done.returncode == 0, f"{command} failed\n{done.stdout}\n{done.stderr}"
    return done


def clean(*command, env=WITHOUT_DISPLAY):
    """Runs a program that must not complain."""
    done = run(*command, env=env)
    assert not re.search(r"ERR\||ERROR|Traceback", done.stderr + done.stdout), done.stderr + done.stdout
    return done.stdout


@functools.cache
def shipped_in_paraview():
    return clean("pvpython", HERE / "shipped.py", DATA).splitlines()


def test_every_proxy_says_what_its_class_does():
    filters, parameters = map(int, re.findall(r"\d+", clean("pvpython", HERE / "proxies.py")))
    assert filters >= 16 and parameters >= 50


def test_one_stroke_in_pvpython_and_pvbatch_is_the_class():
    inside = clean("pvpython", HERE / "one_stroke.py")
    assert len(inside.splitlines()) == 2
    assert clean("pvbatch", HERE / "one_stroke.py") == inside


@pytest.mark.skipif(not vtk_build.PRESENT, reason="ParaView is installed: VTK's Python cannot be beside it")
def test_meshes_are_those_of_the_vtk_build():
    """Each shipped stroke, edit and drawing, and what is drawn in space, bit for bit: ParaView brings another VTK, and the filters are
    compiled anew against it."""
    vtk = clean("/usr/bin/python3", HERE / "shipped.py", DATA, env=vtk_build.environment()).splitlines()
    assert len(vtk) == 3 + 2 * len(listing.ONE_STROKE) + len(listing.EDIT) + len(listing.INFLATE) > 35
    paraview = shipped_in_paraview()
    assert paraview[0] != vtk[0], "the same VTK"
    assert paraview[1:] == vtk[1:]
    assert len({line.split()[-1] for line in vtk[1:]}) > 23, "most meshes differ from each other"


def accepting_server():
    """A pvserver that waits for its client, and its port; anew where somebody else took the port."""
    for _ in range(5):
        with socket.socket() as probe:
            probe.bind(("localhost", 0))
            port = probe.getsockname()[1]
        server = subprocess.Popen(["pvserver", f"--server-port={port}"], stdout=subprocess.PIPE, text=True, env=WITHOUT_DISPLAY)
        for line in server.stdout:
            if "Accepting connection" in line:
                return server, port
        server.wait()
    raise AssertionError("pvserver does not listen")


def test_one_stroke_on_a_server_is_the_class():
    server, port = accepting_server()
    try:
        assert len(clean("pvpython", HERE / "one_stroke.py", "localhost", port).splitlines()) == 2
        server.wait(timeout=120)
    finally:
        server.kill()
        server.wait()


def test_a_state_file_gives_the_same_meshes(tmp_path):
    state = tmp_path / "both.pvsm"
    saved = clean("pvpython", HERE / "state.py", state, "save")
    made = {line.split()[0]: line.split()[-1] for line in saved.splitlines()}
    assert sorted(made) == ["again", "each", "edited", "handled", "inflated", "layered", "one", "painted", "profiled", "sketched"]
    assert len(set(made.values())) == len(made)
    assert clean("pvpython", HERE / "state.py", state, "load") == saved
    # What ParaView's own lines make is what the classes make of such lines, which are compared with the VTK build's above.
    classes = {line.split()[0]: line.split()[-1] for line in shipped_in_paraview() if " in space " in line}
    assert classes == {name: made[name] for name in ("edited", "sketched")}


@pytest.fixture(scope="module")
def collection(tmp_path_factory):
    folder = tmp_path_factory.mktemp("collection")
    clean("pvpython", HERE / "make_collection.py", folder, GOOD)
    return folder


def on_ranks(ranks, models, strokes, folder):
    """What all ranks together made, by model; their reports; what they complained of; seconds of the whole program."""
    folder.mkdir()
    root = ["--allow-run-as-root"] if os.getuid() == 0 else []
    # One thread each: a rank stands for a core.
    threads = {"VTK_SMP_MAX_THREADS": "1", "POCL_MAX_PTHREAD_COUNT": "1", "POCL_CPU_MAX_CU_COUNT": "1"}
    start = time.perf_counter()
    done = run("mpirun", *root, "--oversubscribe", "--bind-to", "none", "-np", ranks, "env",
               *(f"{key}={value}" for key, value in threads.items()),
               "pvbatch", "--sym", HERE / "collection.py", models, strokes, folder)
    seconds = time.perf_counter() - start
    reports = [json.loads((folder / f"rank{rank}.json").read_text()) for rank in range(ranks)]
    made = {}
    for report in reports:
        assert not set(report["made"]) & set(made), "two ranks made the same model"
        made.update(report["made"])
    return made, reports, [line for line in done.stderr.splitlines() if "ForEach" in line and "ERR|" in line], seconds


def test_two_hundred_models_on_one_two_and_four_ranks(collection, tmp_path):
    rows, first = [], None
    for ranks in RANKS:
        made, reports, errors, whole = on_ranks(
            ranks, collection / "models.vtpc", collection / "strokes.vtpc", tmp_path / str(ranks))
        first = first or made
        assert made == first, f"{ranks} ranks differ from one"
        assert sum(1 for digest in made.values() if digest) == GOOD
        held = [report["held"] for report in reports]
        assert sum(held) == GOOD + 3 and min(held) >= (GOOD + 3) // ranks - 1, held
        # Each bad model is reported once, by the rank that has it; the one without points silently gives nothing.
        assert sum(report["failures"] for report in reports) == 2 and len(errors) == 2, errors
        assert sum("Point 7 of the mesh is not finite" in line for line in errors) == 1
        assert sum("no array ViewTransform" in line for line in errors) == 1
        slowest = max(report["seconds"] for report in reports)
        used = sum(report["processor_seconds"] for report in reports)
        rows.append(f"| {ranks} | {slowest:.1f} | {whole:.1f} | {used:.1f} | {1000.0 * used / GOOD:.0f} |")
    assert len(set(first.values())) == GOOD + 1, "no two models give the same mesh"
    head = "| ranks | strokes, wall [s] | whole program, wall [s] | strokes, processor [s] | per model, processor [ms] |\n|---|---|---|---|---|"
    print("\n".join([f"\n{GOOD} models, a stroke each, one thread a rank, {os.cpu_count()} cores:", head, *rows]))


def test_one_stroke_for_all_reaches_ranks_and_one_without_models_stays_silent(collection, tmp_path):
    drawn = DATA / "Strokes" / "dinosaur_longer_tail.vtp"
    alone = on_ranks(1, collection / "few.vtm", drawn, tmp_path / "one")
    spread = on_ranks(4, collection / "few.vtm", drawn, tmp_path / "four")
    assert len(alone[0]) == 3 and alone[0]["0"] and alone[0]["1"]
    # The third model is a dog: a dinosaur's tail is nowhere on it, which is said by the rank that has it.
    assert not alone[0]["2"] and len(alone[2]) == len(spread[2]) == 1, (alone[2], spread[2])
    assert spread[0] == alone[0]
    assert sorted(report["held"] for report in spread[1]) == [0, 1, 1, 1]
