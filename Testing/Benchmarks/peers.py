#!/usr/bin/env python3
"""Peers that come as Python packages: libigl, scikit-learn, pymeshlab. Run by run.sh in a virtual environment of its own.

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
from sklearn.mixture import GaussianMixture

RUNS = 5


def measure(name, threads, prepare, run, figures=lambda result: {}):
    times = []
    for _ in range(RUNS):
        state = prepare()
        start = time.perf_counter()
        result = run(state)
        times.append(1000.0 * (time.perf_counter() - start))
    row = {"name": name, "real_time": float(np.median(times)), "threads": threads}
    row.update(figures(result))
    print(f"{name:50} {row['real_time']:10.3f} ms", flush=True)
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


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    folder, out, sizes = sys.argv[1], sys.argv[2], sys.argv[3:] or ["5k", "30k", "180k"]
    rows = [mixture()]
    for size in sizes:
        vertices, triangles = bunny(folder, size)
        rows += [shape_diameter(size, vertices, triangles), remeshing(size, vertices, triangles)]
    rows += laplacian(os.path.dirname(os.path.abspath(out)))
    with open(out, "w") as file:
        json.dump(rows, file, indent=1)


main()
