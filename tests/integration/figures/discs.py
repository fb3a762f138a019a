"""Scenes of a few discs that are moved as they are told, so that every force between them is known by hand."""

YOUNG, POISSON, DENSITY = 1e9, 0.2, 2000.0
NORMAL, SHEAR = 1e8, 5e7  # stiffness of contacts [N/m]
RADIUS = 0.5


def point(place):
    return {"x": float(place[0]), "y": float(place[1])}


def near(place):
    """Selects the disc or grid point at a place."""
    x, y = place
    return {"x_min": x - 0.1, "x_max": x + 0.1, "y_min": y - 0.1, "y_max": y + 0.1}


def table(places, radius=RADIUS):
    """The discs as a file that `placed` reads."""
    return "x_m,y_m,radius_m\n" + "".join(f"{x},{y},{radius}\n" for x, y in places)


def driven(place, velocity=(0, 0), spin=0.0):
    return {"where": near(place), "velocity": point(velocity), "spin": spin}


def scene(duration, dt, **particles):
    """Discs of the file discs.csv that touch without bonds; every step has its row of histories."""
    contacts = {"normal_stiffness": NORMAL, "shear_stiffness": SHEAR}
    return {"material": {"young_modulus": YOUNG, "poisson_ratio": POISSON, "density": DENSITY}, "time": {"duration": duration, "dt": dt},
            "particles": {"placed": {"path": "discs.csv"}, "engine": "general", "contacts": contacts} | particles,
            "output": {"history_interval": dt}}
