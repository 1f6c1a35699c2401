#!/usr/bin/env python3
"""documentation.py [ROOT]: what the pages say of the tree is true; exit code 1 and a line for each fault, with its file and line.

README.md is short. Links and pictures lead to what is there, also to headings, by the names that GitHub gives them. Filters and widgets that
programs can use are named in Documentation. Each page there is linked from its index. Python in pages compiles.
"""
import pathlib
import re
import sys

LONGEST = 150  # lines of README.md
LINK = re.compile(r"!?\[(?:[^\[\]]|\[[^\[\]]*\])*\]\(<?([^()<>\s]+)>?\)")
FENCE = re.compile(r"^\s*```\s*(\w*)")


class Page:
    """Lines outside code with their numbers, blocks of code as (language, first line, text), and the anchors of headings."""

    def __init__(self, path):
        self.lines, self.blocks, self.anchors, language = [], [], set(), None
        for number, line in enumerate(path.read_text().splitlines(), 1):
            fence = FENCE.match(line)
            if fence and language is None:
                language, block = fence.group(1), (number + 1, [])
            elif fence:
                self.blocks.append((language, block[0], "\n".join(block[1]) + "\n"))
                language = None
            elif language is not None:
                block[1].append(line)
            else:
                self.lines.append((number, line))
        self.isOpen = language is not None
        for _, line in self.lines:
            heading = re.match(r"#{1,6} +(.*?) *#*$", line)
            if heading:
                self.anchors.add(self.free(slug(heading.group(1))))

    def free(self, name):
        """The name, or with the number that the next heading of the same name gets."""
        names = [name, *(f"{name}-{i}" for i in range(1, len(self.anchors) + 1))]
        return next(each for each in names if each not in self.anchors)

    def links(self):
        """(line, target) of each link and picture."""
        for number, line in self.lines:
            for target in LINK.findall(re.sub(r"(`+).*?\1", lambda code: "x" * len(code.group()), line)):
                yield number, target


def slug(heading):
    """GitHub's name of a heading."""
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading)
    return re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-")


def broken(root, path, pages):
    """(line, what is wrong) with the links of a page."""
    for number, target in pages[path].links():
        if re.match(r"[a-z][a-z0-9+.-]*:", target):
            continue  # elsewhere in the world
        place, _, anchor = target.partition("#")
        there = (path.parent / place).resolve() if place else path
        if not there.exists():
            yield number, f"there is no {target}"
        elif root not in [there, *there.parents]:
            yield number, f"{target} leads out of the tree"
        elif anchor and there.suffix == ".md":
            if there not in pages:
                pages[there] = Page(there)
            if anchor not in pages[there].anchors:
                yield number, f"{place or path.name} has no heading #{anchor}"


def classes(root, room):
    """Headers of classes that are wrapped, by name."""
    return {header.stem: header for header in sorted(root.glob(f"{room}/*/vtkOversketch*.h"))
            if re.search(rf"^class \w+_EXPORT {header.stem}\b", header.read_text(), re.M)}


def faults(root):
    documentation = root / "Documentation"
    paths = [root / f"{name}.md" for name in ("README", "CHANGELOG", "CONTRIBUTING", "ARCHITECTURE", "TROUBLESHOOTING")]
    paths += sorted(documentation.rglob("*.md")) + sorted(root.glob("Applications/*/README.md")) + sorted(root.glob("Filters/*/README.md"))
    paths += [root / "Data" / "README.md"]
    pages = {path: Page(path) for path in paths}
    length = len(paths[0].read_text().splitlines())
    if length > LONGEST:
        yield paths[0], length, f"has {length} lines, {LONGEST} are allowed"
    for path in paths:
        if pages[path].isOpen:
            yield path, len(path.read_text().splitlines()), "a block of code is not closed"
        for number, what in broken(root, path, pages):
            yield path, number, what
        for language, first, text in pages[path].blocks:
            if language == "python":
                try:
                    compile(text, str(path), "exec")
                except SyntaxError as error:
                    yield path, first - 1 + (error.lineno or 1), error.msg
    index = documentation / "README.md"
    linked = {target.partition("#")[0] for _, target in pages[index].links()}
    for page in sorted(documentation.glob("*.md")):
        if page != index and page.name not in linked:
            yield index, 1, f"does not link {page.name}"
    for room, name in (("Filters", "filters.md"), ("Widgets", "widgets.md"), ("Applications/Session", "session.md")):
        page = documentation / name
        said = set(re.findall(r"\w+", page.read_text())) if page.exists() else set()
        for each, header in classes(root, room).items():
            if each not in said:
                yield page, 1, f"does not name {each} ({header.relative_to(root)})"


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else __file__).resolve()
    root = root if root.is_dir() else root.parents[1]
    found = [f"{path.relative_to(root)}:{line}: {what}" for path, line, what in faults(root)]
    print("\n".join(found) if found else "the pages are as the tree is")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
