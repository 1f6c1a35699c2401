#!/usr/bin/env python3
"""reference.py DOXYGEN DOXYFILE FOLDER: makes the filter reference; exit code 1 for a warning, or for a public class without a page or
without a word of what it is for."""
import html
import pathlib
import re
import subprocess
import sys



def shown(page):
    return html.unescape(re.sub("<[^>]*>", "", page.read_text()))


if len(sys.argv) != 4:
    sys.exit(__doc__)
if subprocess.run(sys.argv[1:3]).returncode:
    sys.exit("Doxygen found something to say about the headers")
source, pages = pathlib.Path(__file__).resolve().parents[1], pathlib.Path(sys.argv[3]) / "html"
classes = 0
for header in [*source.glob("Filters/*/vtkOversketch*.h"), *source.glob("Widgets/*/vtkOversketch*.h"),
               *source.glob("Applications/Session/Module/vtkOversketch*.h")]:
    text = header.read_text()
    if f"vtkTypeMacro({header.stem}," not in text:
        continue  # shared by the filters inside the project
    brief = re.search(rf"@class {header.stem}\n \* @brief (.+)\n", text)
    page = pages / f"class{header.stem}.html"
    if not brief or not page.exists() or brief.group(1) not in shown(page):
        sys.exit(f"{header.stem} has no page that says what it is for")
    classes += 1
print(classes, "classes")
