#!/usr/bin/python3
"""Is each report what the schema says?  validate_report.py [--misspell] SCHEMA REPORT...: prints what is not, and then ends with 1.

With --misspell: does the schema notice it wherever a member has another name, or a value of another kind?  Each member of each
object is tried once, wherever in a list of whichever report the object stands; certificates are of a grammar of their own.
"""
import copy
import json
import sys

from jsonschema import Draft202012Validator


def place(path):
    return "/".join(str(step) for step in path) or "the report"


def members(value, path=()):
    """Of every object: where it stands, and the name of a member."""
    steps = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for step, inner in steps:
        if isinstance(value, dict):
            yield path, step
        if step != "certificate":
            yield from members(inner, (*path, step))


def changed(report, path, change):
    other = copy.deepcopy(report)
    at = other
    for step in path:
        at = at[step]
    change(at)
    return other


def unnoticed(validator, report, tried):
    for path, name in members(report):
        kind = (report["program"], *("" if isinstance(step, int) else step for step in path), name)
        if kind in tried:
            continue
        tried.add(kind)
        if validator.is_valid(changed(report, path, lambda at: at.update({name + "_": at.pop(name)}))):
            yield place((*path, name)) + " may be misspelt"
        if name != "certificate" and validator.is_valid(changed(report, path, lambda at: at.update({name: {"nobody": 1}}))):
            yield place((*path, name)) + " may be anything"


misspell = sys.argv[1] == "--misspell"
schema_name, *names = sys.argv[2 if misspell else 1:]
with open(schema_name, encoding="utf-8") as file:
    schema = json.load(file)
Draft202012Validator.check_schema(schema)
validator = Draft202012Validator(schema)
wrong = 0
tried = set()
for name in names:
    with open(name, encoding="utf-8") as file:
        report = json.load(file)
    faults = unnoticed(validator, report, tried) if misspell else (
        f"{place(error.absolute_path)}: {error.message[:300]}" for error in validator.iter_errors(report))
    for fault in faults:
        print(f"{name}: {fault}")
        wrong += 1
sys.exit(wrong != 0)
