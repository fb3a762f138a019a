"""Scenes as mappings, to remove parts of a scene."""
import yaml

from adit.results.run import SceneLoader


def read(path):
    """The scene in a file over those that it extends; numbers keep their units as texts."""
    scene = yaml.load(path.read_text(encoding="utf-8"), SceneLoader)
    base = scene.pop("extends", None)
    return merged(read(path.parent / base), scene) if base else scene


def merged(base, over):
    """Mappings are merged key by key, anything else is replaced."""
    if not (isinstance(base, dict) and isinstance(over, dict)):
        return over
    return base | {key: merged(base[key], value) if key in base else value for key, value in over.items()}
