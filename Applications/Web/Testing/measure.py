#!/usr/bin/python3
"""Measures the page on this machine: measure.py [start|pen|visitors]..., by default all. PYTHONPATH names the built package."""
import asyncio
import json
import math
import os
import pathlib
import statistics
import struct
import sys
import tempfile
import time

try:
    import aiohttp
except ImportError:
    from oversketch_web.__main__ import environment
    python = environment()
    os.execv(python, [str(python), *sys.argv])
os.environ.setdefault("OVERSKETCH_SOURCE", str(pathlib.Path(__file__).resolve().parents[3]))
sys.path.insert(0, str(pathlib.Path(__file__).parent))
from browser import MODELS, Browser, Server  # noqa: E402
from test_page import ARCH  # noqa: E402

COUNT, SECONDS, EVERY = 20, 120.0, 5.0


def share(values, part):
    return sorted(values)[min(len(values) - 1, math.ceil(part * len(values)) - 1)]


def said(name, values, unit="ms"):
    print(f"{name}: median {statistics.median(values):.1f} {unit}, 95 % {share(values, 0.95):.1f}, most {max(values):.1f}, of {len(values)}", flush=True)


def start(folder):
    """From the command to the model's picture on the page, the environment made and the browser open."""
    browser, times = Browser(folder / "start"), []
    for number in range(3):
        begin = time.monotonic()
        server = Server(folder / f"s{number}", MODELS / "dog.ply")
        page = browser.page(server.link).ready()
        times.append(time.monotonic() - begin)
        page.close()
        server.close()
    browser.close()
    said("first picture", times, "s")


def pen(folder):
    """From a sample of the pen to the frame that has its line; from the line's end to the new mesh on the page, of 30,000 triangles."""
    browser, server = Browser(folder / "pen"), Server(folder / "p", MODELS / "dog.ply")
    page = browser.page(server.link).ready()
    for number in range(12):
        shift = 0.004 * (number % 3)
        left, top, width, height = page.box("#pen")
        line = [(x, y + shift, force) for x, y, force in ARCH]
        fine = [tuple(a + (b - a) * k / 8 for a, b in zip(line[i], line[i + 1])) for i in range(len(line) - 1) for k in range(8)]
        for k, (x, y, force) in enumerate(fine):
            page.mouse("mouseMoved" if k else "mousePressed", left + x * width, top + y * height, wait=False, button="left", buttons=1,
                       clickCount=1, pointerType="pen", force=force)
            time.sleep(0.008)
        page.mouse("mouseReleased", left + fine[-1][0] * width, top + fine[-1][1] * height, button="left", clickCount=1, pointerType="pen")
        page.done(number + 1)
        time.sleep(2.0)
    for name in ("pen", "stroke"):
        said(name, page.of(f"performance.getEntriesByName('{name}').map(e => e.duration)"))
    browser.close()
    server.close()


async def visitor(session, link, number, took, lost):
    async with session.get(link + "?new") as answer:
        link = str(answer.url)
    async with session.ws_connect(link + "socket", max_msg_size=0) as socket:
        await socket.send_json({"do": "size", "width": 1200, "height": 710})
        sent, steps, model = {}, 0, asyncio.Event()

        async def hear():
            nonlocal steps
            async for message in socket:
                if message.type == aiohttp.WSMsgType.TEXT:
                    steps = len(json.loads(message.data).get("steps", [])) or steps
                elif message.type == aiohttp.WSMsgType.BINARY:
                    length = struct.unpack_from(">I", message.data)[0]
                    meta = json.loads(message.data[4:4 + length])
                    await socket.send_json({"do": "got", "frame": meta["frame"]})
                    if meta["model"]:
                        model.set()
                    for done in [one for one in sent if one <= meta["done"]]:
                        took.append(1000.0 * (time.monotonic() - sent.pop(done)))

        hearing = asyncio.create_task(hear())
        await model.wait()
        await asyncio.sleep(EVERY * number / COUNT)
        count, end = 0, time.monotonic() + SECONDS
        while time.monotonic() < end:
            count += 1
            sent[count] = time.monotonic()
            points = [(1200 * x, 710 * (y + 0.004 * (count % 3)), force) for x, y, force in ARCH]
            await socket.send_json({"do": "stroke", "number": count, "system": "OneStroke", "points": points})
            await asyncio.sleep(EVERY)
        await asyncio.sleep(10.0)
        hearing.cancel()
        lost.append(len(sent) + count - steps)


def visitors(folder):
    """Twenty visitors of 30,000 triangles, each a line every 5 s for two minutes."""
    server, took, lost = Server(folder / "v", MODELS / "dog.ply"), [], []

    async def all():
        async with aiohttp.ClientSession(connector=aiohttp.TCPConnector(limit=0), cookie_jar=aiohttp.DummyCookieJar()) as session:
            await asyncio.gather(*(visitor(session, server.link, number, took, lost) for number in range(COUNT)))

    asyncio.run(all())
    said(f"{COUNT} visitors on {os.cpu_count()} processors", took)
    sizes = [int(line.split()[1]) / 1024 for one in server.visitors() for line in pathlib.Path(f"/proc/{one}/status").read_text().splitlines()
             if line.startswith("VmHWM")]
    said("memory of each", sizes, "MB")
    print(f"lost: {sum(lost)} of {len(took) + sum(lost)}")
    server.close()


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as temporary:
        for work in sys.argv[1:] or ["start", "pen", "visitors"]:
            {"start": start, "pen": pen, "visitors": visitors}[work](pathlib.Path(temporary))
