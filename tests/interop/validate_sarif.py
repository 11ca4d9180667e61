"""Holds SARIF files to the schema of SARIF 2.1.0 and to what code scanning asks beyond it.
usage: validate_sarif.py SCHEMA FILE..."""
import json
import sys

import jsonschema

schema = json.load(open(sys.argv[1], encoding="utf-8"))
validator = jsonschema.Draft4Validator(schema, format_checker=jsonschema.FormatChecker())
wrong = results = 0
for name in sys.argv[2:]:
    log = json.load(open(name, encoding="utf-8"))
    faults = [f"{list(fault.absolute_path)}: {fault.message[:200]}" for fault in validator.iter_errors(log)]
    for run in log["runs"]:
        rules = run["tool"]["driver"]["rules"]
        for result in run["results"]:
            results += 1
            if rules[result["ruleIndex"]]["id"] != result["ruleId"]:
                faults.append(f"{result['ruleId']}: ruleIndex is that of another rule")
            # Without a file, a line and a fingerprint an alert is not shown, or is new at every push.
            if not result["locations"] or not result["partialFingerprints"]:
                faults.append(f"{result['ruleId']}: no place or no fingerprint")
    for fault in faults:
        print(f"{name}: {fault}")
    wrong += bool(faults)
# A validator that takes everything proves nothing.
log["runs"][0]["tool"]["driver"].pop("name")
if validator.is_valid(log):
    sys.exit("the schema takes a tool without a name")
print(f"SARIF: {len(sys.argv) - 2} files, {results} results, {wrong} not valid")
sys.exit(wrong > 0)
