"""Fragility models of OpenQuake: NRML 0.5, continuous functions of the shape `logncdf`.

A limit state has the mean and the deviation of the intensity itself: mean = median exp(dispersion^2 / 2) and deviation = mean
sqrt(exp(dispersion^2) - 1). The engine takes them back (openquake/risklib/scientific.py, FragilityFunctionContinuous). It draws the
curve between `minIML` and `maxIML`, holds it constant outside, and takes it as 0 up to `noDamageLimit`.
"""
import math
import re
import xml.etree.ElementTree as ET

from adit.results.files import Unusable, read as read_file
from adit.study.fragility.curves import Curve
from adit.study.fragility.measures import MEASURES

NAMESPACE = "http://openquake.org/xmlns/nrml/0.5"


def mean_and_deviation(curve):
    mean = curve.median * math.exp(curve.dispersion**2 / 2)
    return mean, mean * math.sqrt(math.expm1(curve.dispersion**2))


def curve_of(mean, deviation):
    return Curve(mean**2 / math.hypot(mean, deviation), math.sqrt(math.log1p((deviation / mean)**2)))


def written(number):
    """With all digits."""
    return repr(float(number))


def checked_name(name):
    if not re.fullmatch(r"[A-Za-z0-9_-]{1,100}", name):
        raise Unusable(f"`{name}` cannot be a name in a fragility model of OpenQuake, which takes letters, digits, - and _: rename it.")
    return name


def write(path, name, curves, measure, lowest, highest, *, period=None, no_damage=0.0, description=""):
    """Writes the function `name` with `curves` {state: Curve}, from the least to the worst, over a measure (measures.MEASURES) in SI;
    `lowest`, `highest`: the range of intensity, `no_damage`: below it there is none, all in SI."""
    known = MEASURES[measure]
    factor = known.openquake_per_si
    root = ET.Element("nrml", xmlns=NAMESPACE)
    model = ET.SubElement(root, "fragilityModel", id=checked_name(name), assetCategory="lifelines", lossCategory="structural")
    ET.SubElement(model, "description").text = description or name
    ET.SubElement(model, "limitStates").text = " ".join(checked_name(state) for state in curves)
    function = ET.SubElement(model, "fragilityFunction", id=name, format="continuous", shape="logncdf")
    ET.SubElement(function, "imls", imt=f"{known.openquake}({period:g})" if measure == "SA" else known.openquake,
                  noDamageLimit=written(no_damage * factor), minIML=written(lowest * factor), maxIML=written(highest * factor))
    for state, curve in curves.items():
        mean, deviation = mean_and_deviation(curve)
        ET.SubElement(function, "params", ls=state, mean=written(mean * factor), stddev=written(deviation * factor))
    ET.indent(root)
    path.write_bytes(ET.tostring(root, encoding="utf-8", xml_declaration=True) + b"\n")


def read(path):
    """{function: (imt, {state: Curve})} of the continuous functions, in OpenQuake's units."""
    root = read_file(path, ET.parse).getroot()
    space = {"n": NAMESPACE}
    return {function.get("id"): (function.find("n:imls", space).get("imt"),
                                 {each.get("ls"): curve_of(float(each.get("mean")), float(each.get("stddev")))
                                  for each in function.findall("n:params", space)})
            for function in root.findall("n:fragilityModel/n:fragilityFunction[@format='continuous']", space)}
