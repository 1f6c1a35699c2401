"""What a build uses that is under the GPL."""
import os
import pathlib
import re
import subprocess

SOURCE = pathlib.Path(os.environ["OVERSKETCH_SOURCE"])


def run(*command):
    return subprocess.run([str(part) for part in command], capture_output=True, text=True, check=True).stdout


def gpl_alone(header):
    """Whether a header is under the GPL with neither a weaker choice nor an exception for those who include it."""
    text = pathlib.Path(header).read_text(errors="replace")
    return (re.search(r"\bGPL\b|GNU\s+General\s+Public", text) is not None
            and re.search(r"LGPL|Lesser|Runtime\s+Library\s+Exception|Linux-syscall-note", text) is None)


def gpl_parts(build):
    """What a build uses that is under the GPL: of every header that was included and of every library that is loaded."""
    listing = run("ninja", "-C", build, "-t", "deps")
    headers = {os.path.realpath(build / line.strip()) for line in listing.splitlines() if line.startswith("    ")}
    headers = {h for h in headers if "/include/" in h and not h.startswith(str(SOURCE)) and os.path.exists(h)}
    assert len(headers) > 500
    binaries = [f for f in [*build.glob("bin/*"), *build.rglob("*.so*")] if f.is_file() and not f.is_symlink()]
    assert len(binaries) > 20
    loaded = "".join(run("ldd", binary) for binary in binaries)
    assert "libvtkCommonCore" in loaded
    return [h for h in sorted(headers) if gpl_alone(h)] + re.findall(r"lib(?:cholmod|umfpack|spqr|gsl|readline|fftw\w*)\.so", loaded)
