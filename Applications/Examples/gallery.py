#!/usr/bin/env python3
"""Runs every example, keeps its picture in Pictures/ and writes README.md, the gallery, from what each says of itself.

usage: gallery.py
"""
import ast
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
DEFORMATION = (
    "working_procedure",
    "deformations",
    "silhouette_traces",
    "hidden_silhouette",
    "matching",
    "shape_diameter",
    "region_growing",
    "region_border",
    "remeshing",
)
EDITING = (
    "line_and_ring",
    "control_points",
    "resketching",
    "transitions",
    "shadings",
    "flattened",
    "layer_handles",
    "area_selection",
    "profile_planes",
    "profile",
    "axis_handle",
    "influence",
    "rotated_and_resketched",
    "rotated_and_extruded",
    "sunk_and_extruded",
)
AUGMENTATION = (
    "augmentation",
    "displacements",
    "refinement",
    "snapping",
    "resolution",
    "sharp_feature",
    "sharpness",
    "adaptive",
    "inward_outward",
    "new_silhouettes",
    "terrain_mesh",
    "terrain_pipeline",
    "terrain_strokes",
)
DRAWING = (
    "magnetic_pen",
    "classification",
    "approximation",
    "planar_meshing",
    "subdivision",
    "quads",
    "darts",
    "inflation",
    "distance_transform",
    "cross_sections",
    "holes_and_tunnels",
    "features",
    "models",
)
EXAMPLES = DEFORMATION + EDITING + AUGMENTATION + DRAWING
HEAD = """# Gallery

One short script for each figure of the papers that shows a result. Each runs alone, with the package on `PYTHONPATH` and a display or
`xvfb-run -a`:

```
xvfb-run -a /usr/bin/python3 Applications/Examples/matching.py matching.png
```

`gallery.py` makes all pictures and this page again; the tests compare each picture with the one here. `sheet.py` is what they draw with,
`edited.py` what those of editing share, `grown.py` those of augmentation, `inflated.py` those of drawings.
"""
CHAPTERS = (
    ("""# Deformation by one stroke

Bao and Howard, "SEED: Sketch-Based 3D Model Deformation"; figures 4 and 5 are drawings of formulas.
""", DEFORMATION),
    ("""# A line, a ring, and what lies between

Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", chapters 4 to 9, on models of our own; what figure 5.1 lays out is figures 5.2 and 5.3.
""", EDITING),
    ("""# Augmentation

"Sketch-based Adaptive Mesh Augmentation using Stellar Operators", on models of our own; figure 3 is a drawing of operators.
""", AUGMENTATION),
    ("""# Models from drawings

"Image-Assisted Modeling from Sketches", on drawings and pictures of our own; figures 1 and 2 are among those of figure 17, 4 and 5 are drawings.
""", DRAWING),
)


def says(name):
    """Title and text of an example."""
    about = ast.get_docstring(ast.parse((HERE / (name + ".py")).read_text()))
    title, text = about.split("\n\nusage:")[0].split(": ", 1)
    return title, " ".join(text.split())


def page():
    parts = [HEAD]
    for chapter, names in CHAPTERS:
        parts.append(chapter)
        for name in names:
            title, text = says(name)
            parts.append(f"## {title}\n\n[{name}.py]({name}.py): {text}\n\n![{title}](Pictures/{name}.png)\n")
    return "\n".join(parts)


def draw(name, path):
    subprocess.run([sys.executable, str(HERE / (name + ".py")), str(path)], check=True)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        sys.exit(__doc__)
    for example in EXAMPLES:
        draw(example, HERE / "Pictures" / (example + ".png"))
    (HERE / "README.md").write_text(page())
