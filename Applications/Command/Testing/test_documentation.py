"""The pages of Documentation: their lines of the command run as written, and name all options that there are."""
import re
import shlex

import pytest

from scene import *  # noqa: F403

PAGES = sorted((SOURCE / "Documentation").glob("*.md"))
LINE = re.compile(r"^oversketch (\S+ .*\bData/.*)$", re.M)
VERBS = {"one-stroke": "one-stroke", "augment": "augment", "terrain": "augment", "edit": "edit", "relax": "relax", "mask": "mask", "pose": "pose", "transform": "files", "check": "print",
         "inflate": "drawings", "assemble": "drawings", "replay": "files"}
OF_EVERY_COMMAND = {"--output", "--report", "--picture", "--turntable", "--backend", "--inner"}


def lines_of(page):
    return [shlex.split(line, comments=True) for line in LINE.findall(page.read_text())]


def test_pages_have_lines():
    assert {line[0] for page in PAGES for line in lines_of(page)} == {"one-stroke", "augment", "terrain", "edit", "relax", "mask", "inflate", "assemble", "transform", "check"}


@pytest.mark.parametrize("page", [page for page in PAGES if lines_of(page)], ids=lambda page: page.stem)
def test_lines_of_the_documentation(page, tmp_path):
    """One after the other, in a folder that has Data, as the source folder has: a line may take what one before has made."""
    (tmp_path / "Data").symlink_to(SOURCE / "Data")
    for line in lines_of(page):
        done = run(*line, cwd=tmp_path)
        assert done.returncode == 0, (line, done.stderr)
        assert (tmp_path / line[line.index("-o") + 1]).stat().st_size > 0, line


@pytest.mark.parametrize("verb", VERBS)
def test_the_page_of_a_command_names_its_options(verb):
    asked = set(re.findall(r"^  (?:-o, )?(--[\w-]+)", run(verb, "--help").stdout, re.M))
    assert asked
    page, files = ((SOURCE / "Documentation" / f"{name}.md").read_text() for name in (VERBS[verb], "files"))
    named = set(re.findall(r"--[\w-]+", page)) | (set(re.findall(r"--[\w-]+", files)) & OF_EVERY_COMMAND)
    assert asked <= named, f"{VERBS[verb]}.md does not name {asked - named}"
