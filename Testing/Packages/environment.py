"""What the tests of packages share: a virtual environment over the system's packages, for what comes from PyPI, and what was compiled."""
import os
import pathlib
import re
import subprocess
import sys

import pytest


def run(*command, code=0, **more):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, **more)
    assert done.returncode == code, (command, done.returncode, done.stdout[-3000:] + done.stderr[-3000:])
    return done.stdout


def compiled_anew(log):
    """The sources that the compiler's cache had to compile, of those that it noted in a file (CCACHE_STATSLOG) meanwhile. What CMake asks
    the compiler by small programs of its own is left out."""
    entries = re.findall(r"^# (.*)\n((?:\w+\n)*)", pathlib.Path(log).read_text(), re.M)
    assert len(entries) > 50, f"the compiler's cache saw {len(entries)} sources"
    return [source for source, results in entries
            if "cache_miss" in results.split() and not re.search(r"CMakeScratch|CompilerId|CompilerABI", source)]


class Environment:
    def __init__(self, folder):
        self.python = pathlib.Path(folder) / "bin" / "python"
        self.variables = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
        run(sys.executable, "-m", "venv", "--system-site-packages", folder, env=self.variables)

    def run(self, *arguments, **more):
        return run(self.python, *arguments, env={**self.variables, **more.pop("variables", {})}, **more)

    def has(self, module):
        """Whether the system's packages bring it."""
        return subprocess.run([str(self.python), "-c", f"import {module}"], capture_output=True, env=self.variables).returncode == 0

    def require_index(self, folder):
        """Skips the tests where no package index can be reached: asks it for one small package."""
        asked = [self.python, "-m", "pip", "download", "--quiet", "--no-deps", "--retries", "1", "-d", folder, "scooby"]
        if subprocess.run([str(part) for part in asked], capture_output=True, env=self.variables).returncode != 0:
            pytest.skip("no package index can be reached")
