"""Random fields of stiffness and strength, written as the lattices that `scatter` of a scene reads.

The correlation of the logarithms is a product of two exponentials, so that their matrix on a lattice is the Kronecker product of
those in x and y, and so is its Cholesky factor: a lattice of thousands of nodes costs two small factors.
"""
import numpy as np

from adit.study.quantities import openturns, seed_of

NODES = 4  # in a correlation length


def lattice(given):
    """The coordinates [m] of its columns and rows."""
    return [np.linspace(given[f"{axis}_min"], given[f"{axis}_max"],
                        2 + int(NODES * (given[f"{axis}_max"] - given[f"{axis}_min"]) / given[f"length_{axis}"]))
            for axis in "xy"]


def realization(given, seed):
    """(x, y, factors of shape (y, x)) of a random field."""
    ot = openturns()
    axes = lattice(given)
    factors = [np.linalg.cholesky(np.array(ot.AbsoluteExponential([given[f"length_{axis}"]], [1.0]).discretize(ot.Mesh(axis_nodes[:, None]))))
               for axis, axis_nodes in zip("xy", axes)]
    normal = np.random.default_rng(seed).standard_normal((len(axes[1]), len(axes[0])))
    return *axes, np.exp(given["dispersion"] * (factors[1] @ normal @ factors[0].T))


def settings(study, sample, folder):
    """{key: text} of the scene for the fields of a sample (a name of its own), whose files lie in the folder."""
    scattered = {}
    for given in study.fields:
        path = folder / f"{given['name']}_{sample}.csv"
        if not path.exists():
            _write(path, *realization(given, seed_of(study.seed, sample, given["name"])))
        for part in given["parts"]:
            scattered.setdefault(f"{part}.scatter", []).extend(f"{{of: {what}, path: {path}}}" for what in given["of"])
    return {key: "[" + ", ".join(each) + "]" for key, each in scattered.items()}


def _write(path, x, y, factors):
    path.parent.mkdir(parents=True, exist_ok=True)
    rows = (f"{a:.6g},{b:.6g},{factor:.6g}" for b, row in zip(y, factors) for a, factor in zip(x, row))
    written = path.with_suffix(".writing")
    written.write_text("\n".join(["x_m,y_m,factor", *rows]) + "\n")
    written.replace(path)
