"""The inner side of a lining of `tunnels`, and lines at a distance outside it (coupler/tunnel/contour.hpp)."""
import numpy as np


class Contour:
    """A circle; an arch over walls and a floor; or a box. Lines outside keep its corners."""

    def __init__(self, tunnel):
        self.centre = np.array([tunnel["centre"].get(axis, 0.0) for axis in "xy"])
        if "box" in tunnel:
            self.half, self.above, self.below = tunnel["box"]["width"] / 2, tunnel["box"]["height"] / 2, tunnel["box"]["height"] / 2
        elif "horseshoe" in tunnel:
            self.half = self.above = tunnel["horseshoe"]["width"] / 2
            self.below = tunnel["horseshoe"]["height"] - self.half
        else:
            self.half = self.above = self.below = tunnel["circle"]["radius"]
        self.arch, self.floor = "box" not in tunnel, "circle" not in tunnel

    def away(self, points):
        """The offset [m] of the line through each point (n, 2), negative inside."""
        x, y = (points - self.centre).T
        straight = np.maximum(np.abs(x) - self.half, np.maximum(y - self.above, -y - self.below))
        return np.where((y > 0) | (not self.floor), np.hypot(x, y) - self.half, straight) if self.arch else straight

    def area(self, offset):
        """Within the line at this offset [m^2]."""
        half, above, below = self.half + offset, self.above + offset, self.below + offset
        return (np.pi * half**2 / 2 if self.arch else 2 * half * above) + (2 * half * below if self.floor else np.pi * half**2 / 2)
