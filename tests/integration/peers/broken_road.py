"""fdm_server with one fault in statics or in its states, which the templates do not compute: the road to it changes frames.

Each fault of FAULTS gives, for one connection, what changes the requests on their way there and the answers on their way back.
"""
import math
import zlib

from foreign import Listener, rewritten, road


def kept(_):
    pass


def where(kind, change):
    """Only frames of this kind are changed."""
    return lambda frame: frame.HasField(kind) and change(getattr(frame, kind))


def reverse(couple):
    pairs = [couple.points[i:i + 2] for i in range(0, len(couple.points), 2)]
    couple.points[:] = [x for pair in reversed(pairs) for x in pair]


def overlook_what_is_wrong(advance):
    if not advance.relax:
        advance.stop, advance.stage, advance.local_damping = False, 0, 0


def double_unrest(predicted):
    predicted.relaxation.unbalanced_force *= 2


def without(name):
    return where("advance", lambda advance: advance.ClearField(name))


def pretend_to_relax():
    """The participant takes a step of time and says that it relaxed."""

    def answer(predicted):
        predicted.relaxation.points = 1

    return without("relax"), where("predicted", answer)


def go_on_from_the_sag():
    """Displacements of time are those since the beginning of statics."""
    sag = [0.0]

    def answer(predicted):
        if predicted.HasField("relaxation"):
            sag[:] = predicted.histories or sag
        else:
            predicted.histories[0] += sag[0]

    return kept, where("predicted", answer)


def correct_time_instead():
    """Impulses on the last step of statics move the first step of time."""

    def answer(predicted):
        if not predicted.HasField("relaxation"):
            predicted.velocities[0] += 1e-9

    return kept, where("predicted", answer)


def forget_a_bit():
    """The first velocity after a restart is another one in its last bit."""
    restarted = [False]

    def answer(frame):
        if frame.HasField("restored"):
            restarted[0] = True
        elif frame.HasField("predicted") and restarted[0]:
            frame.predicted.velocities[0] = math.nextafter(frame.predicted.velocities[0], math.inf)

    return kept, answer


def take_any_part(restore):
    restore.offset, restore.checksum = 0, zlib.crc32(restore.data)


FAULTS = {
    "chosen_points": lambda: (where("couple", reverse), kept),
    "refusals_in_statics": lambda: (where("advance", overlook_what_is_wrong), kept),
    "loads_in_statics": pretend_to_relax,
    "relaxation": lambda: (kept, where("predicted", double_unrest)),
    "local_damping": lambda: (without("local_damping"), kept),
    "stop": lambda: (without("stop"), kept),
    "slowing": lambda: (without("slowing"), kept),
    "scaled_masses": lambda: (without("scale_masses"), kept),
    "rest_of_statics": go_on_from_the_sag,
    "impulses_of_statics": correct_time_instead,
    "restored": forget_a_bit,
    "refused_states": lambda: (where("restore", take_any_part), kept),
}


def broken(server, fault):
    """The address of the server with this fault."""
    return Listener(lambda client: road(server, *map(rewritten, FAULTS[fault]()))(client), clients=math.inf).address
