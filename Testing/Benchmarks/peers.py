#!/usr/bin/env python3
"""Peers that come as Python packages: libigl, potpourri3d, scikit-learn, pymeshlab, Shewchuk's Triangle. Run by run.sh in a virtual environment of its own.

usage: peers.py MESHES OUT.json [SIZE...]
MESHES holds bunny_5k.obj, bunny_30k.ply and bunny_180k.ply. Writes a list of {"name": "job/size/who", "real_time": median
milliseconds of five runs, "threads": ..., figures...}, as the table reads it.
"""
import json
import os
import sys
import time

os.environ["OMP_NUM_THREADS"] = os.environ["IGL_NUM_THREADS"] = "2"

import numpy as np
import pymeshlab
import igl
import igl.embree
import potpourri3d
import triangle
from sklearn.mixture import GaussianMixture

RUNS = 5


def measure(name, threads, prepare, run, figures=lambda result: {}):
    times, processor = [], []
    for _ in range(RUNS):
        state = prepare()
        start, busy = time.perf_counter(), time.process_time()
        result = run(state)
        times.append(1000.0 * (time.perf_counter() - start))
        processor.append(1000.0 * (time.process_time() - busy))
    row = {"name": name, "real_time": float(np.median(times)), "threads": threads}
    row.update(figures(result))
    print(f"{name:50} {row['real_time']:10.3f} ms, of the processor {np.median(processor):10.3f}", flush=True)
    return row


def bunny(folder, size):
    """Vertices and triangles, the bounding box's middle at the origin and its diagonal 1."""
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(f"{folder}/bunny_{size}.{'obj' if size == '5k' else 'ply'}")
    vertices, triangles = meshes.current_mesh().vertex_matrix(), meshes.current_mesh().face_matrix()
    lower, upper = vertices.min(0), vertices.max(0)
    return (vertices - 0.5 * (lower + upper)) / np.linalg.norm(upper - lower), triangles.astype(np.int64)


def shape_diameter(size, vertices, triangles):
    """libigl's shoots a whole hemisphere, a harder cone than ours; its tree is built in the time, as ours is."""
    normals = igl.per_vertex_normals(vertices, triangles)
    return measure(f"SDF Embree/{size}/libigl", 2, lambda: None,
                   lambda _: igl.embree.shape_diameter_function(vertices, triangles, vertices, normals, 32))


def remeshing(size, vertices, triangles):
    length = np.mean([np.linalg.norm(vertices[triangles[:, k]] - vertices[triangles[:, k - 1]], axis=1) for k in range(3)])

    def load():
        meshes = pymeshlab.MeshSet()
        meshes.add_mesh(pymeshlab.Mesh(vertices, triangles))
        return meshes

    def run(meshes):
        meshes.meshing_isotropic_explicit_remeshing(iterations=5, targetlen=pymeshlab.PureValue(length),
                                                    checksurfdist=False, featuredeg=180)
        return meshes
    return measure(f"remeshing/{size}/pymeshlab", 1, load, run,
                   lambda meshes: {"triangles": meshes.current_mesh().face_number()})


def mixture():
    """62 iterations, none less, the work of our whole greedy fit (em_benchmark.cxx); 2048 samples, four components."""
    random = np.random.default_rng(7)
    samples = np.concatenate([random.normal(m, s, 512) for m, s in ((.1, .05), (.3, .08), (.55, .06), (.8, .05))])[:, None]
    means = ((np.arange(4) + 0.5) / 4)[:, None]

    def model():
        return GaussianMixture(4, covariance_type="diag", tol=0.0, max_iter=62, means_init=means, weights_init=[0.25] * 4,
                               precisions_init=np.full((4, 1), 100.0), reg_covar=1e-9)
    import warnings
    warnings.filterwarnings("ignore")  # that it did not converge is what we ask for
    return measure("greedy EM/2048/scikit-learn", 1, model, lambda fit: fit.fit(samples),
                   lambda fit: {"iterations": int(fit.n_iter_)})


def laplacian(folder):
    """The systems that laplacian_benchmark wrote (NAME.txt: row, column, value, from 0; whole symmetric matrix)."""
    import scipy.sparse
    rows = []
    for file in sorted(os.listdir(folder)):
        if not file.endswith(".triplets"):
            continue
        size = file[:-len(".triplets")]
        i, j, value = np.loadtxt(os.path.join(folder, file), unpack=True)
        matrix = scipy.sparse.csc_matrix((value, (i.astype(int), j.astype(int))))
        right = np.ones((matrix.shape[0], 3))
        known, values = np.zeros(0, dtype=np.int64), np.zeros((0, 3))

        def factor(_):
            data = igl.min_quad_with_fixed_data()
            igl.min_quad_with_fixed_precompute(matrix, known, scipy.sparse.csc_matrix((0, matrix.shape[0])), True, data)
            return data
        rows.append(measure(f"Laplacian factor/{size}/libigl", 1, lambda: None, factor))
        data = factor(None)
        rows.append(measure(f"Laplacian solve/{size}/libigl", 1, lambda: None,
                            lambda _: igl.min_quad_with_fixed_solve(data, right, values, np.zeros((0, 3)))))
    return rows


def triangulations(folder):
    """The points and constraints that triangulation_benchmark wrote, and its edges: those that are not alike are counted."""
    rows = []
    for file in sorted(os.listdir(folder)):
        if not file.endswith(".plane"):
            continue
        read = {"point": [], "constraint": [], "edge": []}
        with open(os.path.join(folder, file)) as lines:
            for kind, a, b in map(str.split, lines):
                read[kind].append((float(a), float(b)))
        plane = {"vertices": np.array(read["point"])}
        if read["constraint"]:
            plane["segments"] = np.array(read["constraint"], np.int32)
        ours = {(int(a), int(b)) for a, b in read["edge"]}

        def unlike(made):
            corners = made["triangles"]
            sides = np.sort(np.concatenate([corners[:, [0, 1]], corners[:, [1, 2]], corners[:, [2, 0]]]), axis=1)
            return {"constraints": len(read["constraint"]), "edges_unlike_ours": len(ours ^ {tuple(map(int, side)) for side in sides})}
        # Without constraints the convex hull is asked for, which its segments would else cut down to.
        rows.append(measure(f"{file[:-len('.plane')]}/5k/Triangle", 1, lambda: None,
                            lambda _: triangle.triangulate(plane, "pc" if read["constraint"] else ""), unlike))
    return rows


def icosphere(levels):
    """That of the test harness, in another order."""
    t = 0.5 * (1.0 + 5.0 ** 0.5)
    points = np.array([[-1, t, 0], [1, t, 0], [-1, -t, 0], [1, -t, 0], [0, -1, t], [0, 1, t], [0, -1, -t], [0, 1, -t],
                       [t, 0, -1], [t, 0, 1], [-t, 0, -1], [-t, 0, 1]], float)
    faces = np.array([[0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11], [1, 5, 9], [5, 11, 4], [11, 10, 2], [10, 7, 6],
                      [7, 1, 8], [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8], [3, 8, 9], [4, 9, 5], [2, 4, 11], [6, 2, 10],
                      [8, 6, 7], [9, 8, 1]], np.int64)
    points /= np.linalg.norm(points, axis=1)[:, None]
    for _ in range(levels):
        sides = np.sort(faces[:, [[0, 1], [1, 2], [2, 0]]].reshape(-1, 2), axis=1)
        edges, number = np.unique(sides, axis=0, return_inverse=True)
        middles = points[edges].sum(1)
        a, b, c = (len(points) + number.reshape(-1, 3)).T
        points = np.concatenate([points, middles / np.linalg.norm(middles, axis=1)[:, None]])
        x, y, z = faces.T
        faces = np.concatenate([np.stack(f, 1) for f in ((x, a, c), (a, y, b), (c, b, z), (a, b, c))])
    return points, faces


def regions():
    """The region of edit_benchmark, the sphere above a height: its plain harmonic map, and distances from a line over its pole by the
    heat method, from nothing."""
    points, faces = icosphere(7)
    rows = []
    for size, height in (("10k", 0.878), ("50k", 0.39)):
        inside = faces[(points[faces, 2] > height).all(1)]
        used, numbers = np.unique(inside, return_inverse=True)
        cap, triangles = points[used], numbers.reshape(-1, 3)
        reach = 0.6 * (1.0 - height * height) ** 0.5
        line = np.nonzero((np.abs(cap[:, 1]) < 0.005) & (np.abs(cap[:, 0]) <= reach))[0]

        def harmonic(_):
            border = igl.boundary_loop(triangles)
            return igl.harmonic(cap, triangles, border, igl.map_vertices_to_circle(cap, border), 1)

        def heat(_):
            return potpourri3d.MeshHeatMethodDistanceSolver(cap, triangles).compute_distance_multisource(line)
        figures = {"vertices": len(cap)}
        rows.append(measure(f"disc/{size}/libigl", 1, lambda: None, harmonic, lambda _: figures))
        rows.append(measure(f"distance/{size}/potpourri3d's heat method", 1, lambda: None, heat, lambda _: figures))
    return rows


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    folder, out, sizes = sys.argv[1], sys.argv[2], sys.argv[3:] or ["5k", "30k", "180k"]
    rows = [mixture()] + regions()
    for size in sizes:
        vertices, triangles = bunny(folder, size)
        rows += [shape_diameter(size, vertices, triangles), remeshing(size, vertices, triangles)]
    for written in (laplacian, triangulations):
        rows += written(os.path.dirname(os.path.abspath(out)))
    with open(out, "w") as file:
        json.dump(rows, file, indent=1)


main()
