"""The command oversketch-web: reads its options, sees to what comes from PyPI, and starts the front."""
import argparse
import hashlib
import os
import pathlib
import subprocess
import sys

here = pathlib.Path(__file__).resolve().parent


def options(arguments):
    parser = argparse.ArgumentParser(
        prog="oversketch-web",
        description="Serves a page on which visitors draw on models in their browsers; each has a process of its own.")
    parser.add_argument("path", metavar="FILE|FOLDER", type=pathlib.Path,
                        help="a model, picture or session that each visitor begins with, or a folder of such to choose from")
    parser.add_argument("--host", default="127.0.0.1",
                        help="the address that is served [%(default)s]; of another one than this machine's own the link has a token")
    parser.add_argument("--port", type=int, default=8765, help="the port, 0 for any that is free [%(default)s]")
    parser.add_argument("--visitors", type=int, default=20, metavar="N", help="most processes at once [%(default)s]")
    parser.add_argument("--memory", type=int, default=3072, metavar="MB", help="memory of each [%(default)s]")
    parser.add_argument("--seconds", type=int, default=120, metavar="S", help="longest run of a step [%(default)s]")
    parser.add_argument("--upload", type=int, default=100, metavar="MB", help="largest file that a visitor opens [%(default)s]")
    given = parser.parse_args(arguments)
    if not given.path.exists():
        parser.error(f"{given.path} does not exist; name a model, a picture, a session or a folder of them")
    if min(given.visitors, given.memory, given.seconds, given.upload) < 1:
        parser.error("--visitors, --memory, --seconds and --upload must be 1 or more")
    return given


def environment():
    """The Python of a virtual environment over the system's packages, which is made where it is not there yet."""
    wanted = here / "requirements.txt"
    key = hashlib.sha256(wanted.read_bytes() + sys.version.encode()).hexdigest()[:12]
    folder = pathlib.Path(os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache") / "oversketch" / f"web-{key}"
    python = folder / "bin" / "python"
    if not (folder / "whole").exists():
        print(f"oversketch-web: making {folder} for what the page needs from PyPI, once", file=sys.stderr)
        for command in ([sys.executable, "-m", "venv", "--clear", "--system-site-packages", str(folder)],
                        [str(python), "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "-r", str(wanted)]):
            if subprocess.run(command).returncode != 0:
                sys.exit("oversketch-web: that failed; python3-venv must be installed and a package index be reached. On Debian "
                         "the package python3-aiohttp will do instead")
        (folder / "whole").touch()
    return python


def main():
    given = options(sys.argv[1:])
    try:
        from . import front
    except ImportError as error:
        if error.name != "aiohttp" or "OVERSKETCH_WEB_ENVIRONMENT" in os.environ:
            raise
        python = environment()
        os.execve(python, [str(python), "-m", __package__, *sys.argv[1:]],
                  {**os.environ, "OVERSKETCH_WEB_ENVIRONMENT": "1",
                   "PYTHONPATH": os.pathsep.join([str(here.parent), *filter(None, [os.environ.get("PYTHONPATH")])])})
    front.serve(given)


if __name__ == "__main__":
    main()
