"""What has no order: results that depend on the packing of the particles, or on a last bit once cells crack.

Such a result does not approach a limit from model to model as h^p. It is computed five times, with other seeds of its packings, or
where it has none with a step that differs in its last digits; the median is told with the range.
"""
from adit.accuracy.scene import parts_of

PACKINGS = 5  # runs in all
LAST_DIGITS = 1e-12  # of the step


class Scatter:
    """Of a scene, given as mappings; results that scatter by less than `least` of themselves do not."""

    def __init__(self, scene, least):
        self.least = least
        self.seeds = _seeds(scene)
        self.step = _step(scene)
        self.what = "packings" if self.seeds else "runs that differ in the last digits of the step"
        self.found = {}  # {whether the model cracks: whether its results scatter}

    def others(self, cracked):
        """[{key: text}] of the runs beside the first one, where the results of such a model scatter or where that is not known."""
        if not (cracked or self.seeds) or not any(self.found.values()) and cracked in self.found:
            return []
        if self.seeds:
            return [{key: f"{seed + number}" for key, seed in self.seeds.items()} for number in range(1, PACKINGS)]
        key, value = self.step
        return [{key: f"{value * (1 - number * LAST_DIGITS):.15g}"} for number in range(1, PACKINGS)]

    def counts(self, values, cracked):
        """Whether the results of a model scatter, from {result: [its values]}; from the first model that does, all of them do."""
        several = all(len(each) > 1 for each in values.values())
        if several and cracked not in self.found:
            self.found[cracked] = any(max(each) - min(each) > self.least * max(map(abs, each)) for each in values.values())
        return several and any(self.found.values())


def _seeds(scene):
    found = {f"{path}.{packing}.seed": part[packing].get("seed", 1) for path, part in parts_of(scene)
             for packing in ("cells", "random_packing") if packing in part}
    return found | {f"tunnels[{number}].particles.seed": tunnel["particles"].get("seed", 1)
                    for number, tunnel in enumerate(scene.get("tunnels", [])) if "size" in tunnel.get("particles", {})}


def _step(scene):
    time = scene["time"]
    return ("time.dt", time["dt"]) if "dt" in time else ("time.dt_factor", time.get("dt_factor", 0.5))
