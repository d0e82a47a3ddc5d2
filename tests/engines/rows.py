"""Writes what an engine found as rows for tests/tests/engines.rs: inputs as a problem file has them, answers in SI."""

import json
import platform
import random
import sys
from decimal import Decimal
from pathlib import Path


class Rows:
    """The numbers of one program. `accuracy` is relative, and what the program itself allows."""

    def __init__(self, program, version, accuracy, note):
        self.program, self.version, self.accuracy, self.note = program, version, accuracy, note
        self.rows = []

    def add(self, analysis, name, inputs, answers, accuracy=None):
        """Adds a row. An answer is a number or a vector; a pair (answer, accuracy) has an accuracy of its own."""
        written = {}
        for key, answer in answers.items():
            within = accuracy or self.accuracy
            if isinstance(answer, tuple):
                answer, within = answer
            vector = isinstance(answer, list)
            numbers = [float(number) for number in (answer if vector else [answer])]
            scale = sum(number * number for number in numbers) ** 0.5
            if not scale > 0:
                sys.exit(f"{analysis}, {name}: {key} is zero, which holds nothing")
            written[key] = (numbers if vector else numbers[0], within * scale)
        self.rows.append((analysis, name, inputs, written))

    def write(self):
        """Writes `<script>.toml` beside the script."""
        lines = [
            f"program = {text(self.program)}",
            f"version = {text(self.version)}",
            f"python = {text(platform.python_version())}",
            f"script = {text(Path(sys.argv[0]).name)}",
            f"note = {text(self.note)}",
        ]
        for analysis, name, inputs, answers in self.rows:
            lines += ["", "[[row]]", f"analysis = {text(analysis)}", f"name = {text(name)}", "[row.inputs]"]
            lines += [f"{key} = {toml(value)}" for key, value in inputs.items()]
            lines.append("[row.answers]")
            for key, (value, within) in answers.items():
                lines.append(f"{text(key)} = {{ si = {toml(value)}, within = {within:.1e} }}")
        path = Path(__file__).with_name(f"{Path(sys.argv[0]).stem}.toml")
        path.write_text("\n".join(lines) + "\n", encoding="utf-8")
        count = sum(len(a[0]) if isinstance(a[0], list) else 1 for row in self.rows for a in row[3].values())
        print(f"{path.name}: {len(self.rows)} rows, {count} numbers")


def text(value):
    return json.dumps(value, ensure_ascii=False)


def toml(value):
    """A value as TOML: texts, numbers with 17 digits, arrays, inline tables."""
    if isinstance(value, dict):
        return "{ " + ", ".join(f"{key} = {toml(item)}" for key, item in value.items()) + " }"
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(toml(item) for item in value) + "]"
    if isinstance(value, str):
        return text(value)
    if isinstance(value, int):
        return str(value)
    return f"{value:.17g}" if "." in f"{value:.17g}" or "e" in f"{value:.17g}" else f"{value:.1f}"


class Draw:
    """Numbers for inputs: drawn by chance, the same in every run, with four digits."""

    def __init__(self, seed):
        self.chance = random.Random(seed)

    def __call__(self, least, most):
        """A decimal text between two limits; what it says exactly is what an engine computes with."""
        return (
            str(Decimal(f"{self.chance.uniform(least, most):.4g}").normalize())
            .replace("E+", "e")
            .replace("E", "e")
        )

    def floats(self, *limits):
        """As many decimal texts as there are pairs of limits."""
        return [self(*pair) for pair in limits]


def vector(numbers, unit):
    """A vector as a problem file has it."""
    return "(" + "; ".join(str(number) for number in numbers) + ") " + unit
