"""Rotations of panels as a pattern states them: XYZ Euler angles in degrees, and matrices (rows)."""
import math


def rotation_of(angles):
    x, y, z = (math.radians(a) for a in angles)
    cx, sx, cy, sy, cz, sz = (f(a) for a in (x, y, z) for f in (math.cos, math.sin))
    return [[cz * cy, cz * sy * sx - sz * cx, cz * sy * cx + sz * sx],
            [sz * cy, sz * sy * sx + cz * cx, sz * sy * cx - cz * sx],
            [-sy, cy * sx, cy * cx]]


def angles_of(m):
    y = math.asin(max(-1.0, min(1.0, -m[2][0])))
    return [math.degrees(a) for a in (math.atan2(m[2][1], m[2][2]), y, math.atan2(m[1][0], m[0][0]))]
