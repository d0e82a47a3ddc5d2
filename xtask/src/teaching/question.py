"""Runs a question folder as PrairieLearn does, with its own Python package and its element for numbers.

usage: python question.py PRAIRIELEARN FOLDER

Every variant is generated; its right answers get all points, and each value of a common error gets none and its sentence.
"""

import importlib.util
import json
import os
import pathlib
import random
import sys

import chevron
import jsonschema
import lxml.html

root, folder = (pathlib.Path(path).resolve() for path in sys.argv[1:3])
application = root / "apps" / "prairielearn"
element_folder = application / "elements" / "pl-number-input"


def module(name, path):
    spec = importlib.util.spec_from_file_location(name, path)
    found = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(found)
    return found


def named(schema, draft7="http://json-schema.org/draft-07/schema#"):
    return {key: value for key, value in schema.items() if key != "$id"} | {"$schema": draft7}


schema = json.loads((application / "src" / "schemas" / "schemas" / "infoQuestion.json").read_text())
info = json.loads((folder / "info.json").read_text())
jsonschema.validate(info, named(schema))
server = module("server", folder / "server.py")
element = module("number_input", element_folder / "pl-number-input.py")
page = (folder / "question.html").read_text()
os.chdir(element_folder)


def blank_data(panel="question"):
    return {
        "params": {},
        "correct_answers": {},
        "submitted_answers": {},
        "raw_submitted_answers": {},
        "format_errors": {},
        "partial_scores": {},
        "answers_names": {},
        "score": 0,
        "feedback": {},
        "variant_seed": "1",
        "options": {},
        "editable": True,
        "panel": panel,
        "extensions": {},
        "num_valid_submissions": 0,
        "manual_grading": False,
        "ai_grading": False,
    }


def generated(variant):
    data = blank_data()
    whole, server.VARIANTS = server.VARIANTS, [variant]
    server.generate(data)
    server.VARIANTS = whole
    html = chevron.render(page, {"params": data["params"], "correct_answers": data["correct_answers"]})
    assert variant["statement"] in html
    tags = [lxml.html.tostring(tag, encoding="unicode", with_tail=False) for tag in lxml.html.fromstring(html).iter("pl-number-input")]
    return data, tags


def graded(variant, submitted):
    data, tags = generated(variant)
    for tag in tags:
        element.prepare(tag, data)
    data["submitted_answers"] = {name: repr(value) for name, value in submitted.items()}
    data["raw_submitted_answers"] = dict(data["submitted_answers"])
    for tag in tags:
        element.parse(tag, data)
    assert not data["format_errors"], data["format_errors"]
    for tag in tags:
        element.grade(tag, data)
    server.grade(data)
    for panel in ("question", "submission", "answer"):
        data["panel"] = panel
        for tag in tags:
            element.render(tag, data)
    return data["partial_scores"]


random.seed(1)
right = wrong = 0
for variant in server.VARIANTS:
    answers = variant["answers"]
    values = {name: answer["value"] for name, answer in answers.items()}
    scores = graded(variant, values)
    assert set(scores) == set(values), (scores, values)
    assert all(score["score"] == 1 for score in scores.values()), scores
    right += len(scores)
    for name, answer in answers.items():
        for error in answer["errors"]:
            scores = graded(variant, values | {name: error["value"]})
            assert scores[name]["score"] == 0, (name, error)
            assert scores[name]["feedback"] == error["why"], (name, error, scores[name])
            wrong += 1
assert right and wrong
# The draw is PrairieLearn's: it seeds `random`.
drawn = set()
for seed in range(200):
    random.seed(seed)
    data = blank_data()
    server.generate(data)
    drawn.add(data["params"]["label"])
assert drawn == {variant["label"] for variant in server.VARIANTS}
print(f"{len(server.VARIANTS)} variants, {right} right answers with all points, {wrong} common errors named")
