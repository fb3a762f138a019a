"""A template with one fault: broken_template.py FAULT. Each fault is one that adit conformance must find."""

import pathlib
import sys
import threading
import time

FAULT = sys.argv.pop(1)
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "adapters/python"))
import continuum  # noqa: E402
import leap_frog  # noqa: E402
import particles  # noqa: E402
import reading  # noqa: E402
import wire  # noqa: E402


def nothing(*_):
    pass


def replace(owner, name, make):
    """The function of this name becomes what `make` makes of it."""
    setattr(owner, name, make(getattr(owner, name)))


def after(owner, name, change):
    """Once the method has run, `change` gets its object, its request and its answer."""

    def made(method):
        def changed(self, *arguments):
            result = method(self, *arguments)
            change(self, *arguments)
            return result
        return changed

    replace(owner, name, made)


def scaled(names, factor):
    def change(self, request, answer):
        for name in names:
            setattr(answer, name, factor * getattr(answer, name))
    return change


def double_last_row(self, operator):
    operator.values[-1] *= 2


def forget_prescribed(self, *_):
    self.inverse = 1 / self.masses


def change_if_wanted(self, request, predicted):
    if request.want_energies:
        self.v = self.v * (1 + 1e-12)


def no_limit(self, *_):
    self.accepts = 1 << 40


def tear(forces):
    def changed(self, dt):
        found = forces(self, dt)
        found[0] *= 1.01
        return found
    return changed


def drag(forces):
    return lambda self, dt: forces(self, dt) - 1e3 * self.v


def springs_along_x(stiffness):
    def changed(*arguments):
        found = stiffness(*arguments)
        found[:4:2, :4:2] += 1e5 * continuum.np.array([[1, -1], [-1, 1]])
        found[1:4:2, 1:4:2] += 1e5 * continuum.np.array([[1, -1], [-1, 1]])
        return found
    return changed


def patient(next_frame):
    def changed(self):
        while True:
            try:
                return next_frame(self)
            except wire.Gone as error:
                if "no frame" not in str(error):
                    raise
    return changed


def hang_on(converse):
    def changed(link, participant):
        try:
            converse(link, participant)
        except (OSError, wire.Gone):
            time.sleep(60)
            raise
    return changed


FAULTS = {
    "greeting": lambda: setattr(wire, "MAX_FRAME", 0),
    "computed_keys": lambda: replace(reading, "keys", lambda keys: lambda *given: (key for key in keys(*given) if key != "material.density")),
    "heartbeats": lambda: setattr(wire.Link, "beat", nothing),
    "order": lambda: wire.Conversation.ALLOWED.update(dict.fromkeys(wire.Conversation.ALLOWED, set(wire.Conversation.ANSWERS))),
    "steps": lambda: setattr(leap_frog.LeapFrog, "check", nothing),
    "unknown_keys": lambda: setattr(continuum, "refuse_others", nothing),
    "empty_places": lambda: setattr(reading, "select", lambda area, points, *_: leap_frog.np.arange(0)),
    "one_run_after_another": lambda: replace(wire, "converse", lambda converse: lambda *given: (converse(*given), time.sleep(3))),
    "busy": lambda: replace(wire, "run_for", lambda run_for: lambda *given: run_for(*given[:-1], threading.Lock())),
    "other_version": lambda: replace(wire.Link, "read", lambda read: lambda self, count: (
        read(self, count) and wire.PREAMBLE if count == 8 else read(self, count))),
    "malformed": lambda: replace(wire.Link, "next_frame", patient),
    "too_long": lambda: after(wire.Link, "greet", no_limit),
    "lost_client": lambda: replace(wire, "converse", hang_on),
    "model": lambda: after(continuum.Continuum, "setup", scaled(["p_wave_speed"], 2)),
    "mass": lambda: after(continuum.Continuum, "weights", scaled(["mass"], 2)),
    "operator_rows": lambda: after(leap_frog.LeapFrog, "fill_operator", double_last_row),
    "applied_force": lambda: replace(continuum, "factor", lambda factor: lambda function: lambda t: 2 * factor(function)(t)),
    "body_load": lambda: replace(continuum, "body_loads", lambda read: lambda given, path, points, masses, tolerance: (
        read(given, path, points, 2 * masses, tolerance))),
    "prescribed": lambda: after(leap_frog.LeapFrog, "begin", forget_prescribed),
    "rigid_translation": lambda: replace(continuum.Continuum, "internal_forces", drag),
    "rigid_rotation": lambda: replace(continuum, "zone_stiffness", springs_along_x),
    "uniform_strain": lambda: replace(continuum, "moduli", lambda moduli: lambda *given: tuple(1.01 * m for m in moduli(*given))),
    "momentum": lambda: replace(continuum.Continuum, "internal_forces", tear),
    "energy_ledger": lambda: replace(leap_frog.LeapFrog, "kinetic_energy", lambda energy: lambda self, _: energy(self, False)),
    "critical_step": lambda: after(continuum.Continuum, "setup", scaled(["critical_dt"], 1.2)),
    "what_is_wanted": lambda: after(leap_frog.LeapFrog, "advance", change_if_wanted),
    "snapshot": lambda: replace(continuum.Continuum, "snapshot_request", lambda draw: lambda self, request, answer: (
        draw(self, type(request)(), answer))),
    "histories": lambda: after(leap_frog.LeapFrog, "step", lambda self, *_: setattr(self, "before", self.v)),
    "strongest": lambda: setattr(particles.Particles, "tell_events", nothing),
}

if __name__ == "__main__":
    FAULTS[FAULT]()
    module, side = (particles, "Particles") if FAULT == "strongest" else (continuum, "Continuum")
    wire.serve(f"broken_{FAULT}", getattr(module, side), list(reading.keys(wire.scene.Scene.DESCRIPTOR, module.COMPUTED)))
