"""Reads the results of the cantilever in Python: docs/python.md, with a picture at the end.

    scripts/run cases/cantilever
    PYTHONPATH=python /usr/bin/python3 docs/read_results.py runs/cantilever

An editor that knows cells (`# %%`) opens this file as a notebook.
"""
# %% Two runs of one beam: particles alone, and continuum and particles coupled
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from adit import Run, Unusable

folder = Path(sys.argv[1])
alone, coupled = Run(folder / "full_dem"), Run(folder / "coupled")

# %% Figures of the summary
for run in (alone, coupled):
    print(f"{run.name}: {run.summary['crack_count']} cracks, largest bond force {run.summary['peak_bond_force_N'] / 1e3:.0f} kN "
          f"at {1e3 * run.summary['peak_bond_force_time_s']:.2f} ms")

# %% Histories are arrays over time: how far apart are the two tips?
apart = coupled.histories["tip_uy_m"] - np.interp(
    coupled.histories["time_s"], alone.histories["time_s"], alone.histories["tip_uy_m"])
print(f"tips: at most {1e3 * np.abs(apart).max():.2f} mm apart, of {1e3 * np.abs(alone.histories['tip_uy_m']).max():.1f} mm")

# %% Energies: what the impact put in is in the beam at the end, or was released by the cracks
end = {kind: sum(coupled.energies[f"{side}_{kind}_J"][-1] for side in ("continuum", "particles")) / 1e3
       for kind in ("external_work", "kinetic", "strain", "released")}
print(f"energy: {end['external_work']:.1f} kJ were put in, {end['kinetic'] + end['strain']:.1f} kJ are in the beam at the end, "
      f"{end['released']:.1f} kJ were released by cracks")

# %% Cracks, as a table of pandas where it is installed
cracks = coupled.cracks
print(f"cracks: the first at {1e3 * cracks['time_s'][0]:.2f} ms, all between x = {cracks['x_m'].min():.2f} m "
      f"and {cracks['x_m'].max():.2f} m")
try:
    print(cracks.frame().groupby("mode").size().to_string())
except Unusable as reason:  # pandas is not installed
    print(reason)

# %% Fields at an instant: the deflection of the grid and of the particles along the beam
fields = coupled.fields(0.032)
figure, axes = plt.subplots(figsize=(8, 3.2), layout="constrained")
for kind in ("particles", "grid"):
    axes.plot(fields[kind].points[:, 0], 1e3 * fields[kind]["displacement_m"][:, 1], ".", ms=3, label=kind)
axes.set(xlabel="x [m]", ylabel="deflection [mm]", title="the beam 32 ms after the impact began")
axes.legend()
figure.savefig(folder / "deflection.png", dpi=150)

# %% The scene as it was computed, in SI units
overlap = coupled.scene["interface"]["overlap"]
print(f"overlap: from x = {overlap['particles_begin']['x']:g} m to {overlap['continuum_ends']['x']:g} m")
