# SPDX-License-Identifier: MIT
"""What type checkers and editors know of the package; mypy is one of them."""
import homolog
from mypy import api

EVERY = ", ".join(f"{row['name']}={row['default']!r}" for row in homolog.parameters())
RIGHT = f"""
import homolog

shape = homolog.describe("bear.off", {EVERY})
family: homolog.Family = homolog.match(shape, "bear.off", threads=2, preset="paper", sigma0=1)
weights: float = family[0].model_part.mean()
labels: tuple[str, ...] = homolog.read_landmarks("a.csv").labels
homolog.load("bears").save("again")
"""
WRONG = {
    'homolog.match("a.off", "b.off", resolutoin=3)': 'did you mean "resolution"',
    'homolog.describe("a.off", resolution="64")': 'incompatible type "str"; expected "int"',
    'homolog.symmetry("a.off", mirror="maybe")': "incompatible type",
    'homolog.points("a.off").radii': 'has no attribute "radii"',
}


def test_the_package_itself_is_typed_throughout(tmp_path):
    told, _, code = api.run(["--strict", "-p", "homolog", "--cache-dir", str(tmp_path)])
    assert code == 0, told


def test_type_checkers_know_results_and_every_parameter(tmp_path):
    user = tmp_path / "user.py"
    lines = [*RIGHT.splitlines(), *WRONG]
    user.write_text("\n".join(lines) + "\n")
    told, _, _ = api.run([str(user), "--cache-dir", str(tmp_path / "cache"), "--no-error-summary", "--hide-error-context", "--no-pretty"])
    errors = [line for line in told.splitlines() if ": error: " in line]
    assert len(errors) == len(WRONG), told
    for number, error, line, words in zip(range(len(lines) - len(WRONG) + 1, len(lines) + 1), errors, WRONG, WRONG.values()):
        assert error.startswith(f"{user}:{number}:") and words in error, line
