"""Serves the page, starts a process for each visitor, and passes messages between its browser and that."""
import asyncio
import contextlib
import ctypes
import os
import pathlib
import re
import secrets
import shutil
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import time

from aiohttp import WSMsgType, web

here = pathlib.Path(__file__).resolve().parent
kept = 3600.0  # s that a closed tab is kept for
beat = 10.0  # s between looks at who is there
grace = 20.0  # s that a process has to keep its session
loopback = ("127.0.0.1", "localhost", "::1")
headers = {"Referrer-Policy": "no-referrer", "X-Content-Type-Options": "nosniff", "Cache-Control": "no-cache",
           "Content-Security-Policy": "default-src 'self'; img-src 'self' blob: data:; connect-src 'self'"}


class Display:
    """A virtual display that the visitors' processes draw on, with a key of its own."""

    def __init__(self, folder):
        key = folder / "key"
        name = b"MIT-MAGIC-COOKIE-1"
        cookie = secrets.token_bytes(16)  # of any host and display
        key.write_bytes(struct.pack(">HHHH", 0xFFFF, 0, 0, len(name)) + name + struct.pack(">H", len(cookie)) + cookie)
        key.chmod(0o600)
        mine, its = os.pipe()
        self.process = subprocess.Popen(
            ["Xvfb", "-displayfd", str(its), "-screen", "0", "1280x1024x24", "-nolisten", "tcp", "-noreset", "-auth", str(key)],
            pass_fds=[its], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True,
            preexec_fn=lambda: ctypes.CDLL(None).prctl(1, signal.SIGTERM))  # it ends with the server, however that ends
        os.close(its)
        with os.fdopen(mine) as said:
            number = said.readline().strip()
        if not number:
            sys.exit("oversketch-web: Xvfb did not start; on Debian install xvfb")
        self.variables = {"DISPLAY": f":{number}", "XAUTHORITY": str(key)}


class Visitor:
    """One visitor: a folder, a process while it is needed, and a browser while a tab is open."""

    def __init__(self, folder):
        self.folder = folder
        self.process = self.writer = self.browser = self.pump = None
        self.left = time.monotonic()  # when its last tab was closed
        self.asked = 0.0  # when the process last did not answer yet; 0: it has

    async def start(self, given, variables):
        ours, its = socket.socketpair()
        self.process = await asyncio.create_subprocess_exec(
            sys.executable, "-m", f"{__package__}.visitor", str(its.fileno()), str(self.folder), str(given.path.resolve()),
            str(given.memory), str(given.seconds), pass_fds=[its.fileno()], env={**os.environ, **variables}, start_new_session=True)
        its.close()
        reader, self.writer = await asyncio.open_connection(sock=ours)
        self.asked = 0.0
        self.pump = asyncio.create_task(self.hear(reader, self.process))

    async def hear(self, reader, process):
        """Passes on what the process says, until it ends."""
        try:
            while True:
                length, kind = struct.unpack(">IB", await reader.readexactly(5))
                payload = await reader.readexactly(length)
                if kind == 0:
                    self.asked = 0.0
                elif self.browser is not None and not self.browser.closed:
                    with contextlib.suppress(ConnectionError, RuntimeError):  # the tab is closed
                        await (self.browser.send_bytes(payload) if kind == 2 else self.browser.send_str(payload.decode()))
        except (asyncio.IncompleteReadError, ConnectionError):
            pass
        await process.wait()
        if self.process is process:
            self.process = None
            if self.browser is not None:
                await self.browser.close(code=4001, message=b"process")

    def say(self, payload):
        if self.process is not None:
            self.writer.write(struct.pack(">I", len(payload)) + payload)

    def stop(self, why=signal.SIGTERM):
        with contextlib.suppress(ProcessLookupError):
            self.process and self.process.send_signal(why)

    async def end(self):
        """Ends the process, which keeps its session before; after a while in any case."""
        process = self.process
        if process is not None:
            self.stop()
            try:
                await asyncio.wait_for(process.wait(), grace)
            except asyncio.TimeoutError:
                self.stop(signal.SIGKILL)
                await process.wait()


class Front:
    def __init__(self, given):
        self.given = given
        self.token = None if given.host in loopback else secrets.token_urlsafe(18)
        self.visitors = {}
        state = pathlib.Path(os.environ.get("XDG_STATE_HOME") or pathlib.Path.home() / ".local" / "state")
        self.folder = state / "oversketch" / "web"
        self.folder.mkdir(parents=True, exist_ok=True, mode=0o700)
        for folder in self.folder.iterdir():  # of a server that is gone
            if time.time() - folder.stat().st_mtime > kept:
                shutil.rmtree(folder, ignore_errors=True)
            else:
                self.visitors[folder.name] = Visitor(folder)

    @web.middleware
    async def guard(self, request, handler):
        """Refuses what another site's page sends: by the name of the host on this machine, by the origin elsewhere."""
        name = request.host.rsplit(":", 1)[0].strip("[]")
        origin = request.headers.get("Origin")
        if self.token is None and name not in loopback or origin is not None and origin.split("://")[-1] != request.host:
            raise web.HTTPForbidden(text="Another site may not ask for this.")
        response = await handler(request)
        if not isinstance(response, web.WebSocketResponse):
            response.headers.update(headers)
        return response

    def visitor(self, request):
        visitor = self.visitors.get(request.match_info["id"])
        if visitor is None:
            raise web.HTTPNotFound(text="This visit is over. Open the page's first link for a new one.")
        return visitor

    async def enter(self, request):
        """The page's link: back to the visit of this browser whose tab is closed, or a new one."""
        if self.token is not None and not secrets.compare_digest(request.query.get("token", ""), self.token):
            raise web.HTTPForbidden(text="The link to this page has a token, which this one lacks.")
        name = request.cookies.get("visit", "")
        known = self.visitors.get(name)
        if known is None or known.browser is not None or "new" in request.query:
            name = secrets.token_urlsafe(18)
            folder = self.folder / name
            folder.mkdir(mode=0o700)
            self.visitors[name] = Visitor(folder)
        response = web.Response(status=302, headers={"Location": f"v/{name}/"})
        response.set_cookie("visit", name, max_age=int(kept), httponly=True, samesite="Lax")
        return response

    async def page(self, request):
        self.visitor(request)
        return web.FileResponse(here / "page" / "index.html")

    async def shared(self, request):
        """A file of the page, the same for everyone."""
        return web.FileResponse(here / "page" / request.match_info["name"])

    async def own(self, request):
        """A file that the visitor's process has written or the visitor has sent."""
        file = self.visitor(request).folder / "files" / request.match_info["name"]
        if not file.is_file():
            raise web.HTTPNotFound(text="There is no such file.")
        return web.FileResponse(file)

    async def upload(self, request):
        """Keeps a file that the visitor opens, in place of the one before, for the process to read."""
        visitor, most = self.visitor(request), self.given.upload * 1000000
        ending = re.sub(r"[^a-z0-9.]", "", pathlib.PurePath(request.query.get("name", "")).suffix.lower())[:12]
        folder = visitor.folder / "files"
        folder.mkdir(exist_ok=True)
        for before in folder.glob("upload-*"):
            before.unlink()
        size, name = 0, f"upload-{secrets.token_hex(4)}{ending}"
        try:
            with open(folder / name, "wb") as file:
                async for part in request.content.iter_chunked(1 << 18):
                    size += len(part)
                    if size > most:
                        raise web.HTTPRequestEntityTooLarge(
                            most, size, text=f"The file is larger than {self.given.upload} MB, which is the most here.")
                    file.write(part)
        except BaseException:
            (folder / name).unlink(missing_ok=True)
            raise
        return web.json_response({"file": name})

    async def talk(self, request):
        """A tab's socket: its messages go to the process, which is started where there is none."""
        visitor = self.visitor(request)
        browser = web.WebSocketResponse(max_msg_size=4 << 20, heartbeat=20.0)
        await browser.prepare(request)
        if visitor.process is None and not await self.room():
            await browser.close(code=4002, message=b"full")
            return browser
        before, visitor.browser = visitor.browser, browser
        if before is not None:
            await before.close(code=4003, message=b"another tab")
        if visitor.process is None:
            await visitor.start(self.given, self.display.variables)
        visitor.say(b'{"do": "hello"}')
        async for message in browser:
            if message.type == WSMsgType.TEXT and visitor.browser is browser:
                visitor.say(message.data.encode())
        if visitor.browser is browser:
            visitor.browser, visitor.left = None, time.monotonic()
            visitor.say(b'{"do": "bye"}')
        return browser

    async def room(self):
        """Whether one more process may start: that of the tab that has been closed longest makes room."""
        running = [one for one in self.visitors.values() if one.process is not None]
        if len(running) < self.given.visitors:
            return True
        closed = [one for one in running if one.browser is None]
        if not closed:
            return False
        await min(closed, key=lambda one: one.left).end()
        return True

    async def watch(self):
        """Ends what does not answer, and what nobody has come back to."""
        while True:
            await asyncio.sleep(beat)
            now = time.monotonic()
            for name, visitor in list(self.visitors.items()):
                if visitor.process is not None and visitor.asked and now - visitor.asked > self.given.seconds + beat:
                    visitor.stop(signal.SIGKILL)
                elif visitor.process is not None and not visitor.asked:
                    visitor.asked = now
                    visitor.say(b'{"do": "ping"}')
                if visitor.browser is None and now - visitor.left > kept:
                    del self.visitors[name]
                    await visitor.end()
                    shutil.rmtree(visitor.folder, ignore_errors=True)

    async def run(self):
        app = web.Application(middlewares=[self.guard])
        app.add_routes([
            web.get("/", self.enter), web.get("/v/{id}/", self.page), web.get("/v/{id}/socket", self.talk),
            web.post("/v/{id}/upload", self.upload), web.get(r"/v/{id}/files/{name:[\w-][\w.-]*}", self.own),
            web.get(r"/v/{id}/{name:[a-z]+\.(?:js|css|svg)}", self.shared)])
        runner = web.AppRunner(app, access_log=None)
        await runner.setup()
        try:
            await web.TCPSite(runner, self.given.host, self.given.port, shutdown_timeout=1.0).start()
        except OSError as error:
            sys.exit(f"oversketch-web: {self.given.host}:{self.given.port} cannot be served: {error.strerror}; name another --port")
        with tempfile.TemporaryDirectory(prefix="oversketch-web-") as folder:
            self.display = Display(pathlib.Path(folder))
            try:
                port = runner.addresses[0][1]
                print(f"http://{self.given.host}:{port}/" + (f"?token={self.token}" if self.token else ""), flush=True)
                watching = asyncio.create_task(self.watch())
                stopped = asyncio.Event()
                for name in (signal.SIGINT, signal.SIGTERM):
                    asyncio.get_running_loop().add_signal_handler(name, stopped.set)
                await stopped.wait()
                watching.cancel()
            finally:
                await asyncio.gather(*(one.end() for one in self.visitors.values()))
                self.display.process.terminate()
                await runner.cleanup()


def serve(given):
    asyncio.run(Front(given).run())
