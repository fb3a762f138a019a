"""Pictures of a study: fragility, answers, joints in detail, which input matters, answers over time and along linings."""
from adit.plots import png
from adit.study.pictures import answers, detail, fragility, inputs, linings, over_time

CHAPTERS = {"fragility": fragility.curves, "answers": answers.drawings, "detail": detail.joints, "inputs": inputs.indices, "time": over_time.histories,
            "linings": linings.envelopes}


def draw(outcome, out):
    """{chapter of the page: {name of the file: Drawing}}; writes each as OUT/pictures/NAME.png in place of earlier ones."""
    folder = out / "pictures"
    for old in folder.glob("*.png"):
        old.unlink()
    drawn = {chapter: dict(drawings(outcome, out)) for chapter, drawings in CHAPTERS.items()}
    for drawings in drawn.values():
        for name, drawing in drawings.items():
            png.write(drawing, folder / f"{name}.png")
    return drawn
