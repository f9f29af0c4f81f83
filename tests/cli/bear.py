# SPDX-License-Identifier: MIT
# Shapes for the tests of the program, as OFF text: a bear made of balls, and what else a user may come along with.
import math


def octahedron_ball(centre, radius, turns):
    """A closed ball: the octahedron's faces divided `turns` times, pushed onto the sphere."""
    vertices = [(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    faces = [(0, 2, 4), (2, 1, 4), (1, 3, 4), (3, 0, 4), (2, 0, 5), (1, 2, 5), (3, 1, 5), (0, 3, 5)]
    for _ in range(turns):
        middle, divided = {}, []

        def between(a, b):
            key = (min(a, b), max(a, b))
            if key not in middle:
                x = [(p + q) / 2 for p, q in zip(vertices[a], vertices[b])]
                length = math.hypot(*x)
                middle[key] = len(vertices)
                vertices.append(tuple(c / length for c in x))
            return middle[key]

        for a, b, c in faces:
            ab, bc, ca = between(a, b), between(b, c), between(c, a)
            divided += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = divided
    return [tuple(m + radius * c for m, c in zip(centre, v)) for v in vertices], faces


def limb(start, end, radius, count=7):
    return [(tuple(a + (b - a) * i / (count - 1) for a, b in zip(start, end)), radius) for i in range(count)]


def bear_balls(arm):
    """Symmetric in x but for what the arms hold; y is up. `arm` is where the left hand is."""
    balls = [((0, 0, 0), 1), ((0, 1.45, 0.1), 0.65), ((0, 1.3, 0.7), 0.28), ((0, -0.5, -0.95), 0.25)]
    for side in (-1, 1):
        balls += [((0.55 * side, 2, 0), 0.26)]
        balls += limb((0.5 * side, -0.7, 0.2), (0.75 * side, -1.7, 0.9), 0.33)
    balls += limb((-0.8, 0.5, 0), (-1.9, 0.9, 0.4), 0.26)
    return balls + limb((0.8, 0.5, 0), arm, 0.26)


def off(vertices, faces):
    lines = ["OFF", f"{len(vertices)} {len(faces)} 0"]
    lines += [" ".join(repr(c) for c in v) for v in vertices]
    lines += [f"3 {a} {b} {c}" for a, b, c in faces]
    return "\n".join(lines) + "\n"


def mesh(balls, move=lambda v: v, skip=0):
    """All balls in one mesh; the last `skip` faces are left out, which opens it."""
    vertices, faces = [], []
    for centre, radius in balls:
        v, f = octahedron_ball(centre, radius, 3)
        faces += [tuple(len(vertices) + i for i in face) for face in f]
        vertices += [move(x) for x in v]
    return off(vertices, faces[: len(faces) - skip])


def turned(v):
    """A similarity: turned about two axes, 2.5 times as large, elsewhere."""
    x, y, z = v
    x, y = 0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y
    y, z = 5 / 13 * y - 12 / 13 * z, 12 / 13 * y + 5 / 13 * z
    return 2.5 * x + 10, 2.5 * y - 3, 2.5 * z + 1


def plate():
    """A flat box: nothing in it resembles a ball."""
    corners = [(x, y, z) for z in (0, 0.5) for y in (0, 8) for x in (0, 10)]
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    return off(corners, [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])


def write_all(folder):
    shapes = {
        "bear.off": mesh(bear_balls((1.9, 0.9, 0.4))),
        "bear_bis.off": mesh(bear_balls((1.8, 1.1, 0.5)), turned),
        "open.off": mesh(bear_balls((1.9, 0.9, 0.4)), skip=40),
        "plate.off": plate(),
        "empty.off": "",
        "garbage.off": "\x01\x02 this is no mesh \x7f" * 50,
        "truncated.off": mesh([((0, 0, 0), 1)])[:2000],
        "infinite.off": mesh([((0, 0, 0), 1)]).replace("1 0 0\n", "inf 0 0\n", 1),
        "sheet.off": off([(0, 0, 0), (1, 0, 0), (1, 1, 0.3), (0, 1, 0.3)], [(0, 1, 2), (0, 2, 3)]),
        "huge.off": "OFF\n4000000000 4000000000 0\n0 0 0\n",
        "flat.off": off([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)]),
    }
    for name, text in shapes.items():
        with open(f"{folder}/{name}", "w") as file:
            file.write(text)
