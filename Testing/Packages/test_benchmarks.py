"""The benchmarks build without their peers that are under the GPL."""
import os
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from gpl import gpl_parts, run  # noqa: E402

SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])


def test_benchmarks_build_without_the_gpl():
    build = SOURCE / "build" / "benchmarks"  # a place that stays, for the compiler's cache
    options = {"CMAKE_BUILD_TYPE": "Release", "CMAKE_CXX_COMPILER_LAUNCHER": "ccache", "Python3_EXECUTABLE": sys.executable,
               "OVERSKETCH_GPL": "OFF", "OVERSKETCH_WRAP_PYTHON": "OFF", "OVERSKETCH_BUILD_APPLICATIONS": "OFF"}
    run("cmake", "-G", "Ninja", "-S", SOURCE, "-B", build, *(f"-D{name}={value}" for name, value in options.items()))
    run("cmake", "--build", build, "-j2", "--target", "benchmarks")
    made = {file.name for file in (build / "bin").iterdir()}
    assert {"one_stroke_benchmark", "laplacian_benchmark"} <= made
    assert not {"remesh_benchmark", "em_benchmark", "sdf_benchmark"} & made
    assert gpl_parts(build) == []
