"""Debian's Chromium, driven by the DevTools protocol through two pipes, and a server of the page."""
import base64
import fcntl
import itertools
import json
import os
import pathlib
import re
import select
import signal
import subprocess
import sys
import time

import pytest

SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])
MODELS = SOURCE / "Data" / "Models"
PATIENCE = 60.0  # s


class Browser:
    """A browser without a window; its pages share nothing but what their server does."""

    def __init__(self, folder):
        ours, its = os.pipe(), os.pipe()
        # The protocol's pipes are 3 and 4 of the browser.
        given = [fcntl.fcntl(one, fcntl.F_DUPFD, 10) for one in (ours[0], its[1])]
        script = f"exec 3<&{given[0]} 4>&{given[1]}; exec chromium \"$@\""
        self.process = subprocess.Popen(
            ["bash", "-c", script, "chromium", "--headless=new", "--remote-debugging-pipe", "--no-sandbox", "--disable-gpu", "--no-first-run",
             "--disable-dev-shm-usage", "--disable-background-timer-throttling", "--disable-renderer-backgrounding",
             f"--user-data-dir={folder}", "about:blank"],
            pass_fds=given, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
        for one in (ours[0], its[1], *given):
            os.close(one)
        self.to, self.back, self.heard, self.numbers = ours[1], its[0], b"", itertools.count(1)
        self.events, self.answers = [], {}

    def hear(self, until):
        """Reads messages until a number is answered, or for so long [s]."""
        end = time.monotonic() + (PATIENCE if isinstance(until, int) else until)
        while not (isinstance(until, int) and until in self.answers):
            left = end - time.monotonic()
            if left <= 0 or not select.select([self.back], [], [], left)[0]:
                assert not isinstance(until, int), "the browser does not answer"
                return None
            self.heard += os.read(self.back, 1 << 20)
            *whole, self.heard = self.heard.split(b"\0")
            for message in map(json.loads, whole):
                if "id" in message:
                    self.answers[message["id"]] = message
                else:
                    self.events.append(message)
        return self.answers.pop(until)

    def ask(self, method, session=None, wait=True, **parameters):
        number = next(self.numbers)
        message = {"id": number, "method": method, "params": parameters, **({"sessionId": session} if session else {})}
        data = json.dumps(message).encode() + b"\0"
        while data:
            data = data[os.write(self.to, data):]
        if not wait:
            return number
        answer = self.hear(number)
        assert "error" not in answer, (method, answer["error"])
        return answer["result"]

    def page(self, link, size=(1280, 800), phone=False, apart=True):
        """A page of that size; apart: with cookies of its own."""
        context = {"browserContextId": self.ask("Target.createBrowserContext")["browserContextId"]} if apart else {}
        target = self.ask("Target.createTarget", url="about:blank", **context)["targetId"]
        session = self.ask("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        page = Page(self, target, session, context)
        page.ask("Page.enable")
        page.ask("Runtime.enable")
        page.ask("Emulation.setDeviceMetricsOverride", width=size[0], height=size[1], deviceScaleFactor=2 if phone else 1, mobile=phone)
        if phone:
            page.ask("Emulation.setTouchEmulationEnabled", enabled=True)
        page.ask("Page.navigate", url=link)
        return page

    def close(self):
        os.close(self.to)
        try:
            self.process.wait(5)
        except subprocess.TimeoutExpired:
            os.killpg(self.process.pid, signal.SIGKILL)
            self.process.wait()
        os.close(self.back)


class Page:
    def __init__(self, browser, target, session, context):
        self.browser, self.target, self.session, self.context = browser, target, session, context

    def ask(self, method, **parameters):
        return self.browser.ask(method, self.session, **parameters)

    def of(self, expression):
        """The value of an expression of the page's, or of a promise."""
        answer = self.ask("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        assert "exceptionDetails" not in answer, (expression, answer["exceptionDetails"])
        return answer["result"].get("value")

    def until(self, expression, patience=PATIENCE):
        end = time.monotonic() + patience
        while not (value := self.of(f"!!({expression})")):
            assert time.monotonic() < end, (expression, self.of("document.body.innerText.slice(-600)"))
            time.sleep(0.02)
        return value

    def ready(self):
        """The model is seen."""
        self.until("document.readyState === 'complete' && document.getElementById('view').dataset.model === 'true'")
        self.rests()
        return self

    def rests(self):
        """Nothing runs, and all that was drawn is done."""
        self.until("document.getElementById('progress').hidden && !document.getElementById('veil').textContent")

    def done(self, count):
        self.until(f"+document.getElementById('view').dataset.done >= {count}")
        self.rests()

    def box(self, selector):
        return self.of(f"(b => [b.left, b.top, b.width, b.height])(document.querySelector({json.dumps(selector)}).getBoundingClientRect())")

    def click(self, selector):
        found = f"document.querySelector({json.dumps(selector)})"
        self.until(f"{found}?.offsetParent")
        self.of(f"{found}.scrollIntoView({{ block: 'nearest', inline: 'nearest' }})")
        left, top, width, height = self.box(selector)
        for kind in ("mousePressed", "mouseReleased"):
            self.mouse(kind, left + width / 2, top + height / 2, button="left", clickCount=1)

    def mouse(self, kind, x, y, wait=True, **more):
        self.browser.ask("Input.dispatchMouseEvent", self.session, wait, type=kind, x=x, y=y, **more)

    def draw(self, points, kind="pen", button="left", selector="#pen", modifiers=0, wait=True):
        """A line of shares of a canvas, each with the pen's force where it is given."""
        left, top, width, height = self.box(selector)
        places = [(left + x * width, top + y * height, *force) for x, y, *force in points]
        for number, (x, y, *force) in enumerate(places):
            more = {"pointerType": kind, "force": force[0] if force else 0.5} if kind == "pen" else {}
            held = {"left": 1, "right": 2, "middle": 4}[button]
            self.mouse("mousePressed" if number == 0 else "mouseMoved", x, y, wait, button=button, buttons=held, modifiers=modifiers,
                       clickCount=int(number == 0), **more)
        self.mouse("mouseReleased", *places[-1][:2], button=button, modifiers=modifiers, clickCount=1,
                   **({"pointerType": kind} if kind == "pen" else {}))

    def touch(self, lines, selector="#pen"):
        """Fingers along lines of shares of a canvas, all at once."""
        left, top, width, height = self.box(selector)
        for number, places in enumerate(zip(*lines)):
            at = [{"x": left + x * width, "y": top + y * height, "id": finger} for finger, (x, y) in enumerate(places)]
            self.ask("Input.dispatchTouchEvent", type="touchStart" if number == 0 else "touchMove", touchPoints=at)
        self.ask("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])

    def key(self, name, modifiers=0):
        for kind in ("rawKeyDown", "keyUp"):
            self.ask("Input.dispatchKeyEvent", type=kind, key=name, modifiers=modifiers, windowsVirtualKeyCode=ord(name[0].upper()))

    def choose(self, selector, value):
        self.of(f"(s => {{ s.value = {json.dumps(value)}; s.dispatchEvent(new Event('change')); }})(document.querySelector({json.dumps(selector)}))")

    def open(self, file):
        """Sends a file by the page's own field."""
        self.ask("DOM.enable")
        node = self.ask("DOM.querySelector", nodeId=self.ask("DOM.getDocument")["root"]["nodeId"], selector="#file")["nodeId"]
        self.ask("DOM.setFileInputFiles", files=[str(file)], nodeId=node)

    def download(self, act, folder):
        """The file that comes after an act."""
        folder.mkdir(exist_ok=True)
        self.browser.ask("Browser.setDownloadBehavior", behavior="allow", downloadPath=str(folder), eventsEnabled=True, **self.context)
        before = set(folder.iterdir())
        act()
        end = time.monotonic() + PATIENCE
        while not (new := [file for file in set(folder.iterdir()) - before if file.suffix != ".crdownload"]):
            assert time.monotonic() < end, "no file came"
            self.browser.hear(0.05)
        return new[0]

    def shot(self, file):
        file.write_bytes(base64.b64decode(self.ask("Page.captureScreenshot", format="png")["data"]))

    @property
    def advice(self):
        return self.of("document.getElementById('advice').textContent")

    @property
    def rows(self):
        return self.of("[...document.querySelectorAll('#steps li > button')].map(b => b.textContent)")

    def close(self):
        self.browser.ask("Target.closeTarget", targetId=self.target)


class Server:
    """The command, on a free port, with folders of its own."""

    def __init__(self, folder, *arguments, port=0):
        self.folder = folder
        variables = {**os.environ, "XDG_STATE_HOME": str(folder / "state"), "OVERSKETCH_OPENCL": "off"}
        self.process = subprocess.Popen([sys.executable, "-m", "oversketch_web", "--port", str(port), *map(str, arguments)],
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=variables)
        self.link = self.process.stdout.readline().strip()
        if not self.link:
            said = self.process.stderr.read()
            if "package index" in said:
                pytest.skip("what the page needs cannot be had: no package index can be reached")
            raise AssertionError(said)
        self.port = int(re.search(r":(\d+)/", self.link).group(1))

    def visitors(self):
        """Processes of visitors."""
        listed = subprocess.run(["pgrep", "-P", str(self.process.pid), "-f", "oversketch_web.visitor"], capture_output=True, text=True)
        return [int(number) for number in listed.stdout.split()]

    def close(self, why=signal.SIGTERM):
        self.process.send_signal(why)
        self.process.wait(30)
        self.process.stdout.close()
        self.process.stderr.close()


@pytest.fixture(scope="session")
def browser(tmp_path_factory):
    if subprocess.run(["bash", "-c", "command -v chromium"], capture_output=True).returncode != 0:
        pytest.skip("chromium is not installed")
    one = Browser(tmp_path_factory.mktemp("chromium"))
    yield one
    one.close()


@pytest.fixture
def serve(tmp_path):
    """Starts servers, which end with the test."""
    servers = []

    def start(*arguments, **more):
        servers.append(Server(tmp_path, *arguments, **more))
        return servers[-1]

    yield start
    for server in servers:
        if server.process.poll() is None:
            server.close()


def replayed(session, file):
    """The bytes of the mesh that the command makes of a session."""
    done = subprocess.run([os.environ["OVERSKETCH_COMMAND"], "replay", str(session), "-o", str(file)], capture_output=True, text=True,
                          env={**os.environ, "OVERSKETCH_OPENCL": "off"})
    assert done.returncode == 0, done.stderr
    return file.read_bytes()
