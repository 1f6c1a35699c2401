"""The Python of the VTK build, beside ParaView's. No test of its own."""
import os

PACKAGE = "OVERSKETCH_VTK_PACKAGE"
PRESENT = PACKAGE in os.environ  # not where ParaView is installed: VTK's Python cannot be beside it


def environment():
    """What a program is to run in for VTK's Python and the package built against it in place of ParaView's."""
    outside = {name: value for name, value in os.environ.items() if name not in ("DISPLAY", "LD_LIBRARY_PATH")}
    return dict(outside, PYTHONPATH=os.environ[PACKAGE])
