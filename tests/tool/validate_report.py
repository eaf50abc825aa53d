#!/usr/bin/python3
"""Is each report what the schema says?  validate_report.py SCHEMA REPORT...: prints what is not, and then ends with 1."""
import json
import sys

from jsonschema import Draft202012Validator


def place(error):
    return "/".join(str(step) for step in error.absolute_path) or "the report"


with open(sys.argv[1], encoding="utf-8") as file:
    schema = json.load(file)
Draft202012Validator.check_schema(schema)
validator = Draft202012Validator(schema)
wrong = 0
for name in sys.argv[2:]:
    with open(name, encoding="utf-8") as file:
        report = json.load(file)
    for error in validator.iter_errors(report):
        print(f"{name}: {place(error)}: {error.message[:300]}")
        wrong += 1
sys.exit(wrong != 0)
