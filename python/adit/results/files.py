"""Files of a run, read or refused in one sentence."""
from difflib import get_close_matches


class Unusable(Exception):
    """A request cannot be fulfilled, for example because a file of a run is missing; the message is one sentence for the user."""


def read(path, reader):
    """reader(path); Unusable if the file is missing or damaged."""
    if not path.exists():
        raise Unusable(f"{path} does not exist: is {path.parent} the folder of a run?")
    try:
        return reader(path)
    except Exception as error:  # a damaged file can cause any error, and the user needs to know which file it is
        raise Unusable(f"{path} is damaged ({type(error).__name__}: {error}): run the scene again.") from error


def nearest(name, known):
    """The end of a message about an unknown name: the nearest known name, or all of them."""
    known = list(known)
    close = get_close_matches(str(name), known, 1)
    return f"did you mean `{close[0]}`?" if close else f"there is {', '.join(known)}." if known else "it is empty."
