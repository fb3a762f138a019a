"""The immersed tunnel of cases/hzm: its joint at 1842 m in a wave of 500 m/s, as a chain, as a beam, and as coupled windows."""
import numpy as np

from adit import programs
from adit.cases.tunnels import plan_joint
from adit.trade.tunnels.ladder import Ladder, Quantity, Rung

SCENE = programs.ROOT / "cases" / "hzm" / "wave_500_0.2g.yaml"
PLACE, JOINT = "worst-opening", 1842.0  # where the beam opens most [m]
UNTIL = 16.0  # all largest values occur earlier [s]
# The chain needs ground that does not slip.
LINEAR_SPRINGS = "simplified.soil_springs={wavelength: 400 m, dashpot_time: 20 ms}"

QUANTITIES = [Quantity("opening of the edge", "opening of the edge [mm]", 1e3, ".1f"),
              Quantity("offset", "offset [mm]", 1e3, ".2f"), Quantity("rotation", "rotation [mrad]", 1e3, ".3f"),
              Quantity("axial force", "gasket [MN]", 1e-6, ".1f"), Quantity("key force", "keys [MN]", 1e-6, ".1f"),
              Quantity("moment", "moment [MN m]", 1e-6, ".0f")]


def chain(settings):
    def compute(meter):
        run = meter.run("simplified", SCENE, "chain", [*settings, "simplified.model=chain", LINEAR_SPRINGS])
        joints = run.table("joints.csv")
        here = np.argmin(np.abs(joints["chainage_m"] - JOINT))
        return {"opening of the edge": joints["opening_max_m"][here], "offset": joints["offset_max_m"][here]}
    return compute


def beam(settings):
    def compute(meter):
        run = meter.run("simplified", SCENE, "beam", settings, "--zoom", PLACE)
        return largest(plan_joint.of_beam(run, PLACE, plan_joint.half_width(run)))
    return compute


def coupled(width, settings):
    """A window of this width [m], moved at its edges by the beam, whose cost is counted, too."""
    def compute(meter):
        whole = meter.run("simplified", SCENE, "beam", [*settings, f"simplified.zoom.width={width} m"], "--zoom", PLACE)
        run = meter.run("coupler", whole.folder / "zoom" / f"{PLACE}.yaml", "joint",
                        [f"time.duration={min(UNTIL, whole.summary['duration_s'])} s", "output.field_times=[]"])
        return largest(plan_joint.of_model(run, plan_joint.half_width(whole)))
    return compute


def largest(joint):
    times, histories = joint
    return {name: np.abs(values[times <= UNTIL]).max() for name, values in histories.items()}


def ladder(quick):
    settings, widths = (["time.duration=6 s"], (45,)) if quick else ([], (45, 60, 90))
    finer = [*settings, "simplified.ground.column_spacing=20 m"]
    return Ladder("hzm", QUANTITIES, [
        Rung("chain", "chain of rigid bodies", chain(settings)), Rung("beam", "beam", beam(settings)),
        Rung("beam", "beam, ground every 20 m", beam(finer)),
        *(Rung("coupled", f"window of {width} m", coupled(width, settings)) for width in widths)])
