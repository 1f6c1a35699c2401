"""A build can leave a system out, tests and benchmarks included: what needs it is not there, the rest is configured."""
import json
import os
import pathlib
import re
import subprocess
import sys

import pytest

SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])
ASKED = {"OneStroke": ("one_stroke_test", "systems_test", "hostile_meshes_test"),
         "Augment;Stellar": ("hostile_augment_test", "stellar_benchmark", "oversketch_tables")}
KERNELS = {name for file in SOURCE.glob("Kernels/*/CMakeLists.txt")
           for name in re.findall(r"^oversketch_gtest\((\w+)", file.read_text(), re.M)}


@pytest.mark.parametrize("systems", ASKED)
def test_it_is_configured_with_its_tests(tmp_path, systems):
    done = subprocess.run(["cmake", "-G", "Ninja", "-S", SOURCE, "-B", tmp_path, f"-DOVERSKETCH_WITHOUT={systems}",
                           "-DCMAKE_EXPORT_COMPILE_COMMANDS=ON", f"-DPython3_EXECUTABLE={sys.executable}"], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr[-4000:]
    rules = (tmp_path / "build.ninja").read_text()
    made = {line.split(":")[0].split()[1] for line in rules.splitlines() if line.startswith("build ") and ": phony" in line}
    assert {"oversketch", "edit_system_test"} <= made
    assert "kernel_ray_test" in KERNELS and KERNELS <= made, KERNELS - made  # those of kernels that come later in the alphabet, too
    assert not made & set(ASKED[systems]), made & set(ASKED[systems])
    absent = {header.name for system in systems.split(";") for header in SOURCE.glob(f"Filters/{system}/*.h")}
    compiled = {pathlib.Path(entry["file"]) for entry in json.loads((tmp_path / "compile_commands.json").read_text())
                if entry["file"].startswith(f"{SOURCE}/")}
    assert absent and len(compiled) > 300
    for source in compiled:
        text = re.sub(r"^#ifdef OVERSKETCH_WITH_.*?^#endif", "", source.read_text(), flags=re.M | re.S)
        assert not absent.intersection(re.findall(r'#include "(.+)"', text)), source
