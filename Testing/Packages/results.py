"""What a package makes of the shipped files, as digests: README's lines of Python for each system, and its lines of the command where one
is named. digest.py of Testing/ParaView lies beside this file, or where it is in the tree.

usage: results.py README.md DATA [COMMAND]"""
import contextlib
import hashlib
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

import oversketch

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / "ParaView"))
from digest import digest  # noqa: E402

readme, data, *command = map(os.path.abspath, sys.argv[1:])
text = pathlib.Path(readme).read_text()
with tempfile.TemporaryDirectory() as folder, contextlib.chdir(folder):
    os.symlink(data, "Data")
    for snippet in re.findall(r"```python\n(import oversketch, vtk\n.*?)```", text, re.S):
        names = {}
        exec(compile(snippet, "README.md", "exec"), names)
        print(names["system"].GetClassName(), digest(oversketch.update(names["system"])), flush=True)
    for program in command:
        for line in re.findall(r"^oversketch (\S+ Data/.*)$", text, re.M):
            subprocess.run([program, *shlex.split(line)], check=True)
            made = pathlib.Path(re.search(r"-o (\S+)", line).group(1))
            print(line.split()[0], hashlib.md5(made.read_bytes()).hexdigest(), flush=True)
