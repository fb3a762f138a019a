"""What `adit trade NAME` computes: scenes, as it computes a user's own, and ladders of tunnels."""
from adit import programs
from adit.trade.tunnels import hzm, longxi, longxi_cells, qingcaosha

OWN = programs.PACKAGE / "trade" / "scenes"
SCENES = {  # name: (scene, questions)
    "cantilever": (OWN / "cantilever.yaml", ["clamp_moment_Nm", "near_uy_m", "tip_uy_m"]),
    "bar": (OWN / "bar.yaml", ["clamp_thrust_N", "near_ux_m", "far_ux_m"]),
    "ground_patch": (programs.ROOT / "cases" / "ground_patch" / "coupled.yaml", ["surface_uy_m", "middle_uy_m"])}
TUNNELS = {"longxi": longxi, "longxi_cells": longxi_cells, "qingcaosha": qingcaosha, "hzm": hzm}
NAMES = [*SCENES, *TUNNELS]
