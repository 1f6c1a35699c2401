"""Strokes as a person would draw them, made by rule: find a limb in a view of a model, take its outline from base to
base, and displace that smoothly so that the limb grows longer, shorter, thicker, or bends.

    python3 strokes.py FOLDER    writes the strokes (.vtp), index.json and contact sheets
"""
import json
import sys
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkDoubleArray
from vtkmodules.vtkFiltersModeling import vtkDijkstraGraphGeodesicPath

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))
import meshes  # noqa: E402  (finds what follows)
import listing  # noqa: E402
import picture  # noqa: E402
import sheets  # noqa: E402
import stroke_files  # noqa: E402

KINDS = {  # amounts to try, the boldest first
    "lengthen": (0.50, 0.35, 0.25, 0.15),
    "bend": (32, -32, 24, -24, 15, -15),
    "thicken": (0.50, 0.35, 0.22),
    "shorten": (0.28, 0.22, 0.16),
}
PER_MODEL = 4
PER_KNOWN_MODEL = 8  # of capsule_figure, whose limbs are known exactly
SPACING = 2.0  # px between the outline points that limbs are searched on
LEAST_LIMB = 0.008  # of the model's size; what sticks out by less is a bump or a tuft of fur, and no limb (an ear of a dog is 0.009)


# ------------------------------------------------------------------------------------------- tips of a model

def geodesic(mesh, start):
    """Lengths of the shortest paths along edges from a vertex to all others (inf where there is none)."""
    path = vtkDijkstraGraphGeodesicPath()
    path.SetInputData(mesh)
    path.SetStartVertex(int(start))
    path.SetEndVertex(int(start))
    path.StopWhenEndReachedOff()
    path.Update()
    weights = vtkDoubleArray()
    path.GetCumulativeWeights(weights)
    length = vtk_to_numpy(weights).copy()
    length[(length < 0) | (np.arange(len(length)) != start) & (length == 0)] = np.inf
    return length


def tips(points, triangles):
    """The limb tips of a welded mesh, vertices whose mean geodesic distance to the rest is largest about them, each with
    its distances to all vertices; and of each by how much it sticks out."""
    mesh = meshes.to_polydata(points, triangles)
    used = np.unique(triangles)
    chosen = [int(used[np.argmax(((points[used] - points[used].mean(0)) ** 2).sum(1))])]
    fields = [geodesic(mesh, chosen[0])]
    for _ in range(23):  # farthest points, spread evenly over the surface
        nearest = np.min(fields, axis=0)
        nearest[~np.isfinite(nearest)] = -1
        chosen.append(int(np.argmax(nearest)))
        fields.append(geodesic(mesh, chosen[-1]))
    mean = np.mean(np.where(np.isfinite(fields), fields, np.nanmax(np.where(np.isfinite(fields), fields, 0))), axis=0)
    radius = 0.10 * mean.max()
    highest = np.full(len(points), -np.inf)  # among the neighbours
    for a, b in ((0, 1), (1, 2), (2, 0), (1, 0), (2, 1), (0, 2)):
        np.maximum.at(highest, triangles[:, a], mean[triangles[:, b]])
    peaks = used[mean[used] >= highest[used]]
    found = []
    for v in peaks[np.argsort(-mean[peaks], kind="stable")]:
        if mean[v] < 0.75 * mean[used].mean() or len(found) == 16:
            break
        if found and min(np.linalg.norm(points[v] - points[f]) for f, _ in found) < radius * 0.5:
            continue
        if found and any(field[v] < radius for _, field in found):
            continue
        field = geodesic(mesh, v)
        if np.all(mean[field < radius] <= mean[v]):
            found.append((int(v), field))
    out = prominences(mean, triangles)
    return dict(found), {v: out[v] for v, _ in found}


def prominences(height, triangles):
    """Of each vertex how much higher it is than the pass to something higher, over edges: the persistence of peaks. Infinite where nothing is
    higher, 0 of what is no peak."""
    pairs, found = meshes.edges_of(triangles)[0], np.zeros(len(height))
    both = np.concatenate([pairs, pairs[:, ::-1]])
    both = both[np.argsort(both[:, 0], kind="stable")]
    start = np.searchsorted(both[:, 0], np.arange(len(height) + 1))
    peak = np.full(len(height), -1)  # towards the highest vertex of what is joined so far

    def top(v):
        while peak[v] != v:
            peak[v] = v = peak[peak[v]]
        return v
    for v in np.argsort(-height, kind="stable"):
        peak[v] = v
        for other in both[start[v]:start[v + 1], 1]:
            if peak[other] < 0:
                continue
            high, low = sorted((top(other), top(v)), key=lambda k: -height[k])
            if high != low:
                found[low], peak[low] = height[low] - height[v], high
    found[[v for v in np.unique(triangles) if peak[v] == v]] = np.inf
    return found


# ------------------------------------------------------------------------------------------ limbs in a view

def limbs_in(view, points, triangles):
    """Protrusions of the outer outline, the best first: dicts of section (n, 2) px from base to base, and measures."""
    xy, depth = view.display(points)
    loops = picture.outline(xy, triangles, 1.0)
    area = [0.5 * np.sum(l[:-1, 0] * l[1:, 1] - l[1:, 0] * l[:-1, 1]) for l in loops]
    outer = picture.resample(loops[int(np.argmax(area))], SPACING)[:-1]
    n = len(outer)
    count = picture.layers(xy, triangles)
    covered = count > 0
    total = covered.sum()
    whole = np.concatenate([outer, outer])
    limbs = []
    i = np.arange(0, n, 2)
    steps = np.arange(int(64 / SPACING), int(0.45 * n), 2)
    chord = np.linalg.norm(whole[i[:, None] + steps] - outer[i][:, None], axis=2)
    ratio = np.where((chord > 10) & (chord < 260), steps * SPACING / np.maximum(chord, 1e-9), 0)
    ratio[ratio < 2.4] = 0
    block = 5  # of each 5 x 5 candidates only the best one is looked at
    ratio = np.pad(ratio, [(0, -k % block) for k in ratio.shape])
    tiles = ratio.reshape(ratio.shape[0] // block, block, -1, block).swapaxes(1, 2).reshape(-1, block * block)
    tile, best = np.arange(len(tiles)), tiles.argmax(1)
    strength = tiles[tile, best]
    across_tiles = ratio.shape[1] // block
    for k in np.argsort(-strength, kind="stable"):
        if strength[k] == 0:
            break
        a = 2 * int(k // across_tiles * block + best[k] // block)
        s = int(k % across_tiles * block + best[k] % block)
        b = a + int(steps[s])
        width = float(np.linalg.norm(whole[b] - whole[a]))
        span = np.arange(a, b + 1)
        if any(limb["span"] >= 0.7 * len(span) and np.isin(span % n, limb["ids"]).sum()
               > 0.55 * min(len(span), limb["span"]) for limb in limbs):
            continue
        p, q = whole[a], whole[b]
        across = p + (q - p) * np.linspace(0.08, 0.92, 15)[:, None]
        ok = (across > 0).all(1) & (across < (picture.WIDTH, picture.HEIGHT)).all(1)
        if not ok.all() or not covered[across[:, 1].astype(int), across[:, 0].astype(int)].all():
            continue
        section = whole[a:b + 1]
        base = (p + q) / 2
        far = int(np.argmax(np.linalg.norm(section - base, axis=1)))
        tip = section[far]
        length = float(np.linalg.norm(tip - base))
        if length < max(32, 0.9 * width) or not 0.36 < far / len(span) < 0.64:
            continue
        # One limb, not two or a head with horns: out along one side, back along the other, from a base across it.
        axis = (tip - base) / length
        if np.abs(np.diff((section - base) @ axis)).sum() > 2.35 * length or abs((q - p) @ axis) > 0.5 * width:
            continue
        body = picture.inside_polygon(section)
        pixels = (body & covered).sum()
        if width > 2.2 * pixels / length or not 0.003 < pixels / total < 0.33:
            continue
        if (count[body] == 2).mean() < 0.98:
            continue
        limbs.append({"ids": span % n, "span": len(span), "section": section, "length": length, "body": body,
                      "width": float(pixels / length), "base": base, "tip": tip, "outer": outer})
        if len(limbs) == 12:
            break
    return limbs, xy, depth, covered


def smooth(line, sigma):
    """A Gaussian average along a polyline of even spacing, its ends held."""
    reach = int(3 * sigma)
    kernel = np.exp(-0.5 * (np.arange(-reach, reach + 1) / sigma) ** 2)
    kernel /= kernel.sum()
    padded = np.concatenate([2 * line[0] - line[reach:0:-1], line, 2 * line[-1] - line[-2:-reach - 2:-1]])
    return np.c_[np.convolve(padded[:, 0], kernel, "valid"), np.convolve(padded[:, 1], kernel, "valid")]


def ramp(x):
    x = np.clip(x, 0, 1)
    return x * x * (3 - 2 * x)


def displaced(limb, kind, amount):
    """The section, moved as a person would draw the changed limb."""
    section = smooth(limb["section"], 2.0)
    base, axis = limb["base"], (limb["tip"] - limb["base"]) / limb["length"]
    along = np.clip((section - base) @ axis / limb["length"], 0, 1)
    if kind in ("lengthen", "shorten"):
        grow = amount if kind == "lengthen" else -amount
        return section + np.outer(grow * limb["length"] * along * ramp(along / 0.5) ** 0.5, axis)
    if kind == "bend":  # every point turns about a centre near the base, the farther out the more
        angle = np.radians(amount) * ramp(along / 0.9)
        pivot = base + 0.15 * limb["length"] * axis
        c, s = np.cos(angle), np.sin(angle)
        d = section - pivot
        return pivot + np.c_[c * d[:, 0] - s * d[:, 1], s * d[:, 0] + c * d[:, 1]]
    tangent = np.gradient(section, axis=0)
    normal = np.c_[tangent[:, 1], -tangent[:, 0]] / np.maximum(np.linalg.norm(tangent, axis=1, keepdims=True), 1e-9)
    size = amount * limb["width"] / 2 * ramp(np.minimum(np.arange(len(section)), np.arange(len(section))[::-1])
                                             * SPACING / (0.3 * limb["length"]))
    return smooth(section + smooth(normal, 4.0) * size[:, None], 3.0)


def crosses_itself(line):
    p = picture.resample(line, 4.0)
    a, d = p[:-1], np.diff(p, axis=0)
    cross = lambda u, v: u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]
    gap = a[None] - a[:, None]
    whole = cross(d[:, None], d[None])
    with np.errstate(divide="ignore", invalid="ignore"):
        s, t = cross(gap, d[None]) / whole, cross(gap, d[:, None]) / whole
    hit = (s > 0) & (s < 1) & (t > 0) & (t < 1)
    return bool(np.triu(hit, 2).any())


def drawable(limb, kind, stroke, covered):
    """Whether a person could draw this: inside the picture, not over itself, clear of everything but its own limb."""
    if kind in ("lengthen", "shorten") and picture.lengths(limb["section"])[-1] / 2 > 1.2 * limb["length"] + limb["width"] / 2:
        return False  # a curled limb: along which line?
    if (stroke < 10).any() or (stroke > (picture.WIDTH - 10, picture.HEIGHT - 10)).any() or crosses_itself(stroke):
        return False
    swept = picture.inside_polygon(stroke) & ~limb["body"] & covered
    rows, columns = np.nonzero(swept)
    if len(rows):  # what it sweeps over must lie by its own base
        ends = limb["section"][[0, -1]]
        away = np.linalg.norm(np.c_[columns, rows][:, None] - ends, axis=2).min(1)
        if (away > 0.35 * limb["width"] + 10).sum() > 0.01 * limb["body"].sum():
            return False
    others = np.delete(limb["outer"], limb["ids"], axis=0)
    m = len(stroke)
    middle = stroke[int(0.18 * m):int(0.82 * m)]
    gap, _, _ = picture.distance_to(middle, [np.vstack([others, others[:1]])]) if len(others) > 2 else ([np.inf], 0, 0)
    return min(gap) > 7


def pen(stroke, number):
    """Samples as a pen leaves them: 3 to 5 px apart."""
    s = picture.lengths(stroke)
    at, k = [0.0], 0
    while at[-1] < s[-1] - 5.5:
        at.append(at[-1] + 4.0 + np.sin(0.37 * k + number))
        k += 1
    at.append(s[-1])
    return np.c_[np.interp(at, s, stroke[:, 0]), np.interp(at, s, stroke[:, 1])]


# ------------------------------------------------------------------------------------------------ the set

def views_of(points, up):
    axis = {"x": 0, "y": 1, "z": 2}[up[1]]
    up_vector = np.zeros(3)
    up_vector[axis] = -1 if up[0] == "-" else 1
    front = np.roll(up_vector, 1)
    side = np.cross(up_vector, front)
    for number, (azimuth, elevation) in enumerate(
            [(a, e) for e in (0, 18, -14) for a in (0, 90, 45, 135, 180, 270, 22, 67, 112, 157, 225, 315)]):
        a, e = np.radians(azimuth), np.radians(elevation)
        towards = np.cos(e) * (np.cos(a) * front + np.sin(a) * side) + np.sin(e) * up_vector
        for perspective in (False, True):
            yield number, perspective, picture.View.looking(points, towards, up_vector, perspective, 0.62)


def strokes_for(name, mesh, up, number=0, count=PER_MODEL, views=views_of):
    """A model's strokes: (stroke polydata with its note). Spread over its limbs, the kinds and both projections."""
    points, triangles, _ = meshes.weld(*meshes.arrays(mesh))
    paths, sticks_out = tips(points, triangles)
    all_tips, size = list(paths), np.linalg.norm(np.ptp(points, axis=0))
    candidates = []
    for view_number, perspective, view in views(points, up):
        if (view_number % 2 == 0) == perspective:  # each view with one projection
            continue
        limbs, xy, depth, covered = limbs_in(view, points, triangles)
        for limb in limbs:
            pixel = np.round(xy).astype(int)
            on = (pixel >= 0).all(1) & (pixel < (picture.WIDTH, picture.HEIGHT)).all(1)
            within = np.zeros(len(points), bool)
            within[on] = limb["body"][pixel[on, 1], pixel[on, 0]]
            at_base = within & (np.linalg.norm(xy - limb["base"], axis=1) < 0.5 * limb["width"] + 4)
            at_tip = within & (np.linalg.norm(xy - limb["tip"], axis=1) < 0.5 * limb["width"] + 4)
            if not at_base.any() or not at_tip.any():
                continue
            step = points[at_tip].mean(0) - points[at_base].mean(0)
            slant = abs(view.view[2, :3] @ step) / np.linalg.norm(step)
            if slant > 0.6:
                continue
            rim, _, _ = picture.distance_to(xy[all_tips], [limb["section"]])  # a toe may just stick out of the section
            own = [t for t, off in zip(all_tips, rim) if within[t] or off < 5]
            if any(paths[a][b] > np.linalg.norm(step) for a in own for b in own):  # two limbs side by side
                continue
            near = points[at_tip].mean(0)
            spread = max([np.linalg.norm(xy[t] - limb["tip"]) for t in own], default=0.0)
            if spread > max(0.3 * limb["length"], 0.6 * limb["width"]):  # a hand's fingers, but not a head's ears
                continue
            which = min(own or all_tips, key=lambda t: np.linalg.norm(points[t] - near))
            # What lies nearer over the surface than the limb's base is the limb's own: a beak under a head seen from behind.
            own = [t for t in all_tips if t in own or paths[which][t] < np.median(paths[which][at_base])]
            merit = np.sqrt(limb["length"]) * min(limb["length"] / limb["width"], 3) * (1.2 - slant) \
                * (1.0 if view_number < 12 else 0.9)
            candidates.append({"merit": merit, "limb": limb, "view": view, "covered": covered, "tip": int(which),
                               "inner": [int(t) for t in own], "perspective": perspective, "view_number": view_number})
    candidates.sort(key=lambda c: (-c["merit"], c["view_number"]))
    made, used_tips, used_views = [], [], []
    kinds = list(KINDS)
    for turn in range(count * 3):
        if len(made) == count:
            break
        kind = kinds[(len(made) + number + (turn - len(made))) % 4]
        turn_number = len(made) + number
        perspective = (turn_number + turn_number // 4) % 2 == 1  # not tied to the kind
        order = sorted(range(len(candidates)), key=lambda k: (
            used_tips.count(candidates[k]["tip"]), candidates[k]["perspective"] != perspective,
            used_views.count((candidates[k]["view_number"], candidates[k]["tip"])), -candidates[k]["merit"]))
        for k in order[:25]:
            c = candidates[k]
            if used_views.count((c["view_number"], c["tip"])):
                continue
            amounts = KINDS[kind] if kind != "bend" or (k % 2 == 0) else tuple(-a for a in KINDS[kind])
            amounts = amounts[len(made) % 2:] if kind != "bend" else amounts
            amount = next((a for a in amounts if drawable(c["limb"], kind, displaced(c["limb"], kind, a), c["covered"])), None)
            if amount is None:
                continue
            line = displaced(c["limb"], kind, amount)
            note = {"name": f"{name}-{len(made) + 1}-{kind}", "model": name, "kind": kind, "amount": amount,
                    "projection": "perspective" if c["perspective"] else "orthographic",
                    "tip": points[c["tip"]].tolist(), "section": np.round(c["limb"]["section"], 2).tolist(),
                    "other_tips": [points[t].tolist() for t in all_tips
                                   if t not in c["inner"] and t != c["tip"] and sticks_out[t] >= LEAST_LIMB * size]}
            made.append((stroke_files.polydata(pen(line, len(made)), c["view"], note), note))
            used_tips.append(c["tip"])
            used_views.append((c["view_number"], c["tip"]))
            break
    return made


def _make_for_model(job):
    folder, number, name, path, up = job
    entries = []
    count = PER_KNOWN_MODEL if name == "capsule_figure" else PER_MODEL
    for stroke, note in strokes_for(name, meshes.read(path), up, number, count):
        stroke_files.write(stroke, folder / f"{note['name']}.vtp")
        entries.append({"name": note["name"], "model": name, "mesh": str(path), "kind": note["kind"],
                        "projection": note["projection"]})
    print(f"{name}: {len(entries)} strokes", flush=True)
    return entries


def make_all(folder, only=(), workers=2):
    """Writes every model's strokes and an index, the shipped strokes first; returns the index."""
    folder = Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    index = []
    for path in listing.one_stroke():
        model = path.stem.split("_")[0]
        if not only or model in only:
            stroke, _, view, _ = stroke_files.read(path)
            stroke_files.write(stroke, folder / path.name)
            index.append({"name": path.stem, "model": model, "mesh": str(meshes.DATA / "Models" / f"{model}.ply"),
                          "kind": "shipped", "projection": "perspective" if view.perspective else "orthographic"})
    jobs = [(folder, n, *model) for n, model in enumerate(meshes.models()) if not only or model[0] in only]
    with ProcessPoolExecutor(workers) as pool:
        for entries in pool.map(_make_for_model, jobs):
            index += entries
    (folder / "index.json").write_text(json.dumps(index, indent=1))
    return index


def preview(mesh, samples, view, note):
    points, triangles, _ = meshes.weld(*meshes.arrays(mesh))
    image = picture.shaded(view, points, triangles, scale=1)
    if note and note.get("section"):
        picture.draw(image, np.array(note["section"]), picture.BLUE)
    picture.draw(image, samples, picture.RED)
    return image


def main():
    folder = Path(sys.argv[1])
    index = make_all(folder, sys.argv[2:])
    pictures = []
    for entry in index:
        _, samples, view, note = stroke_files.read(folder / f"{entry['name']}.vtp")
        image = picture.halve(preview(meshes.read(entry["mesh"]), samples, view, note))
        picture.write_text(image, f"{entry['name']} {note['amount'] if note else ''} {entry['projection'][:5]}", 6, 6, 13)
        pictures.append(image)
    sheets.write(pictures, folder / "sheet", columns=4, rows=4)


if __name__ == "__main__":
    main()
