#!/usr/bin/env python3
"""What of the tree the ParaView plugin is made of, as one digest, beside the one that was tested last: tested.txt. Tests of other
rooms do not count, nor do lines that are a comment and no more.

usage: stamp.py          exit code 0 where they are the same, 1 where the plugin is to be tested
       stamp.py --write  after all its tests have passed; the stamp is committed with what was tested
"""
import hashlib
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
STAMP = HERE / "tested.txt"
COMMENT = re.compile(rb"^\s*//.*\n", re.M)
FOLDERS = "Applications/ParaView", "Filters", "Kernels", "Testing/ParaView", "Wrapping"


def digest():
    files = [path for folder in FOLDERS for path in (ROOT / folder).rglob("*") if path.is_file() and path != STAMP
             and "__pycache__" not in path.parts and "Testing" not in path.relative_to(ROOT / folder).parts and not path.name.endswith("_test.cxx")]
    made = hashlib.sha256()
    for path in sorted(files):
        made.update(f"{path.relative_to(ROOT)}\0{hashlib.sha256(COMMENT.sub(b'', path.read_bytes())).hexdigest()}\n".encode())
    return made.hexdigest()


def main():
    if sys.argv[1:] == ["--write"]:
        STAMP.write_text(digest() + "\n")
    elif sys.argv[1:]:
        sys.exit(__doc__)
    elif not STAMP.exists() or STAMP.read_text().strip() != digest():
        sys.exit(1)


if __name__ == "__main__":
    main()
