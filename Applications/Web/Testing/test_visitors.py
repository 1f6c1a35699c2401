"""Each tool once, phones, several visitors, and what goes wrong: killed servers, large and hostile files, random hands."""
import json
import math
import os
import pathlib
import random
import signal
import sys
import time
import types
import urllib.error
import urllib.request
import zipfile

import oversketch
import pytest
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOPLY import vtkPLYReader

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from browser import MODELS, SOURCE, Page, browser, replayed, serve  # noqa: E402, F401
from test_page import ARCH  # noqa: E402

SEED = int(os.environ.get("OVERSKETCH_SEED") or time.strftime("%Y%m%d"))


def circle(x, y, across, up, count=30):
    return [(x + across * math.cos(2 * math.pi * k / count), y + up * math.sin(2 * math.pi * k / count)) for k in range(count)]


@pytest.fixture
def dog(browser, serve):  # noqa: F811
    return browser.page(serve(MODELS / "dog.ply").link).ready()


def status(link, **headers):
    try:
        with urllib.request.urlopen(urllib.request.Request(link, headers=headers)) as answer:
            return answer.status
    except urllib.error.HTTPError as error:
        return error.code


def test_each_tool_makes_a_step_and_the_command_the_same_bits(dog, tmp_path):
    dog.draw(ARCH)
    dog.done(1)
    for tool, lines in {
        "line": [[(0.37 + 0.011 * k, 0.46) for k in range(18)]],
        "smooth": [[(0.37 + 0.011 * k, 0.46) for k in range(18)]],
        "pose": [[(0.30, 0.42), (0.25, 0.37), (0.23, 0.29), (0.24, 0.225)], [(0.30, 0.42), (0.26, 0.36), (0.22, 0.29), (0.21, 0.22)]],
        "mask": [circle(0.70, 0.30, 0.11, 0.13)],
        "edit": [[(0.35 + 0.0005 * k, 0.44 + 0.008 * k) for k in range(12)], circle(0.353, 0.49, 0.05, 0.09)],
    }.items():
        dog.click(f"[data-tool={tool}]")
        for line in lines:
            before = int(dog.of("document.getElementById('view').dataset.done"))
            dog.draw(line)
            dog.done(before + 1)
    assert dog.rows == ["Stroke 1", "Line 2", "Smoothing 3", "Pose 4", "Mask 5", "Edit 6"]
    before = dog.of("document.getElementById('view').dataset.done")
    dog.draw([(0.353, 0.49), (0.35, 0.48), (0.345, 0.46)])  # takes hold of the line
    dog.done(int(before) + 1)
    assert dog.of("document.querySelector('[name=Operations]').value").startswith("drag -")
    dog.click("#section")  # a point is no section
    dog.draw([(0.15, 0.8), (0.3, 0.5), (0.5, 0.3), (0.7, 0.5), (0.85, 0.8)], selector="#section")
    dog.done(int(before) + 2)
    assert dog.rows[6:] == ["Edit 7"]
    assert dog.of("[...document.querySelectorAll('#steps small:not([hidden])')].map(s => s.textContent)") == []
    file = dog.download(lambda: dog.click("#save"), tmp_path / "session")
    mesh = dog.download(lambda: dog.choose("#export", "ply"), tmp_path / "mesh")
    assert mesh.read_bytes() == replayed(file, tmp_path / "replayed.ply")
    dog.click("#steps li:nth-child(1) input")  # off: another model
    dog.rests()
    dog.until("!document.querySelector('#steps input').checked")
    other = dog.download(lambda: dog.choose("#export", "ply"), tmp_path / "off")
    assert other.read_bytes() != mesh.read_bytes()


def test_a_picture_becomes_a_model_by_a_line_a_hole_or_a_tap(dog, tmp_path):
    dog.open(SOURCE / "Data" / "Drawings" / "fish.png")
    dog.until("!document.getElementById('pad').hidden && document.getElementById('under').naturalWidth > 1")
    (left, top, width, height), pad = dog.box("#under"), dog.box("#lines")

    def places(shares):
        return [((left + x * width - pad[0]) / pad[2], (top + y * height - pad[1]) / pad[3]) for x, y in shares]

    dog.draw(places([*circle(0.5, 0.5, 0.4, 0.35), (0.9, 0.5)]), selector="#lines")
    dog.done(1)
    dog.draw(places([*circle(0.5, 0.5, 0.1, 0.1), (0.6, 0.5)]), selector="#lines")
    dog.done(2)
    whole = dog.download(lambda: dog.choose("#export", "ply"), tmp_path / "whole")
    dog.draw(places([(0.5, 0.5)]), kind="mouse", selector="#lines")
    dog.click("#steps li > button")
    dog.until("document.querySelector('[name=Holes]')?.value === '1'")
    dog.rests()
    holed = dog.download(lambda: dog.choose("#export", "ply"), tmp_path / "holed")
    assert holed.read_bytes() != whole.read_bytes()
    glb = dog.download(lambda: dog.choose("#export", "glb"), tmp_path / "glb")
    assert b"image/png" in glb.read_bytes() or b"image/jpeg" in glb.read_bytes()


def test_a_narrow_phone_draws_with_a_finger_turns_with_two_and_has_all_in_reach(browser, serve, tmp_path):  # noqa: F811
    page = browser.page(serve(MODELS / "dog.ply").link, (360, 740), phone=True).ready()
    small = page.of("""[...document.querySelectorAll('header > *, nav button')].filter(e => e.offsetParent)
        .map(e => e.getBoundingClientRect()).filter(b => b.height && b.height < 44 || b.width && b.width < 44).length""")
    assert small == 0
    assert page.of("document.documentElement.scrollWidth") <= 360
    page.touch([[(0.2 + 0.05 * k, 0.72) for k in range(12)]])
    page.done(1)
    assert page.rows == ["Stroke 1"]
    before = page.of("document.getElementById('view').dataset.frame")
    page.touch([[(0.3 + 0.03 * k, 0.5) for k in range(8)], [(0.6 + 0.03 * k, 0.5) for k in range(8)]])
    page.until(f"+document.getElementById('view').dataset.frame > {before}")
    assert page.rows == ["Stroke 1"]
    page.click("#history")
    page.click("#steps .acts button:nth-child(3)")
    page.until("document.querySelectorAll('#steps li').length === 0")


def test_visitors_see_nothing_of_each_other_and_a_closed_tab_is_kept(browser, serve, tmp_path):  # noqa: F811
    server = serve(MODELS, "--visitors", 2)
    one, two = (browser.page(server.link).ready() for _ in range(2))
    one.click("#open")
    one.of("[...document.querySelectorAll('#offered button')].find(b => b.textContent === 'dog.ply').click()")
    one.until("document.title.startsWith('dog')")
    one.rests()
    one.draw(ARCH)
    one.done(1)
    assert one.rows == ["Stroke 1"] and two.rows == []
    assert len(server.visitors()) == 2
    full = browser.page(server.link)
    full.until("document.getElementById('veil')?.textContent.includes('As many visitors')")
    link = one.of("location.href")
    one.close()
    again = browser.page(link).ready()
    assert again.rows == ["Stroke 1"] and again.of("document.title").startswith("dog")
    assert status(link + "files/../../name") == 404 and status(server.link + "v/unknown/") == 404
    assert status(server.link, Host="example.org") == 403  # a name that was bound to this machine
    assert status(link, Origin="http://example.org") == 403


def test_a_notebooks_cell_has_the_page_with_its_mesh(browser, monkeypatch, tmp_path):  # noqa: F811
    frame = types.SimpleNamespace(IFrame=lambda link, width, height: link)  # of IPython, which may be absent
    monkeypatch.setitem(sys.modules, "IPython", types.SimpleNamespace(display=frame))
    monkeypatch.setitem(sys.modules, "IPython.display", frame)
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    ball = vtkSphereSource()
    ball.SetThetaResolution(24)
    ball.Update()
    cell = tmp_path / "cell.html"
    cell.write_text(f'<iframe src="{oversketch.show(ball.GetOutput())}" width="800" height="600"></iframe>')
    page = browser.page(cell.as_uri())
    page.until("document.readyState === 'complete'")
    frames = []
    end = time.monotonic() + 60.0
    while not frames:  # the frame is a target of its own
        frames = [one for one in browser.ask("Target.getTargets")["targetInfos"] if one["type"] == "iframe" and "/v/" in one["url"]]
        assert time.monotonic() < end
    session = browser.ask("Target.attachToTarget", targetId=frames[0]["targetId"], flatten=True)["sessionId"]
    inner = Page(browser, frames[0]["targetId"], session, page.context).ready()
    file = inner.download(lambda: inner.choose("#export", "ply"), tmp_path / "mesh")
    reader = vtkPLYReader()
    reader.SetFileName(str(file))
    reader.Update()
    assert reader.GetOutput().GetNumberOfPoints() == ball.GetOutput().GetNumberOfPoints()


def test_a_link_to_another_address_needs_its_token(serve):  # noqa: F811
    server = serve(MODELS / "dog.ply", "--host", "0.0.0.0")
    base, _, token = server.link.partition("?")
    assert token and status(base) == 403 and status(base + "?token=wrong") == 403 and status(server.link) == 200


def test_after_a_killed_process_or_server_it_goes_on_from_the_last_step(browser, serve):  # noqa: F811
    server = serve(MODELS / "dog.ply")
    page = browser.page(server.link).ready()
    page.draw(ARCH)
    page.done(1)
    time.sleep(2.5)  # it is kept a second later
    os.kill(server.visitors()[0], signal.SIGKILL)
    page.until("document.getElementById('veil').textContent.length > 0")
    page.ready()
    page.until("document.querySelectorAll('#steps li').length === 1")
    server.close(signal.SIGKILL)
    page.until("document.getElementById('veil').textContent.includes('does not answer')")
    serve(MODELS / "dog.ply", port=server.port)
    page.ready()
    page.until("document.querySelectorAll('#steps li').length === 1")
    page.draw(ARCH[::-1])
    page.done(2)
    assert len(page.rows) == 2


def test_files_too_large_damaged_or_hostile_are_refused_and_the_session_stays(browser, serve, tmp_path):  # noqa: F811
    server = serve(MODELS / "dog.ply", "--memory", 3072)
    page = browser.page(server.link).ready()
    page.draw(ARCH)
    page.done(1)

    def refused(file):
        before = page.advice
        page.open(file)
        page.until(f"document.getElementById('advice').classList.contains('said') && document.getElementById('advice').textContent !== {json.dumps(before)}")
        assert page.rows == ["Stroke 1"]
        return page.advice

    large = tmp_path / "large.ply"
    large.write_bytes(b"ply\n" + b"\0" * 100000001)
    assert "larger than 100 MB" in refused(large)
    (tmp_path / "damaged.ply").write_bytes((MODELS / "dog.ply").read_bytes()[:5000])
    assert "damaged" in refused(tmp_path / "damaged.ply")
    hostile = tmp_path / "hostile.oversketch"
    with zipfile.ZipFile(hostile, "w") as archive:
        archive.writestr("session.json", json.dumps({"steps": [{"system": "../../../etc/passwd"}] * 1000}))
        archive.writestr("../../outside", "no")
    assert refused(hostile)
    assert not list(server.folder.rglob("outside"))


def test_hostile_messages_do_nothing(dog):
    dog.draw(ARCH)
    dog.done(1)
    point = {"do": "stroke", "number": 1, "system": "OneStroke", "points": [[1, 1, 1], [9, 9, 1]]}
    hostile = ["", "[]", "{", "[" * 100000, json.dumps({"do": "__init__"}), json.dumps({"do": "keep"}), '{"do":"zoom","factor":NaN,"x":1,"y":1}',
               '{"do":"zoom","factor":1e999,"x":1e999,"y":-1e999}', '{"do":"hand","event":"MouseMoveEvent","x":1e999,"y":0}',
               *(json.dumps(one) for one in [
                   {"do": "act", "what": "Open", "arguments": ["/etc/passwd"]}, {"do": "act", "what": "RemoveStep", "arguments": ["1"]},
                   {"do": "open", "file": "../session.oversketch"}, {"do": "open", "file": "/etc/passwd"}, {"do": "open", "shared": "../../x"},
                   {"do": "export", "format": "../x"}, {"do": "size", "width": 10 ** 12, "height": -5}, {"do": "select", "id": None},
                   {"do": "change", "id": 1, "values": {"Nothing": {}}}, {**point, "points": [[None]]}, {**point, "points": []},
                   {**point, "system": "Edit", "redraw": []}, {**point, "values": [1]}, {"do": "trace", "number": 1, "points": [[0, 0]]}])]
    answered, pictures = dog.of(f"""new Promise(done => {{
        const other = new WebSocket(new URL("socket", location.href.replace(/^http/, "ws"))), states = [], pictures = [];
        other.onmessage = ({{ data }}) => typeof data !== "string" ? pictures.push(data) : JSON.parse(data).kind === "state" && states.push(JSON.parse(data));
        other.onopen = () => {json.dumps(hostile)}.forEach(one => other.send(one));
        setTimeout(() => (other.close(), done([states, pictures.length])), 3000); }})""")
    assert sum(bool(state["message"]) for state in answered) >= 15
    assert pictures == 2  # none of which it says that it has got
    assert all([step["id"] for step in state["steps"]] == [1] for state in answered)
    dog.click("#veil button")  # the other socket was another tab
    dog.ready()
    assert dog.rows == ["Stroke 1"]
    dog.draw(ARCH[::-1])
    dog.done(2)


def test_memory_and_time_of_a_visitor_are_bounded(browser, serve, tmp_path):  # noqa: F811
    count, file = 1100, tmp_path / "grid.off"  # needs 900 MB
    with open(file, "w") as out:
        out.write(f"OFF\n{count ** 2} {2 * (count - 1) ** 2} 0\n")
        out.writelines(f"{x} {y} {(x * y) % 7}\n" for y in range(count) for x in range(count))
        for y in range(count - 1):
            out.writelines(f"3 {a} {a + 1} {a + count}\n3 {a + 1} {a + count + 1} {a + count}\n"
                           for a in range(y * count, (y + 1) * count - 1))
    page = browser.page(serve(MODELS / "dog.ply", "--memory", 700).link).ready()
    page.draw(ARCH)
    page.done(1)
    page.open(file)
    page.until("document.getElementById('advice').textContent.includes('not enough memory')")
    assert page.rows == ["Stroke 1"]
    page.draw(ARCH[::-1])
    page.done(2)
    slow = browser.page(serve(file, "--seconds", 1).link).ready()
    slow.draw([(0.3 + 0.2 * math.sin(k / 9) + 0.02 * k / 60, 0.2 + 0.6 * k / 60) for k in range(60)])
    slow.click("[data-tool=line]")
    slow.draw([(0.3 + 0.2 * math.sin(k / 3), 0.2 + 0.6 * k / 60) for k in range(60)])
    slow.until("/took longer than 1 seconds|does not answer|too much/.test(document.getElementById('advice').textContent + document.getElementById('veil').textContent)")
    slow.rests()


def test_an_upload_of_100_mb_is_opened(browser, serve, tmp_path):  # noqa: F811
    page = browser.page(serve(MODELS / "dog.ply").link).ready()
    count, file = 1297, tmp_path / "grid.ply"
    with open(file, "w") as out:
        out.write(f"ply\nformat ascii 1.0\nelement vertex {count ** 2}\nproperty float x\nproperty float y\nproperty float z\n"
                  f"element face {2 * (count - 1) ** 2}\nproperty list uchar int vertex_indices\nend_header\n")
        out.writelines(f"{x} {y} {(x * y) % 7}\n" for y in range(count) for x in range(count))
        for y in range(count - 1):
            out.writelines(f"3 {a} {a + 1} {a + count}\n3 {a + 1} {a + count + 1} {a + count}\n"
                           for a in range(y * count, (y + 1) * count - 1))
        out.write("\n" * (100000000 - out.tell()))
    assert 99e6 < file.stat().st_size <= 100e6
    page.open(file)
    page.until("document.title.startsWith('grid')", 300)
    page.until("document.getElementById('progress').hidden && document.getElementById('view').dataset.model === 'true'", 300)
    assert not page.of("document.getElementById('advice').classList.contains('said')"), page.advice


def test_a_newcomers_tasks_take_as_many_actions_as_in_the_window_or_one_more(browser, serve, tmp_path):  # noqa: F811
    """Those of Testing/Studio/TASKS.md, the first ten; a name in the system's own dialogue and Return count two, as they do there."""
    page = browser.page(serve(MODELS / "dog.ply").link).ready()
    taken = []

    def act(work, count=1):
        taken[-1] += count
        work()

    def task(*acts):
        taken.append(0)
        for one in acts:
            act(*one) if isinstance(one, tuple) else act(one)
        page.rests()

    def drawn(line, selector="#pen"):
        def work():
            before = int(page.of("document.getElementById('view').dataset.done"))
            page.draw(line, selector=selector)
            page.done(before + 1)
        return work

    def slid():  # the thumb of the profile's sharpness
        left, top, width, height = page.box("[name=Sharpness]")
        share = page.of("(f => f.value / f.max)(document.querySelector('[name=Sharpness]'))")
        page.mouse("mousePressed", left + 8 + share * (width - 16), top + height / 2, button="left", clickCount=1)
        page.mouse("mouseMoved", left + width / 2, top + height / 2, button="left", buttons=1)
        page.mouse("mouseReleased", left + width / 2, top + height / 2, button="left", clickCount=1)

    page.ask("Page.setInterceptFileChooserDialog", enabled=True)
    task(lambda: page.click("#open"), (lambda: page.open(MODELS / "person.ply"), 2))
    page.until("document.title.startsWith('person')")
    page.rests()
    page.open(MODELS / "dog.ply")
    page.until("document.title.startsWith('dog')")
    page.rests()
    task(drawn(ARCH))
    assert page.rows == ["Stroke 1"]
    task(lambda: page.click("#undo"))
    page.until("document.querySelectorAll('#steps li').length === 0")
    page.draw(ARCH)
    page.done(2)
    task(lambda: page.click("[data-tool=line]"), drawn([(0.37 + 0.011 * k, 0.46) for k in range(18)]))
    before = page.of("document.querySelector('[name=Sharpness]').value")
    task(slid)
    page.until(f"document.querySelector('[name=Sharpness]').value !== '{before}'")
    page.rests()
    task(lambda: page.click("#steps li > button"), lambda: page.click("#steps li:first-child .acts button"), drawn([(x, y + 0.02, p) for x, y, p in ARCH]))
    assert page.rows == ["Stroke 1", "Line 2"]
    page.click("[data-tool=outline]")
    task((lambda: page.choose("#mirror", "2"), 2), drawn([(x + 0.33, y, p) for x, y, p in ARCH]))
    assert page.rows[-1] == "Stroke 3"
    page.click("#undo")  # it and its mirror are one step
    page.until("document.querySelectorAll('#steps li').length === 2")
    page.click("#redo")
    page.until("document.querySelectorAll('#steps li').length === 3")
    page.rests()
    page.choose("#mirror", "")
    circled = [*circle(0.5, 0.5, 0.4, 0.15), (0.9, 0.5)]
    task(lambda: page.click("#open"), (lambda: page.open(SOURCE / "Data" / "Drawings" / "fish.png"), 2),
         (lambda: page.until("!document.getElementById('pad').hidden && document.getElementById('under').naturalWidth > 1"), 0),
         drawn(circled, "#lines"))
    glb = []
    task((lambda: glb.append(page.download(lambda: page.choose("#export", "glb"), tmp_path / "glb")), 2))
    assert b"image/" in glb[0].read_bytes()
    task(lambda: glb.append(page.download(lambda: page.click("#save"), tmp_path / "session")), lambda: replayed(glb[1], tmp_path / "replayed.ply"))
    window = [3, 1, 1, 2, 1, 3, 3, 4, 3, 4]
    print("actions on the page", taken, "and in the window", window)
    assert len(taken) == 10 and all(here <= there + 1 for here, there in zip(taken, window))


@pytest.mark.parametrize("number", range(20 if os.environ.get("OVERSKETCH_FULL") else 2))
def test_after_200_random_events_the_page_still_draws(dog, number, tmp_path):
    """Pens, mice and keys anywhere; nothing throws on the page, and the session is what the command makes of it."""
    print(f"OVERSKETCH_SEED={SEED}")
    hand = random.Random(f"{SEED} {number}")
    dog.of("window.faults = []; window.addEventListener('error', e => faults.push(e.message));"
           "window.addEventListener('unhandledrejection', e => faults.push(String(e.reason)))")
    at = (640, 400)
    for _ in range(200):
        what = hand.random()
        at = (min(1279, max(0, at[0] + hand.gauss(0, 60))), min(799, max(0, at[1] + hand.gauss(0, 60))))
        if what < 0.75:
            kind, button = hand.choice(["mousePressed", "mouseMoved", "mouseMoved", "mouseReleased"]), hand.choice(["left", "left", "middle", "right"])
            more = {"pointerType": "pen", "force": hand.random()} if hand.random() < 0.5 else {}
            dog.mouse(kind, *at, button=button, buttons=1, clickCount=1, modifiers=hand.choice([0, 0, 0, 8, 2, 1]), **more)
        elif what < 0.8:
            dog.mouse("mouseWheel", *at, deltaX=0, deltaY=hand.choice([-300, 120]))
        else:
            dog.key(hand.choice(["d", "b", "q", "4", "6", "e", "g", "Escape", "Delete", "x", "Z", "w", "5"]), hand.choice([0, 0, 8]))
    dog.mouse("mouseReleased", *at, button="left", clickCount=1)
    dog.of("document.getElementById('files').close()")
    dog.key("Escape")
    dog.rests()
    dog.key("w")
    dog.click("[data-tool=outline]")
    before = int(dog.of("document.getElementById('view').dataset.done"))
    dog.draw(ARCH)
    dog.done(before + 1)
    assert dog.of("faults") == []
    if dog.of("document.querySelectorAll('#steps small:not([hidden])').length") == 0:
        file = dog.download(lambda: dog.click("#save"), tmp_path / "session")
        mesh = dog.download(lambda: dog.choose("#export", "ply"), tmp_path / "mesh")
        assert mesh.read_bytes() == replayed(file, tmp_path / "replayed.ply")
